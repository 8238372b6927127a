// A browser for the bench pages: Chromium with its software rasteriser, and pages that are timed in turn.
import { mkdtemp, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from 'playwright-core';
import { chromiumPath } from '../../tools/setup.mjs';
import { serve } from './server.mjs';

export const median = (values) => {
  const sorted = [...values].sort((a, b) => a - b), middle = sorted.length >> 1;
  return sorted.length % 2 ? sorted[middle] : (sorted[middle - 1] + sorted[middle]) / 2;
};
export const column = (text, width) => String(text).padStart(width);

/** Options of the command line over their defaults: --name value. */
export function readOptions(defaults) {
  const options = { ...defaults };
  for (let i = 2; i < process.argv.length; i += 2) {
    const name = process.argv[i].replace(/^--/, '');
    if (!(name in options)) throw new Error(`unknown option ${process.argv[i]}; there are --${Object.keys(options).join(', --')}`);
    options[name] = process.argv[i + 1];
  }
  return options;
}

/** work(open) with a browser; open(query) gives a tab of page.html that has drawn. */
export async function withBrowser(work) {
  const { origin, close } = await serve();
  const profile = await mkdtemp(join(tmpdir(), 'wet-fur-bench-'));
  const context = await chromium.launchPersistentContext(profile, {
    executablePath: chromiumPath(),
    headless: false,
    viewport: { width: 1700, height: 1060 },
    args: ['--headless=new', '--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking',
      '--disable-component-update', '--disable-sync', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  });
  const open = async (query) => {
    const tab = await context.newPage();
    tab.on('pageerror', (error) => console.error(`${query}: ${error}`));
    tab.on('console', (message) => message.type() === 'error' && console.error(`${query}: ${message.text()}`));
    await tab.goto(`${origin}/bench/page.html?${query}`);
    await tab.waitForFunction(() => window.bench, null, { timeout: 120000 });
    await tab.evaluate(() => window.bench(2));
    return tab;
  };
  try {
    await work(open);
  } finally {
    await context.close();
    close();
    await rm(profile, { recursive: true, force: true, maxRetries: 5 });
  }
}

/** frameOf(tab) for each of the tabs, by name, in each of some rounds, in turn, so that the machine's drift cancels. */
async function inTurn(tabs, rounds, frameOf) {
  const all = [];
  for (let i = 0; i < rounds; ++i) {
    const round = {};
    for (const [name, tab] of Object.entries(tabs)) {
      await tab.bringToFront();
      round[name] = await frameOf(tab);
    }
    all.push(round);
  }
  return all;
}

/** The median frame of each of the tabs in each round, in milliseconds by the clock. */
export const timeInTurn = (tabs, rounds, frames) =>
  inTurn(tabs, rounds, async (tab) => median(await tab.evaluate((n) => window.bench(n), frames)));

/** The mean frame of each of the tabs in each round, in milliseconds of processors that the software rasteriser took: what else runs meanwhile hardly
 * counts. It knows hundredths of a second: ten frames at least. */
export async function workInTurn(tabs, rounds, frames) {
  const session = await Object.values(tabs)[0].context().browser().newBrowserCDPSession();
  const taken = async () => {
    const { processInfo } = await session.send('SystemInfo.getProcessInfo');
    return processInfo.find(({ type }) => type === 'GPU').cpuTime * 1000;
  };
  const all = await inTurn(tabs, rounds, async (tab) => {
    await tab.evaluate(() => window.bench(1));
    const before = await taken();
    await tab.evaluate((n) => window.bench(n), frames);
    return (await taken() - before) / frames;
  });
  await session.detach();
  return all;
}
