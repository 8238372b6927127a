// How long the generator takes in WebAssembly, on one thread: node tests/bench/coat.mjs [--rounds 5].
// The best of some rounds each: other programs only ever add. Growth is read off the last column, the time
// for a million texels of all layers.
import { start } from './programs.mjs';

const rounds = process.argv[2] === '--rounds' ? Number(process.argv[3]) : 5;
const program = await start('core');
// In the order of core.js.
const defaults = {
  size: 256, layers: 16, seed: 1,
  density: 1, thickness: 0, taper: 0.5, lengthVariation: 0.35, length: 1, curl: 0.25,
  wave: 0, coil: 0, frizz: 0, clump: 0, lockSize: 0.3, roll: 0, stray: 0.1, tipBreak: 0,
  undercoat: 0, undercoatLength: 0.45,
};

function time(parameters) {
  const values = Float64Array.from(Object.values({ ...defaults, ...parameters }));
  let best = Infinity, strands = 0;
  for (let i = 0; i < rounds; ++i) {
    const begun = performance.now();
    const volume = program.callOrThrow('fur_generate', values);
    best = Math.min(best, performance.now() - begun);
    strands = program.numbers(program.call('fur_volumeInfo', volume), 6)[2];
    program.call('fur_volumeFree', volume);
  }
  const { size, layers } = { ...defaults, ...parameters };
  return { strands, ms: +best.toFixed(1), 'ms a million texels': +(best / (size * size * layers / 1e6)).toFixed(1) };
}

console.log('The densest fine coat (density 1, thickness 0, curl 0.25) and what differs from it:');
console.table(Object.fromEntries([
  ['256 x 16', {}],
  ['strands: density 0.5', { density: 0.5 }],
  ['strands: density 0.25', { density: 0.25 }],
  ['strands: undercoat 1', { undercoat: 1 }],
  ['layers: 256 x 4', { layers: 4 }],
  ['layers: 256 x 32', { layers: 32 }],
  ['layers: 256 x 64', { layers: 64 }],
  ['layers: 256 x 128', { layers: 128 }],
  ['texels: 128 x 16', { size: 128 }],
  ['texels: 512 x 16', { size: 512 }],
  ['texels: 1024 x 16', { size: 1024 }],
  ['512 x 64', { size: 512, layers: 64 }],
  ['512 x 64, undercoat 1', { size: 512, layers: 64, undercoat: 1 }],
  ['curl 1', { curl: 1 }],
  ['thickness 1, curl 1', { thickness: 1, curl: 1 }],
  ['locks, roll, wave, frizz', { clump: 1, roll: 1, wave: 1, frizz: 1 }],
  ['coil 0.5', { coil: 0.5 }],
  ['everything at once', { coil: 0.5, clump: 1, roll: 1, wave: 1, frizz: 1, undercoat: 1, curl: 1 }],
].map(([name, parameters]) => [name, time(parameters)])));
