// npm run wet: docs/wet-*.jpg, the bunny from dry to soaked and drying again.
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { buildNative } from './build.mjs';
import { inline, photograph } from './photograph.mjs';
import { command, root, run } from './process.mjs';
import { needs, setUp } from './setup.mjs';

const size = { width: 380, height: 320 };  // drawn twice as large
const look = ['--camera', '0.42,0.22,2.85', '--size', `${2 * size.width}x${2 * size.height}`, '--samples', '16'];
const states = {
  dry: [],
  droplets: ['--rain', '1', '--time', '4'],
  half: ['--wetness', '0.65'],
  soaked: ['--wetness', '1'],
  drying: ['--wetness', '1', '--hold', `dryer,5,${1.08 * size.width},${size.height}`],
};

await command(async () => {
  setUp({ packages: [needs.headless, needs.browser], npm: true });
  const program = await buildNative('wet-fur-render'), folder = join(root, 'build/wet');
  mkdirSync(folder, { recursive: true });
  for (const [name, options] of Object.entries(states)) {
    const file = join(folder, `${name}.png`);
    run(program, ['bunny', '-o', file, ...look, ...options], { quiet: true });
    await photograph(`<!doctype html><body style="margin: 0; width: max-content"><img style="display: block" width="${size.width}" src="${inline(file)}">`,
                     join(root, `docs/wet-${name}.jpg`));
  }
});
