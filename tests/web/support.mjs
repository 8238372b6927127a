// One Chromium and one server a test file; pages that report every error they meet.
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { basename, dirname, join } from 'node:path';
import { after, afterEach, before } from 'node:test';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';
import { PNG } from 'pngjs';
import { serve } from '../../tools/serve.mjs';
import { Pages } from './pages.mjs';

export const root = fileURLToPath(new URL('../../', import.meta.url));
/** The folder under test; another one than dist/ when FUR_DIST names it. */
export const dist = process.env.FUR_DIST ?? join(root, 'dist');

const flags = [
  '--headless=new', '--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync',
];
/** Who draws, on the CPU: Chromium's own rasteriser, or Mesa's where there is one, which takes two thirds of the time. */
const rasterisers = {
  swiftshader: ['--use-angle=swiftshader', '--enable-unsafe-swiftshader'],
  mesa: ['--use-gl=angle', '--use-angle=gles-egl', '--ignore-gpu-blocklist'],
};

/** A browser that draws with Mesa if that is asked for and there; else with Chromium's own. */
async function launch(wanted) {
  const open = (name) => chromium.launch({ executablePath: chromiumPath(), args: [...flags, ...rasterisers[name]] });
  const browser = await open(wanted);
  if (wanted === 'swiftshader') return browser;
  const page = await browser.newPage();
  const renderer = await page.evaluate(() => {
    const gl = document.createElement('canvas').getContext('webgl2');
    const info = gl?.getExtension('WEBGL_debug_renderer_info');
    return info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : '';
  });
  await page.close();
  if (/llvmpipe/.test(renderer)) return browser;
  await browser.close();
  return open('swiftshader');
}

function chromiumPath() {
  const named = process.env.FUR_CHROMIUM || process.env.CHROMIUM;
  const usual = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/usr/bin/google-chrome', '/snap/bin/chromium',
    '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome'];
  const found = named || usual.find(existsSync);
  assert.ok(found, 'no Chromium: name one in CHROMIUM');
  return found;
}

/** Milliseconds after which something is taken to hang: no machine is so slow or busy. */
const patience = 300000;

/** Small, because a software rasteriser draws; light, because most tests are not about the coat, its shadow, how it breathes or how a picture gets better. */
const viewport = { width: 480, height: 360 };
export const plain = 'quality=low&layers=8&fins=0&breath=0&lie=0&shadows=none&refine=0';
export const light = `${plain}&ui=0`;

/**
 * Runs before the page's scripts. With `fast`, each frame comes a tenth of a second after the one before, as on a slow
 * machine, but at once: nobody waits for water to run and fur to settle. `untilStill(fur)` resolves when no frame is drawn any more.
 */
function watchTime(fast) {
  const { requestAnimationFrame: frame, cancelAnimationFrame: cancelFrame, setTimeout: later, clearTimeout: cancelLater } = window;
  const soon = 400;  // ms: what is asked for later than that draws nothing
  const frames = new Set(), timers = new Set();  // that are asked for
  let shown = 0, clock = 0;
  const clockAt = (time) => {
    if (time !== shown) clock = Math.max(clock + 100, time);
    shown = time;
    return clock;
  };
  window.requestAnimationFrame = (work) => {
    const id = frame((time) => {
      frames.delete(id);
      work(fast ? clockAt(time) : time);
    });
    frames.add(id);
    return id;
  };
  window.cancelAnimationFrame = (id) => {
    frames.delete(id);
    cancelFrame(id);
  };
  window.setTimeout = (work, milliseconds = 0, ...given) => {
    const id = later((...all) => {
      timers.delete(id);
      work(...all);
    }, milliseconds, ...given);
    if (milliseconds <= soon) timers.add(id);
    return id;
  };
  window.clearTimeout = (id) => {
    timers.delete(id);
    cancelLater(id);
  };
  const look = () => new Promise((resolve) => { frame(() => later(resolve, 20)); });
  window.untilStill = async (fur) => {
    const drawnNow = () => fur.stats?.framesDrawn;
    // Elsewhere on the page something may go on for ever: frames that draw nothing are waited for so often and no more. A timer is
    // always waited for: a better picture may take many looks where the graphics processor is busy or a shader is still being linked.
    const most = 20;
    for (let looks = 0, idle = 0, drawn = drawnNow(); looks < 3 && idle < most; drawn = drawnNow()) {
      await look();
      const isStill = drawnNow() === drawn;
      idle = isStill && timers.size === 0 ? idle + 1 : 0;
      looks = isStill && frames.size + timers.size === 0 ? looks + 1 : 0;
      // Of five seconds that go by only the end is drawn. What waits for a timer a step would put off.
      if (fast && frames.size > 0 && fur.state === 'ready' && !fur.paused) fur.step(0.1, 49);
    }
    return drawnNow();
  };
}

/** A picture that stays is not made better, as few tests are about that: on the CPU its samples take as long as all the rest. */
function leavePictures() {
  new MutationObserver(() => {
    for (const fur of document.querySelectorAll('wet-fur:not([refine])')) fur.setAttribute('refine', '0');
  }).observe(document, { childList: true, subtree: true });
}

/** Notes what the page's policy stops. */
function noteViolations() {
  window.violations = [];
  document.addEventListener('securitypolicyviolation', (event) => window.violations.push(event.violatedDirective));
}

/** Notes which model each figure shows (`untilShown()`). */
function noteShown() {
  document.addEventListener('load', ({ target, detail }) => { if (target.localName === 'wet-fur') target.shownName = detail.name; }, true);
}

/**
 * Starts both before the tests of a file and stops them after; `always` are options of every page. Gives { url, open }:
 * `open(path, options)` opens a page in a context that no other page of the test has, and waits for the model. Its frames are
 * tenths of a second, unless `fast` is false; only with `refine` do pictures that stay get better. Functions in `scripts` run before the page's own scripts; `prepare(page)` sets
 * routes and listeners. After a test its pages are used for others, but those with `keep`.
 */
export function startBrowser({ headers = {}, subfolder = false, rasteriser = 'mesa', ...always } = {}) {
  const site = {};
  let browser;
  let server;
  let pages;
  const open = new Set();
  const start = async () => {
    // From the folder above, dist/ is a sub-folder of the host.
    server = await serve({ folder: subfolder ? dirname(dist) : dist, extraHeaders: headers });
    browser = await launch(rasteriser);
    site.url = subfolder ? `${server.url}${basename(dist)}/` : server.url;
    pages = new Pages(browser, new URL(site.url).origin);
  };
  let started;
  before(() => { started ??= start(); return started; });
  after(async () => {
    await browser?.close();
    await server?.close();
  });
  // A page that is left open goes on drawing at the cost of the next.
  afterEach(async ({ passed }) => {
    const used = [...open];
    open.clear();
    await Promise.all(used.map((one) => (passed ? pages.giveBack(one) : pages.close(one))));
  });
  site.open = async (path, { wait = true, keep = false, fast = true, refine = false, scripts = [], prepare, ...options } = {}) => {
    await (started ??= start());
    const taken = await pages.take({ viewport, ...always, ...options, scripts: [noteViolations, noteShown, `(${watchTime})(${fast})`, ...refine ? [] : [leavePictures], ...scripts] });
    if (!keep) open.add(taken);
    const { page } = taken;
    page.context().setDefaultTimeout(patience);
    await prepare?.(page);
    await page.goto(new URL(path, site.url).href);
    if (wait) await page.waitForFunction(() => ((fur) => fur.loaded && fur.state !== 'loading')(document.querySelector('wet-fur')));
    return page;
  };
  return site;
}

/**
 * For `scripts`: notes every context that elements make, and what is in it. `contextsAlive()` and `contextsOf()` count
 * those that are left and all, `contextsNow()` gives the former; `contextsHeld()` what they and their JavaScript objects hold;
 * `programMemory()` the bytes of the programs; `newestContext()` is the last that was made.
 */
export function recordContexts() {
  const made = [];
  const memories = [];
  const kinds = ['Texture', 'Buffer', 'Framebuffer', 'Renderbuffer', 'VertexArray', 'Program', 'Shader', 'Sampler'];
  const original = OffscreenCanvas.prototype.getContext;
  OffscreenCanvas.prototype.getContext = function getContext(type, ...rest) {
    const gl = original.call(this, type, ...rest);
    if (type !== 'webgl2' || !gl || rest.length === 0) return gl;
    const entry = { gl: new WeakRef(gl), objects: 0, programs: 0 };
    made.push(entry);
    for (const kind of kinds) {
      const [create, remove] = [gl[`create${kind}`], gl[`delete${kind}`]];
      gl[`create${kind}`] = (...given) => {
        entry.objects++;
        if (kind === 'Program') entry.programs++;
        return create.apply(gl, given);
      };
      gl[`delete${kind}`] = (object) => { if (object) entry.objects--; remove.call(gl, object); };
    }
    return gl;
  };
  const instantiate = WebAssembly.instantiate;
  WebAssembly.instantiate = async (...given) => {
    const instance = await instantiate(...given);
    memories.push(Object.values(instance.exports ?? {}).find((one) => one instanceof WebAssembly.Memory));
    return instance;
  };
  const living = () => made.filter(({ gl }) => gl.deref()?.isContextLost() === false);
  window.contextsOf = () => made.length;
  window.contextsAlive = () => living().length;
  window.newestContext = () => made.at(-1).gl.deref();
  window.contextsNow = () => living().map(({ gl }) => gl.deref());
  window.programMemory = () => memories.reduce((sum, memory) => sum + (memory?.buffer.byteLength ?? 0), 0);
  window.contextsHeld = () => ({
    made: made.length, programs: made.reduce((sum, { programs }) => sum + programs, 0), alive: living().length, reachable: made.filter(({ gl }) => gl.deref()).length,
    objects: living().reduce((sum, { objects }) => sum + objects, 0),
    leftInDead: made.filter((entry) => !living().includes(entry)).reduce((sum, { objects }) => sum + objects, 0),
  });
}

/** Evaluates in the page with its <wet-fur> as `fur`. */
export const withFur = (page, work, argument) =>
  page.evaluate(`(${work})(document.querySelector('wet-fur'), ${JSON.stringify(argument) ?? 'undefined'})`);

/** The picture as drawn now, {width, height, data (RGBA)}. */
export async function picture(page, options = {}) {
  const base64 = await withFur(page, async (fur, given) => {
    const bytes = new Uint8Array(await (await fur.toBlob(given)).arrayBuffer());
    let text = '';
    for (const byte of bytes) text += String.fromCharCode(byte);
    return btoa(text);
  }, options);
  return PNG.sync.read(Buffer.from(base64, 'base64'));
}

export function luminanceAt({ width, data }, x, y, half = 0) {
  let sum = 0;
  for (let dy = -half; dy <= half; dy++) {
    for (let dx = -half; dx <= half; dx++) {
      const at = ((y + dy) * width + x + dx) * 4;
      sum += 0.2126 * data[at] + 0.7152 * data[at + 1] + 0.0722 * data[at + 2];
    }
  }
  return sum / (2 * half + 1) ** 2;
}

/** Share of pixels that differ by more than `tolerance` in some channel. */
export function difference(a, b, tolerance = 0) {
  assert.equal(a.data.length, b.data.length);
  let differing = 0;
  for (let i = 0; i < a.data.length; i += 4) {
    if ([0, 1, 2].some((c) => Math.abs(a.data[i + c] - b.data[i + c]) > tolerance)) differing++;
  }
  return differing / (a.data.length / 4);
}

/** For `scripts`: figures lighter than the page's own, as a software rasteriser draws them. */
export const lighten = () => addEventListener('DOMContentLoaded', () => {
  for (const fur of document.querySelectorAll('wet-fur')) {
    fur.quality = 'low';
    Object.assign(fur.settings, { layers: 8, fins: false });
  }
});

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
/** What axe-core says against the page, a line each; `only`: the names of its rules, all without; `iframes`: those within as well. */
export async function axeFindings(page, { only, iframes = true } = {}) {
  if (await page.evaluate(() => !window.axe)) await page.evaluate(axe);
  return page.evaluate(async ([rules, within]) => {
    const { violations } = await window.axe.run(document, { iframes: within, resultTypes: ['violations'], ...rules && { runOnly: { type: 'rule', values: rules } } });
    return violations.flatMap(({ id, nodes }) => nodes.map(({ html, any }) => `${id}: ${html.slice(0, 160)} ${any[0]?.message ?? ''}`));
  }, [only, iframes]);
}

export const sleep = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

/** Waits until the page's figure shows the model of that name: `modelName` is that already while it comes. */
export const untilShown = (page, name) => page.waitForFunction((wanted) => wetFur.shownName === wanted, name);

/** Waits until no frame is drawn any more, on a machine of any speed; gives how many were. */
export const untilStill = (page) => withFur(page, (fur) => window.untilStill(fur));

/** A pixel of the model near the middle of the page, in CSS pixels, with its atlas coordinates. */
export const spotOnModel = (page) => withFur(page, (fur) => {
  const { width, height } = fur.getBoundingClientRect();
  for (const [fx, fy] of [[0.5, 0.55], [0.5, 0.5], [0.48, 0.6], [0.45, 0.45]]) {
    const at = { x: Math.round(width * fx), y: Math.round(height * fy) };
    const hit = fur.pick(at);
    if (hit) return { ...at, ...hit };
  }
  throw new Error('no model in the middle');
});
