// Many <wet-fur> on a page, whose browser has fewer contexts to give.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { PNG } from 'pngjs';
import { difference, recordContexts, startBrowser } from './support.mjs';

const site = startBrowser();
/** That the elements hold together (web/contexts.js); Chromium has 16. */
const limit = 8;
const sources = ['torus', 'sphere', 'plane'];

const pageOf = (count, style) => `<!doctype html><meta charset="utf-8"><title>Many</title>
<style>body { margin: 0 } wet-fur { display: block; width: 96px; height: 72px; ${style} }</style>
<script type="module" src="element.js"></script>
${Array.from({ length: count }, (_, i) => `<wet-fur id="fur${i}" src="${sources[i % 3]}" quality="low" camera-controls
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

/** A page of so many of them: one under the other, or, with `inView`, side by side. */
const open = (count, { inView = false, ...options } = {}) => site.open('many.html', {
  wait: false, viewport: inView ? { width: 640, height: 400 } : { width: 240, height: 200 }, ...options,
  scripts: [recordContexts, addWords],
  prepare: (page) => {
    const style = inView ? 'float: left; margin: 2px' : 'margin: 20px auto 60px';
    return page.route('**/many.html', (route) => route.fulfill({ contentType: 'text/html', body: pageOf(count, style) }));
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

test('eighteen elements, scrolled to the end and back, show their own pictures with few contexts', async () => {
  const page = await open(18);
  const before = [];
  for (let i = 0; i < 18; i++) {
    await page.evaluate(async (at) => {
      const fur = await see(at);
      if (at % 6 === 1) await fur.groom('length', 0.3);
      fur.setWetness((at % 5) * 0.12);
      await untilStill(fur);
    }, i);
    before.push({ scene: await page.evaluate((at) => scene(at), i), picture: await shown(page, i) });
    assert.ok(await alive(page) <= limit, `${await alive(page)} contexts at element ${i}`);
  }
  assert.equal(await page.evaluate(() => furAt(0).state), 'suspended');
  for (const i of [0, 9]) assert.ok(same(before[i].picture, await holds(page, i)), `what element ${i} holds out of view`);
  assert.equal(new Set(before.map(({ scene }) => scene.state)).size, 18);
  for (let i = 17; i >= 0; i--) {
    // At once, before it can have a context: what it showed last.
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

test('more elements in view than the browser has contexts for are all seen, and each still does what it is told', async () => {
  const page = await open(18, { inView: true });
  await page.evaluate(async () => {
    for (let i = 0; i < 18; i++) await until(() => furAt(i).loaded);
    for (let i = 0; i < 18; i++) await untilStill(furAt(i));
  });
  assert.ok(await alive(page) <= 16);
  const first = await page.evaluate(() => {
    for (let i = 0; i < 18; i++) if (furAt(i).state === 'suspended') return i;
    return -1;
  });
  assert.ok(first >= 0, 'the browser has taken none');
  for (let i = 0; i < 18; i++) assert.ok(!isBlank(await shown(page, i)), `element ${i}`);
  const dry = await shown(page, first);
  await page.evaluate(async (i) => {
    furAt(i).setWetness(0.6);
    await until(() => furAt(i).state === 'ready');
    await untilStill(furAt(i));
  }, first);
  assert.ok(difference(dry, await shown(page, first), 24) > 0.1);
  for (let i = 0; i < 18; i++) assert.ok(!isBlank(await shown(page, i)), `element ${i} after that`);
  assert.equal(await page.evaluate(() => messages()), 0);
  assert.deepEqual(page.problems, []);
});

test('a context that the browser takes for others comes back when its element is seen', async () => {
  const page = await open(3);
  const before = [];
  for (let i = 0; i < 3; i++) {
    await page.evaluate(async (at) => {
      const fur = await see(at);
      fur.splash({ u: 0.5, v: 0.5 }, { radius: 0.3, amount: 0.4 });
      await untilStill(fur);
      fur.paused = at === 1;
    }, i);
    before.push({ scene: await page.evaluate((at) => scene(at), i), picture: await shown(page, i) });
  }
  const taken = await page.evaluate(async () => {
    const told = [];
    for (const type of ['context-lost', 'context-restored'])
      for (const i of [0, 2]) furAt(i).addEventListener(type, () => told.push(`${type} ${i}`));
    window.others = Array.from({ length: 20 }, () => new OffscreenCanvas(1, 1).getContext('webgl2'));
    await until(() => told.length === 3);
    await untilStill(furAt(2));
    return { told: told.sort(), states: [furAt(0).state, furAt(2).state], messages: messages() };
  });
  assert.deepEqual(taken, {
    told: ['context-lost 0', 'context-lost 2', 'context-restored 2'], states: ['suspended', 'ready'], messages: 0,
  });
  for (const i of [2, 1, 0]) {
    await page.evaluate((at) => see(at).then(() => {}), i);
    assert.deepEqual(await page.evaluate((at) => scene(at), i), before[i].scene);
    assert.ok(same(before[i].picture, await shown(page, i)), `element ${i}`);
  }
  assert.deepEqual(page.problems, []);
});

test('an element without a context does all it is told', async () => {
  const page = await open(10);
  const seen = await page.evaluate(async () => {
    for (let i = 0; i < 10; i++) await see(i);
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
    wet: 0, hit: true, held: 0, stepped: { frames: 1, held: true, contexts: 1 }, undone: true, picture: [64, 48, true], saved: true,
    states: ['suspended', 'suspended', 'suspended'],
  });
  assert.ok(await alive(page) <= limit);
  assert.deepEqual(page.problems, []);
});

test('what grows with scrolling up and down is given back: no context, texture, buffer or shader is left over', async () => {
  const page = await open(9);
  const session = await page.context().newCDPSession(page);
  const count = async () => {
    await page.evaluate(() => scrollTo(0, 0));
    await page.evaluate(() => see(0).then(() => {}));
    // What a context still on its way out holds goes at the second collection.
    for (let i = 0; i < 2; i++) {
      await session.send('HeapProfiler.collectGarbage');
      await page.evaluate(() => new Promise((resolve) => setTimeout(resolve)));
    }
    return page.evaluate(() => ({ ...contextsHeld(), memory: programMemory() }));
  };
  const scroll = () => page.evaluate(async () => { for (let i = 1; i < 9; i++) await see(i); });
  await scroll();
  await count();
  await scroll();
  const once = await count();
  // More than the browser has.
  for (let i = 0; i < 3; i++) {
    await scroll();
    await page.evaluate(() => see(0).then(() => {}));
  }
  const often = await count();
  assert.ok(often.made > once.made + 16, `${often.made - once.made} contexts were made`);
  // The collector may not have come to the last ones.
  for (const { reachable } of [once, often]) assert.ok(reachable <= limit + 2, `${reachable} contexts are held`);
  assert.deepEqual({ ...often, made: 0, reachable: 0 }, { ...once, made: 0, reachable: 0 });
  assert.equal(often.leftInDead, 0);
  assert.deepEqual(page.problems, []);
});

test('an open editor stays open and as it was while its element has no context', async () => {
  const page = await open(10);
  const seen = await page.evaluate(async () => {
    const fur = await see(0);
    await fur.openEditor();
    fur.setWetness(0.3);
    await untilStill(fur);
    const before = scene(0);
    for (let i = 1; i < 10; i++) await see(i);
    const away = [fur.state, fur.stats.gpuBytes, fur.editorOpen];
    await see(0);
    return { before, after: scene(0), away, open: fur.editorOpen };
  });
  assert.deepEqual(seen.away, ['suspended', 0, true]);
  assert.deepEqual(seen.after, seen.before);
  assert.equal(seen.open, true);
  assert.deepEqual(page.problems, []);
});
