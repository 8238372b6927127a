// Which tests there are, and which of them a person has named.
import { existsSync, readFileSync, readdirSync, statSync } from 'node:fs';
import { basename, join, relative } from 'node:path';
import { Stop, root } from './process.mjs';

const folder = join(root, 'tests');
const isTest = (name) => /(Test\.cpp|\.test\.mjs)$/.test(name);

function testFilesBelow(place) {
  return readdirSync(place, { withFileTypes: true }).flatMap((entry) => {
    const path = join(place, entry.name);
    if (entry.isDirectory()) return testFilesBelow(path);
    return isTest(entry.name) ? [relative(root, path)] : [];
  }).sort();
}

/** Folders of tests/ that can be named: dynamics, app/tools, web, ... */
export function areas() {
  const below = (place) => readdirSync(place, { withFileTypes: true }).filter((entry) => entry.isDirectory())
    .map((entry) => join(place, entry.name)).flatMap((path) => [path, ...below(path)]);
  return below(folder).filter((path) => testFilesBelow(path).length > 0).map((path) => relative(folder, path)).sort();
}

// "web", "web/editor", "tests/dynamics/ForcesTest.cpp": the files that it means.
function filesOf(name) {
  const path = join(folder, name.replace(/^tests\//, ''));
  if (!path.startsWith(join(folder, '/')) || path === join(folder, '/')) return [];
  if (existsSync(path)) return statSync(path).isDirectory() ? testFilesBelow(path) : [relative(root, path)];
  const wanted = relative(root, path);
  return testFilesBelow(folder).filter((file) => [`${wanted}Test.cpp`, `${wanted}GLTest.cpp`, `${wanted}.test.mjs`].includes(file));
}

/** The test files that the names mean, all of them where none is given. Throws Stop for a name that means none. */
export function testFiles(names = []) {
  if (names.length === 0) return testFilesBelow(folder);
  const files = names.flatMap((name) => {
    const found = filesOf(name).filter((file) => isTest(basename(file)));
    if (found.length === 0) throw new Stop(`no tests in "${name}"; there are: ${areas().join(', ')}, and each of their files, such as web/editor`);
    return found;
  });
  return [...new Set(files)].sort();
}

/** Whether a C++ test is one of wet-fur-gl-tests: what is not in the pure folders of cmake/Tests.cmake, or draws. */
export function needsGl(file) {
  const [, list] = /set\(FUR_PURE_TEST_FOLDERS ([^)]*)\)/.exec(readFileSync(join(root, 'cmake/Tests.cmake'), 'utf8'));
  const pure = [...list.split(/\s+/), 'truth'];
  return /GLTest\.cpp$/.test(file) || !pure.some((name) => file.startsWith(`tests/${name}/`));
}

/** GoogleTest's filter for the tests that these files hold. */
export function filterOf(files) {
  const names = files.flatMap((file) => [...readFileSync(join(root, file), 'utf8').matchAll(/^\s*TEST(|_F|_P)\(\s*(\w+)\s*,\s*(\w+)\s*\)/gm)]);
  return names.map(([, kind, suite, test]) => (kind === '_P' ? `*/${suite}.${test}/*` : `${suite}.${test}`)).join(':');
}
