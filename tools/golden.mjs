// npm run golden [-- name...]: draws the pictures of tests/golden anew, all or those named, and puts old, new and
// difference side by side into build/golden/sheet.jpg. Look at it before the new ones are committed.
// npm run golden -- --tolerances: after the page has drawn them too (node --test tests/web/golden.test.mjs), twice what it
// was apart becomes what may be. For when rasterisers differ more than before and that is as it should be.
import { existsSync, mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { availableParallelism, tmpdir } from 'node:os';
import { join } from 'node:path';
import { buildNative } from './build.mjs';
import { inline, photograph } from './photograph.mjs';
import { command, root, say, Stop } from './process.mjs';
import { needs, setUp } from './setup.mjs';

const amplified = 8;

/** How far each channel has moved, from black, `amplified` times. */
function differenceOf({ width, height, data }, other) {
  const shown = data.map((value, i) => (i % 4 === 3 ? 255 : Math.min(255, amplified * Math.abs(value - other.data[i]))));
  return { width, height, data: Buffer.from(shown) };
}

async function remake(golden, scene, scratch) {
  const drawn = await golden.drawNatively(scene);
  const shown = (name) => join(scratch, `${scene.name}-${name}.png`);
  const old = existsSync(scene.picture) ? golden.readPicture(scene) : undefined;
  if (old) {
    golden.writePicture(shown('old'), old);
    golden.writePicture(shown('difference'), differenceOf(drawn, old));
  }
  golden.writePicture(scene.picture, drawn);
  const measured = old && golden.distance(old, drawn);
  return { scene, measured, wrong: measured ? golden.excess(scene, measured) : 'new', images: [shown('old'), scene.picture, shown('difference')] };
}

const page = (rows) => `<!doctype html><style>
  body { margin: 0; padding: 12px; display: grid; grid-template-columns: repeat(2, max-content); gap: 12px 24px;
         font: 13px Karla, sans-serif; background: #f6f3ee; color: #2b2622; width: max-content }
  figure { margin: 0; width: 678px } img { width: 224px; height: 168px; margin-right: 2px; background: #ddd }
  .other { outline: 3px solid #c02818 }
</style>${rows.map(({ scene, text, wrong, images }) => `<figure class="${wrong ? 'other' : ''}">${images
    .map((file) => (existsSync(file) ? `<img src="${inline(file)}">` : '<img>')).join('')}
  <figcaption><b>${scene.name}</b> ${text}<br>${scene.guards}</figcaption></figure>`).join('')}`;

await command(async () => {
  if (process.argv[2] === '--tolerances') {
    const { renewTolerance, scenes } = await import('../tests/golden/golden.mjs');
    scenes.forEach(renewTolerance);
    return;
  }
  setUp({ packages: [needs.headless, needs.browser], npm: true });
  await buildNative('wet-fur-render');
  const golden = await import('../tests/golden/golden.mjs');  // after npm
  const names = process.argv.slice(2), unknown = names.find((name) => !golden.scenes.some((scene) => scene.name === name));
  if (unknown) throw new Stop(`there is no golden scene ${unknown}`);
  const waiting = golden.scenes.filter(({ name }) => !names.length || names.includes(name)), rows = [], failures = [];
  const scratch = mkdtempSync(join(tmpdir(), 'wet-fur-'));
  try {
    await Promise.all(Array.from({ length: availableParallelism() }, async () => {
      for (let scene; (scene = waiting.shift());)
        await remake(golden, scene, scratch).then((row) => rows.push(row), (error) => failures.push(error.message));
    }));
    rows.sort((a, b) => (a.scene.name < b.scene.name ? -1 : 1));
    for (const row of rows) {
      row.text = row.measured ? golden.inWords(row.measured) : 'new';
      say(`${row.wrong ? 'OTHER ' : 'same  '} ${row.scene.name}: ${row.text}`);
    }
    const sheet = join(root, 'build/golden/sheet.jpg');
    mkdirSync(join(root, 'build/golden'), { recursive: true });
    await photograph(page(rows), sheet);
    if (failures.length) throw new Stop(failures.join('\n'));
    say(`look at ${sheet}: old, new, difference times ${amplified}`);
  } finally {
    rmSync(scratch, { recursive: true });
  }
});
