// Many figures on one page: node tests/bench/many.mjs [--count 24] [--dwell 400] [--mounts 200] [--sources otter.glb,bunny.glb,...]
// [--parts scroll,start,mounts,alone] [--draws 0]. Chromium draws with the CPU here, and tasks of the page wait for it: without draws they are
// what the program itself takes.
//
// scroll   one under the other, scrolled through twice: contexts, tasks of the page above 50 ms, memory after each pass
// start    until the first figure is live: of so many, and of one alone, in turn
// mounts   so many put on the page and taken off it, a few at a time: what is left of them
// alone    frames of one figure that turns
import { chromium } from 'playwright-core';
import { chromiumPath } from '../../tools/setup.mjs';
import { column, median, readOptions } from './browser.mjs';
import { serve } from '../../tools/serve.mjs';
import { fileURLToPath } from 'node:url';

const options = readOptions({
  count: '24', dwell: '400', mounts: '200', rounds: '5', parts: 'scroll,start,mounts,alone', size: '360x240', draws: '1', dist: fileURLToPath(new URL('../../dist', import.meta.url)),
  sources: 'bunny,otter,torus,sphere,pony,wet-bunny,half-wet,plane',
});
const [width, height] = options.size.split('x').map(Number), sources = options.sources.split(',');
const count = Number(options.count);

/** Runs before the page's scripts: notes contexts, what is in them, programs, tasks and listeners. */
function note() {
  const contexts = [], memories = new Set(), kinds = ['Texture', 'Buffer', 'Framebuffer', 'Renderbuffer', 'VertexArray', 'Program', 'Shader', 'Sampler', 'Query'];
  const original = OffscreenCanvas.prototype.getContext;
  OffscreenCanvas.prototype.getContext = function getContext(type, ...rest) {
    const gl = original.call(this, type, ...rest);
    if (type !== 'webgl2' || !gl || contexts.some((one) => one.gl.deref() === gl)) return gl;
    const entry = { gl: new WeakRef(gl), objects: 0, programs: 0 };
    contexts.push(entry);
    for (const kind of kinds) {
      const [create, remove] = [gl[`create${kind}`], gl[`delete${kind}`]];
      gl[`create${kind}`] = (...given) => {
        entry.objects++;
        if (kind === 'Program') entry.programs++;
        return create.apply(gl, given);
      };
      gl[`delete${kind}`] = (object) => {
        if (object) entry.objects--;
        remove.call(gl, object);
      };
    }
    return gl;
  };
  const instantiate = WebAssembly.instantiate;
  WebAssembly.instantiate = async (...given) => {
    const instance = await instantiate(...given);
    const memory = Object.values(instance.exports ?? {}).find((one) => one instanceof WebAssembly.Memory);
    if (memory) memories.add(new WeakRef(memory));
    return instance;
  };
  let listeners = 0;
  const { addEventListener, removeEventListener } = EventTarget.prototype;
  EventTarget.prototype.addEventListener = function add(type, work, given) {
    if (this === window || this === document || this instanceof MediaQueryList) {
      listeners++;
      given?.signal?.addEventListener.call(given.signal, 'abort', () => listeners--);
    }
    return addEventListener.call(this, type, work, given);
  };
  EventTarget.prototype.removeEventListener = function remove(type, work, given) {
    if (this === window || this === document || this instanceof MediaQueryList) listeners--;
    return removeEventListener.call(this, type, work, given);
  };
  const living = () => contexts.filter(({ gl }) => gl.deref()?.isContextLost() === false);
  window.held = () => ({
    contexts: living().length, made: contexts.length, programs: contexts.reduce((sum, one) => sum + one.programs, 0),
    objects: living().reduce((sum, { objects }) => sum + objects, 0), listeners,
    wasm: [...memories].reduce((sum, memory) => sum + (memory.deref()?.buffer.byteLength ?? 0), 0), instances: [...memories].filter((memory) => memory.deref()).length,
    gpu: [...document.querySelectorAll('wet-fur')].reduce((sum, fur) => sum + (fur.stats?.gpuBytes ?? 0), 0),
  });
}

function drawNothing() {
  for (const name of ['drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced', 'clear', 'blitFramebuffer', 'generateMipmap'])
    WebGL2RenderingContext.prototype[name] = () => {};
}

const pageOf = (figures) => `<!doctype html><meta charset="utf-8"><title>Many</title>
<style>body { margin: 0 } wet-fur { display: block; width: ${width}px; height: ${height}px; margin: 20px auto 60px }</style>
<script type="module" src="element.js"></script><p>Figures</p><div id="room">
${Array.from({ length: figures }, (_, i) => `<wet-fur id="fur${i}" src="${sources[i % sources.length]}" camera-controls camera-orbit="${13 * i}deg 20deg 3.4" refine="0"></wet-fur>`).join('\n')}</div>`;

const { url, close } = await serve({ folder: options.dist });
const browser = await chromium.launch({
  executablePath: chromiumPath(),
  args: ['--headless=new', '--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync', '--ignore-gpu-blocklist',
    '--js-flags=--expose-gc', ...process.env.FUR_SWIFT ? ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'] : ['--use-gl=angle', '--use-angle=gles-egl']],
});

async function open(figures) {
  const page = await browser.newPage({ viewport: { width: 480, height: 600 } });
  page.setDefaultTimeout(600000);
  page.on('pageerror', (error) => console.error(`${error}`));
  page.on('console', (message) => message.type() === 'error' && console.error(message.text()));
  await page.addInitScript(note);
  if (options.draws === '0') await page.addInitScript(drawNothing);
  await page.route('**/many.html', (route) => route.fulfill({ contentType: 'text/html', body: pageOf(figures) }));
  await page.goto(`${url}many.html`);
  return page;
}

/** Tasks of the page while `work` goes on, in milliseconds of the processor's time: on a busy machine the clock tells nothing. */
async function tasksDuring(page, work) {
  const session = await page.context().newCDPSession(page), tasks = [], mains = new Set();
  session.on('Tracing.dataCollected', ({ value }) => {
    for (const { name, args, pid, tid, tdur } of value) {
      if (name === 'thread_name' && args.name === 'CrRendererMain') mains.add(`${pid} ${tid}`);
      if (name.endsWith('RunTask') && tdur > 20000) tasks.push({ thread: `${pid} ${tid}`, ms: tdur / 1000 });
    }
  });
  await session.send('Tracing.start', { transferMode: 'ReportEvents', traceConfig: { includedCategories: ['toplevel', '__metadata'], excludedCategories: ['*'] } });
  const result = await work(), done = new Promise((resolve) => session.once('Tracing.tracingComplete', resolve));
  await session.send('Tracing.end');
  await done;
  await session.detach();
  return { ...result, tasks: tasks.filter(({ thread }) => mains.has(thread)).map(({ ms }) => ms).sort((a, b) => b - a) };
}

async function memory(page) {
  const session = await page.context().newCDPSession(page);
  for (let i = 0; i < 2; ++i) await session.send('HeapProfiler.collectGarbage');
  const { usedSize, backingStorageSize = 0 } = await session.send('Runtime.getHeapUsage');
  await session.detach();
  return { ...await page.evaluate(() => window.held()), heap: usedSize, buffers: backingStorageSize };
}
const mega = (bytes) => (bytes / 2 ** 20).toFixed(1);
const told = (m) => `${m.contexts} contexts (${m.made} made), ${m.instances} programs, ${m.programs} shader programs made, ${m.objects} GL objects, wasm ${mega(m.wasm)} MB, heap ${mega(m.heap)} MB, buffers ${mega(m.buffers)} MB, GPU ${mega(m.gpu)} MB, ${m.listeners} listeners`;

async function scroll() {
  const page = await open(count);
  const pass = () => page.evaluate(async ({ count, dwell }) => {
    let most = 0;
    for (let i = 0; i < count; ++i) {
      const fur = document.getElementById(`fur${i}`);
      fur.scrollIntoView({ block: 'center' });
      while (!fur.loaded || fur.state !== 'ready') await new Promise((resolve) => setTimeout(resolve, 20));
      await new Promise((resolve) => setTimeout(resolve, dwell));
      most = Math.max(most, held().contexts);
    }
    return { most };
  }, { count, dwell: Number(options.dwell) });
  const results = [];
  for (const name of ['first', 'second']) {
    const begun = performance.now(), { most, tasks } = await tasksDuring(page, pass);
    const after = await memory(page);
    console.log(`${name} pass, ${((performance.now() - begun) / 1000).toFixed(1)} s: at most ${most} contexts; ${tasks.filter((ms) => ms > 50).length} tasks above 50 ms, the longest ${tasks.slice(0, 12).map((ms) => ms.toFixed(0)).join(', ')}`);
    console.log(`   ${told(after)}`);
    results.push(after);
  }
  const sum = (m) => m.wasm + m.heap + m.buffers;
  console.log(`   the second over the first: ${(results[1].wasm / results[0].wasm).toFixed(3)} of the programs, ${(results[1].heap / results[0].heap).toFixed(3)} of the heap; a figure: ${mega(results[1].wasm / count)} MB of program, ${mega(sum(results[1]) / count)} MB in all`);
  console.log(await page.evaluate(() => [...document.querySelectorAll('wet-fur')].slice(0, 8).map((fur) => `${fur.src}: cpu ${(fur.stats?.cpuBytes / 1e6).toFixed(1)} gpu ${(fur.stats?.gpuBytes / 1e6).toFixed(1)}`).join('; ')));
  await page.close();
}

async function start() {
  const times = { one: [], many: [] };
  for (let i = 0; i < Number(options.rounds); ++i)
    for (const [name, figures] of [['one', 1], ['many', count]]) {
      const page = await open(figures);
      const ms = await page.evaluate(() => new Promise((resolve) => {
        const fur = document.getElementById('fur0');
        if (fur.loaded) resolve(performance.now());
        else fur.addEventListener('load', () => resolve(performance.now()));
      }));
      times[name].push(ms);
      await page.close();
    }
  const [one, many] = [median(times.one), median(times.many)];
  console.log(`until the first figure is live: alone ${one.toFixed(0)} ms, of ${count} ${many.toFixed(0)} ms, ${(many / one).toFixed(2)} times (medians of ${options.rounds})`);
}

async function mounts() {
  const page = await open(0);
  const put = (n) => page.evaluate(async ({ n, sources }) => {
    for (let i = 0; i < n; i += 4) {
      const some = Array.from({ length: Math.min(4, n - i) }, (_, k) => {
        const fur = document.createElement('wet-fur');
        Object.assign(fur, { src: ['torus', 'sphere', 'plane'][(i + k) % 3], loading: 'eager' });
        fur.setAttribute('refine', '0');
        return fur;
      });
      document.getElementById('room').append(...some);
      await Promise.all(some.map((fur) => fur.ready));
      some.forEach((fur) => fur.remove());
      await new Promise((resolve) => setTimeout(resolve));
    }
    await new Promise((resolve) => setTimeout(resolve, 300));
  }, { n, sources });
  const n = Number(options.mounts);
  await put(8);
  console.log(`mounted and removed   8: ${told(await memory(page))}`);
  await put(n);
  console.log(`mounted and removed ${column(8 + n, 3)}: ${told(await memory(page))}`);
  await page.close();
}

async function alone() {
  const page = await open(1);
  const times = await page.evaluate(async () => {
    const fur = document.getElementById('fur0');
    await new Promise((resolve) => (fur.loaded ? resolve() : fur.addEventListener('load', resolve)));
    await new Promise((resolve) => setTimeout(resolve, 2000));
    fur.quality = 'medium';
    fur.autoRotate = true;
    const times = [];
    for (let i = 0, last = performance.now(), drawn = fur.stats.framesDrawn; i < 60;) {
      await new Promise((resolve) => requestAnimationFrame(resolve));
      if (fur.stats.framesDrawn === drawn) continue;
      drawn = fur.stats.framesDrawn;
      const now = performance.now();
      times.push(now - last);
      last = now;
      ++i;
    }
    return times.slice(5);
  });
  console.log(`one that turns: ${median(times).toFixed(1)} ms a frame`);
  await page.close();
}

const parts = { scroll, start, mounts, alone };
for (const name of options.parts.split(',')) await parts[name]();
await browser.close();
await close();
