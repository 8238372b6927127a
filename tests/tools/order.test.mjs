// A program whose functions have another order is the same program, and packs better.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';
import { ordered } from '../../tools/order-functions.mjs';

const number = (value) => (value < 128 ? [value] : [(value & 127) | 128, ...number(value >> 7)]);
const signed = (value) => (value < 64 ? [value] : [(value & 127) | 128, ...signed(value >> 7)]);
const vector = (items) => [...number(items.length), ...items.flat()];
const text = (name) => vector([...Buffer.from(name)].map((byte) => [byte]));
const section = (id, bytes) => [id, ...number(bytes.length), ...bytes];
const body = (code) => { const all = [0, ...code, 0x0b]; return [...number(all.length), ...all]; };

const count = 800, kinds = 100;

/**
 * Functions of many kinds in turn, those of a kind alike but further apart than 32 KB: each calculates with what the one before it gives,
 * the first with the import. A table holds three, and one runs at the start and counts in a global.
 */
function program({ more = [] } = {}) {
  const operations = [0x6a, 0x6b, 0x73, 0x6c];  // + - xor *
  const stretch = (kind) => {
    let chance = kind + 1;
    return Array.from({ length: 100 }, () => {
      chance = (chance * 48271) % 0x7fffffff;
      return [0x41, ...signed(chance % 8000), operations[chance % operations.length]];
    }).flat();
  };
  const functions = Array.from({ length: count }, (_, i) => body([0x10, ...number(i), 0x41, ...signed(i), 0x6a, ...stretch(i % kinds)]));
  const counts = body([0x23, 0, 0x41, 1, 0x6a, 0x24, 0, ...more]), throughTable = body([0x41, 1, 0x11, 1, 0]);
  return Buffer.from([
    0, 0x61, 0x73, 0x6d, 1, 0, 0, 0,
    ...section(1, vector([[0x60, 0, 0], [0x60, 0, 1, 0x7f]])),
    ...section(2, vector([[...text('outside'), ...text('seed'), 0, 1]])),
    ...section(3, vector([...functions.map(() => [1]), [0], [1]])),
    ...section(4, vector([[0x70, 0, 3]])),
    ...section(6, vector([[0x7f, 1, 0x41, 11, 0x0b]])),
    ...section(7, vector([[...text('last'), 0, ...number(count)], [...text('through'), 0, ...number(count + 2)], [...text('count'), 3, 0], [...text('seventh'), 0, 7]])),
    ...section(8, number(count + 1)),
    ...section(9, vector([[0, 0x41, 0, 0x0b, ...vector([[1], number(count - 3), [2]])]])),
    ...section(10, vector([...functions, counts, throughTable])),
  ]);
}

const run = async (bytes) => {
  const { instance: { exports } } = await WebAssembly.instantiate(bytes, { outside: { seed: () => 5 } });
  return { last: exports.last(), through: exports.through(), seventh: exports.seventh(), count: exports.count.value };
};

test('functions in another order do what they did, called, through a table, exported and at the start', async () => {
  const before = program(), after = ordered(before);
  const results = await run(before);
  assert.equal(results.count, 12);
  assert.notEqual(after.compare(before), 0);
  assert.deepEqual(await run(after), results);
  assert.deepEqual(WebAssembly.Module.exports(new WebAssembly.Module(after)), WebAssembly.Module.exports(new WebAssembly.Module(before)));
});

test('a program whose repetitions lie far apart packs better when they are put together', () => {
  const [before, after] = [program(), ordered(program())].map((bytes) => gzipSync(bytes).length);
  // Each kind comes eight times, of which the functions with numbers below 128 stay where they are.
  assert.ok(after < before / 2, `${after} of ${before}`);
});

test('the same program comes out the same, and again of the result', () => {
  const once = ordered(program());
  assert.equal(once.compare(ordered(program())), 0);
  assert.ok(WebAssembly.validate(ordered(once)));
});

test('a program with what the tool does not know stays as it was, and that is said', () => {
  const folder = mkdtempSync(join(tmpdir(), 'wet-fur-'));
  try {
    for (const [what, bytes, reason] of [
      ['an operation', program({ more: [0x12, 0] }), /operation 18/],
      ['names', Buffer.concat([program(), Buffer.from(section(0, [...text('name'), 0, 0]))]), /names of functions/],
    ]) {
      const file = join(folder, 'program.wasm');
      writeFileSync(file, bytes);
      const { status, stdout } = spawnSync(process.execPath, [fileURLToPath(new URL('../../tools/order-functions.mjs', import.meta.url)), file], { encoding: 'utf8' });
      assert.equal(status, 0, what);
      assert.match(stdout, reason);
      assert.equal(readFileSync(file).compare(bytes), 0, what);
    }
  } finally {
    rmSync(folder, { recursive: true, force: true });
  }
});
