// Frame times of ours against the limit page (limit.js), in one browser, round by round, so that the
// machine's drift cancels: node tests/bench/run.mjs [--layers 16,32,64] [--sizes 800x600] [--rounds 9]
// [--query "wetness=0.8"] [--shots folder] [--model bunny|bunny16|torus142k]. Absolute times mean something only on a GPU.
import { mkdir } from 'node:fs/promises';
import { join } from 'node:path';
import { column, median, readOptions, timeInTurn, withBrowser } from './browser.mjs';

const options = readOptions({ layers: '16,32,64', sizes: '800x600', rounds: '9', query: '', shots: '', model: 'bunny', frames: '4' });

async function measure(open, layers, size) {
  const [width, height] = size.split('x'), tabs = {};
  for (const page of ['limit', 'fur']) {
    tabs[page] = await open(`page=${page}&shells=${layers}&width=${width}&height=${height}&mesh=${options.model}&${options.query}`);
    if (!options.shots) continue;
    await mkdir(options.shots, { recursive: true });
    await tabs[page].screenshot({ path: join(options.shots, `${page}-${layers}-${size}.png`) });
  }
  const rounds = await timeInTurn(tabs, Number(options.rounds), Number(options.frames));
  const firstFrame = await tabs.fur.evaluate(() => window.firstFrameMs);
  for (const tab of Object.values(tabs)) await tab.close();
  const ratios = rounds.map((r) => r.fur / r.limit);
  console.log([
    column(layers, 6), column(size, 10), column(median(rounds.map((r) => r.limit)).toFixed(1), 10),
    column(median(rounds.map((r) => r.fur)).toFixed(1), 10), column(median(ratios).toFixed(2), 7),
    column(`${Math.min(...ratios).toFixed(2)} to ${Math.max(...ratios).toFixed(2)}`, 14), column(firstFrame.toFixed(0), 12),
  ].join(' '));
}

await withBrowser(async (open) => {
  console.log(`${options.model}${options.query ? `, ${options.query}` : ''}: median of ${options.rounds} rounds, milliseconds a frame`);
  console.log('layers       size      limit       ours   ratio        min, max  first frame');
  for (const size of options.sizes.split(','))
    for (const layers of options.layers.split(',')) await measure(open, Number(layers), size);
});
