// npm run bench: frame times (tests/bench/run.mjs), those of long hair (tests/bench/hair.mjs), of several types and materials, and saving
// (tests/bench/several.mjs), of the animals that move (tests/bench/animals.mjs), the generator's (tests/bench/coat.mjs)
// ten slow seconds (tests/bench/governor.mjs) and many figures on a page (tests/bench/many.mjs), of the built site.
import { join } from 'node:path';
import { buildSite } from './build.mjs';
import { command, root, run } from './process.mjs';
import { chromiumPath, needs, setUp } from './setup.mjs';

await command(async () => {
  setUp({ packages: [needs.browser] });
  await buildSite();
  run(process.execPath, [join(root, 'tests/bench/coat.mjs')]);
  run(process.execPath, [join(root, 'tests/bench/hair.mjs')], { env: { FUR_CHROMIUM: chromiumPath() } });
  run(process.execPath, [join(root, 'tests/bench/several.mjs')], { env: { FUR_CHROMIUM: chromiumPath() } });
  run(process.execPath, [join(root, 'tests/bench/animals.mjs')], { env: { FUR_CHROMIUM: chromiumPath() } });
  run(process.execPath, [join(root, 'tests/bench/governor.mjs')], { env: { FUR_CHROMIUM: chromiumPath() } });
  run(process.execPath, [join(root, 'tests/bench/many.mjs'), '--draws', '0'], { env: { FUR_CHROMIUM: chromiumPath() } });
  run(process.execPath, [join(root, 'tests/bench/run.mjs'), ...process.argv.slice(2)], { env: { FUR_CHROMIUM: chromiumPath() } });
});
