// The CPU tests, built to WebAssembly, under Node: one test here for each of theirs.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { closeSync, mkdtempSync, openSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, describe, test } from 'node:test';
import { root } from '../../tools/process.mjs';

const program = join(root, 'build/web-release/node/wet-fur-tests.js');
const nativeProgram = process.env.FUR_NATIVE_TESTS ?? join(root, 'build/native-release/wet-fur-tests');
const scratch = mkdtempSync(join(tmpdir(), 'wet-fur-'));
after(() => rmSync(scratch, { recursive: true }));

// What it prints goes into a file: Node may end a program before all of it has gone through a pipe.
function runProgram(...args) {
  const path = join(scratch, 'listed'), file = openSync(path, 'w');
  const { status, stderr } = spawnSync(process.execPath, [program, '--gtest_color=no', ...args], { encoding: 'utf8', stdio: ['ignore', file, 'pipe'] });
  closeSync(file);
  return { status, stderr, stdout: readFileSync(path, 'utf8') };
}

/** Every so many'th suite; the shares run side by side. The program does not see the environment, in which GoogleTest has shares. */
function runShare(share) {
  const path = join(scratch, `share${share}`), file = openSync(path, 'w');
  const filter = Object.keys(suites).filter((_, i) => i % shares === share).map((suite) => `${suite}.*`).join(':');
  const child = spawn(process.execPath, [program, '--gtest_color=no', `--gtest_filter=${filter}`], { stdio: ['ignore', file, 'pipe'] });
  let stderr = '';
  child.stderr.setEncoding('utf8').on('data', (text) => { stderr += text; });
  return new Promise((resolve) => {
    child.on('error', (error) => resolve({ stdout: '', stderr: error.message, status: 1 }));
    child.on('close', (status) => {
      closeSync(file);
      resolve({ stdout: readFileSync(path, 'utf8'), stderr, status });
    });
  });
}

// { Suite: [name, ...] } from --gtest_list_tests: a line per suite, indented lines per test.
function listedTests() {
  const { stdout, stderr, status } = runProgram('--gtest_list_tests');
  assert.equal(status, 0, stderr);
  const suites = {};
  let suite;
  for (const line of stdout.split('\n').map((one) => one.replace(/\s*#.*/, ''))) {
    if (/^\S+\.$/.test(line)) suites[(suite = line.slice(0, -1))] = [];
    else if (/^ {2}\S/.test(line)) suites[suite].push(line.trim());
  }
  return suites;
}

const suites = listedTests();
const shares = 2;
const results = await Promise.all(Array.from({ length: shares }, (_, share) => runShare(share)));
const result = {
  status: results.every(({ status }) => status === 0) ? 0 : 1, stdout: results.map(({ stdout }) => stdout).join(''), stderr: results.map(({ stderr }) => stderr).join(''),
};

// What the program printed between "[ RUN ]" and the verdict of one test.
function verdictOf(name) {
  const start = result.stdout.indexOf(`[ RUN      ] ${name}\n`);
  if (start < 0) return { verdict: 'DID NOT RUN', text: result.stderr };
  const rest = result.stdout.slice(start);
  const end = /^\[\s+(OK|FAILED|SKIPPED)\s+\] /m.exec(rest);
  return end ? { verdict: end[1], text: rest.slice(0, end.index) } : { verdict: 'CRASHED', text: rest + result.stderr };
}

test('every test that ran is listed here', () => {
  const ran = [...result.stdout.matchAll(/^\[==========\] (\d+) tests? from .* ran\./gm)].reduce((sum, [, count]) => sum + Number(count), 0);
  assert.equal(Object.values(suites).flat().length, ran);
});

for (const [suite, names] of Object.entries(suites)) {
  describe(suite, () => {
    for (const name of names) {
      test(name, () => {
        const { verdict, text } = verdictOf(`${suite}.${name}`);
        assert.equal(verdict, 'OK', text);
      });
    }
  });
}

// What tests print by printOnEveryPlatform(), as { name: hash }.
const printedBy = ({ stdout }) => Object.fromEntries([...stdout.matchAll(/^on every platform: (.*) ([0-9a-f]{16})$/gm)].map(([, name, hash]) => [name, hash]));

test('seeds and recordings give the same bytes as in the native program', () => {
  const native = spawnSync(nativeProgram, ['--gtest_filter=*OnEveryPlatform'], { encoding: 'utf8' });
  assert.equal(native.status, 0, native.stderr);
  assert.ok(Object.keys(printedBy(native)).length >= 8, native.stdout);
  assert.deepEqual(printedBy(result), printedBy(native));
});

test('the program says of itself that all passed', () => assert.equal(result.status, 0, result.stderr));
