// wet-fur/core in plain Node: no browser, no DOM.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { PNG } from 'pngjs';
import { badModels, hugeImage, pngHeader, tetrahedron, withImage } from './glb.mjs';
import { dist } from './support.mjs';

const load = (name) => import(pathToFileURL(join(dist, name)).href);
const { loadCore, FurError } = await load('core.js');
const core = await loadCore();

test('every entry of the package can be imported without a DOM', async () => {
  const { createWetFur, isSupported } = await load('index.js');
  assert.equal(typeof createWetFur, 'function');
  assert.equal(isSupported(), false);
  await load('element.js');
  await load('editor.js');
});

test('a fur volume has every channel with its type and size', () => {
  const v = core.generateFur({ size: 64, layers: 8, density: 0.8, seed: 5 });
  const texels = 64 * 64 * 8;
  for (const [name, Type, each] of [['coverage', Uint8Array, 1], ['dominance', Uint8Array, 1], ['variance', Uint8Array, 1],
    ['tangent', Float32Array, 3], ['offset', Float32Array, 2], ['strandId', Uint16Array, 1]]) {
    assert.ok(v[name] instanceof Type, name);
    assert.equal(v[name].length, texels * each, name);
  }
  assert.ok(v.strandCount > 10 && v.density > 0 && v.density < 1);
  assert.equal(v.fin.coverage.length, v.fin.rows * v.fin.columns);
  assert.equal(Math.max(...v.strandId) <= v.strandCount, true);
  // Stored as bytes of 1/127, so a unit vector is unit to within half a step a component.
  const at = 3 * v.coverage.indexOf(255);
  assert.ok(Math.abs(Math.hypot(v.tangent[at], v.tangent[at + 1], v.tangent[at + 2]) - 1) < 0.01);
});

test('the same seed grows the same fur, another seed another', () => {
  const grow = (seed) => core.generateFur({ size: 64, layers: 4, seed }).coverage;
  assert.deepEqual(grow(3), grow(3));
  assert.notDeepEqual(grow(3), grow(4));
});

test('density 0 is bald, and a parameter that does not exist is refused', () => {
  assert.equal(core.generateFur({ size: 64, layers: 4, density: 0 }).strandCount, 0);
  assert.throws(() => core.generateFur({ densty: 1 }), /densty/);
});

test('a droplet wets its own texels, and drying takes only the water', () => {
  const mask = core.createWetnessMask(64);
  const dry = mask.hash();
  mask.addDroplet({ u: 0.5, v: 0.25, radius: 0.1, wetness: 0.6 });
  assert.equal(mask.data.length, 64 * 64 * 4);
  const wet = mask.at(0.5, 0.25);
  assert.ok(Math.abs(wet.wetness - 0.6) < 1e-6);  // a float
  assert.ok(Math.abs(wet.centreU - 0.5) < 1e-6 && Math.abs(wet.centreV - 0.25) < 1e-6);
  assert.equal(mask.at(0.5, 0.5).wetness, 0);
  mask.dry(2, { rate: 0.1 });
  const later = mask.at(0.5, 0.25);
  assert.ok(Math.abs(later.wetness - (1.75 - 1.15 * Math.exp(0.16))) < 1e-6);  // as wet/Drying.h says: a little more than 0.4
  assert.deepEqual([later.centreU, later.centreV, later.radius], [wet.centreU, wet.centreV, wet.radius]);
  mask.dry(100, { rate: 0.1 });
  assert.equal(mask.hash(), dry);
  mask.dispose();
  assert.throws(() => mask.hash(), /disposed/);
});

test('the same strokes give the same hash', () => {
  const hash = () => {
    const mask = core.createWetnessMask(128);
    for (let i = 0; i < 20; i++) mask.addDroplet({ u: (i * 0.37) % 1, v: (i * 0.61) % 1, radius: 0.04, wetness: 0.5 });
    return mask.hash();
  };
  assert.equal(hash(), hash());
  assert.match(hash(), /^[0-9a-f]{16}$/);
});

test('a model is read, and its size is in the units of the file', () => {
  const model = core.importModel(tetrahedron().glb(), { name: 'four.glb' });
  assert.equal(model.triangleCount, 4);
  assert.equal(model.hasTexcoords, false);
  assert.deepEqual(model.bounds, { low: [-1, -1, -1], high: [1, 1, 1] });
  assert.ok(core.importModel(readFileSync(join(dist, 'models/bunny.glb')), { name: 'bunny.glb' }).hasTexcoords);
});

test('.obj and .fo are read too, known by their names or without one by their content', () => {
  const encode = (text) => new TextEncoder().encode(text);
  const obj = encode('v 0 0 0\nv 2 0 0\nv 0 2 0\nv 2 2 0\nf 1 2 4 3\n');
  const fo = encode('v 0 0 0 0 0 1 1 0\nv 1 0 0 0 0 1 0.5 0\nv 0 1 0 0 0 1 1 0\nt 0 0 0 0\np 1/1 2/1 3/1\n');
  assert.equal(core.importModel(obj, { name: 'a.obj' }).triangleCount, 2);
  assert.equal(core.importModel(obj).vertexCount, 4);
  const model = core.importModel(fo);
  assert.equal(model.hasTexcoords, true);
  assert.deepEqual(model.warnings, []);
  assert.throws(() => core.importModel(encode('v 0 0 nan'), { name: 'a.obj' }), (error) => {
    assert.equal(error.code, 'bad-file');
    assert.equal(error.message, 'a.obj, line 1: the z of a vertex is "nan", which is not a number');
    return true;
  });
});

test('a .gltf takes its buffer from the files beside it', () => {
  const { json, binary } = tetrahedron({ uri: 'four.bin' });
  const text = Buffer.from(JSON.stringify(json));
  assert.equal(core.importModel(text, { name: 'four.gltf', files: { 'four.bin': binary } }).triangleCount, 4);
  assert.throws(() => core.importModel(text, { name: 'four.gltf' }), /four\.bin/);
});

test('a texture is decoded without a browser', () => {
  const png = new PNG({ width: 2, height: 1 });
  png.data.set([1, 2, 3, 255, 250, 251, 252, 128]);
  const { image } = core.importModel(withImage(PNG.sync.write(png)), { name: 'textured.glb' });
  assert.deepEqual([image.mimeType, image.width, image.height], ['image/png', 2, 1]);
  assert.deepEqual({ ...core.decodeImage(image.bytes) }, { width: 2, height: 1, data: Uint8ClampedArray.from(png.data) });
  assert.equal(core.importModel(tetrahedron().glb()).image, null);
});

test('an image that is none, or too large, is a FurError', () => {
  for (const [bytes, code] of [[Buffer.from('RIFF????WEBP'), 'bad-file'], [pngHeader(2), 'bad-file'], [pngHeader(20000), 'too-large'], [Buffer.alloc(0), 'bad-file']])
    assert.throws(() => core.decodeImage(bytes), (error) => error instanceof FurError && error.code === code);
});

for (const [what, bytes] of Object.entries({ ...badModels, 'an image of 20,000 pixels': hugeImage })) {
  test(`${what} is a FurError that names the file, soon`, () => {
    const begun = process.cpuUsage();
    assert.throws(() => core.importModel(bytes, { name: 'spoilt.glb' }), (error) => {
      assert.ok(error instanceof FurError);
      assert.match(error.code, /^(bad-file|too-large)$/);
      assert.match(error.message, /spoilt\.glb/);
      return true;
    });
    // They take some tens of milliseconds; time of this process, so that a busy machine fails nothing.
    const { user, system } = process.cpuUsage(begun);
    assert.ok(user + system < 2e6);
  });
}

test('the formula sheet answers with the numbers of the papers', () => {
  const e = core.equations;
  const near = (a, b, tolerance = 1e-5) => assert.ok(Math.abs(a - b) < tolerance, `${a} is not ${b}`);  // floats inside
  near(e.clumpProfile(1, 0.7, 16), 1);
  near(e.clumpProfile(1 / 16, 0.7, 16), 0.3 / 16);
  near(e.clumpShift(1, 0.5, 16, 0.5), 1);
  near(e.clumpDisplacement(1, 0.5, 16, 0.5), 0.5);
  near(e.finOpacity(0, 0.2), 0.6);
  assert.equal(e.finOpacity(0.3, 1), 0);
  const light = { color: 0.4, specular: 0.5, nDotL: 0.5, cosine: 0.9, p: 40, h: 1, rho: 0, sigmaOcc: 0.6, sigmaWet: 0, sigmaSpec: 0.75 };
  near(e.printedLight(light), 0.4 * 0.5 + 0.5 * 0.9 ** 10);
  near(e.printedLight({ ...light, rho: 1 }), 0.4 * 0.5 + 0.5 * 0.9 ** 40);  // sigma_wet = 0: no darker but for the sharper highlight
  near(e.printedLight({ ...light, rho: 1, sigmaWet: 0.5, h: 0 }), 0.4 * 0.5 * (0.4 * 0.5 + 0.5 * 0.9 ** 40));
  near(e.wetSpecularExponent(24, 0, 0.5), 12);
  near(e.occlusionFactor(0, 0.6), 0.4);
  near(e.wetDarkening(1, 0.55), 0.45);
  near(e.strandThinning(0), 1 - 1 / 5.4);
  assert.equal(e.strandThinning(1.01), 0);
  near(e.strandThinning(1, 0), e.strandThinning(0));
  near(e.strandThinning(1, 1), 0);
  // d m (1 - 0.7 t), m = 1500 for a tile of 256 texels.
  assert.equal(e.strandCount(0.6, 0.4), 648);
  assert.equal(e.strandCount(0.6, 0.4, 512), 4 * 648);
  assert.equal(e.strandCount(0, 0.4), 0);
  assert.ok(e.strandRadius(1) > e.strandRadius(0));
  assert.equal(e.strandExists(0.5, 1, 0.8), true);
  assert.equal(e.strandExists(0.5, 0, 0.8), false);
  near(e.furShadow(0, 0.5, 1), 1);
  assert.deepEqual(e.arcBend(0, 1), [1, 0]);
  near(e.windBend(0, 1)[1], 0);
  near(e.kajiyaDiffuse([0, 1, 0], [1, 0, 0]), 1);
  near(e.kajiyaDiffuse([0, 1, 0], [0, 1, 0]), 0);
  near(e.kajiyaSpecular([0, 1, 0], [1, 0, 0], [1, 0, 0], 8), 1);
  near(e.marschnerM(0.1, 0.1, 0.2), 1 / (0.2 * Math.sqrt(2 * Math.PI)));
  // R straight back: ((eta - 1) / (eta + 1))^2 / 4.
  near(e.marschnerN(0, 0, 0, 1.55, 0.3), (0.55 / 2.55) ** 2 / 4);
  assert.ok(e.marschnerN(1, 0, Math.PI, 1.55, 0) > e.marschnerN(1, 0, Math.PI, 1.55, 0.5));
  near(e.transmittance(3, 0.5), Math.exp(-1.5));
  near(e.opacityLookup([0, 0.2, 0.6], 0.15, 0.1), 0.4);
  assert.deepEqual(e.verletStep([1, 2, 3], [0, 2, 4], [0, -8, 0], 0.5, 0.5), [1.5, 0, 2.5]);
  near(e.springStiffness(6, 0.5, 4, 2), 1.5);
  near(e.springStiffness(6, 0.5, 4, 3), 0.75);
  near(e.tiltStiffness(8, 2, 1), 8);
  near(e.tiltStiffness(8, 2, -1), 2);
});

test('the settings table has choices as a list, and bounds where they mean something', () => {
  const row = (name) => core.settingsTable.find((field) => field.name === name);
  assert.deepEqual(row('technique').options, ['march', 'shells']);
  assert.deepEqual([row('density').min, row('density').max, 'min' in row('fins')], [0, 1, false]);
});
