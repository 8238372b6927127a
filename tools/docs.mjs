// npm run docs: the pages of docs/ in dist/docs, and the still pictures that they show, as far as what those are made of has changed
// (npm run docs -- --all: every one of them, as when the shaders have changed).
import { existsSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { buildNative, buildSite } from './build.mjs';
import { drawn, drawPictures, outdated, pictures } from './docs/pictures.mjs';
import { command, say } from './process.mjs';
import { needs, setUp } from './setup.mjs';
import { dist } from './site.mjs';

/** @param {() => Promise<string>} renderer gives the program that draws */
export async function makeDocs(renderer, { all = false } = {}) {
  const { buildDocs } = await import('./docs/build.mjs');  // not at the top: its packages may have to be installed first
  if (all) for (const used of [join(pictures, 'inputs.json'), drawn]) rmSync(used, { recursive: true, force: true });
  const wanted = await buildDocs(dist);
  const due = outdated(wanted);
  if (due.length === 0) return 0;
  say(`${due.length} pictures to draw`);
  const count = await drawPictures(wanted, await renderer());
  await buildDocs(dist);
  return count;
}

if (process.argv[1]?.endsWith('docs.mjs')) {
  await command(async () => {
    setUp({ packages: [needs.browser], npm: true });
    if (!existsSync(join(dist, 'core.js'))) await buildSite();
    await makeDocs(async () => {
      setUp({ packages: [needs.headless] });
      return buildNative('wet-fur-render');
    }, { all: process.argv.includes('--all') });
    say(`done: ${join(dist, 'docs/index.html')}`);
  });
}
