// dist/: the npm package and the static site in one folder, from what has been built.
import { cpSync, existsSync, mkdirSync, readFileSync, readdirSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { extname, join } from 'node:path';
import { buildFolder } from './cmake.mjs';
import { notices } from './notices.mjs';
import { Stop, root } from './process.mjs';
import { scenes } from '../assets/scenes/scenes.mjs';
import { drawingOf, makeTables, pageText, typingsText, withEndings } from './tables.mjs';

export const dist = join(root, 'dist');

const programs = ['wet-fur.mjs', 'wet-fur.wasm', 'wet-fur-hair.mjs', 'wet-fur-hair.wasm', 'wet-fur-editor.mjs', 'wet-fur-editor.wasm', 'wet-fur-core.mjs', 'wet-fur-core.wasm'];
const notForSite = new Set(['.cpp', '.h', '.inc', '.js', '.md']);
const icons = join(root, 'web/icons');  // they stand in the page

// What a bundler and Node may ask for, by the names of the public surface. Typings lie in types/.
const entries = {
  '.': ['index.js', 'types/index.d.ts'],
  './element': ['element.js', 'types/element.d.ts'],
  './editor': ['editor.js', 'types/editor.d.ts'],
  './core': ['core.js', 'types/core.d.ts'],
  './companions': ['companions.js', 'types/companions.d.ts'],
};

function manifest() {
  const { version, license } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
  const exported = Object.fromEntries(Object.entries(entries).map(([name, [script, types]]) =>
    [name, { types: `./${types}`, default: `./${script}` }]));
  return {
    name: 'wet-fur',
    version,
    description: 'Real-time fur that gets wet: an element, a function and a core for the browser (WebAssembly, WebGL2)',
    license,
    type: 'module',
    main: './index.js',
    types: './types/index.d.ts',
    exports: {
      ...exported,
      './wet-fur.wasm': './wet-fur.wasm',
      './wet-fur-core.wasm': './wet-fur-core.wasm',
      './models/*': './models/*',
      './types': { types: './types/index.d.ts' },
      // Our tags in JSX and in Vue's templates.
      './react': { types: './types/react.d.ts' },
      './vue': { types: './types/vue.d.ts' },
      './custom-elements.json': './custom-elements.json',
      './package.json': './package.json',
    },
    files: ['*', '!docs'],  // those are of the site
    customElements: './custom-elements.json',
    sideEffects: ['./element.js', './editor.js', './companions.js', './shared-*.js'],
  };
}

/** Every file that the package's manifest names and that `folder` lacks. */
export function missingFiles(folder) {
  const named = [...programs, ...Object.values(entries).flat(), 'custom-elements.json', 'types/attributes.d.ts', 'types/react.d.ts', 'types/vue.d.ts', 'index.html', 'embed.html', ...['otter', 'pony', 'bunny', 'plain-bunny', ...scenes.map(({ name }) => name)].map((name) => `models/${name}.glb`)];
  return named.filter((name) => !existsSync(join(folder, name)));
}

/** The scripts of web/, joined: the public ones under their names, what several need in files beside them. */
async function joinScripts(folder) {
  const { build } = await import('esbuild');
  await build({
    absWorkingDir: join(root, 'web'), outdir: folder, bundle: true, splitting: true, format: 'esm', target: 'es2022', logLevel: 'warning', minifySyntax: true, minifyIdentifiers: true,
    entryPoints: [...Object.values(entries).map(([script]) => script), 'page.js', 'embed.js'], chunkNames: 'shared-[hash]',
    // The programs' scripts are fetched when they are needed, again if that has failed.
    external: ['./wet-fur*.mjs', 'node:*'],
  });
}

/** The compiler writes a function for every export of a program: a loop is shorter. */
function joinExports(script) {
  const wrappers = [...script.matchAll(/var _(\w+)=Module\["_\1"\]=function\(\)\{return\(_\1=Module\["_\1"\]=Module\["asm"\]\["([\w$]+)"\]\)\.apply\(null,arguments\)\};/g)]
    .filter(([, name]) => name.startsWith('fur_'));
  if (wrappers.length === 0) return script;
  const keys = JSON.stringify(Object.fromEntries(wrappers.map(([, name, key]) => [`_${name}`, key])));
  const loop = `for (const [name, key] of Object.entries(${keys})) Module[name] = (...args) => (Module[name] = Module["asm"][key])(...args);\n`;
  return wrappers.reduce((text, [wrapper], i) => text.replace(wrapper, i === 0 ? loop : ''), script);
}

/** How the compiler's script would fetch a program and make an instance of it: web/runtime.js does both, always. */
function leaveInstances(script) {
  return script.replace(/if\(Module\["instantiateWasm"\]\)\{try\{var exports=Module\["instantiateWasm"\]\(info,receiveInstance\);return exports\}catch\(e\)\{[^{}]*\}\}/,
    'return Module["instantiateWasm"](info,receiveInstance);');
}

/** Scripts without comments and long names: half of what a visitor would download. Smaller than what joins them can. */
async function minifyScripts(folder) {
  const { minify } = await import('terser');
  for (const name of readdirSync(folder).filter((file) => /\.m?js$/.test(file))) {
    const file = join(folder, name);
    const { code } = await minify(leaveInstances(joinExports(readFileSync(file, 'utf8'))), { module: true, ecma: 2022, compress: { passes: 3 }, format: { quote_style: 1 } });
    writeFileSync(file, `${code}\n`);
  }
}

/** Puts dist/ together anew; the old one stays until the new one is whole. */
export async function assemble() {
  // Not at the top: commands that install their packages import this file first.
  const { attributesText, elementsOf, manifestOf } = await import('./elements.mjs');
  const next = join(root, 'build/dist.part');
  rmSync(next, { recursive: true, force: true });
  mkdirSync(next, { recursive: true });
  cpSync(join(root, 'web'), next, { recursive: true, filter: (path) => path !== icons && !notForSite.has(extname(path)) });
  for (const entry of readdirSync(next, { withFileTypes: true })) {
    if (entry.isDirectory() && readdirSync(join(next, entry.name)).length === 0) rmSync(join(next, entry.name), { recursive: true });
  }
  for (const name of programs) cpSync(join(buildFolder('web-release'), 'web', name), join(next, name));
  const tables = makeTables();
  writeFileSync(join(next, 'types/tables.d.ts'), typingsText(tables));
  const typings = join(next, 'types');
  for (const name of readdirSync(typings)) writeFileSync(join(typings, name), withEndings(readFileSync(join(typings, name), 'utf8'), tables));
  const elements = elementsOf(tables);
  writeFileSync(join(typings, 'attributes.d.ts'), attributesText(elements));
  writeFileSync(join(next, 'custom-elements.json'), `${JSON.stringify(manifestOf(elements, typings), null, 1)}\n`);
  const page = join(next, 'index.html');
  writeFileSync(page, pageText(readFileSync(page, 'utf8'), tables, drawingOf));
  await joinScripts(next);
  await minifyScripts(next);
  cpSync(join(root, 'build/models'), join(next, 'models'), { recursive: true });
  for (const name of ['LICENSE', 'README.md', 'CHANGELOG.md']) cpSync(join(root, name), join(next, name));
  writeFileSync(join(next, 'THIRD-PARTY-NOTICES.txt'), notices());
  writeFileSync(join(next, 'package.json'), `${JSON.stringify(manifest(), null, 2)}\n`);
  const { buildDocs } = await import('./docs/build.mjs');  // it needs the tables, too
  await buildDocs(next);
  const missing = missingFiles(next);
  if (missing.length > 0) throw new Stop(`dist/ would lack ${missing.join(', ')}`);
  rmSync(dist, { recursive: true, force: true });
  renameSync(next, dist);
}
