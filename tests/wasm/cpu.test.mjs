// The CPU tests, built to WebAssembly, under Node: one test here for each of theirs.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { describe, test } from 'node:test';
import { root } from '../../tools/process.mjs';

const program = join(root, 'build/web-release/node/wet-fur-tests.js');
const nativeProgram = process.env.FUR_NATIVE_TESTS ?? join(root, 'build/native-release/wet-fur-tests');
const runProgram = (...args) => spawnSync(process.execPath, [program, '--gtest_color=no', ...args], { encoding: 'utf8', maxBuffer: 1 << 26 });

/** Every so many'th test; the shares run side by side. */
function runShare(share) {
  const child = spawn(process.execPath, [program, '--gtest_color=no'], { env: { ...process.env, GTEST_TOTAL_SHARDS: String(shares), GTEST_SHARD_INDEX: String(share) } });
  const result = { stdout: '', stderr: '' };
  for (const stream of ['stdout', 'stderr']) child[stream].setEncoding('utf8').on('data', (text) => { result[stream] += text; });
  return new Promise((resolve) => {
    child.on('error', (error) => resolve({ ...result, stderr: error.message, status: 1 }));
    child.on('close', (status) => resolve({ ...result, status }));
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
