// The package as a user gets it: packed by npm, unpacked into the node_modules of a project elsewhere.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, relative } from 'node:path';
import { after, before, test } from 'node:test';
import { root } from '../../tools/process.mjs';
import { dist, missingFiles } from '../../tools/site.mjs';

let project, installed;

const runNode = (...args) => spawnSync(process.execPath, args, { cwd: project, encoding: 'utf8' });

before(() => {
  project = mkdtempSync(join(tmpdir(), 'wet fur project '));
  installed = join(project, 'node_modules/wet-fur');
  mkdirSync(installed, { recursive: true });
  const packed = spawnSync('npm', ['pack', '--pack-destination', project, '--silent'], { cwd: dist, encoding: 'utf8' });
  assert.equal(packed.status, 0, packed.stderr);
  const unpacked = spawnSync('tar', ['-xzf', join(project, packed.stdout.trim()), '--strip-components=1', '-C', installed], { encoding: 'utf8' });
  assert.equal(unpacked.status, 0, unpacked.stderr);
  writeFileSync(join(project, 'package.json'), '{ "type": "module" }');
});
after(() => rmSync(project, { recursive: true, force: true }));

test('the package holds every file that it names, and its licences', () => {
  assert.deepEqual(missingFiles(installed), []);
  for (const name of ['LICENSE', 'THIRD-PARTY-NOTICES.txt', 'README.md']) assert.ok(existsSync(join(installed, name)), name);
});

test('the notices name all that is linked', () => {
  const text = readFileSync(join(dist, 'THIRD-PARTY-NOTICES.txt'), 'utf8');
  for (const name of ['GLM', 'stb', 'Dear ImGui', 'Emscripten', 'musl', 'LLVM']) assert.match(text, new RegExp(name));
});

test('no file of ours names a place on the machine that built it', () => {
  const texts = readdirSync(dist, { recursive: true }).filter((name) => /\.(m?js|html|css|ts|json|txt|wasm)$/.test(name));
  assert.ok(texts.length > 10);
  for (const name of texts) assert.ok(!readFileSync(join(dist, name), 'latin1').includes(root), name);
});

test('every entry can be imported in plain Node without a DOM', () => {
  for (const entry of ['wet-fur', 'wet-fur/core', 'wet-fur/element', 'wet-fur/editor', 'wet-fur/companions']) {
    const { status, stderr } = runNode('--input-type=module', '-e', `await import('${entry}')`);
    assert.equal(status, 0, `${entry}: ${stderr}`);
  }
});

test('wet-fur/core computes in plain Node', () => {
  const script = `
    import { loadCore } from 'wet-fur/core';
    const core = await loadCore();
    const mask = core.createWetnessMask(64);
    mask.addDroplet({ u: 0.5, v: 0.5, radius: 0.1, wetness: 0.6 });
    console.log(JSON.stringify({ length: mask.data.length, wet: Math.max(...mask.data) > 0, equations: typeof core.equations.clumpShift }));`;
  const { status, stdout, stderr } = runNode('--input-type=module', '-e', script);
  assert.equal(status, 0, stderr);
  assert.deepEqual(JSON.parse(stdout), { length: 4 * 64 * 64, wet: true, equations: 'function' });
});

test('the .wasm can be asked for by name', () => {
  const { status, stdout, stderr } = runNode('--input-type=module', '-e', "console.log(import.meta.resolve('wet-fur/wet-fur.wasm'))");
  assert.equal(status, 0, stderr);
  assert.match(stdout, /wet-fur\.wasm$/m);
});

for (const [resolution, module] of [['Bundler', 'ESNext'], ['NodeNext', 'NodeNext']]) {
  test(`the typings serve a strict TypeScript user (moduleResolution ${resolution})`, () => {
    const folder = join(project, resolution);
    mkdirSync(folder);
    cpSync(join(root, 'tests/web/types/consumer.ts'), join(folder, 'consumer.ts'));
    const { compilerOptions } = JSON.parse(readFileSync(join(root, 'tests/web/types/tsconfig.json'), 'utf8'));
    delete compilerOptions.paths;
    writeFileSync(join(folder, 'tsconfig.json'), JSON.stringify({
      compilerOptions: { ...compilerOptions, module, moduleResolution: resolution }, files: ['consumer.ts'],
    }));
    const { status, stdout } = runNode(join(root, 'node_modules/typescript/bin/tsc'), '-p', relative(project, folder));
    assert.equal(status, 0, stdout);
  });
}
