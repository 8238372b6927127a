/**
 * wet-fur: fur, dry and wet, on a canvas. `const fur = await createWetFur(canvas, { src: 'otter.glb' })`.
 * The tag <wet-fur> is in wet-fur/element, the parts without a picture in wet-fur/core.
 */
import { offersContext, setBudget } from './contexts.js';
import { FurError } from './errors.js';
import { WetFur } from './host.js';
import { setModelsUrl } from './models.js';
import { compileProgram, setWasmUrl } from './runtime.js';

export { FurError };

/**
 * Draws a model on the canvas; resolves when it is there. dispose() ends it, and the canvas cannot
 * be used again.
 * @param {HTMLCanvasElement} canvas
 * @param {import('./types/index.d.ts').WetFurOptions} [options]
 */
export async function createWetFur(canvas, options = {}) {
  const fur = new WetFur(canvas, { src: 'bunny', ...options });
  try {
    await fur.ready;
  } catch (error) {
    fur.dispose();
    throw error;
  }
  return fur;
}

/** Fetches and compiles the program before it is needed. */
export async function preload(onBytes) {
  await compileProgram('viewer', onBytes);
}

/**
 * Where the files lie when they are not beside the scripts; call it before the first element loads. `gpuBudget`: bytes on the
 * graphics processor beyond which figures out of view give theirs back.
 */
export function configure({ wasmUrl, hairWasmUrl, editorWasmUrl, coreWasmUrl, modelsUrl, gpuBudget } = {}) {
  if (wasmUrl) setWasmUrl('viewer', wasmUrl);
  if (hairWasmUrl) setWasmUrl('hair', hairWasmUrl);
  if (editorWasmUrl) setWasmUrl('editor', editorWasmUrl);
  if (coreWasmUrl) setWasmUrl('core', coreWasmUrl);
  if (modelsUrl) setModelsUrl(modelsUrl);
  if (gpuBudget >= 0) setBudget(gpuBudget);
}

/** Whether this browser can draw it: WebAssembly and WebGL2. False outside a browser. */
export function isSupported() {
  if (typeof document === 'undefined' || typeof WebAssembly !== 'object') return false;
  return offersContext();
}
