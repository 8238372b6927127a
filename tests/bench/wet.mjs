// What a frame of wet fur costs beside one of dry fur, in one browser, round by round: the work of its software rasteriser in milliseconds of
// processors, of which other work on the machine takes nothing away. node tests/bench/wet.mjs [--wetness 0.5,1] [--lengths 0.06,0.12] [--sizes 800x600,1680x1050] [--layers 16] [--rounds 7] [--frames 12] [--model plain-bunny] [--query "view=steps"] [--shots folder]
import { mkdir } from 'node:fs/promises';
import { join } from 'node:path';
import { column, median, readOptions, workInTurn, withBrowser } from './browser.mjs';

const options = readOptions({
  wetness: '0.5,1', lengths: '0.06,0.12', sizes: '800x600,1680x1050', layers: '16', rounds: '7', frames: '12', model: 'plain-bunny', query: '', shots: '',
});

async function measure(open, length, size) {
  const [width, height] = size.split('x'), tabs = {};
  for (const wetness of ['0', ...options.wetness.split(',')]) {
    const name = `wet ${wetness}`;
    // Water stays where it is.
    tabs[name] = await open(`page=fur&shells=${options.layers}&width=${width}&height=${height}&mesh=${options.model}&length=${length}&gravity=0&${options.query}&wetness=${wetness}`);
    if (!options.shots) continue;
    await mkdir(options.shots, { recursive: true });
    await tabs[name].screenshot({ path: join(options.shots, `${length}-${size}-${wetness}.png`) });
  }
  const rounds = await workInTurn(tabs, Number(options.rounds), Number(options.frames));
  for (const tab of Object.values(tabs)) await tab.close();
  for (const name of Object.keys(tabs)) {
    const ratios = rounds.map((round) => round[name] / round['wet 0']);
    console.log([column(length, 7), column(size, 10), column(name, 9), column(median(rounds.map((round) => round[name])).toFixed(1), 8),
      column(median(ratios).toFixed(2), 7), column(`${Math.min(...ratios).toFixed(2)} to ${Math.max(...ratios).toFixed(2)}`, 14)].join(' '));
  }
}

await withBrowser(async (open) => {
  console.log(`${options.model}, ${options.layers} layers: median of ${options.rounds} rounds, milliseconds of processors a frame`);
  console.log(' length       size           ours   ratio       min, max');
  for (const size of options.sizes.split(','))
    for (const length of options.lengths.split(',')) await measure(open, length, size);
});
