// npm run render -- scene.glb -o out.png --size 1600x900 [...]: a picture without a window. The
// arguments are those of the program wet-fur-render; paths are relative to where npm was called.
import { buildNative } from './build.mjs';
import { command, run } from './process.mjs';
import { needs, setUp } from './setup.mjs';

await command(async () => {
  setUp({ packages: [needs.headless], npm: true });
  run(await buildNative('wet-fur-render'), process.argv.slice(2), { cwd: process.env.INIT_CWD ?? process.cwd() });
});
