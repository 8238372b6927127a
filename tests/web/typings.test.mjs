// The typings: a strict program compiles against them, and they list every setting as the program has it.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { dist, root } from './support.mjs';

for (const [folder, what] of [['types', 'a strict TypeScript program compiles'], ['types/templates', 'our tags in JSX of React and in templates of Vue are checked']]) {
  test(`${what} against the typings`, () => {
    const tsc = createRequire(import.meta.url).resolve('typescript/bin/tsc');
    const { status, stdout } = spawnSync(process.execPath, [tsc, '-p', join(root, 'tests/web', folder)], { encoding: 'utf8' });
    assert.equal(status, 0, stdout);
  });
}

test('the typings list the fields of the settings table, all and no others', async () => {
  const { loadCore } = await import(pathToFileURL(join(dist, 'core.js')).href);
  const { settingsTable } = await loadCore();
  const text = readFileSync(join(dist, 'types/tables.d.ts'), 'utf8');
  const block = /export interface FurSettings \{([\s\S]*?)\n\}/.exec(text)[1];
  const types = { float: 'number', int: 'number', bool: 'boolean', color: 'Color' };
  // A choice has a type of its own that lists the options.
  const choiceType = ({ name, options }) => {
    const type = /^type[2-4]$/.test(name) ? 'FurType' : name[0].toUpperCase() + name.slice(1);
    const union = new RegExp(`export type ${type} = ([^;]+);`).exec(text);
    assert.deepEqual(union?.[1].split('|').map((option) => option.trim().slice(1, -1)), options, type);
    return type;
  };
  const listed = Object.fromEntries([...block.matchAll(/^ {2}(\w+): (\w+);/gm)].map(([, name, type]) => [name, type]));
  assert.deepEqual(listed, Object.fromEntries(settingsTable.map((field) => [field.name, types[field.type] ?? choiceType(field)])));
});
