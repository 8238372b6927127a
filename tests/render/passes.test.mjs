// Holds the table of the frame in src/render/README.md to the tree and to the renderer.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { root } from '../../tools/process.mjs';

const render = join(root, 'src/render');
const rows = [...readFileSync(join(render, 'README.md'), 'utf8').matchAll(/^\| ([a-z ]+) \| `([a-z]+)` \|/gm)].map(([, name, folder]) => ({ name, folder }));

test('every pass has a folder, and every folder of a pass a row in the table of the frame', () => {
  const folders = readdirSync(join(render, 'passes'), { withFileTypes: true }).filter((entry) => entry.isDirectory()).map((entry) => entry.name);
  assert.deepEqual([...new Set(rows.map(({ folder }) => folder))].sort(), folders.sort());
});

test('the table lists the passes in the order in which the renderer draws them', () => {
  const text = readFileSync(join(render, 'Renderer.cpp'), 'utf8');
  const bodyOf = (name) => text.slice(text.indexOf(` Renderer::${name}(`)).split('\n}\n')[0];
  // What draws each pass, in the text of a frame with the functions that it calls put in their places.
  const frame = bodyOf('draw').replace('drawPasses(', bodyOf('drawFinal').replace('drawModel(', bodyOf('drawModel')));
  const calls = {
    'ground shadow': 'groundShadow_.update(', 'fur shadow': 'furShadow_.update(', ball: 'drawBall(', shells: 'shells_.draw(', fins: 'fins_.draw(',
    skin: 'drawSkin(', hair: 'hair_->draw(', whiskers: 'whiskers_.draw(', ground: 'ground_.draw(', background: 'drawBackground(', 'bare parts': 'drawBlended(', beads: 'beads_.draw(', drops: 'drops_.draw(', enlarge: 'small_.show(', gather: 'gather(',
  };
  const names = rows.map(({ name }) => name).filter((name) => name !== 'arrows' && name !== 'hair views');  // of views alone
  assert.deepEqual(names.toSorted(), Object.keys(calls).sort());
  const places = names.map((name) => frame.indexOf(calls[name]));
  places.forEach((place, i) => assert.ok(place > (places[i - 1] ?? 0), `${names[i]} is drawn after ${names[i - 1]}`));
});
