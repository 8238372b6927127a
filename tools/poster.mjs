// npm run poster: web/otter.webp, which the page shows until the otter is there: the model alone, as the first picture has it.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { buildNative } from './build.mjs';
import { webpOf, withTab } from './photograph.mjs';
import { command, root, run, say } from './process.mjs';
import { needs, setUp } from './setup.mjs';

const side = 900, quality = 0.72;

await command(async () => {
  setUp({ packages: [needs.headless, needs.browser], npm: true });
  const program = await buildNative('wet-fur-render'), file = join(root, 'build/poster.png');
  mkdirSync(join(root, 'build'), { recursive: true });
  run(program, ['otter', '-o', file, '--size', `${side}x${side}`, '--transparent', '--behaviour', 'none'], { quiet: true });
  const bytes = await withTab((tab) => webpOf(tab, [file], { quality }));
  writeFileSync(join(root, 'web/otter.webp'), bytes);
  say(`${readFileSync(file).length} bytes as PNG, ${bytes.length} as WebP`);
});
