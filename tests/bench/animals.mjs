// Frames of the animals, moving with everything on, against the bunny's where both cover as much of the picture; round by round in one
// browser: node tests/bench/animals.mjs [--models otter,pony,otter:fins=false&layers=8] [--rounds 9] [--frames 4] [--size 800x600] [--covers 0.2] [--wet 0,0.8] [--shots folder]
import { mkdir } from 'node:fs/promises';
import { join } from 'node:path';
import { column, median, readOptions, timeInTurn, withBrowser } from './browser.mjs';

const options = readOptions({ models: 'otter,pony', rounds: '9', frames: '4', size: '800x600', covers: '0.2', wet: '0,0.8', shots: '' });
const [width, height] = options.size.split('x');

if (options.shots) await mkdir(options.shots, { recursive: true });
await withBrowser(async (open) => {
  for (const wet of options.wet.split(',').map((wetness) => (wetness === '0' ? {} : { wetness }))) {
    const tabs = {};
    for (const name of ['bunny', ...options.models.split(',')]) {
      const [mesh, settings = ''] = name.split(':');
      tabs[name] = await open(new URLSearchParams({ page: 'animal', mesh, width, height, covers: options.covers, settings, ...wet }).toString());
      if (options.shots) await tabs[name].screenshot({ path: join(options.shots, `${name}${wet.wetness ? '-wet' : ''}.png`) });
    }
    console.log(`${wet.wetness ? 'wet' : 'dry'}, ${options.size}: median of ${options.rounds} rounds, milliseconds a frame`);
    const rounds = await timeInTurn(tabs, Number(options.rounds), Number(options.frames));
    for (const [name, tab] of Object.entries(tabs)) {
      const ratios = rounds.map((round) => round[name] / round.bunny), { covers } = await tab.evaluate(() => window.info);
      console.log(`${name.padEnd(12)} ${column(median(rounds.map((round) => round[name])).toFixed(1), 8)} ms   covers ${covers.toFixed(3)}   this / bunny ${median(ratios).toFixed(2)} (${Math.min(...ratios).toFixed(2)} to ${Math.max(...ratios).toFixed(2)})`);
      await tab.close();
    }
  }
});
