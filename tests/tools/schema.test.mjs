// Holds what WETFUR_fur.schema.json says of limits to the code that reads such files.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { root } from '../../tools/process.mjs';

const { properties } = JSON.parse(readFileSync(join(root, 'src/scene/WETFUR_fur.schema.json'), 'utf8'));

/** A constant of a source file, as a number. */
function constant(file, name) {
  const found = readFileSync(join(root, file), 'utf8').match(new RegExp(`\\b${name} = ([\\d.e']+)`));
  assert.ok(found, `${file} has no ${name}`);
  return Number(found[1].replaceAll("'", ''));
}
const ofMaps = (name) => constant('src/groom/Groom.h', name);

test('maps have the sizes that are read', () => {
  const scalp = properties.hair.properties.scalps.items.properties;
  for (const map of [properties.groom.properties, scalp.map.properties]) {
    assert.equal(map.size.minimum, ofMaps('kLeastSize'));
    assert.equal(map.size.maximum, ofMaps('kMostSize'));
  }
});

test('of hair there is as much as is read', () => {
  const { scalps, bodies } = properties.hair.properties, { nodes, positions, flags } = scalps.items.properties.guides.properties;
  assert.equal(scalps.maxItems, constant('src/hair/Scalp.h', 'kMostScalps'));
  assert.equal(nodes.minimum, constant('src/hair/Guides.h', 'kLeastNodes'));
  assert.equal(nodes.maximum, constant('src/hair/Guides.h', 'kMostNodes'));
  assert.match(flags.description, new RegExp(`of up to ${constant('src/hair/Guides.h', 'kMostGuides')}\\.`));
  assert.match(positions.description, new RegExp(`At most ${constant('src/hair/Guides.h', 'kFarthestNode')} bounding radii`));
  assert.match(bodies.description, new RegExp(`up to ${constant('src/hair/Body.h', 'kMostBodies')} spheres`));
  assert.match(bodies.description, new RegExp(`within ${constant('src/scene/import/GltfHair.cpp', 'kMostBody')} bounding radii`));
});
