// How much the picture flickers while the camera moves: the share of the model's pixels that change by more than 20 of 255 between two
// frames half a pixel apart, at 320 x 240, by wetness and distance; and each as a share of dry fur's.
// node tests/bench/shimmer.mjs [model] [--preset NAME ...]: further arguments are those of wet-fur-render
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { PNG } from 'pngjs';
import { buildNative } from '../../tools/build.mjs';

const [model, ...others] = process.argv.length > 2 ? process.argv.slice(2) : ['plain-bunny'];
const width = 320, height = 240, wetness = [0, 0.25, 0.5, 0.8, 1], distances = [1.8, 2.75, 5], yaws = [0.35, 1.9, 3.6];
const program = await buildNative('wet-fur-render'), folder = mkdtempSync(join(tmpdir(), 'shimmer-'));

function draw(yaw, distance, wet, samples) {
  const file = join(folder, 'frame.png');
  const blue = ['--backgroundTop', '#0000ff', '--backgroundBottom', '#0000ff', '--ground', 'false', '--dryRate', '0'];
  execFileSync(program, [model, '-o', file, '--size', `${width}x${height}`, '--samples', samples, '--camera', `${yaw},0.28,${distance}`, '--wetness', wet, ...blue, ...others]);
  return PNG.sync.read(readFileSync(file)).data;
}

const largest = (a, b, i) => Math.max(...[0, 1, 2].map((k) => Math.abs(a[i + k] - b[i + k])));
for (const samples of ['1', '16']) {
  console.log(`${model} ${others.join(' ')}: ${samples === '1' ? 'one frame' : `gathered, ${samples} samples`}`);
  console.log(`distance${wetness.map((wet) => ` ${`wet ${wet}`.padStart(15)}`).join('')}`);
  for (const distance of distances) {
    // What is nearest to the eye moves by half a pixel when the camera turns by this about the middle of a model of radius 1.
    const step = 0.5 * (distance - 1) / (height / (2 * Math.tan(0.3)));
    const shares = wetness.map((wet) => {
      let changed = 0, all = 0;
      for (const yaw of yaws) {
        const a = draw(yaw, distance, wet, samples), b = draw(yaw + step, distance, wet, samples);
        for (let i = 0; i < a.length; i += 4) {
          if (a[i] < 5 && a[i + 1] < 5 && a[i + 2] > 250) continue;
          ++all;
          changed += largest(a, b, i) > 20;
        }
      }
      return changed / all;
    });
    console.log(`${distance.toFixed(2).padEnd(8)}${shares.map((share) => ` ${share.toFixed(4)} (${(share / shares[0]).toFixed(2)})`.padStart(16)).join('')}`);
  }
}
rmSync(folder, { recursive: true });
