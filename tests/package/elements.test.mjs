// custom-elements.json: what editors and frameworks are told of our elements is what these have.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { root } from '../../tools/process.mjs';
import { dist } from '../../tools/site.mjs';

const { modules } = JSON.parse(readFileSync(join(dist, 'custom-elements.json'), 'utf8'));
const declarations = modules.flatMap(({ path, declarations: all }) => all.map((one) => ({ ...one, path })));
const classOf = async ({ path, name }) => (await import(pathToFileURL(join(dist, path)).href))[name];
const sorted = (names) => [...new Set(names)].sort();
const companionSources = readdirSync(join(root, 'web/companions')).map((name) => readFileSync(join(root, 'web/companions', name), 'utf8')).join('\n');
const elementSources = ['element.js', 'element-shadow.js'].map((name) => readFileSync(join(root, 'web', name), 'utf8')).join('\n');
const sourcesOf = ({ tagName }) => (tagName === 'wet-fur' ? elementSources : companionSources);
const found = (text, pattern) => sorted([...text.matchAll(pattern)].map(([, name]) => name));

test('every element is in it, with the attributes that it observes', async () => {
  const { WetFurElement, Companion, ...others } = { ...await import(pathToFileURL(join(dist, 'element.js')).href), ...await import(pathToFileURL(join(dist, 'companions.js')).href) };
  assert.ok(Companion && WetFurElement);
  assert.deepEqual(sorted(declarations.map(({ name }) => name)), sorted(['WetFurElement', ...Object.keys(others)]));
  for (const one of declarations) assert.deepEqual(sorted(one.attributes.map(({ name }) => name)), sorted((await classOf(one)).observedAttributes), one.tagName);
});

test('its members are those of the classes', async () => {
  for (const one of declarations) {
    const { prototype } = await classOf(one);
    for (const { kind, name } of one.members) {
      if (kind === 'method') assert.equal(typeof Object.getOwnPropertyDescriptor(prototype, name)?.value, 'function', `${one.tagName}: ${name}()`);
      else assert.ok(name in prototype, `${one.tagName}: ${name}`);
    }
  }
});

test('its parts, slots, events and CSS variables are those that the scripts have, all and no others', () => {
  const ofCompanions = declarations.filter(({ tagName }) => tagName !== 'wet-fur');
  const wetFur = declarations.find(({ tagName }) => tagName === 'wet-fur');
  const names = (all, key) => sorted(all.flatMap((one) => one[key].map(({ name }) => name)));
  for (const [all, text] of [[[wetFur], elementSources], [ofCompanions, companionSources]]) {
    // Of a side the name is a variable.
    assert.deepEqual(names(all, 'cssParts').filter((name) => !/^(before|after)$/.test(name)), found(text, /part: '([\w-]+)'/g));
    assert.deepEqual(names(all, 'cssProperties'), found(text, /var\((--wet-fur-[\w-]+)/g));
  }
  assert.deepEqual(names([wetFur], 'slots'), found(elementSources, /make\('slot', \{ name: '([\w-]+)'/g));
  assert.deepEqual(names(ofCompanions, 'events').filter((name) => name.includes('-') || name === 'divide'), found(companionSources, /new CustomEvent\('([\w-]+)'/g));
  for (const one of declarations) for (const { name } of one.cssParts) assert.match(sourcesOf(one), new RegExp(`part: '${name}'|'${name}'`), `${one.tagName}: ${name}`);
});
