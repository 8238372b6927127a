// node assets/makeAssets.mjs <program> <out folder>
//
// Makes the models that are shipped: the bunny, and `plain-bunny`, the scan alone by which pictures are measured, with the program
// wet-fur-make-assets, its wasm build (a .js file, run by this same Node) or the native one, scenes that are wet or have long hair likewise, and
// the others; animals are in this folder as files (tools/assets). Nothing is done for a model newer than its sources.
import { execFileSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, mkdtempSync, readdirSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { hairText, makeScenes, scenes, waterBytes } from './scenes/scenes.mjs';
import { meshOf, sphere } from './scenes/shapes.mjs';
import { bunnyFile } from '../tools/assets/bunny.mjs';
import { commandOf, meshBytes } from '../tools/assets/program.mjs';

const require = createRequire(import.meta.url);

const threes = (list) => Array.from({ length: list.length / 3 }, (_, i) => list.slice(3 * i, 3 * i + 3));
const asCells = ({ mesh }) => ({ positions: threes(mesh.positions), cells: threes(mesh.indices) });
const flat = { cells: 24, part: 0, at: (s, t) => ({ position: [1.4 * s - 0.7, 0, 0.7 - 1.4 * t], normal: [0, 1, 0] }) };
const shapes = { bunny: () => require('bunny'), sphere: () => asCells(meshOf(sphere({ cells: 24 }))), plane: () => asCells(meshOf([flat])) };

function isNewer(file, sources) {
  return existsSync(file) && sources.every((source) => statSync(source).mtimeMs < statSync(file).mtimeMs);
}

// Animals: files of this folder.
function copyAnimals(outFolder) {
  const folder = fileURLToPath(new URL('.', import.meta.url));
  for (const name of readdirSync(folder).filter((file) => file.endsWith('.glb')))
    if (!isNewer(join(outFolder, name), [join(folder, name)])) copyFileSync(join(folder, name), join(outFolder, name));
}

export function makeAssets(program, outFolder) {
  program = resolve(program);
  outFolder = resolve(outFolder);
  mkdirSync(outFolder, { recursive: true });
  copyAnimals(outFolder);
  makeScenes(outFolder);
  const scripts = (folder) => readdirSync(new URL(folder, import.meta.url)).filter((file) => file.endsWith('.mjs')).map((file) => fileURLToPath(new URL(`${folder}${file}`, import.meta.url)));
  const sources = [program, ...['./', './scenes/', '../tools/assets/'].flatMap(scripts)];
  const waiting = [{ name: 'bunny', file: bunnyFile }, { name: 'plain-bunny', shape: 'bunny' }, ...scenes.filter(({ body }) => !body)]
    .filter(({ name }) => !isNewer(join(outFolder, `${name}.glb`), [...sources, require.resolve('bunny')]));
  if (!waiting.length) return;
  const scratch = mkdtempSync(join(tmpdir(), 'wet-fur-'));
  try {
    const command = commandOf(program);
    for (const scene of waiting) {
      const out = join(outFolder, `${scene.name}.glb`);
      if (scene.file) {
        writeFileSync(out, scene.file(program, require('bunny')));
        continue;
      }
      const mesh = join(scratch, 'mesh'), more = join(scratch, 'more');
      writeFileSync(mesh, meshBytes((scene.mesh ?? shapes[scene.shape])()));
      if (scene.drops) writeFileSync(more, waterBytes(scene));
      if (scene.steps) writeFileSync(more, hairText(scene));
      const options = scene.drops ? [more] : scene.steps ? ['--hair', more] : [];
      execFileSync(command[0], [...command.slice(1), mesh, out, ...options], { stdio: 'inherit' });
    }
  } finally {
    rmSync(scratch, { recursive: true });
  }
}

if (process.argv[1] && resolve(process.argv[1]) === fileURLToPath(import.meta.url)) {
  const [program, outFolder] = process.argv.slice(2);
  if (!program || !outFolder) {
    console.error('usage: node assets/makeAssets.mjs <wet-fur-make-assets program> <out folder>');
    process.exit(2);
  }
  makeAssets(program, outFolder);
}
