// Ours: the viewer as it ships, everything on, the same mesh, camera, size and layer count.
import { createWetFur } from '/index.js';
import { install, makeCanvas, noteContext, setting, view } from './shared.js';

const noted = noteContext(), canvas = makeCanvas();
const query = new URLSearchParams(location.search), pageSettings = ['page', 'shells', 'width', 'height', 'mesh', 'length', 'aa', 'wetness'];
const fur = await createWetFur(canvas, {
  src: new URL(`/models/${setting.model}.glb`, location).href, quality: setting.antialias ? 'medium' : 'low', paused: true, dryRate: 0, lie: 0,
  cameraOrbit: `${view.yaw}rad ${view.pitch}rad ${view.distance}m`,
  ...Object.fromEntries([...query].filter(([name]) => !pageSettings.includes(name))), layers: setting.layers, furLength: setting.furLength,
});
for (const warning of fur.warnings) console.warn(warning);
if (noted.gl.drawingBufferWidth !== setting.width) throw new Error(`the buffer is ${noted.gl.drawingBufferWidth} wide`);
if (query.has('wetness')) fur.setWetness(Number(query.get('wetness')));
install(noted.gl, () => fur.step(0, 1), fur.stats, !query.has('wetness'));
