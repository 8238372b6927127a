// Water in a link: what is wet comes back, and no text unfolds to more than its limit.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { deflateRawSync } from 'node:zlib';
import { mostUnpacked, unpackBytes } from '../../web/packed.js';
import { unpackStrokes } from '../../web/strokes.js';
import { mostUnpackedWater, packWater, unpackWater, waterSizes } from '../../web/packedwater.js';

const side = 256;

/** Bytes as FurApp.water has them, with these texels. */
function waterOf(texelAt, tail = [9, 8, 7]) {
  const texels = new Float32Array(4 * side * side);
  for (let i = 0; i < side * side; ++i) texels.set(texelAt(i % side, Math.floor(i / side)) ?? [], 4 * i);
  return new Uint8Array(Buffer.concat([Uint32Array.of(4, side * side), texels, Uint32Array.of(0)].map(({ buffer }) => Buffer.from(buffer)).concat(Buffer.from(tail))));
}
const texels = (water) => new Float32Array(water.slice(8, 8 + 16 * side * side).buffer);
const dry = waterOf(() => null);
// Two clumps, one of them half beside the atlas, and a gradient of wetness.
const drops = waterOf((x, y) => {
  if (Math.hypot(x - 100, y - 80) < 20) return [100.5 / side, 80.5 / side, 20 / side, 0.1 + y / 300];
  return x < 12 && y < 30 ? [-0.02, 0.05, 0.08, 0.9] : null;
});

test('what is wet comes back with its clumps, over what else there is of the water', async () => {
  const back = await unpackWater(await packWater(drops, 256), dry);
  assert.equal(back.length, dry.length + 4 * side * side, 'with a film');
  assert.deepEqual([...back.subarray(-3)], [9, 8, 7]);
  const [before, after] = [texels(drops), texels(back)];
  for (let i = 0; i < before.length; i += 4) {
    assert.equal(after[i + 3] > 0, before[i + 3] > 0);
    if (!(before[i + 3] > 0)) continue;
    for (const [k, off] of [[0, 0.001], [1, 0.001], [2, 0.05 * before[i + 2]], [3, 0.017]]) assert.ok(Math.abs(after[i + k] - before[i + k]) <= off, `${k}: ${after[i + k]} of ${before[i + k]}`);
  }
});

test('what stands on the fur comes back, too', async () => {
  const film = Float32Array.from({ length: side * side }, (_, i) => (i % side < 9 ? 0.25 : 0));
  const before = new Uint8Array(Buffer.concat([drops.subarray(0, 8 + 16 * side * side), new Uint8Array(Uint32Array.of(side * side).buffer), new Uint8Array(film.buffer), Buffer.from([9])]));
  const back = await unpackWater(await packWater(before, 256), dry);
  assert.deepEqual(new Float32Array(back.slice(12 + 16 * side * side, 12 + 20 * side * side).buffer), film);
});

test('a coarser one is smaller and as wet', async () => {
  const sum = (water) => texels(water).reduce((all, value, i) => all + (i % 4 === 3 ? value : 0), 0);
  const packed = await Promise.all(waterSizes.map((size) => packWater(drops, size)));
  assert.ok(packed[0].length > packed[1].length && packed[1].length > packed[2].length);
  for (const text of packed) assert.ok(Math.abs(sum(await unpackWater(text, dry)) - sum(drops)) < 0.05 * sum(drops));
});

const packedOf = (bytes) => deflateRawSync(bytes, { level: 9 }).toString('base64url');

test('a link of 8 KB never unfolds to more than its limit', async () => {
  const bomb = packedOf(Buffer.alloc(6 * 1024 * 1024));
  assert.ok(bomb.length < 8 * 1024);
  assert.ok(mostUnpackedWater < 1024 * 1024 && mostUnpacked <= 4 * 1024 * 1024);
  await assert.rejects(unpackWater(bomb, dry), /unfolds to more than/);
  await assert.rejects(unpackBytes(bomb), /unfolds to more than/);
});

test('strokes of a link never unfold to more than their limit, nor take longer to be painted again', async () => {
  await assert.rejects(unpackStrokes(packedOf(Buffer.alloc(6 * 1024 * 1024, ' '))), /unfolds to more than/);
  const long = [[['droplet', 1, 1, 1, 0, 0, 0], ...[60, 0, 0, 0, 100].map((value) => Array(400).fill(value))]];
  await assert.rejects(unpackStrokes(packedOf(Buffer.from(JSON.stringify(long)))), /too long/);
});

test('what packWater() did not make is refused', async () => {
  const head = (...bytes) => packedOf(Buffer.concat([Buffer.from(bytes), Buffer.alloc(5 * 64 * 64)]));
  for (const bad of ['', 'AAAA', '%', head(2, 6, 0, 0), head(1, 5, 0, 0), head(1, 40, 0, 0), head(1, 6, 255, 255), packedOf(Buffer.from([1, 6, 0, 0]))]) await assert.rejects(unpackWater(bad, dry), bad);
  const stray = Buffer.alloc(4 + 5 * 64 * 64, 0);
  stray.set([1, 6, 0, 0]);
  stray[4 + 17] = 3;  // a clump that the table lacks
  await assert.rejects(unpackWater(packedOf(stray), dry), /no such clump/);
});
