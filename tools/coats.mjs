// npm run coats: docs/coats.jpg, a contact sheet of the presets on the bunny, each near and at a distance; and web/coats.jpg,
// a square of the fur of each for the demo page's chooser.
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { buildNative } from './build.mjs';
import { inline, photograph } from './photograph.mjs';
import { command, root, run } from './process.mjs';
import { needs, setUp } from './setup.mjs';

// Yaw, pitch and distance of the two looks.
const views = { far: '0.35,0.28,2.75', near: '0.35,0.2,1.45' };
const size = { width: 400, height: 330 };  // drawn twice as large

/** The table of presets, as the program lists it. */
function presets(program) {
  return JSON.parse(run(program, ['--list-presets'], { quiet: true }));
}

function pictures(program, preset, folder) {
  return Object.entries(views).map(([view, camera]) => {
    const file = join(folder, `${preset.name}-${view}.png`);
    run(program, ['bunny', '-o', file, '--preset', preset.name, '--size', `${2 * size.width}x${2 * size.height}`, '--camera', camera], { quiet: true });
    return inline(file);
  });
}

const swatchSide = 112;  // twice as many pixels as web/coats.js shows
function swatch(program, { name }, folder) {
  const file = join(folder, `${name}-swatch.png`);
  run(program, ['sphere', '-o', file, '--preset', name, '--size', `${2 * swatchSide}x${2 * swatchSide}`, '--camera', '0.35,0.1,2.55'], { quiet: true });
  return inline(file);
}
const row = (images) => `<!doctype html><style>body { margin: 0; display: flex; width: max-content }</style>
  ${images.map((src) => `<img width="${swatchSide}" src="${src}">`).join('')}`;

const page = (figures) => `<!doctype html><style>
  body { margin: 0; padding: 12px; display: grid; grid-template-columns: repeat(2, max-content); gap: 12px;
         font: 17px Karla, sans-serif; background: #f6f3ee; color: #2b2622; width: max-content }
  figure { margin: 0 } img { display: inline-block; vertical-align: bottom } figcaption { padding: 6px 2px 2px }
</style>${figures.map(({ label, description, images }) => `<figure>${images.map((src) => `<img width="${size.width}" src="${src}">`).join('')}
  <figcaption><b>${label}</b>: ${description}</figcaption></figure>`).join('')}`;

await command(async () => {
  setUp({ packages: [needs.headless, needs.browser], npm: true });
  const program = await buildNative('wet-fur-render'), folder = join(root, 'build/coats');
  mkdirSync(folder, { recursive: true });
  mkdirSync(join(root, 'docs'), { recursive: true });
  const figures = presets(program).map((preset) => ({ ...preset, images: pictures(program, preset, folder) }));
  await photograph(page(figures), join(root, 'docs/coats.jpg'));
  await photograph(row(figures.map((preset) => swatch(program, preset, folder))), join(root, 'web/coats.jpg'));
});
