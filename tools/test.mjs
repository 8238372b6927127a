// npm test: every test, each kind with the set-up and builds it needs; npm test -- dynamics web/editor: those of a folder or
// a file of tests/, with what they need. A stage that fails is reported and the others still run; the last line adds up all
// runners, and the exit status is 0 only when every stage passed. Pages wait a third of their time, for the screen and for one
// another: what needs no page runs aside, when they leave a core alone.
import { join } from 'node:path';
import { buildNative, buildSite, siteTargets } from './build.mjs';
import { build, buildFolder } from './cmake.mjs';
import { command, jobs, root, runGathering, say } from './process.mjs';
import { chromiumPath, needs, setUp } from './setup.mjs';
import { filterOf, needsGl, testFiles } from './testAreas.mjs';

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

// One stage: set-up and builds throw and give nothing, a test program gives { status, output }. Of one that runs aside the
// output is printed when it has ended.
async function stage(name, work, { aside = false } = {}) {
  if (!aside) console.log(`\n=== ${name}`);
  const begun = Date.now();
  let failure;
  try {
    const { status, output } = (await work({ aside })) ?? { status: 0, output: '' };
    if (aside) console.log(`\n=== ${name} (ran aside)\n${output}`);
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

// Node's runner for files of tests/, two at a time: so many cores has the machine that this is for.
function nodeTests(files, { env = {}, aside = false } = {}) {
  return runGathering(process.execPath, ['--test', '--test-concurrency=2', ...files], { env, aside });
}

// GoogleTest's tests in as many shares as there are cores, side by side; all of them, or those that `filter` names.
async function program(preset, name, { filter = '', aside = false } = {}) {
  const runs = await Promise.all(Array.from({ length: jobs }, (_, share) => runGathering(
    join(buildFolder(preset), name), ['--gtest_color=no', '--gtest_brief=1'],
    { env: { GTEST_TOTAL_SHARDS: String(jobs), GTEST_SHARD_INDEX: String(share), ...filter && { GTEST_FILTER: filter } }, aside },
  )));
  return { status: runs.find(({ status }) => status !== 0)?.status ?? 0, output: runs.map(({ output }) => output).join('\n') };
}

// The longest first, so that no core waits for the last of them.
const longest = ['endless', 'docs', 'many', 'keeping', 'alive', 'bar', 'page', 'editor', 'refine', 'governor', 'examples', 'companions'].map((name) => `tests/web/${name}.test.mjs`);
const byLength = (files) => [...longest.filter((file) => files.includes(file)), ...files.filter((file) => !longest.includes(file))];

/** The chosen tests by their kinds, and what has to be built for them. */
function plan(files) {
  const all = files.length === testFiles().length;
  const of = (...folders) => files.filter((file) => file.endsWith('.mjs') && folders.some((folder) => file.startsWith(`tests/${folder}/`)));
  const cpp = files.filter((file) => file.endsWith('.cpp'));
  const kinds = {
    cpu: cpp.filter((file) => !needsGl(file)), gl: cpp.filter(needsGl), golden: of('golden'), native: of('native'), wasm: of('wasm'),
    package: of('package'), page: of('web'), assets: of('assets'),
  };
  const others = files.filter((file) => file.endsWith('.mjs') && !Object.values(kinds).flat().includes(file));
  const has = (...names) => names.some((name) => kinds[name].length > 0);
  // Their pictures and hashes are compared with those of the native programs.
  const comparesWithGl = files.includes('tests/web/page.test.mjs');
  const programs = [
    ...has('cpu', 'wasm') && !all ? ['wet-fur-tests'] : [], ...has('gl') || comparesWithGl ? ['wet-fur-gl-tests'] : [],
    ...has('golden', 'native') ? ['wet-fur-render', 'wet-fur-compare', 'wet-fur'] : [], ...has('assets') ? ['wet-fur-make-assets'] : [],
  ];
  return { all, kinds, others, programs: all ? [...programs, 'all'] : programs, site: has('package', 'page'), wasm: has('wasm'), page: has('page') };
}

async function main() {
  const { all, kinds, others, programs, site, wasm, page } = plan(testFiles(process.argv.slice(2)));
  const filter = (files) => (all ? '' : filterOf(files));
  // All of them run under the sanitizers natively, and optimized as wasm: no need to build them a third time.
  const nativeTests = all ? 'native-asan' : 'native-release';
  const packages = [
    ...programs.length > 0 ? [needs.nativeTests, needs.native] : [], ...site || wasm ? [needs.web] : [], ...wasm ? [needs.wasmTests] : [],
    ...page ? [needs.browser] : [],
  ];
  await stage('set-up', () => setUp({ packages, npm: programs.length > 0 || site || wasm, imgui: programs.length > 0 || site }));
  if (all) await stage('arrows between modules', () => runGathering(process.execPath, [join(root, 'tools/check-arrows.mjs')]));
  if (others.length) await stage('commands and shaders, as text', () => nodeTests(others));

  // Those of the pure modules need no models.
  if (programs.length) await stage('native build', async () => { await (programs.join() === 'wet-fur-tests' ? build('native-release', programs) : buildNative(...programs)); });
  // In one run: while one core links a program the other compiles what the next is made of.
  if (site || wasm) await stage('WebAssembly build', async () => { await build('web-release', [...site ? siteTargets : [], ...wasm ? ['wet-fur-tests'] : []], { keepGoing: true }); });
  if (site) await stage('dist/', buildSite);

  const pages = async () => {
    if (page) await stage('the page in Chromium', () => nodeTests(byLength(kinds.page), { env: { FUR_CHROMIUM: chromiumPath() ?? '' } }));
  };
  const withoutPages = async (how) => {
    if (kinds.cpu.length && !all) await stage('CPU tests, native', ({ aside }) => program('native-release', 'wet-fur-tests', { filter: filter(kinds.cpu), aside }), how);
    if (all) {
      await stage('sanitizer build', async ({ aside }) => { await build('native-asan', ['wet-fur-tests'], { aside }); }, how);
      await stage('CPU tests, native, under the address and undefined-behaviour sanitizers', ({ aside }) => program('native-asan', 'wet-fur-tests', { aside }), how);
    }
    if (wasm) await stage('CPU tests, WebAssembly under Node', ({ aside }) => nodeTests(kinds.wasm, { env: { FUR_NATIVE_TESTS: join(buildFolder(nativeTests), 'wet-fur-tests') }, aside }), how);
    if (kinds.gl.length) await stage('GL tests, native', ({ aside }) => program('native-release', 'wet-fur-gl-tests', { filter: filter(kinds.gl), aside }), how);
    if (kinds.golden.length) await stage('golden pictures, native', ({ aside }) => nodeTests(kinds.golden, { aside }), how);
    if (kinds.native.length) await stage('the native programs', ({ aside }) => nodeTests(kinds.native, { aside }), how);
    if (kinds.assets.length) await stage('animals', ({ aside }) => nodeTests(kinds.assets, { aside }), how);
    if (kinds.package.length) await stage('package: typings, entries, size', ({ aside }) => nodeTests(kinds.package, { aside }), how);
  };
  await Promise.all([pages(), withoutPages({ aside: page })]);

  console.log(`\n=== summary\n${verdicts.join('\n')}\n`);
  console.log(`${totals.passed} passed, ${totals.failed} failed${totals.skipped ? `, ${totals.skipped} skipped` : ''}`);
  if (verdicts.some((verdict) => verdict.startsWith('FAILED'))) process.exitCode = 1;
}

if (process.argv[1] === join(root, 'tools/test.mjs')) await command(main);
