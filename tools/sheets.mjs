// npm run sheets: docs/otter.jpg and docs/pony.jpg, contact sheets of the animals: eight sides, dry to soaked, shaking and back-lit.
// npm run sheets -- pony: that one alone.
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { animals } from './assets/animals.mjs';
import { buildNative } from './build.mjs';
import { inline, photograph } from './photograph.mjs';
import { command, root, run, Stop } from './process.mjs';
import { needs, setUp } from './setup.mjs';

const sides = 8, width = 190;  // drawn twice as large
// Yaw, pitch, distance and middle; a turn goes on from there.
const looks = { otter: { height: 112, camera: '0,0.12,2.2,0,-0.06,0.05' }, pony: { height: 160, camera: '0,0.08,2.85,0,0.02,0' } };
const still = ['--behaviour', 'none'];
const states = {
  dry: still,
  'half wet': ['--wetness', '0.55', ...still],
  soaked: ['--wetness', '1', ...still],
  shaking: ['--wetness', '1', '--hold', 'shake,0.75'],
  'back-lit': ['--light', 'backlit', ...still],
};

function turnOf(program, name, state, folder) {
  const file = join(folder, `${name}-${state.replace(' ', '-')}.png`);
  run(program, [name, '-o', file, '--turntable', `${sides}`, '--turn-seconds', '0.1', '--size', `${2 * width}x${2 * looks[name].height}`, '--camera', looks[name].camera, ...states[state]], { quiet: true });
  return Array.from({ length: sides }, (_, i) => inline(file.replace('.png', `-00${i}.png`)));
}

const page = (rows) => `<!doctype html><style>
  body { margin: 0; padding: 8px; display: grid; grid-template-columns: max-content repeat(${sides}, max-content); gap: 2px; width: max-content;
         font: 15px Karla, sans-serif; background: #f6f3ee; color: #2b2622 }
  span { writing-mode: vertical-rl; rotate: 180deg; text-align: center; padding: 2px } img { display: block }
</style>${rows.map(({ state, images }) => `<span>${state}</span>${images.map((src) => `<img width="${width}" src="${src}">`).join('')}`).join('')}`;

await command(async () => {
  const names = process.argv.slice(2), known = animals.map(({ name }) => name), unknown = names.find((name) => !known.includes(name));
  if (unknown) throw new Stop(`npm run sheets -- ${known.join(' | ')}`);
  setUp({ packages: [needs.headless, needs.browser], npm: true });
  const program = await buildNative('wet-fur-render'), folder = join(root, 'build/sheets');
  mkdirSync(folder, { recursive: true });
  for (const name of names.length ? names : known)
    await photograph(page(Object.keys(states).map((state) => ({ state, images: turnOf(program, name, state, folder) }))), join(root, `docs/${name}.jpg`), { quality: 80 });
});
