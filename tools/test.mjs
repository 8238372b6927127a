// npm test: every test, each kind with the set-up and builds it needs. A stage that fails is reported
// and the others still run; the last line adds up all runners, and the exit status is 0 only when every
// stage passed.
import { readdirSync } from 'node:fs';
import { join, relative } from 'node:path';
import { buildNative, buildSite } from './build.mjs';
import { build, buildFolder } from './cmake.mjs';
import { command, jobs, root, runGathering, say } from './process.mjs';
import { chromiumPath, needs, setUp } from './setup.mjs';

const totals = { passed: 0, failed: 0, skipped: 0 };
const verdicts = [];

// Counts out of what a runner printed: GoogleTest's or Node's closing lines.
export function countsIn(output) {
  const sum = (pattern) => [...output.matchAll(pattern)].reduce((total, match) => total + Number(match[1]), 0);
  return {
    passed: sum(/^\[  PASSED  \] (\d+) tests?\./gm) + sum(/^(?:#|ℹ) pass (\d+)$/gm),
    failed: sum(/^\[  FAILED  \] (\d+) tests?, listed below/gm) + sum(/^(?:#|ℹ) (?:fail|cancelled) (\d+)$/gm),
    skipped: sum(/^\[  SKIPPED \] (\d+) tests?, listed below/gm) + sum(/^(?:#|ℹ) (?:skipped|todo) (\d+)$/gm),
  };
}

// One stage: set-up and builds throw and give nothing, a test program gives { status, output }.
async function stage(name, work) {
  console.log(`\n=== ${name}`);
  const begun = Date.now();
  let failure;
  try {
    const { status, output } = (await work()) ?? { status: 0, output: '' };
    const counts = countsIn(output);
    for (const key of Object.keys(totals)) totals[key] += counts[key];
    if (status !== 0) {
      failure = `exit ${status}`;
      // A crash leaves no count of its own.
      if (counts.failed === 0) totals.failed += 1;
    }
  } catch (error) {
    failure = error.message;
    totals.failed += 1;
  }
  verdicts.push(`${failure ? 'FAILED' : 'passed'}  ${name} (${((Date.now() - begun) / 1000).toFixed(0)} s)${failure ? `: ${failure.split('\n')[0]}` : ''}`);
  say(verdicts.at(-1));
  return !failure;
}

function testFilesBelow(folder) {
  return readdirSync(folder, { withFileTypes: true }).flatMap((entry) => {
    const path = join(folder, entry.name);
    if (entry.isDirectory()) return testFilesBelow(path);
    return entry.name.endsWith('.test.mjs') ? [relative(root, path)] : [];
  }).sort();
}

// Node's runner for files of tests/; one file at a time where the files share a browser's two cores.
function nodeTests(files, { concurrency = 2, env = {} } = {}) {
  if (files.length === 0) throw new Error('no test files');
  return runGathering(process.execPath, ['--test', `--test-concurrency=${concurrency}`, ...files], { env });
}

// GoogleTest's tests in as many shares as there are cores, side by side.
async function program(preset, name) {
  const runs = await Promise.all(Array.from({ length: jobs }, (_, share) => runGathering(
    join(buildFolder(preset), name), ['--gtest_color=no', '--gtest_brief=1'],
    { env: { GTEST_TOTAL_SHARDS: String(jobs), GTEST_SHARD_INDEX: String(share) } },
  )));
  return { status: runs.find(({ status }) => status !== 0)?.status ?? 0, output: runs.map(({ output }) => output).join('\n') };
}

async function main() {
  const files = testFilesBelow(join(root, 'tests'));
  const pageFiles = files.filter((file) => file.startsWith('tests/web/'));
  const of = (...folders) => files.filter((file) => folders.some((folder) => file.startsWith(`tests/${folder}/`)));
  const rest = files.filter((file) => !pageFiles.includes(file) && !of('tools', 'wasm', 'golden').includes(file));

  await stage('set-up', () => setUp({
    packages: [needs.nativeTests, needs.native, needs.web, needs.wasmTests, needs.browser], npm: true, imgui: true,
  }));
  await stage('arrows between modules', () => runGathering(process.execPath, [join(root, 'tools/check-arrows.mjs')]));
  await stage('the commands\' own tests', () => nodeTests(of('tools')));

  await stage('native build', () => { buildNative('all', 'wet-fur-tests', 'wet-fur-gl-tests'); });
  await stage('CPU tests, native', () => program('native-release', 'wet-fur-tests'));
  await stage('GL tests, native', () => program('native-release', 'wet-fur-gl-tests'));
  await stage('golden pictures, native', () => nodeTests(of('golden')));
  await stage('sanitizer build', () => build('native-asan', ['wet-fur-tests']));
  await stage('CPU tests under the address and undefined-behaviour sanitizers', () => program('native-asan', 'wet-fur-tests'));

  await stage('WebAssembly build and dist/', buildSite);
  await stage('WebAssembly test build', () => build('web-release', ['wet-fur-tests']));
  await stage('CPU tests, WebAssembly under Node', () => nodeTests(of('wasm')));
  await stage('package: typings, entries, size', () => nodeTests(rest));
  await stage('the page in Chromium', () => nodeTests(pageFiles, { concurrency: 1, env: { FUR_CHROMIUM: chromiumPath() ?? '' } }));

  console.log(`\n=== summary\n${verdicts.join('\n')}\n`);
  console.log(`${totals.passed} passed, ${totals.failed} failed${totals.skipped ? `, ${totals.skipped} skipped` : ''}`);
  if (verdicts.some((verdict) => verdict.startsWith('FAILED'))) process.exitCode = 1;
}

if (process.argv[1] === join(root, 'tools/test.mjs')) await command(main);
