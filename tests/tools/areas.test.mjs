import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { root } from '../../tools/process.mjs';
import { areas, filterOf, needsGl, testFiles } from '../../tools/testAreas.mjs';

test('a name is a folder of tests/ or a file in it, with or without its ending', () => {
  assert.ok(areas().includes('dynamics') && areas().includes('web'));
  assert.ok(testFiles(['dynamics']).every((file) => file.startsWith('tests/dynamics/')));
  for (const name of ['web/editor', 'web/editor.test.mjs', 'tests/web/editor.test.mjs']) assert.deepEqual(testFiles([name]), ['tests/web/editor.test.mjs']);
  assert.deepEqual(testFiles(['dynamics/Forces']), ['tests/dynamics/ForcesTest.cpp']);
  assert.deepEqual(testFiles(['wet', 'dynamics']), testFiles(['dynamics', 'wet', 'wet/Water']));
});

test('the areas together are all there is', () => {
  assert.deepEqual(testFiles(areas()), testFiles());
});

test('a name that means no tests is refused with a list of those that do', () => {
  for (const name of ['dynamix', '', '../src', 'bench']) assert.throws(() => testFiles([name]), /there are: app, .*dynamics, .*web/, name);
  const { status, stderr } = spawnSync(process.execPath, [join(root, 'tools/test.mjs'), 'dynamix'], { encoding: 'utf8' });
  assert.equal(status, 1);
  assert.match(stderr, /^wet-fur: no tests in "dynamix"; there are: .*\n$/);
});

test('a filter names every test of its files', () => {
  const files = testFiles().filter((file) => file.endsWith('.cpp'));
  for (const file of files) {
    const names = filterOf([file]).split(':');
    const written = readFileSync(join(root, file), 'utf8').match(/\bTEST(_[FP])?\(|TYPED_TEST/g) ?? [];
    assert.equal(names.length, written.length, file);
    for (const name of names) assert.match(name, /^(\*\/)?\w+\.\w+(\/\*)?$/, file);
  }
});

test('what draws or stands above the pure modules is in the program with a context', () => {
  assert.equal(needsGl('tests/dynamics/ForcesTest.cpp'), false);
  assert.equal(needsGl('tests/truth/TruthTest.cpp'), false);
  for (const file of ['tests/truth/TruthGLTest.cpp', 'tests/render/BlocksGLTest.cpp', 'tests/editor/EditorTest.cpp']) assert.equal(needsGl(file), true, file);
});
