// node tools/makeAssets.mjs <program> <out folder>
//
// Makes the models that are shipped: the bunny with the program wet-fur-make-assets, its wasm build (a .js file,
// run by this same Node) or the native one, and the scenes. Nothing is done for a model newer than its sources.
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { makeScenes } from './scenes/scenes.mjs';

const require = createRequire(import.meta.url);

function meshBytes({ positions, cells }) {
  const bytes = new DataView(new ArrayBuffer(8 + 12 * (positions.length + cells.length)));
  bytes.setUint32(0, positions.length, true);
  bytes.setUint32(4, cells.length, true);
  let at = 8;
  for (const value of positions.flat()) bytes.setFloat32(at, value, true), (at += 4);
  for (const value of cells.flat()) bytes.setUint32(at, value, true), (at += 4);
  return bytes;
}

function isNewer(file, sources) {
  return existsSync(file) && sources.every((source) => statSync(source).mtimeMs < statSync(file).mtimeMs);
}

export function makeAssets(program, outFolder) {
  program = resolve(program);
  mkdirSync(outFolder, { recursive: true });
  makeScenes(resolve(outFolder));
  const out = join(resolve(outFolder), 'bunny.glb');
  if (isNewer(out, [program, fileURLToPath(import.meta.url), require.resolve('bunny')])) return;
  const scratch = mkdtempSync(join(tmpdir(), 'wet-fur-'));
  try {
    const mesh = join(scratch, 'bunny.mesh');
    writeFileSync(mesh, meshBytes(require('bunny')));
    const command = /\.(c|m)?js$/.test(program) ? [process.execPath, program] : [program];
    execFileSync(command[0], [...command.slice(1), mesh, out], { stdio: 'inherit' });
  } finally {
    rmSync(scratch, { recursive: true });
  }
}

if (process.argv[1] && resolve(process.argv[1]) === fileURLToPath(import.meta.url)) {
  const [program, outFolder] = process.argv.slice(2);
  if (!program || !outFolder) {
    console.error('usage: node tools/makeAssets.mjs <wet-fur-make-assets program> <out folder>');
    process.exit(2);
  }
  makeAssets(program, outFolder);
}
