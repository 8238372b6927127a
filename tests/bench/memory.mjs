// What the page's model takes of memory: the program's heap and its GL objects as it counts them, dry, then wet with the picture gathered.
// node tests/bench/memory.mjs [--query "src=bunny"] [--size 800x600] [--wetness 0.7] [--seconds 3] [--dist FOLDER]
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import { serve } from '../../tools/serve.mjs';
import { chromiumPath } from '../../tools/setup.mjs';
import { readOptions } from './browser.mjs';

const options = readOptions({ query: '', size: '800x600', wetness: '0.7', seconds: '3', dist: fileURLToPath(new URL('../../dist', import.meta.url)) });
const [width, height] = options.size.split('x').map(Number);

/** Runs before the page's scripts: notes the memories of programs. */
function note() {
  const memories = new Set();
  const keep = (instance) => {
    const memory = Object.values(instance.exports).find((one) => one instanceof WebAssembly.Memory);
    if (memory) memories.add(memory);
  };
  for (const name of ['instantiate', 'instantiateStreaming']) {
    const original = WebAssembly[name];
    WebAssembly[name] = async (...given) => {
      const result = await original.apply(WebAssembly, given);
      keep(result.instance ?? result);
      return result;
    };
  }
  window.programBytes = () => [...memories].map((memory) => memory.buffer.byteLength);
}

const { url, close } = await serve({ folder: options.dist });
const browser = await chromium.launch({
  executablePath: chromiumPath(),
  args: ['--headless=new', '--no-sandbox', '--disable-quic', '--no-first-run', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
});
const page = await browser.newPage({ viewport: { width, height } });
page.setDefaultTimeout(300000);
page.on('pageerror', (error) => console.error(`${error}`));
await page.addInitScript(note);
await page.goto(`${url}?${options.query}`);
await page.waitForFunction(() => window.wetFur?.loaded);

async function tell(what) {
  const session = await page.context().newCDPSession(page);
  await session.send('HeapProfiler.collectGarbage');
  const { usedSize } = await session.send('Runtime.getHeapUsage');
  await session.detach();
  const { programs, gpu, cpu } = await page.evaluate(() => ({ programs: programBytes(), gpu: wetFur.stats.gpuBytes, cpu: wetFur.stats.cpuBytes }));
  const mega = (bytes) => (bytes / 2 ** 20).toFixed(1).padStart(6);
  const program = programs.reduce((sum, bytes) => sum + bytes, 0);
  console.log(`${what.padEnd(28)} program ${mega(program)} MB (${programs.map(mega).join(', ')}), GL ${mega(gpu)} MB, together ${mega(program + gpu)} MB; scripts ${mega(usedSize)} MB, stats.cpuBytes ${mega(cpu)}`);
}
/** Waits until nothing more is drawn, and no samples are gathered out of sight. */
const settled = () => page.evaluate(async () => {
  for (let before = -1, same = 0; same < 15;) {
    await new Promise((resolve) => setTimeout(resolve, 700));
    same = wetFur.stats.framesDrawn === before ? same + 1 : 0;
    before = wetFur.stats.framesDrawn;
  }
});
await settled().catch(() => {});
await tell('dry');
await page.evaluate(async ({ wetness, seconds }) => {
  wetFur.setWetness(wetness);
  await new Promise((resolve) => setTimeout(resolve, 1000 * seconds));
}, { wetness: Number(options.wetness), seconds: Number(options.seconds) });
await tell('wet');
await page.evaluate(() => { wetFur.stayWet = true; });
await Promise.race([settled(), new Promise((resolve) => setTimeout(resolve, 120000))]);
await tell('wet, picture gathered');
await browser.close();
await close();
