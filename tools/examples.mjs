// The recipes of examples/, each built by its own script as in a project that has installed the package of dist/. They lie below this
// tree, so that its packages are found.
import { cpSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, symlinkSync } from 'node:fs';
import { basename, join, relative } from 'node:path';
import { Stop, root, runGathering } from './process.mjs';

const examples = join(root, 'examples');
/** Where they are built. */
export const builtExamples = join(root, 'build/examples');

/** The editor and most models stay where they are: no recipe asks for them. */
const forPages = (path) => !/wet-fur-(editor|hair)\./.test(path) && !/\.glb$/.test(path);

export const exampleNames = readdirSync(examples, { withFileTypes: true }).filter((entry) => entry.isDirectory()).map(({ name }) => name);

/** Copies them anew, and gives them `dist` as the package. */
export function prepareExamples(dist) {
  rmSync(builtExamples, { recursive: true, force: true });
  mkdirSync(join(builtExamples, 'node_modules'), { recursive: true });
  cpSync(examples, builtExamples, { recursive: true, filter: (path) => !/^(node_modules|dist|site|cache)$/.test(basename(path)) });
  const link = join(builtExamples, 'node_modules/wet-fur');
  symlinkSync(relative(join(builtExamples, 'node_modules'), dist), link, 'junction');
}

/** Builds one; gives the folder with its page. Throws Stop with what the build printed. */
export async function buildExample(name, dist) {
  const folder = join(builtExamples, name);
  const manifest = join(folder, 'package.json');
  const { build } = existsSync(manifest) ? JSON.parse(readFileSync(manifest, 'utf8')).scripts : {};
  // One without a build asks for the files of the package beside the page.
  if (!existsSync(manifest)) cpSync(dist, join(folder, 'wet-fur'), { recursive: true, filter: forPages });
  if (!build) return folder;
  const [program, ...given] = build.split(' ');
  const script = program === 'vite' ? join(root, 'node_modules/vite/bin/vite.js') : given.shift();
  const { status, output } = await runGathering(process.execPath, [script, ...given], { cwd: folder, aside: true });
  if (status !== 0) throw new Stop(`examples/${name}: ${output}`);
  return [join(folder, 'dist'), join(folder, 'site')].find(existsSync);
}
