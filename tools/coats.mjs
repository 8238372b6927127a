// npm run coats: docs/coats.jpg, a contact sheet of the presets on the bunny, each near and at a distance; and web/coats.webp,
// what the demo page shows of each.
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { buildNative } from './build.mjs';
import { inline, photograph } from './photograph.mjs';
import { command, root, run } from './process.mjs';
import { needs, setUp } from './setup.mjs';
import { drawSwatches } from './swatches.mjs';

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

const page = (figures) => `<!doctype html><style>
  body { margin: 0; padding: 12px; display: grid; grid-template-columns: repeat(2, max-content); gap: 12px;
         font: 17px Karla, sans-serif; background: #f6f3ee; color: #2b2622; width: max-content }
  figure { margin: 0 } img { display: inline-block; vertical-align: bottom } figcaption { padding: 6px 2px 2px }
</style>${figures.map(({ label, description, images }) => `<figure>${images.map((src) => `<img width="${size.width}" src="${src}">`).join('')}
  <figcaption><b>${label}</b>: ${description}</figcaption></figure>`).join('')}`;

await command(async () => {
  setUp({ packages: [needs.headless, needs.browser], npm: true });
  const program = buildNative('wet-fur-render'), folder = join(root, 'build/coats');
  mkdirSync(folder, { recursive: true });
  mkdirSync(join(root, 'docs'), { recursive: true });
  const figures = presets(program).map((preset) => ({ ...preset, images: pictures(program, preset, folder) }));
  await photograph(page(figures), join(root, 'docs/coats.jpg'));
  await drawSwatches(program, figures, folder, join(root, 'web/coats.webp'));
});
