// What a visitor downloads: for the viewer, without the editor and the models; and for the page with its first model.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { dirname, join, normalize } from 'node:path';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';
import { dist } from '../../tools/site.mjs';

// Fur round hard edges took 8 KB of these; the way back to former models, painted coats, picking the coat's outside, the camera's
// attributes and pictures refined in bands another 10; strands that brushes have shaped, light rigs and water that looks like it
// another 4, of which tooltips that only the editor shows gave 2 back. Drawing long hair is 13; all that grows and moves it is in a
// program of its own, which only models with hair fetch. The technique of the papers, shells and equations as printed, took 4;
// a free camera, a comb for all fur, and parts of the picture that can be hidden 2.5;
// several materials, furry and bare, 10, and the question what a picture is 1, which is fetched when one is dropped;
// four whole coats, with coats and colour maps from files for each type, 10; animals that move by themselves 9, pictures that are
// gathered from samples 3; saved coats, the skin's picture, markings and bare parts that stay dry, 4; locks of soaked fur, shells for
// slender bodies and pictures by two sets of coordinates, 4. What reads formats beside glTF is in the larger program: 13 less; models in
// pieces 3; how a coat lies, wet locks and what finds dry patches 10; beads of water
// and a coat's room beside creases 2. Functions that are alike lie together and are inlined last: 15 less. Soaked fur near to the eye 1, water that
// knows no charts 2. Wet fur that comes to rest and keeps its colour 1, locks of half-wet
// fur 0.4; two passes of wasm-opt and hard edges without inlining 1.3 less.
const budgetBytes = 330 * 1024;

// The scripts that `entry` imports, at once or later, but for the editor's and those of long hair.
function scriptsFrom(entry, seen = new Set()) {
  if (seen.has(entry) || /editor|wet-fur-hair|\.d\.ts$/.test(entry)) return seen;
  assert.ok(existsSync(join(dist, entry)), entry);
  seen.add(entry);
  for (const [, name] of readFileSync(join(dist, entry), 'utf8').matchAll(/(?:from|import)\s*\(?\s*["'`](\.[^"'`]+)["'`]/g)) {
    scriptsFrom(normalize(join(dirname(entry), name)), seen);
  }
  return seen;
}

test('the viewer downloads at most 330 KB, gzipped', (t) => {
  const files = [...new Set(['index.js', 'element.js'].flatMap((entry) => [...scriptsFrom(entry)])), 'wet-fur.wasm'];
  const sizes = files.map((name) => [name, gzipSync(readFileSync(join(dist, name)), { level: 9 }).length]);
  const total = sizes.reduce((sum, [, size]) => sum + size, 0);
  t.diagnostic(`${(total / 1024).toFixed(1)} KB: ${sizes.map(([name, size]) => `${name} ${(size / 1024).toFixed(1)}`).join(', ')}`);
  assert.ok(files.includes('wet-fur.mjs'), 'the closure of the entries reaches the program');
  assert.ok(total <= budgetBytes, `${total} bytes`);
});

test('the page downloads at most 1.3 MB, gzipped, until the otter is there', (t) => {
  const files = [...scriptsFrom('page.js'), 'index.html', 'page.css', 'icon.svg', 'chevron.svg', 'otter.webp', 'wet-fur.wasm', 'models/otter.glb'];
  const sizes = [...new Set(files)].map((name) => [name, gzipSync(readFileSync(join(dist, name)), { level: 9 }).length]);
  const total = sizes.reduce((sum, [, size]) => sum + size, 0);
  t.diagnostic(`${(total / 1024).toFixed(1)} KB: ${sizes.map(([name, size]) => `${name} ${(size / 1024).toFixed(1)}`).join(', ')}`);
  assert.ok(total <= 1.3e6, `${total} bytes`);
});

test('the companions download at most 16 KB, gzipped', (t) => {
  const bytes = gzipSync(readFileSync(join(dist, 'companions.js')), { level: 9 }).length;
  t.diagnostic(`${(bytes / 1024).toFixed(1)} KB`);
  assert.ok(bytes <= 16 * 1024, `${bytes} bytes`);
});
