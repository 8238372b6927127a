// Many <wet-fur> on a page: one program and at most two contexts for all.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { PNG } from 'pngjs';
import { difference, recordContexts, startBrowser } from './support.mjs';

const site = startBrowser();
/** That the elements have together (web/contexts.js). */
const limit = 2;
const sources = ['torus', 'sphere', 'plane'];

const pageOf = (count, style, budget) => `<!doctype html><meta charset="utf-8"><title>Many</title>
<style>body { margin: 0 } wet-fur { display: block; width: 96px; height: 72px; ${style} }</style>
<script type="module" src="element.js"></script>
<script type="module">import { configure } from './index.js'; configure({ gpuBudget: ${budget} });</script>
${Array.from({ length: count }, (_, i) => `<wet-fur id="fur${i}" src="${sources[i % 3]}" quality="${i % 3 === 2 ? 'medium' : 'low'}" camera-controls
  camera-orbit="${13 * i}deg 30deg 3.4" seed="${i + 1}" background="#dfe3e2"></wet-fur>`).join('\n')}
<script>
  customElements.whenDefined('wet-fur').then(() => {
    for (const fur of document.querySelectorAll('wet-fur'))
      Object.assign(fur.settings, { layers: 8, fins: false, breath: 0, dryRate: 0, tileSize: '64', refine: false });
  });
</script>`;

/** What tests say in the page. */
function addWords() {
  const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
  window.furAt = (i) => document.getElementById(`fur${i}`);
  window.until = async (condition) => { while (!condition()) await frame(); };
  /** Scrolls to it; resolves when it is drawn and still. */
  window.see = async (i) => {
    const fur = furAt(i);
    fur.scrollIntoView({ block: 'center' });
    await until(() => fur.state === 'ready');
    await untilStill(fur);
    return fur;
  };
  window.scene = (i) => {
    const fur = furAt(i);
    return { water: fur.wetnessHash, state: fur.getState(), groomed: fur.groomed, undo: fur.canUndo, wetness: fur.meanWetness };
  };
  window.messages = () => [...document.querySelectorAll('wet-fur')]
    .map((fur) => fur.shadowRoot.querySelector('.message')).filter((box) => box.checkVisibility()).length;
}

/** With `trapped` set the next call into any program fails, as where it runs into an instruction that must not be reached. */
function setTraps() {
  const instantiate = WebAssembly.instantiate;
  WebAssembly.instantiate = async (...given) => {
    const { exports } = await instantiate(...given);
    const guarded = Object.entries(exports).map(([name, one]) => [name, typeof one !== 'function' ? one : (...all) => {
      if (!window.trapped) return one(...all);
      window.trapped = false;
      throw new WebAssembly.RuntimeError('unreachable');
    }]);
    return { exports: Object.fromEntries(guarded) };
  };
}

/** `listeners()`: how many there are at the window, the document and media queries. */
function countListeners() {
  let count = 0;
  const { addEventListener: add, removeEventListener: remove } = EventTarget.prototype;
  const counts = (target) => target === window || target === document || target instanceof MediaQueryList;
  EventTarget.prototype.addEventListener = function addEventListener(type, work, given) {
    if (counts(this)) {
      count++;
      if (given?.signal) add.call(given.signal, 'abort', () => count--);
    }
    return add.call(this, type, work, given);
  };
  EventTarget.prototype.removeEventListener = function removeEventListener(...given) {
    if (counts(this)) count--;
    return remove.apply(this, given);
  };
  window.listeners = () => count;
}

/** A page of so many of them: one under the other, or, with `inView`, side by side; `budget`: bytes for those out of view. */
const open = (count, { inView = false, budget = 0, scripts = [], ...options } = {}) => site.open('many.html', {
  wait: false, viewport: inView ? { width: 640, height: 400 } : { width: 240, height: 200 }, ...options,
  scripts: [recordContexts, addWords, ...scripts],
  prepare: (page) => {
    const style = inView ? 'float: left; margin: 2px' : 'margin: 20px auto 60px';
    return page.route('**/many.html', (route) => route.fulfill({ contentType: 'text/html', body: pageOf(count, style, budget) }));
  },
});

/** What the window shows of it. */
const shown = async (page, i) => PNG.sync.read(await page.locator(`#fur${i}`).screenshot({ animations: 'disabled' }));
const alive = (page) => page.evaluate(() => contextsAlive());
/** Two pictures of one scene. The fur's bend settles anew; a few strands may end a pixel further. */
const same = (a, b) => difference(a, b, 24) < 0.02;
/** What its canvas holds, whoever composes the page; it is there whether or not a context is. */
const holds = async (page, i) => {
  const { width, height, data } = await page.evaluate((at) => {
    const canvas = furAt(at).shadowRoot.querySelector('canvas');
    const context = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d');
    context.drawImage(canvas, 0, 0);
    const { width, height, data } = context.getImageData(0, 0, canvas.width, canvas.height);
    return { width, height, data: Array.from(data) };
  }, i);
  return { width, height, data };
};
const isBlank = ({ data }) => data.every((value, at) => value === data[at % 4]);

test('a dozen elements, scrolled to the end and back, show their own pictures in two contexts, water included', async () => {
  const count = 12, page = await open(count);
  const before = [];
  for (let i = 0; i < count; i++) {
    await page.evaluate(async (at) => {
      const fur = await see(at);
      if (at % 6 === 1) await fur.groom('length', 0.3);
      fur.setWetness((at % 5) * 0.12);
      await untilStill(fur);
    }, i);
    before.push({ scene: await page.evaluate((at) => scene(at), i), picture: await shown(page, i) });
    assert.ok(await alive(page) <= limit, `${await alive(page)} contexts at element ${i}`);
  }
  assert.deepEqual(await page.evaluate(() => [furAt(0).state, furAt(0).stats.gpuBytes]), ['suspended', 0]);
  for (const i of [0, 5]) assert.ok(same(before[i].picture, await holds(page, i)), `what element ${i} holds out of view`);
  assert.equal(new Set(before.map(({ scene }) => scene.state)).size, count);
  for (let i = count - 1; i >= 0; i--) {
    // At once, before anything of it is in the context: what it showed last.
    await page.evaluate((at) => furAt(at).scrollIntoView({ block: 'center' }), i);
    assert.ok(same(before[i].picture, await shown(page, i)), `element ${i} as it comes into view`);
    await page.evaluate((at) => see(at).then(() => {}), i);
    assert.deepEqual(await page.evaluate((at) => scene(at), i), before[i].scene);
    assert.ok(same(before[i].picture, await shown(page, i)), `element ${i}`);
    assert.equal(await page.evaluate(() => messages()), 0);
    assert.ok(await alive(page) <= limit);
  }
  assert.ok(!before.some(({ picture }) => isBlank(picture)));
  assert.deepEqual(page.problems, []);
});

test('as many in view as a browser has contexts for and more are all alive, of their own sizes, and each does what it is told', async () => {
  const count = 18, page = await open(count, { inView: true });
  await page.evaluate(async (n) => {
    furAt(4).style.width = '130px';
    for (let i = 0; i < n; i++) await until(() => furAt(i).loaded);
    for (let i = 0; i < n; i++) await untilStill(furAt(i));
  }, count);
  assert.equal(await alive(page), limit);
  assert.deepEqual(await page.evaluate((n) => Array.from({ length: n }, (_, i) => furAt(i).state).filter((state) => state !== 'ready'), count), []);
  for (let i = 0; i < count; i++) assert.ok(!isBlank(await shown(page, i)), `element ${i}`);
  const [dry, other] = [await shown(page, 7), await shown(page, 4)];
  await page.evaluate(async () => {
    furAt(7).setWetness(0.6);
    await untilStill(furAt(7));
  });
  assert.ok(difference(dry, await shown(page, 7), 24) > 0.1);
  assert.ok(same(other, await shown(page, 4)));
  assert.equal(await page.evaluate(() => messages()), 0);
  assert.deepEqual(page.problems, []);
});

test('a lost context brings all of them back: at once what is seen, the others when they are', async () => {
  const page = await open(5, { budget: 2 ** 28 });
  const before = [];
  for (const i of [4, 2, 0]) {
    await page.evaluate(async (at) => {
      furAt(at).quality = 'low';
      const fur = await see(at);
      fur.splash({ u: 0.5, v: 0.5 }, { radius: 0.3, amount: 0.4 });
      await untilStill(fur);
      fur.paused = at === 2;
    }, i);
    before[i] = { scene: await page.evaluate((at) => scene(at), i), picture: await shown(page, i) };
  }
  const told = await page.evaluate(async () => {
    const told = [];
    for (const type of ['context-lost', 'context-restored'])
      for (const i of [0, 2, 4]) furAt(i).addEventListener(type, () => told.push(`${type} ${i}`));
    for (const gl of contextsNow()) gl.getExtension('WEBGL_lose_context').loseContext();
    await until(() => told.includes('context-restored 0'));
    await untilStill(furAt(0));
    return told.sort();
  });
  assert.deepEqual(told, ['context-lost 0', 'context-lost 2', 'context-lost 4', 'context-restored 0']);
  for (const i of [0, 2, 4]) {
    await page.evaluate((at) => see(at).then(() => {}), i);
    assert.deepEqual(await page.evaluate((at) => scene(at), i), before[i].scene);
    assert.ok(same(before[i].picture, await shown(page, i)), `element ${i}`);
  }
  assert.equal(await page.evaluate(() => messages()), 0);
  assert.deepEqual(page.problems, []);
});

test('a program that fails takes no figure with it: they go on in another, as they were; what fails again says so', async () => {
  const page = await open(3, { inView: true, scripts: [setTraps] });
  const seen = await page.evaluate(async () => {
    for (let i = 0; i < 3; i++) {
      await until(() => furAt(i).loaded);
      furAt(i).setWetness(0.1 + 0.1 * i);
      await untilStill(furAt(i));
    }
    const errors = [], before = [0, 1, 2].map((i) => ({ ...scene(i), camera: furAt(i).cameraOrbitText }));
    for (let i = 0; i < 3; i++) furAt(i).addEventListener('error', ({ detail }) => errors.push(`${i} ${detail.code}`));
    const trap = async () => {
      let code;
      window.trapped = true;
      try {
        furAt(1).meanWetness;
      } catch (error) {
        ({ code } = error);
      }
      return code;
    };
    const code = await trap();
    for (let i = 0; i < 3; i++) await until(() => furAt(i).state === 'ready');
    for (let i = 0; i < 3; i++) await untilStill(furAt(i));
    const after = [0, 1, 2].map((i) => ({ ...scene(i), camera: furAt(i).cameraOrbitText }));
    const told = [...errors];
    await trap();
    await until(() => [0, 2].every((i) => furAt(i).state === 'ready') && furAt(1).state === 'error');
    await untilStill(furAt(0));
    const states = [0, 1, 2].map((i) => furAt(i).state), message = messages();
    await furAt(1).reload();
    return { before, after, code, told, errors, states, message, wetness: furAt(1).meanWetness, again: furAt(0).meanWetness };
  });
  assert.equal(seen.code, 'program-failed');
  assert.deepEqual(seen.told, []);
  assert.deepEqual(seen.after, seen.before);
  assert.deepEqual(seen.errors, ['1 program-failed']);
  assert.deepEqual(seen.states, ['ready', 'error', 'ready']);
  assert.equal(seen.message, 1);
  assert.equal(seen.wetness, 0);
  assert.equal(seen.again, seen.before[0].wetness);
  assert.ok(await alive(page) <= limit);
});

test('an element out of view with nothing on the graphics processor does all it is told', async () => {
  const page = await open(6);
  const seen = await page.evaluate(async () => {
    for (let i = 0; i < 6; i++) await see(i);
    const fur = furAt(0);
    const had = contextsOf();
    const wet = (fur.setWetness(0.5), fur.meanWetness);
    const hit = fur.splash({ u: 0.3, v: 0.3 }) && fur.wetnessAt(0.3, 0.3) > 0.5;
    const drawn = fur.stats.framesDrawn;
    const held = fur.stats.gpuBytes;
    fur.step(1 / 60, 3);
    const stepped = { frames: fur.stats.framesDrawn - drawn, held: fur.stats.gpuBytes > 0, contexts: contextsOf() - had };
    const undone = fur.undo() && fur.canRedo;
    const lost = furAt(1);
    const blob = await lost.toBlob({ width: 64, height: 48 });
    const bitmap = await createImageBitmap(blob);
    const scene = await furAt(2).save();
    return { wet, hit, held, stepped, undone, picture: [bitmap.width, bitmap.height, blob.size > 500], saved: scene.length > 1000, states: [0, 1, 2].map((i) => furAt(i).state) };
  });
  assert.ok(seen.wet > 0.2);
  assert.deepEqual({ ...seen, wet: 0 }, {
    wet: 0, hit: true, held: 0, stepped: { frames: 1, held: true, contexts: 0 }, undone: true, picture: [64, 48, true], saved: true,
    states: ['suspended', 'suspended', 'suspended'],
  });
  assert.ok(await alive(page) <= limit);
  assert.deepEqual(page.problems, []);
});

test('scrolling up and down leaves nothing behind: memory, contexts, textures, buffers and shaders stay what they were', async () => {
  const page = await open(6);
  const scroll = () => page.evaluate(async () => { for (const i of [0, 1, 2, 3, 4, 5, 4, 3, 2, 1, 0]) await see(i); });
  await scroll();
  // Memory grows by a megabyte at a time and never shrinks: with three loads at once it is up to three above what scrolling takes, where
  // two may meet badly or not. So three times as many scrolls as would show a leak of one.
  await page.evaluate(async () => {
    for (let i = 0; i < 4; i++) await Promise.all([i, i + 1, i + 2].map((k) => furAt(k).toBlob({ width: 64, height: 48 })));
  });
  await scroll();
  const once = await page.evaluate(() => ({ ...contextsHeld(), memory: programMemory() }));
  for (let i = 0; i < 9; i++) await scroll();
  assert.deepEqual(await page.evaluate(() => ({ ...contextsHeld(), memory: programMemory() })), once);
  assert.equal(once.made, limit);
  assert.deepEqual(page.problems, []);
});

test('figures that are put on the page and taken off it leave no object, memory or listener', async () => {
  const page = await open(1, { scripts: [countListeners] });
  const session = await page.context().newCDPSession(page);
  const put = (times, models = ['torus', 'plane']) => page.evaluate(async ([n, all]) => {
    await see(0);
    for (let i = 0; i < n; i++) {
      const some = all.map((src, k) => Object.assign(document.createElement('wet-fur'), { src, loading: 'eager', quality: k ? 'low' : 'medium' }));
      for (const fur of some) Object.assign(fur.settings, { layers: 8, fins: false, tileSize: '64', refine: false });
      document.body.append(...some);
      // One goes before it is there.
      if (i % 3) await Promise.all(some.map((fur) => fur.ready));
      some.forEach((fur) => fur.remove());
      await until(() => some.every((fur) => fur.state === 'idle'));
    }
    await untilStill(furAt(0));
  }, [times, models]);
  const held = async () => {
    for (let i = 0; i < 2; i++) await session.send('HeapProfiler.collectGarbage');
    const { usedSize } = await session.send('Runtime.getHeapUsage');
    return { ...await page.evaluate(() => ({ ...contextsHeld(), memory: programMemory(), listeners: listeners() })), heap: usedSize };
  };
  // Memory grows by a megabyte at a time and never shrinks: with three loads at once it is above what two that meet badly may take.
  await put(2, ['torus', 'plane', 'torus']);
  await put(6);
  const once = await held();
  await put(24);
  const often = await held();
  assert.deepEqual({ ...often, heap: 0 }, { ...once, heap: 0 });
  assert.ok(often.heap < once.heap + 2e5, `${often.heap - once.heap} bytes more of JavaScript`);
  assert.deepEqual(page.problems, []);
});

test('figures that are alike share shaders and coat', async () => {
  const page = await open(1, { inView: true, budget: 2 ** 28 });
  const seen = await page.evaluate(async () => {
    const first = await see(0);
    const once = { programs: contextsHeld().programs, bytes: first.stats.gpuBytes };
    const second = first.cloneNode();
    document.body.append(second);
    Object.assign(second.settings, { layers: 8, fins: false, breath: 0, dryRate: 0, tileSize: '64', refine: false });
    await second.ready;
    await untilStill(second);
    const both = { programs: contextsHeld().programs, bytes: first.stats.gpuBytes + second.stats.gpuBytes };
    second.settings.density = 0.5;
    await untilStill(second);
    const apart = { programs: contextsHeld().programs, bytes: first.stats.gpuBytes + second.stats.gpuBytes };
    second.remove();
    await untilStill(first);
    return { once, both, apart, left: first.stats.gpuBytes };
  });
  const coat = seen.apart.bytes - seen.both.bytes;
  // Eight layers of a byte of coverage, of which two share six bytes of strands a texel.
  assert.ok(coat > 8 * 64 * 64 * 4, `a coat of ${coat} bytes`);
  assert.equal(seen.both.programs, seen.once.programs);
  assert.equal(seen.apart.programs, seen.once.programs);
  assert.equal(seen.left, seen.once.bytes);
  assert.deepEqual(page.problems, []);
});

test('an open editor stays open and as it was while its element has nothing on the graphics processor', async () => {
  const page = await open(6);
  const seen = await page.evaluate(async () => {
    const fur = await see(0);
    await fur.openEditor();
    fur.setWetness(0.3);
    await untilStill(fur);
    const before = scene(0);
    for (let i = 1; i < 6; i++) await see(i);
    const away = [fur.state, fur.stats.gpuBytes, fur.editorOpen];
    await see(0);
    return { before, after: scene(0), away, open: fur.editorOpen };
  });
  assert.deepEqual(seen.away, ['suspended', 0, true]);
  assert.deepEqual(seen.after, seen.before);
  assert.equal(seen.open, true);
  assert.deepEqual(page.problems, []);
});
