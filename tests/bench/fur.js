// Ours: the viewer as it ships, everything on, the same mesh, camera, size and layer count.
import { createWetFur } from '/index.js';
import { install, makeCanvas, setting, view } from './shared.js';

const canvas = makeCanvas();
const fur = await createWetFur(canvas, {
  src: new URL(`/models/${setting.model}.glb`, location).href, quality: setting.antialias ? 'medium' : 'low', paused: true, dryRate: 0,
});
const query = new URLSearchParams(location.search);
for (const name of fur.settingsTable.map((field) => field.name)) {
  if (query.has(name)) fur.settings[name] = Number(query.get(name));
}
fur.settings.layers = setting.layers;
fur.settings.furLength = setting.furLength;
fur.cameraOrbit = `${view.yaw}rad ${view.pitch}rad ${view.distance}m`;
if (query.has('wetness')) fur.setWetness(Number(query.get('wetness')));
const gl = canvas.getContext('webgl2');
if (gl.drawingBufferWidth !== setting.width) throw new Error(`the buffer is ${gl.drawingBufferWidth} wide`);
fur.step(0, 1);
install(gl, () => fur.step(0, 1), fur.stats);
