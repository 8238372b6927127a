// A model that moves, everything on: ?page=animal&mesh=otter&covers=0.2&wetness=0..1&settings=name%3Dvalue, from where it covers that share of the picture.
import { createWetFur } from '/index.js';
import { install, makeCanvas, noteContext, setting } from './shared.js';

const query = new URLSearchParams(location.search), noted = noteContext(), wanted = Number(query.get('covers') ?? 0.2);
const seen = (canvas, distance) => createWetFur(canvas, {
  src: new URL(`/models/${setting.model}.glb`, location).href, quality: setting.antialias ? 'medium' : 'low', paused: true, motion: 'full', cameraOrbit: `-0.7rad 0.12rad ${distance}m`,
  ...Object.fromEntries(new URLSearchParams(query.get('settings') ?? '')),
});

/** The share of the picture that is not empty. */
async function covered(fur) {
  const bitmap = await createImageBitmap(await fur.toBlob({ width: 200, height: 150, transparent: true, samples: 1 }));
  const paper = new OffscreenCanvas(200, 150).getContext('2d');
  paper.drawImage(bitmap, 0, 0);
  return paper.getImageData(0, 0, 200, 150).data.filter((value, i) => i % 4 === 3 && value > 127).length / (200 * 150);
}

// What is covered goes with the square of the distance, nearly.
let distance = 3.5;
for (let i = 0; i < 2; ++i) {
  const canvas = makeCanvas(), fur = await seen(canvas, distance);
  distance *= Math.sqrt((await covered(fur)) / wanted);
  fur.dispose();
  canvas.remove();
}
const fur = await seen(makeCanvas(), distance), covers = await covered(fur);
if (query.has('wetness')) fur.setWetness(Number(query.get('wetness')));
for (const warning of fur.warnings) console.warn(warning);
install(noted.gl, () => fur.step(1 / 60, 1), { ...fur.stats, covers });
