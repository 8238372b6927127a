// Frame times of ours against the limit page (limit.js), in one browser, round by round, so that the
// machine's drift cancels: node tests/bench/run.mjs [--layers 16,32,64] [--sizes 800x600] [--rounds 9]
// [--query "wetness=0.8"] [--shots folder] [--model plain-bunny|bunny16|torus142k] [--technique march,shells]. Absolute times mean
// something only on a GPU. Of several techniques each has a line, measured in the same rounds.
import { mkdir } from 'node:fs/promises';
import { join } from 'node:path';
import { column, median, readOptions, timeInTurn, withBrowser } from './browser.mjs';

const options = readOptions({ layers: '16,32,64', sizes: '800x600', rounds: '9', query: '', shots: '', model: 'plain-bunny', frames: '4', technique: 'march' });
const techniques = options.technique.split(',');

async function measure(open, layers, size) {
  const [width, height] = size.split('x'), tabs = {};
  for (const name of ['limit', ...techniques]) {
    const page = name === 'limit' ? 'page=limit' : `page=fur&technique=${name}`;
    tabs[name] = await open(`${page}&shells=${layers}&width=${width}&height=${height}&mesh=${options.model}&${options.query}`);
    if (!options.shots) continue;
    await mkdir(options.shots, { recursive: true });
    await tabs[name].screenshot({ path: join(options.shots, `${name}-${layers}-${size}.png`) });
  }
  const rounds = await timeInTurn(tabs, Number(options.rounds), Number(options.frames));
  for (const name of techniques) {
    const firstFrame = await tabs[name].evaluate(() => window.firstFrameMs), ratios = rounds.map((r) => r[name] / r.limit);
    console.log([
      column(layers, 6), column(size, 10), column(median(rounds.map((r) => r.limit)).toFixed(1), 10),
      column(name, 8), column(median(rounds.map((r) => r[name])).toFixed(1), 8), column(median(ratios).toFixed(2), 7),
      column(`${Math.min(...ratios).toFixed(2)} to ${Math.max(...ratios).toFixed(2)}`, 14), column(firstFrame.toFixed(0), 12),
    ].join(' '));
  }
  for (const tab of Object.values(tabs)) await tab.close();
}

await withBrowser(async (open) => {
  console.log(`${options.model}${options.query ? `, ${options.query}` : ''}: median of ${options.rounds} rounds, milliseconds a frame`);
  console.log('layers       size      limit             ours   ratio        min, max  first frame');
  for (const size of options.sizes.split(','))
    for (const layers of options.layers.split(',')) await measure(open, Number(layers), size);
});
