// Transparent pictures and turntables of the program without a window.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { PNG } from 'pngjs';
import { buildFolder } from '../../tools/cmake.mjs';

const program = join(buildFolder('native-release'), 'wet-fur-render');

/** Runs it in a folder of its own; what `look` is given reads its pictures. */
function inScratch(args, look) {
  const scratch = mkdtempSync(join(tmpdir(), 'wet-fur-'));
  try {
    const { status, stderr } = spawnSync(program, args, { cwd: scratch, encoding: 'utf8' });
    return look({ status, stderr, names: readdirSync(scratch).sort(), read: (name) => PNG.sync.read(readFileSync(join(scratch, name))) });
  } finally {
    rmSync(scratch, { recursive: true });
  }
}

const small = ['sphere', '--size', '96x72', '--layers', '8'];

test('a transparent picture has the model alone', () => {
  inScratch([...small, '-o', 'x.png', '--transparent'], ({ status, stderr, read }) => {
    assert.equal(status, 0, stderr);
    const { data, width } = read('x.png');
    const alpha = (x, y) => data[4 * (y * width + x) + 3];
    assert.deepEqual([alpha(0, 0), alpha(95, 71), alpha(48, 36)], [0, 0, 255]);
    assert.ok(data.some((value, i) => i % 4 === 3 && value > 0 && value < 255), 'strands at the outline are half there');
  });
});

test('a turntable is numbered pictures of which each is another and none is the first again', () => {
  inScratch(['bunny', '--size', '64x48', '--layers', '8', '--breath', '0', '-o', 'turn.png', '--turntable', '4'], ({ status, stderr, names, read }) => {
    assert.equal(status, 0, stderr);
    assert.deepEqual(names, [0, 1, 2, 3].map((i) => `turn-00${i}.png`));
    const pictures = names.map((name) => read(name).data.toString('base64'));
    assert.equal(new Set(pictures).size, 4);
  });
});

test('the other way round the pictures come in the other order', () => {
  const turn = (seconds) => inScratch(['bunny', '--size', '64x48', '--layers', '8', '--breath', '0', '-o', 'turn.png', '--turntable', '4', '--turn-seconds', seconds],
    ({ names, read }) => names.map((name) => read(name).data));
  const [right, left] = [turn('4'), turn('-4')];
  const apart = (a, b) => a.reduce((sum, value, i) => sum + Math.abs(value - b[i]), 0) / a.length;
  assert.ok(apart(right[1], left[3]) < 0.2 * apart(right[1], left[1]));
});

test('a number of pictures that makes no turn is refused in one line', () => {
  inScratch([...small, '-o', 'x.png', '--turntable', '1'], ({ status, stderr }) => {
    assert.equal(status, 2);
    assert.match(stderr, /^--turntable 1: expected a number from 2 to 3600\n/);
  });
});

// Rays that pass the head come into the coat of the back past its outside: a sickle of sky, of which one further shell leaves a tip.
test('most of the sky that is seen between the bunny\'s head and its back is gone in a picture of several samples', () => {
  const holesOf = (samples) => inScratch(['bunny', '--size', '960x780', '--camera=-0.6,0.2,2.2', '--preset', 'shortCat', '--wetness', '0.5', '--layers', '8', '--breath', '0',
    '--transparent', '-o', 'x.png', '--samples', `${samples}`], ({ status, stderr, read }) => {
    assert.equal(status, 0, stderr);
    const { data, width } = read('x.png');
    const isFur = (x, y) => data[4 * (y * width + x) + 3] > 200;
    const within = 40, [left, right, top, bottom] = [382, 495, 270, 367];  // where it is; elsewhere sky is seen past ears and feet
    const isHole = (x, y) => data[4 * (y * width + x) + 3] < 100 &&
      [[0, -1], [0, 1], [-1, 0], [1, 0]].every(([dx, dy]) => Array.from({ length: within }, (_, k) => isFur(x + (k + 1) * dx, y + (k + 1) * dy)).some(Boolean));
    let holes = 0;
    for (let y = top; y < bottom; ++y) for (let x = left; x < right; ++x) holes += isHole(x, y);
    return holes;
  });
  const once = holesOf(1), gathered = holesOf(2);
  assert.ok(once >= 50, `${once} holes in a picture that is drawn once: is there still something to see?`);
  assert.ok(gathered < once / 3, `${gathered} holes, ${once} in a picture that is drawn once`);
});

// Where there is a drop the coat is drawn by another shader, in which the dry fur round it is to look as it did.
test('water that nobody sees leaves fur as light as it was, in a picture that is drawn once and in one of several samples', () => {
  const lightOf = (samples, wetness) => inScratch(['bunny', '--size', '320x240', '--breath', '0', '--transparent', '-o', 'x.png', '--samples', `${samples}`, '--wetness', `${wetness}`], ({ status, stderr, read }) => {
    assert.equal(status, 0, stderr);
    const { data } = read('x.png');
    let sum = 0, count = 0;
    for (let i = 0; i < data.length; i += 4) if (data[i + 3] === 255) sum += data[i] + data[i + 1] + data[i + 2], ++count;
    return sum / (3 * count);
  });
  for (const samples of [1, 8]) {
    const dry = lightOf(samples, 0), wet = lightOf(samples, 0.0001);
    // It is 0.008: wet strands are known by their length instead of their height, which is less of it where they bend.
    assert.ok(Math.abs(wet / dry - 1) < 0.012, `${samples} samples: ${wet.toFixed(1)} for ${dry.toFixed(1)}`);
  }
});
