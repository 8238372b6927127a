// npm run render -- scene.glb -o out.png --size 1600x900 [...]: a picture without a window. The
// arguments are those of the program wet-fur-render; paths are relative to where npm was called.
import { join } from 'node:path';
import { models } from './build.mjs';
import { build, buildFolder } from './cmake.mjs';
import { makeAssets } from './makeAssets.mjs';
import { command, run } from './process.mjs';
import { needs, setUp } from './setup.mjs';

await command(() => {
  setUp({ packages: [needs.headless], npm: true });
  build('native-release', ['wet-fur-make-assets', 'wet-fur-render']);
  makeAssets(join(buildFolder('native-release'), 'wet-fur-make-assets'), models);
  run(join(buildFolder('native-release'), 'wet-fur-render'), process.argv.slice(2), { cwd: process.env.INIT_CWD ?? process.cwd() });
});
