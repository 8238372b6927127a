// Ours: the viewer as it ships, everything on, the same mesh, camera, size and layer count. `live`: not paused, so that its first picture is
// the coarse one that visitors see first.
import { createWetFur } from '/index.js';
import { install, makeCanvas, noteContext, setting, view } from './shared.js';

const noted = noteContext(), canvas = makeCanvas();
const query = new URLSearchParams(location.search), pageSettings = ['page', 'shells', 'width', 'height', 'mesh', 'length', 'aa', 'wetness', 'live'];
const live = query.has('live');
const fur = await createWetFur(canvas, {
  src: new URL(`/models/${setting.model}.glb`, location).href, quality: setting.antialias ? 'medium' : 'low', paused: !live, dryRate: 0, lie: 0,
  cameraOrbit: `${view.yaw}rad ${view.pitch}rad ${view.distance}m`,
  ...Object.fromEntries([...query].filter(([name]) => !pageSettings.includes(name))), layers: setting.layers, furLength: setting.furLength,
});
for (const warning of fur.warnings) console.warn(warning);
if (noted.gl.drawingBufferWidth !== setting.width) throw new Error(`the buffer is ${noted.gl.drawingBufferWidth} wide`);
if (query.has('wetness')) fur.setWetness(Number(query.get('wetness')));
install(noted.gl, () => fur.step(0, 1), fur.stats, live || !query.has('wetness'));
