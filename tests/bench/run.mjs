// Frame times of ours against the limit page (limit.js), in one browser, round by round, so that the
// machine's drift cancels: node tests/bench/run.mjs [--layers 16,32,64] [--sizes 800x600] [--rounds 9]
// [--query "wetness=0.8"] [--shots folder] [--model bunny|bunny16|torus142k]. Absolute times mean something only on a GPU.
import { mkdir, mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from 'playwright-core';
import { chromiumPath } from '../../tools/setup.mjs';
import { serve } from './server.mjs';

const options = { layers: '16,32,64', sizes: '800x600', rounds: '9', query: '', shots: '', model: 'bunny', frames: '4' };
for (let i = 2; i < process.argv.length; i += 2) {
  const name = process.argv[i].replace(/^--/, '');
  if (!(name in options)) throw new Error(`unknown option ${process.argv[i]}; there are --${Object.keys(options).join(', --')}`);
  options[name] = process.argv[i + 1];
}

const { origin, close } = await serve();

const median = (values) => {
  const sorted = [...values].sort((a, b) => a - b), middle = sorted.length >> 1;
  return sorted.length % 2 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
};

async function open(context, page, layers, size) {
  const [width, height] = size.split('x');
  const tab = await context.newPage();
  tab.on('pageerror', (error) => console.error(`${page}: ${error}`));
  tab.on('console', (message) => message.type() === 'error' && console.error(`${page}: ${message.text()}`));
  await tab.goto(`${origin}/bench/page.html?page=${page}&shells=${layers}&width=${width}&height=${height}&mesh=${options.model}&${options.query}`);
  await tab.waitForFunction(() => window.bench, null, { timeout: 120000 });
  await tab.evaluate(() => window.bench(2));
  if (options.shots) {
    await mkdir(options.shots, { recursive: true });
    await tab.screenshot({ path: join(options.shots, `${page}-${layers}-${size}.png`) });
  }
  return tab;
}

async function measure(context, layers, size) {
  const tabs = { limit: await open(context, 'limit', layers, size), fur: await open(context, 'fur', layers, size) };
  const rounds = [];
  for (let i = 0; i < Number(options.rounds); ++i) {
    const round = {};
    for (const [name, tab] of Object.entries(tabs)) {
      await tab.bringToFront();
      round[name] = median(await tab.evaluate((n) => window.bench(n), Number(options.frames)));
    }
    rounds.push(round);
  }
  const firstFrame = await tabs.fur.evaluate(() => window.firstFrameMs);
  for (const tab of Object.values(tabs)) await tab.close();
  const ratios = rounds.map((r) => r.fur / r.limit);
  const column = (text, width) => String(text).padStart(width);
  console.log([
    column(layers, 6), column(size, 10), column(median(rounds.map((r) => r.limit)).toFixed(1), 10),
    column(median(rounds.map((r) => r.fur)).toFixed(1), 10), column(median(ratios).toFixed(2), 7),
    column(`${Math.min(...ratios).toFixed(2)} to ${Math.max(...ratios).toFixed(2)}`, 14), column(firstFrame.toFixed(0), 12),
  ].join(' '));
}

const profile = await mkdtemp(join(tmpdir(), 'wet-fur-bench-'));
const context = await chromium.launchPersistentContext(profile, {
  executablePath: chromiumPath(),
  headless: false,
  viewport: { width: 1700, height: 1060 },
  args: ['--headless=new', '--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
    '--disable-component-update', '--disable-sync', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});
try {
  console.log(`${options.model}${options.query ? `, ${options.query}` : ''}: median of ${options.rounds} rounds, milliseconds a frame`);
  console.log('layers       size      limit       ours   ratio        min, max  first frame');
  for (const size of options.sizes.split(','))
    for (const layers of options.layers.split(',')) await measure(context, Number(layers), size);
} finally {
  await context.close();
  close();
  await rm(profile, { recursive: true, force: true, maxRetries: 5 });
}
