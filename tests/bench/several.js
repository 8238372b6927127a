// Several fur types or materials: ?page=several&settings={settings}&types=parts&maps=how many types have one&bald=1&wetness=0..1
// parts: each type on a quarter of the model; bald: where v is above a half.
import { createWetFur } from '/index.js';
import { install, loadMesh, makeCanvas, noteContext, setting, view } from './shared.js';

const query = new URLSearchParams(location.search), settings = JSON.parse(query.get('settings') ?? '{}');
const noted = noteContext(), canvas = makeCanvas();
const fur = await createWetFur(canvas, {
  src: new URL(`/models/${setting.model}.glb`, location).href, quality: setting.antialias ? 'medium' : 'low', paused: true, dryRate: 0, lie: 0,
  cameraOrbit: `${view.yaw}rad ${view.pitch}rad ${view.distance}m`, ...settings,
});

/** A PNG of `size` squared; color(u, v): red, green, blue, 0..1. */
async function picture(size, color) {
  const image = new ImageData(size, size);
  for (let i = 0; i < size * size; ++i) {
    const texel = color((i % size + 0.5) / size, (Math.floor(i / size) + 0.5) / size);
    image.data.set([...texel.map((c) => Math.round(255 * Math.max(0, Math.min(1, c)))), 255], 4 * i);
  }
  const paper = new OffscreenCanvas(size, size);
  paper.getContext('2d').putImageData(image, 0, 0);
  return paper.convertToBlob();
}
const smooth = (from, to, x) => ((t) => t * t * (3 - 2 * t))(Math.max(0, Math.min(1, (x - from) / (to - from))));

/** Over the model's texture coordinates what color(x, y, z) says of places on the unit sphere's scale. */
async function pictureByPlace(size, color) {
  const { positions: p, uvs, indices } = await loadMesh(setting.model), texels = Array.from({ length: size * size }, () => [0, 0, 0]);
  for (let t = 0; t < indices.length; t += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => [uvs[2 * indices[t + k]] * size - 0.5, uvs[2 * indices[t + k] + 1] * size - 0.5]);
    const area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (Math.abs(area) < 1e-9) continue;
    const range = (k) => [Math.max(0, Math.floor(Math.min(a[k], b[k], c[k])) - 1), Math.min(size - 1, Math.ceil(Math.max(a[k], b[k], c[k])) + 1)];
    const [[x0, x1], [y0, y1]] = [range(0), range(1)];
    for (let y = y0; y <= y1; ++y) {
      for (let x = x0; x <= x1; ++x) {
        const v = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area, w = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area;
        // A little over the triangle, so that borders of charts are filled.
        if (v < -0.2 || w < -0.2 || v + w > 1.2) continue;
        texels[y * size + x] = color(...[0, 1, 2].map((k) => p[3 * indices[t] + k] * (1 - v - w) + p[3 * indices[t + 1] + k] * v + p[3 * indices[t + 2] + k] * w));
      }
    }
  }
  return picture(size, (u, v) => texels[Math.floor(v * size) * size + Math.floor(u * size)]);
}

if (query.get('types') === 'parts')
  await fur.loadPicture(await pictureByPlace(256, (x, y) => {
    const right = smooth(-0.05, 0.05, x), high = smooth(-0.05, 0.05, y);
    return [right * (1 - high), (1 - right) * high, right * high];
  }), { as: 'types' });
const colors = [[0.9, 0.6, 0.4], [0.5, 0.7, 0.9], [0.6, 0.9, 0.5], [0.9, 0.8, 0.3]].slice(0, Number(query.get('maps') ?? 0));
for (const [i, color] of colors.entries())
  await fur.setTypePicture(i + 1, await picture(256, (u, v) => color.map((c) => c * (0.6 + 0.4 * Math.sin((20 + 6 * i) * u) * Math.cos(24 * v)))));
if (query.has('bald')) await fur.loadPicture(await picture(64, (u, v) => Array(3).fill(v < 0.5 ? 1 : 0)), { as: 'length' });
for (const warning of fur.warnings) console.warn(warning);
if (noted.gl.drawingBufferWidth !== setting.width) throw new Error(`the buffer is ${noted.gl.drawingBufferWidth} wide`);
if (query.has('wetness')) fur.setWetness(Number(query.get('wetness')));
install(noted.gl, () => fur.step(0, 1), fur.stats);
/** How long saving takes as a page sees it, its bytes, and how often progress is told. */
window.save = async () => {
  let steps = 0;
  const count = () => { ++steps; };
  fur.addEventListener('progress', count);
  const begun = performance.now(), { length } = await fur.save(), ms = performance.now() - begun;
  fur.removeEventListener('progress', count);
  return { ms, bytes: length, steps };
};
