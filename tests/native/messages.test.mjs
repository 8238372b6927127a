// What the programs say when they cannot do what was asked, and where they say it.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { buildFolder } from '../../tools/cmake.mjs';

const folder = buildFolder('native-release');
const run = (program, ...args) => spawnSync(join(folder, program), args, { encoding: 'utf8' });

test('every program lists its options when asked', () => {
  for (const program of ['wet-fur', 'wet-fur-render', 'wet-fur-compare'])
    for (const args of [['--help'], ['-h'], ['bunny', '--help']]) {
      const { status, stdout, stderr } = run(program, ...args);
      assert.deepEqual([status, stderr], [0, ''], `${program} ${args}`);
      assert.match(stdout, new RegExp(`^usage: ${program} `));
    }
});

test('an option that cannot be read is named in one line', () => {
  const { status, stderr } = run('wet-fur-render', '-o', 'x.png', '--sise', '4x4');
  assert.equal(status, 2);
  assert.match(stderr, /^.*--sise.*\n--help lists the options\n$/);
});

test('a value stands behind its option or, after =, in one word with it; only options that have one take it', () => {
  const scratch = mkdtempSync(join(tmpdir(), 'wet-fur-'));
  try {
    const out = join(scratch, 'x.png');
    const common = ['plane', '-o', out, '--layers', '4'];
    const split = run('wet-fur-render', ...common, '--size', '24x16', '--camera', '-0.6,0.4,3'), apart = readFileSync(out);
    const joined = run('wet-fur-render', ...common, '--size=24x16', '--camera=-0.6,0.4,3'), together = readFileSync(out);
    assert.deepEqual([split.status, joined.status], [0, 0], split.stderr + joined.stderr);
    assert.deepEqual(together, apart);
    for (const [args, message] of [
      [['--transparent=0'], '--transparent: it takes no value'], [['--camera'], '--camera: a value is missing'],
      [['--sise=4x4'], /--sise/], [['--size='], /--size/],
    ]) {
      const { status, stderr } = run('wet-fur-render', ...common, ...args);
      assert.equal(status, 2, stderr);
      assert.match(stderr, message instanceof RegExp ? message : new RegExp(`^${message}\\n`));
    }
  } finally {
    rmSync(scratch, { recursive: true });
  }
});

test('a file that cannot be shown is named with the reason, and nothing else', () => {
  const scratch = mkdtempSync(join(tmpdir(), 'wet-fur-'));
  try {
    const file = (name, text) => {
      writeFileSync(join(scratch, name), text);
      return join(scratch, name);
    };
    for (const [model, message] of [
      [join(scratch, 'away.glb'), /^\S*away\.glb: No such file or directory\n$/],
      [file('empty.glb', ''), /^empty\.glb: the file is empty\n$/],
      [file('text.glb', 'a letter'), /^text\.glb: this is neither a \.glb nor a \.gltf\n$/],
    ]) {
      const { status, stderr } = run('wet-fur-render', model, '-o', join(scratch, 'x.png'));
      assert.equal(status, 1);
      assert.match(stderr, message);
    }
  } finally {
    rmSync(scratch, { recursive: true });
  }
});
