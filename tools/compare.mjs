// npm run compare -- [model] [--views near,far] [--layers 16,32] [--variant name=value,...] [--out folder] [...]:
// how far the real-time picture looks from the reference that draws every strand. The arguments are those of
// the program wet-fur-compare; paths are relative to where npm was called.
import { buildNative } from './build.mjs';
import { command, run } from './process.mjs';
import { needs, setUp } from './setup.mjs';

await command(async () => {
  setUp({ packages: [needs.headless], npm: true });
  run(await buildNative('wet-fur-compare'), process.argv.slice(2), { cwd: process.env.INIT_CWD ?? process.cwd() });
});
