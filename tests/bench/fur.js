// Ours: the viewer as it ships, everything on, the same mesh, camera, size and layer count.
import { createWetFur } from '/index.js';
import { install, makeCanvas, setting, view } from './shared.js';

// What it draws in is not the canvas's own: it is noted as it is made.
let gl = null;
const { getContext } = OffscreenCanvas.prototype;
OffscreenCanvas.prototype.getContext = function noted(type, ...rest) {
  const context = getContext.call(this, type, ...rest);
  if (type === 'webgl2') gl = context;
  return context;
};

const canvas = makeCanvas();
const query = new URLSearchParams(location.search), pageSettings = ['page', 'shells', 'width', 'height', 'mesh', 'length', 'aa', 'wetness'];
const fur = await createWetFur(canvas, {
  src: new URL(`/models/${setting.model}.glb`, location).href, quality: setting.antialias ? 'medium' : 'low', paused: true, dryRate: 0,
  cameraOrbit: `${view.yaw}rad ${view.pitch}rad ${view.distance}m`,
  ...Object.fromEntries([...query].filter(([name]) => !pageSettings.includes(name))), layers: setting.layers, furLength: setting.furLength,
});
for (const warning of fur.warnings) console.warn(warning);
if (gl.drawingBufferWidth !== setting.width) throw new Error(`the buffer is ${gl.drawingBufferWidth} wide`);
if (query.has('wetness')) fur.setWetness(Number(query.get('wetness')));
install(gl, () => fur.step(0, 1), fur.stats, !query.has('wetness'));
