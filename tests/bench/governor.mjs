// Ten seconds of forced slow-down in the middle of an animated scene, as a table: second, frame time, level, pixels.
// node tests/bench/governor.mjs [--size 480x360] [--query "layers=32"] [--repeats 6] [--budget MS] [--seconds 10]
// Without a budget it is twice what a frame takes before. Slow: every draw of triangles is repeated.
import { chromium } from 'playwright-core';
import { chromiumPath } from '../../tools/setup.mjs';
import { serve } from '../../tools/serve.mjs';
import { dist } from '../../tools/site.mjs';

const options = { size: '480x360', query: '', repeats: '6', budget: '', seconds: '10' };
for (let i = 2; i < process.argv.length; i += 2) {
  const name = process.argv[i].replace(/^--/, '');
  if (!(name in options)) throw new Error(`unknown option ${process.argv[i]}; there are --${Object.keys(options).join(', --')}`);
  options[name] = process.argv[i + 1];
}
const [width, height] = options.size.split('x').map(Number);

/** In the page: draws are repeated window.repeats times; window.frames gathers what each frame was. */
function prepare() {
  window.repeats = 1;
  window.frames = [];
  const { drawElementsInstanced } = WebGL2RenderingContext.prototype;
  WebGL2RenderingContext.prototype.drawElementsInstanced = function repeated(...args) {
    for (let i = 0; i < window.repeats; i++) {
      if (i > 0) this.clear(this.DEPTH_BUFFER_BIT);
      drawElementsInstanced.apply(this, args);
    }
  };
  let last = 0;
  const each = (time) => {
    const { level, pixels } = window.wetFur?.stats ?? {};
    window.frames.push({ ms: time - last, level, pixels });
    last = time;
    requestAnimationFrame(each);
  };
  requestAnimationFrame(each);
}

const median = (values) => [...values].sort((a, b) => a - b)[values.length >> 1] ?? NaN;
const server = await serve({ folder: dist });
const browser = await chromium.launch({
  executablePath: chromiumPath(),
  args: ['--headless=new', '--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--disable-quic',
    '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'],
});
try {
  const page = await browser.newPage({ viewport: { width, height } });
  page.on('pageerror', (error) => console.error(String(error)));
  await page.addInitScript(prepare);
  await page.goto(`${server.url}?ui=0&quality=auto&wind=1&motion=full&dryRate=0&${options.query}`);
  await page.waitForFunction(() => window.wetFur?.loaded, null, { timeout: 120000 });
  const seconds = async (count, each = () => {}) => {
    const all = [];
    for (let i = 0; i < count; i++) {
      await page.evaluate(() => { window.frames = []; });
      await page.waitForTimeout(1000);
      const frames = await page.evaluate(() => window.frames);
      all.push(...frames);
      each(i, frames);
    }
    return all;
  };
  await page.evaluate(() => { wetFur.frameBudget = 1000; });
  await seconds(2);
  const before = median((await seconds(3)).map((frame) => frame.ms));
  const budget = Number(options.budget) || 2 * before;
  await page.evaluate((ms) => { wetFur.frameBudget = ms; }, budget);
  console.log(`${options.size}: ${before.toFixed(1)} ms a frame before, budget ${budget.toFixed(1)} ms, then ${options.repeats} times the draws`);
  console.log('second  draws  frames  median ms  level   pixels');
  const column = (value, size) => String(value).padStart(size);
  let clock = 0;
  for (const [count, repeats] of [[3, 1], [Number(options.seconds), Number(options.repeats)], [20, 1]]) {
    await page.evaluate((n) => { window.repeats = n; }, repeats);
    await seconds(count, (_, frames) => {
      const { level, pixels } = frames.at(-1) ?? {};
      console.log([column(++clock, 6), column(repeats, 6), column(frames.length, 7),
        column(median(frames.map((frame) => frame.ms)).toFixed(1), 10), column(level, 6), column(pixels, 8)].join(' '));
    });
  }
} finally {
  await browser.close();
  await server.close();
}
