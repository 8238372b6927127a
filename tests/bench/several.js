// Several fur types or materials: ?page=several&settings={settings}&types={picture of the types}&maps=1&wetness=0..1
// types: "parts" is the map below; maps: a colour map for each of the four types; bald: half of the picture is bald (?mesh=bear1).
import { createWetFur } from '/index.js';
import { install, makeCanvas, noteContext, setting, view } from './shared.js';

const query = new URLSearchParams(location.search), settings = JSON.parse(query.get('settings') ?? '{}');
const noted = noteContext(), canvas = makeCanvas();
const fur = await createWetFur(canvas, {
  src: new URL(`/models/${setting.model}.glb`, location).href, quality: setting.antialias ? 'medium' : 'low', paused: true, dryRate: 0,
  cameraOrbit: `${view.yaw}rad ${view.pitch}rad ${view.distance}m`, ...settings,
});

/** A PNG of `size` squared; color(u, v): red, green, blue, 0..1. */
async function picture(size, color) {
  const image = new ImageData(size, size);
  for (let i = 0; i < size * size; ++i) image.data.set([...color((i % size + 0.5) / size, (Math.floor(i / size) + 0.5) / size).map((c) => Math.round(255 * c)), 255], 4 * i);
  const paper = new OffscreenCanvas(size, size);
  paper.getContext('2d').putImageData(image, 0, 0);
  return paper.convertToBlob();
}
const smooth = (from, to, x) => ((t) => t * t * (3 - 2 * t))(Math.max(0, Math.min(1, (x - from) / (to - from))));

// Spots and a saddle of the types 2 to 4 on the first, each a fifth to a quarter of the skin, with borders as brushes leave them.
if (query.get('types') === 'parts')
  await fur.loadPicture(await picture(256, (u, v) => {
    const right = smooth(0.46, 0.54, u), low = smooth(0.46, 0.54, v);
    return [right * (1 - low), (1 - right) * low, right * low];
  }), { as: 'types' });
if (query.has('maps')) {
  const colors = [[0.9, 0.6, 0.4], [0.5, 0.7, 0.9], [0.6, 0.9, 0.5], [0.9, 0.8, 0.3]];
  for (const [i, color] of colors.entries()) {
    if (i >= Number(query.get('maps'))) break;
    await fur.setTypePicture(i + 1, await picture(256, (u, v) => color.map((c) => c * (0.6 + 0.4 * Math.sin((20 + 6 * i) * u) * Math.cos(24 * v)))));
  }
}
if (query.has('bald')) await fur.loadPicture(await picture(64, (u, v) => Array(3).fill(v < 0.5 ? 1 : 0)), { as: 'length' });
for (const warning of fur.warnings) console.warn(warning);
if (noted.gl.drawingBufferWidth !== setting.width) throw new Error(`the buffer is ${noted.gl.drawingBufferWidth} wide`);
if (query.has('wetness')) fur.setWetness(Number(query.get('wetness')));
install(noted.gl, () => fur.step(0, 1), fur.stats, false);
/** Milliseconds that saving takes, and its bytes. */
window.save = async () => {
  const steps = [], begun = performance.now();
  canvas.addEventListener('progress', (event) => steps.push(event.detail));
  const { length } = await fur.save();
  return { ms: performance.now() - begun, length, steps };
};
window.fur = fur;
