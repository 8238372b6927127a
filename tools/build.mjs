// npm run build: dist/, with all set-up that takes.
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { makeAssets } from '../assets/makeAssets.mjs';
import { build, buildFolder } from './cmake.mjs';
import { command, root, say } from './process.mjs';
import { needs, setUp } from './setup.mjs';
import { assemble, dist } from './site.mjs';

/** Where the programs, native and web, look for the models that are shipped. */
export const models = join(root, 'build/models');

/** Builds native programs, and the models that they look for. Returns the path of the first. */
export async function buildNative(...programs) {
  const folder = buildFolder('native-release');
  await build('native-release', ['wet-fur-make-assets', ...programs]);
  makeAssets(join(folder, 'wet-fur-make-assets'), models);
  return join(folder, programs[0]);
}

/** The programs of dist/, and the one that makes its models. */
export const siteTargets = ['wet-fur-make-assets', 'wet-fur', 'wet-fur-hair', 'wet-fur-editor', 'wet-fur-core'];

/** Brings dist/ up to date. */
export async function buildSite() {
  setUp({ packages: [needs.web], npm: true, imgui: true });
  await build('web-release', siteTargets);
  makeAssets(join(buildFolder('web-release'), 'node/wet-fur-make-assets.js'), models);
  await assemble();
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  await command(async () => {
    await buildSite();
    say(`done: ${dist}`);
  });
}
