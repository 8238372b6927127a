// The scenes that ship: files that any glTF viewer opens, under the names that the page offers.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import validator from 'gltf-validator';
import { root } from '../../tools/process.mjs';
import { scenes } from '../../assets/scenes/scenes.mjs';
import { dist } from '../../tools/site.mjs';
import { sceneNames } from '../../web/models.js';

const names = scenes.map(({ name }) => name);
const fileOf = (name) => readFileSync(join(dist, `models/${name}.glb`));

test('page and editor offer every scene by the same label, and nothing else as one', () => {
  assert.deepEqual([...sceneNames], names);
  const [, group] = /<optgroup label="Scenes">(.*?)<\/optgroup>/s.exec(readFileSync(join(dist, 'index.html'), 'utf8'));
  const onPage = [...group.matchAll(/value="([^"]+)">([^<]+)</g)].map(([, name, label]) => [name, label]);
  assert.deepEqual(onPage.map(([name]) => name), names);
  const [, table] = /ShippedScene kScenes\[\] = \{(.*?)\n\};/s.exec(readFileSync(join(root, 'src/editor/Editor.cpp'), 'utf8'));
  assert.deepEqual([...table.matchAll(/\{"([^"]+)", "([^"]+)"\}/g)].map(([, name, label]) => [name, label]), onPage);
});

for (const name of names) {
  test(`${name} is sound glTF, and is read without a warning`, async () => {
    const { issues } = await validator.validateBytes(new Uint8Array(fileOf(name)));
    const serious = issues.messages.filter(({ severity }) => severity < 2);
    assert.deepEqual(serious, []);
    const { loadCore } = await import(pathToFileURL(join(dist, 'core.js')).href);
    const core = await loadCore(), read = () => core.importModel(fileOf(name), { name: `${name}.glb` });
    // Of those the core says whose they are; tests/native/hairscenes.test.mjs reads them.
    if (name.startsWith('hair-')) return assert.throws(read, /long hair/);
    const model = read();
    assert.deepEqual([...model.warnings], []);
    assert.ok(model.hasTexcoords);
  });
}
