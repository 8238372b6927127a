// npm run native -- [scene]: the desktop editor.
import { join } from 'node:path';
import { models } from './build.mjs';
import { build, buildFolder } from './cmake.mjs';
import { makeAssets } from './makeAssets.mjs';
import { command, run } from './process.mjs';
import { needs, setUp } from './setup.mjs';

await command(() => {
  setUp({ packages: [needs.native], npm: true, imgui: true });
  build('native-release', ['wet-fur-make-assets', 'wet-fur']);
  makeAssets(join(buildFolder('native-release'), 'wet-fur-make-assets'), models);
  run(join(buildFolder('native-release'), 'wet-fur'), process.argv.slice(2), { cwd: process.env.INIT_CWD ?? process.cwd() });
});
