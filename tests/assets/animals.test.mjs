// The animals that ship: files of assets/, made by tools/assets.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { describe, test } from 'node:test';
import validator from 'gltf-validator';
import { animals } from '../../tools/assets/animals.mjs';
import { bunnyFile } from '../../tools/assets/bunny.mjs';
import { readGlb } from '../../tools/assets/glb.mjs';
import { unpackBits } from '../../tools/assets/paint.mjs';
import { far } from '../../tools/assets/vectors.mjs';
import { buildFolder } from '../../tools/cmake.mjs';
import { root } from '../../tools/process.mjs';

const { PNG } = createRequire(import.meta.url)('pngjs');
const program = process.env.FUR_MAKE_ASSETS ?? join(buildFolder('native-release'), 'wet-fur-make-assets');
const both = (names) => names.flatMap((name) => [`${name}L`, `${name}R`]);
const joints = ['root', 'hips', 'spine1', 'spine2', 'chest', 'neck', 'head', 'jaw', ...both(['ear', 'eye', 'lidUpper', 'lidLower', 'upperArm', 'foreArm', 'hand', 'thigh', 'shin', 'foot'])];
const tail = (count) => Array.from({ length: count }, (_, i) => `tail${i + 1}`);
const layers = ['breathe', 'blink', 'squint', 'earFlickL', 'earFlickR', 'tailSway', 'leanL', 'leanR'];
const expected = {
  otter: {
    materials: ['fur', 'eye', 'nose', 'mouth', 'claws', 'pads', 'lids', 'innerEar'], ownJoints: tail(6), loops: ['stand', 'sit', 'walk', 'swim', 'breathe', 'tailSway'], once: ['groom', 'yawn', 'shake'],
  },
  pony: {
    materials: ['fur', 'eye', 'nose', 'mouth', 'hooves', 'lids', 'innerEar'], ownJoints: ['neck1', ...both(['cannonF', 'cannonH']), ...tail(3)],
    loops: ['stand', 'walk', 'canter', 'breathe', 'tailSway'], once: ['toss', 'shake'],
  },
};
const inFours = (list, width = 4) => Array.from({ length: list.length / width }, (_, i) => list.slice(width * i, width * (i + 1)));

for (const { name, file } of animals) describe(name, () => {
  const bytes = readFileSync(join(root, `assets/${name}.glb`)), glb = readGlb(bytes), { json } = glb, fur = json.extensions.WETFUR_fur;
  const primitives = json.meshes[0].primitives, { materials, ownJoints, loops, once } = expected[name];
  // The values of a channel's first and last key.
  const ends = ({ samplers, channels }) => channels.map(({ sampler, target }) => {
    const values = inFours(glb.numbers(samplers[sampler].output), target.path === 'rotation' ? 4 : 3);
    return { first: values[0], last: values.at(-1), rest: target.path === 'rotation' ? [0, 0, 0, 32767] : json.nodes[target.node].translation, what: `${json.nodes[target.node].name} ${target.path}` };
  });
  const of = (animation) => json.animations.find((one) => one.name === animation);
  const same = (a, b, tolerance, what) => {
    const off = a.findIndex((x, i) => !(Math.abs(x - b[i]) <= tolerance));
    assert.ok(off < 0, `${what}: number ${off} is ${a[off]} and ${b[off]}`);
  };

  test('it is sound glTF', async () => {
    const { issues } = await validator.validateBytes(new Uint8Array(bytes));
    assert.deepEqual(issues.messages.filter(({ severity }) => severity < 2), []);
  });

  test('it is light enough for a page: 8 to 25 thousand triangles, 1.2 MB', () => {
    const triangles = primitives.reduce((sum, { indices }) => sum + json.accessors[indices].count / 3, 0);
    assert.ok(triangles >= 8000 && triangles <= 25000, `${triangles} triangles`);
    assert.ok(bytes.length <= 1.2e6, `${bytes.length} bytes`);
  });

  test('its materials have the names that programs look for, and all but the fur are bare', () => {
    assert.deepEqual(json.materials.map((material) => material.name), materials);
    assert.deepEqual(fur.bare.map((i) => json.materials[i].name), materials.filter((one) => one !== 'fur'));
  });

  test('its joints have the names that programs look for, and none is turned at rest', () => {
    const names = json.skins[0].joints.map((i) => json.nodes[i].name);
    for (const joint of [...joints, ...ownJoints]) assert.ok(names.includes(joint), joint);
    for (const i of json.skins[0].joints) assert.deepEqual([json.nodes[i].rotation, json.nodes[i].scale, json.nodes[i].matrix], [undefined, undefined, undefined]);
  });

  test('the weights of each vertex add up to 1', () => {
    for (const { attributes } of primitives)
      for (const weights of inFours(glb.numbers(attributes.WEIGHTS_0))) assert.equal(weights.reduce((a, b) => a + b), 255);
  });

  test('animations that go on end as they begin', () => {
    for (const animation of loops) for (const { first, last, what } of ends(of(animation))) same(first, last, 1e-6, `${animation}, ${what}`);
  });

  test('layers begin and end at rest', () => {
    // A quaternion of shorts: 1e-3 is a tenth of a degree.
    for (const animation of layers) for (const { first, last, rest, what } of ends(of(animation)))
      for (const values of [first, last]) same(values, rest, rest.length === 4 ? 33 : 1e-4, `${animation}, ${what}`);
  });

  test('what is done once ends as it begins', () => {
    for (const animation of once) for (const { first, last, what } of ends(of(animation))) same(first, last, first.length === 4 ? 33 : 1e-3, `${animation}, ${what}`);
  });

  test('its code makes the same file', () => {
    const again = readGlb(file(program).file);
    const shape = ({ json: { accessors, bufferViews, buffers, ...rest } }) => ({ ...rest, accessors: accessors.map(({ min, max, ...accessor }) => accessor) });
    assert.deepEqual(shape(again), shape(glb));
    // Sines and exponentials of other versions of Node may differ in their last digit: files are rounded to 5e-4, bytes to 1.
    json.accessors.forEach((accessor, i) => {
      const tolerance = accessor.componentType === 5126 ? 2e-3 : 2;
      same(again.numbers(i), glb.numbers(i), tolerance, `accessor ${i}`);
    });
    json.images.forEach(({ bufferView }, i) => {
      const [a, b] = [again, glb].map((one) => PNG.sync.read(Buffer.from(one.view(bufferView))).data);
      assert.equal(a.length, b.length);
      assert.ok(a.every((value, k) => Math.abs(value - b[k]) <= 2), `picture ${i}`);
    });
    assert.deepEqual(again.view(again.json.extensions.WETFUR_fur.groom.bufferView), glb.view(fur.groom.bufferView));
  });
});

describe('bunny', () => {
  const bytes = bunnyFile(program, createRequire(import.meta.url)('bunny')), glb = readGlb(bytes), { json, view, numbers } = glb, fur = json.extensions.WETFUR_fur;
  const [skin, eyes, lids] = json.meshes[0].primitives;
  const placesOf = ({ attributes }) => inFours(numbers(attributes.POSITION), 3);

  test('it is sound glTF of at most 25 thousand triangles, with eyes and lids that are bare', async () => {
    const { issues } = await validator.validateBytes(new Uint8Array(bytes));
    assert.deepEqual(issues.messages.filter(({ severity }) => severity < 2), []);
    assert.ok([skin, eyes, lids].reduce((sum, { indices }) => sum + json.accessors[indices].count / 3, 0) <= 25000);
    assert.deepEqual(json.materials.map(({ name }) => name), ['fur', 'eye', 'lids']);
    assert.deepEqual(fur.bare, [1, 2]);
  });

  test('an eye looks out on either side of its head, half in and half out of the skin', () => {
    const places = placesOf(eyes), halves = [places.slice(0, places.length / 2), places.slice(places.length / 2)];
    const middles = halves.map((half) => [0, 1, 2].map((k) => half.reduce((sum, p) => sum + p[k], 0) / half.length));
    assert.ok(far(...middles) > 0.3, `${far(...middles)}`);
    const around = placesOf(skin);
    for (const middle of middles) {
      const nearest = Math.min(...around.map((p) => far(p, middle)));
      assert.ok(nearest < 0.05 && nearest > 0.01, `${nearest}`);
    }
  });

  test('no fur grows on the skin in which its eyes are', () => {
    const { size, bufferView } = fur.groom, lengths = unpackBits(view(bufferView), size * size), uv = inFours(numbers(skin.attributes.TEXCOORD_0), 2), eyePlaces = placesOf(eyes);
    const under = placesOf(skin).flatMap((p, v) => (eyePlaces.some((q) => far(p, q) < 0.02) ? [v] : []));
    assert.ok(under.length > 8);
    for (const v of under) {
      const [x, y] = uv[v].map((t) => Math.min(size - 1, Math.floor((t / 65535) * size)));
      assert.ok(lengths[x + size * y] < 0.1 * 255, `${lengths[x + size * y]}`);
    }
  });
});
