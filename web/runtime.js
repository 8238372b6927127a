// The WebAssembly programs: fetched, compiled and, but for the editor's, instantiated once a page.
import { FurError } from './errors.js';
import { counted, fetchOrThrow } from './fetching.js';

const isNode = typeof process === 'object' && Boolean(process.versions?.node) && typeof document === 'undefined';

/**
 * The programs from the same sources. `glue` imports the script that the compiler wrote beside
 * the .wasm; the failed import of a module stays failed, so a retry asks under another address.
 */
const programs = {
  viewer: { wasm: new URL('./wet-fur.wasm', import.meta.url), glue: () => import('./wet-fur.mjs'), script: './wet-fur.mjs' },
  editor: {
    wasm: new URL('./wet-fur-editor.wasm', import.meta.url),
    glue: () => import('./wet-fur-editor.mjs'),
    script: './wet-fur-editor.mjs',
  },
  // The viewer with long hair.
  hair: { wasm: new URL('./wet-fur-hair.wasm', import.meta.url), glue: () => import('./wet-fur-hair.mjs'), script: './wet-fur-hair.mjs' },
  // Its glue is core.js's to import: pages without it need not even name it.
  core: { wasm: new URL('./wet-fur-core.wasm', import.meta.url), script: './wet-fur-core.mjs' },
};
const compiled = new Map();
const failures = new Map();

/** Where the .wasm lies when it is not beside this script. */
export function setWasmUrl(which, url) {
  programs[which].wasm = url instanceof URL || isNode ? url : new URL(url, document.baseURI);
  compiled.delete(which);
}

/** How the glue of a program is imported that this script does not name. */
export function setGlue(which, glue) {
  programs[which].glue = glue;
}

async function readFromDisk(url) {
  const { readFile } = await import('node:fs/promises');
  return readFile(url);
}

async function compile(url, onBytes) {
  if (typeof WebAssembly !== 'object')
    throw new FurError('wasm-blocked', 'WebAssembly is missing or switched off in this browser.');
  try {
    if (isNode) return await WebAssembly.compile(await readFromDisk(url));
    const response = counted(await fetchOrThrow(url, 'wasm-load'), onBytes, 'application/wasm');
    return await WebAssembly.compileStreaming(response);
  } catch (error) {
    if (error instanceof FurError) throw error;
    const blocked = /content security|unsafe-eval|disallowed|blocked/i.test(error.message);
    throw new FurError(blocked ? 'wasm-blocked' : 'wasm-load', blocked
      ? "This page's Content-Security-Policy blocks WebAssembly: it needs script-src 'wasm-unsafe-eval'."
      : `${url.pathname ?? url}: ${error.message}`);
  }
}

async function importGlue(which) {
  const failed = failures.get(which) ?? 0;
  const program = programs[which];
  try {
    if (failed === 0) return (await program.glue()).default;
    const url = new URL(`${program.script}?retry=${failed}`, import.meta.url).href;
    return (await import(/* @vite-ignore */ /* webpackIgnore: true */ url)).default;
  } catch (error) {
    failures.set(which, failed + 1);
    throw new FurError('wasm-load', `${program.script.slice(2)}: ${error.message}`);
  }
}

/**
 * Fetches and compiles; the work is shared by every caller, and thrown away when it failed.
 * @param {'viewer'|'hair'|'editor'|'core'} which
 * @param {(loaded: number, total: number) => void} [onBytes] total is 0 when unknown
 */
export function compileProgram(which, onBytes) {
  if (!compiled.has(which)) {
    const entry = { listeners: new Set() };
    const tell = (loaded, total) => entry.listeners.forEach((listener) => listener(loaded, total));
    entry.promise = Promise.all([compile(programs[which].wasm, tell), importGlue(which)])
      .then(([module, glue]) => ({ module, glue }));
    entry.promise.catch(() => compiled.delete(which));
    compiled.set(which, entry);
  }
  const entry = compiled.get(which);
  if (onBytes) entry.listeners.add(onBytes);
  return entry.promise.finally(() => entry.listeners.delete(onBytes));
}

/** A fresh instance with memory of its own. */
export async function instantiateProgram(which, onBytes) {
  const { module, glue } = await compileProgram(which, onBytes);
  let memory;
  const emscripten = await new Promise((resolve, reject) => {
    const instantiateWasm = (imports, done) => {
      WebAssembly.instantiate(module, imports).then((instance) => {
        // Under its own name, or under whichever the optimiser gave it.
        memory = Object.values(instance.exports).find((one) => one instanceof WebAssembly.Memory);
        done(instance, module);
      }).catch(reject);
      return {};
    };
    const onAbort = (what) => reject(new Error(String(what)));
    glue({ instantiateWasm, onAbort, print: console.log, printErr: console.warn }).then(resolve, reject);
  }).catch((error) => {
    const memoryRefused = error instanceof RangeError;
    throw new FurError(memoryRefused ? 'out-of-memory' : 'wasm-load', error.message);
  });
  return new Program(emscripten, memory ?? emscripten.wasmMemory);
}

/** Instances that all figures of the page share, by program. */
const shared = new Map();

/** The instance in which all figures of the page have their scenes, one App each. */
export function sharedProgram(which, onBytes) {
  const had = shared.get(which);
  if (had) {
    if (onBytes) compileProgram(which, onBytes).catch(() => {});  // it may be on its way still
    return had;
  }
  const pending = instantiateProgram(which, onBytes);
  const drop = () => { if (shared.get(which) === pending) shared.delete(which); };
  shared.set(which, pending);
  pending.then((program) => program.onFailure.add(drop), drop);
  return pending;
}

const decoder = new TextDecoder();
const encoder = new TextEncoder();

/** One instance: its exports by name, and text and arrays across the border. */
export class Program {
  constructor(emscripten, memory) {
    this.emscripten = emscripten;
    this.memory = memory;
    /** The one that its GL calls go to. @type {import('./contexts.js').SharedContext | null} */
    this.context = null;
    /** Why no call goes through any more. @type {FurError | null} */
    this.failure = null;
    /** Called, soon after, when it fails. @type {Set<() => void>} */
    this.onFailure = new Set();
  }

  has(name) {
    return typeof this.emscripten[`_${name}`] === 'function';
  }

  /** Calls an export; strings and byte arrays among the arguments live in its memory during the call. */
  call(name, ...args) {
    if (this.failure) throw this.failure;
    const taken = [];
    const lower = (arg) => {
      if (typeof arg === 'string') return this.#copyIn(encoder.encode(`${arg}\0`), taken);
      if (ArrayBuffer.isView(arg)) return this.#copyIn(new Uint8Array(arg.buffer, arg.byteOffset, arg.byteLength), taken);
      return arg;
    };
    try {
      return this.emscripten[`_${name}`](...args.map(lower));
    } catch (error) {
      if (!(error instanceof WebAssembly.RuntimeError)) throw error;
      console.error(error);
      this.failure = new FurError('program-failed', `The program has failed: ${error.message}`);
      for (const tell of this.onFailure) queueMicrotask(tell);
      throw this.failure;
    } finally {
      if (!this.failure) for (const pointer of taken) this.emscripten._fur_free(pointer);
    }
  }

  /** What can still be read of one that has failed: its memory is there, though a call may fail again. */
  salvage(read) {
    const { failure } = this;
    this.failure = null;
    try {
      return read();
    } finally {
      this.failure = failure;
    }
  }

  /** The same, and 0 becomes a thrown FurError. */
  callOrThrow(name, ...args) {
    const result = this.call(name, ...args);
    if (!result) throw this.error();
    return result;
  }

  error() {
    return new FurError(this.text(this.call('fur_errorCode')), this.text(this.call('fur_errorMessage')));
  }

  text(pointer) {
    const bytes = new Uint8Array(this.memory.buffer);
    return decoder.decode(bytes.slice(pointer, bytes.indexOf(0, pointer)));
  }

  lines(pointer) {
    return this.text(pointer).split('\n').filter(Boolean);
  }

  /** A copy: a view would be cut off when the memory grows. */
  array(Type, pointer, length) {
    return new Type(this.memory.buffer.slice(pointer, pointer + length * Type.BYTES_PER_ELEMENT));
  }

  numbers(pointer, length) {
    return pointer ? Array.from(this.array(Float64Array, pointer, length)) : null;
  }

  #copyIn(bytes, taken) {
    const pointer = this.emscripten._fur_alloc(bytes.byteLength);
    if (!pointer) throw this.error();
    taken.push(pointer);
    new Uint8Array(this.memory.buffer).set(bytes, pointer);
    return pointer;
  }
}
