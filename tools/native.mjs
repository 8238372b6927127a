// npm run native -- [scene]: the desktop editor.
import { buildNative } from './build.mjs';
import { command, run } from './process.mjs';
import { needs, setUp } from './setup.mjs';

await command(async () => {
  setUp({ packages: [needs.native], npm: true, imgui: true });
  run(await buildNative('wet-fur'), process.argv.slice(2), { cwd: process.env.INIT_CWD ?? process.cwd() });
});
