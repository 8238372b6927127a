// Nothing is lost: work outlives a reload, other models, other tabs and a browser that keeps nothing.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { packStrokes, unpackStrokes } from '../../web/strokes.js';
import { tetrahedron } from './glb.mjs';
import { dist, sleep, spotOnModel, startBrowser, untilShown, withFur } from './support.mjs';

const site = startBrowser({ reducedMotion: 'reduce' });  // nothing here is about fur that breathes
const simple = '?quality=low&motion=reduced';
/** Nothing here is about the otter: what comes under its name is there sooner and keeps still. */
const open = (path, options = {}) => site.open(path, {
  ...options, prepare: (page) => page.context().route('**/otter.glb', (route) => route.fulfill({ path: join(dist, 'models/shells-8.glb') })),
});
const permissions = ['clipboard-read', 'clipboard-write'];

/** Wet, shorter fur, another length, another view; what it is then. */
const work = (page) => withFur(page, async (fur) => {
  fur.settings.dryRate = 0;
  fur.settings.furLength = 0.2;
  fur.settings.breath = 0;
  fur.pause();
  fur.splash({ u: 0.4, v: 0.4 }, { radius: 0.1, amount: 0.6 });
  await fur.groom('length', 0.5);
  fur.cameraOrbit = '1 0.3 4';
});
const scene = (page) => withFur(page, (fur) => ({ name: fur.modelName, state: fur.getState(), wet: fur.wetnessHash, groomed: fur.groomed }));
const message = (page, text) => page.locator('#messages .message', { hasText: text });
const loads = (page) => withFur(page, (fur) => new Promise((resolve) => fur.addEventListener('load', ({ detail }) => resolve(detail.name), { once: true })));

/** Notes go by themselves: what the page says when its link is copied, however slow the machine. */
async function copyLink(page) {
  await page.evaluate(() => {
    window.told = new Promise((resolve) => {
      new MutationObserver(([{ addedNodes }], observer) => {
        if (addedNodes.length === 0) return;
        observer.disconnect();
        resolve(addedNodes[0].querySelector('p').textContent);
      }).observe(document.getElementById('messages'), { childList: true });
    });
  });
  await page.click('#share');
  await page.click('#link');
  return page.evaluate(() => window.told);
}

/** What the browser keeps newest of the page, its state and its source as text. */
const kept = (page) => page.evaluate(async () => {
  const result = (request) => new Promise((resolve) => { request.onsuccess = () => resolve(request.result); });
  if (!(await indexedDB.databases()).some(({ name }) => name === 'wet-fur')) return '';
  const database = await result(indexedDB.open('wet-fur'));
  const records = await result(database.transaction('records').objectStore('records').getAll());
  database.close();
  const newest = records.sort((a, b) => b.time - a.time)[0];
  return newest ? newest.document.state + JSON.stringify(newest.source) : '';
});
const untilKept = async (page, text) => { while (!(await kept(page)).includes(text)) await sleep(100); };
const hasWork = '"yaw":1}';

/** Another tab of the same person. */
async function another(page, path) {
  const tab = await page.context().newPage();
  await tab.goto(new URL(path, site.url).href);
  await tab.waitForFunction(() => document.querySelector('wet-fur').loaded && !document.getElementById('bar').inert);
  return tab;
}
const reload = async (page) => {
  await page.reload();
  await page.waitForFunction(() => document.querySelector('wet-fur').loaded && !document.getElementById('bar').inert);
};

test('work is there again after a reload, and who starts afresh can undo that', async () => {
  const page = await open(simple);
  assert.equal(await message(page, 'Your last work').count(), 0);
  const { groomed } = await scene(page);
  const length = await withFur(page, (fur) => fur.settings.furLength);
  await work(page);
  const before = await scene(page);
  await untilKept(page, hasWork);
  await reload(page);
  await withFur(page, (fur) => fur.pause());
  const after = await scene(page);
  assert.deepEqual({ ...after, wet: 0 }, { ...before, wet: 0 });
  assert.ok(await withFur(page, (fur) => fur.meanWetness > 0));
  await message(page, 'Your last work is back').getByText('Start afresh').click();
  await page.waitForFunction(() => wetFur.meanWetness === 0);
  assert.equal((await scene(page)).groomed, groomed);
  assert.equal(await withFur(page, (fur) => fur.settings.furLength), length);
  await page.click('#undo');
  assert.deepEqual(await scene(page), after);
  assert.deepEqual(page.problems, []);
});

test('what an older version kept otherwise is told, and the rest is there', async () => {
  const page = await open(simple);
  await work(page);
  await untilKept(page, hasWork);
  // As this tab has it from another version.
  await page.evaluate(async () => {
    const result = (request) => new Promise((resolve) => { request.onsuccess = () => resolve(request.result); });
    const database = await result(indexedDB.open('wet-fur'));
    const records = database.transaction('records', 'readwrite').objectStore('records');
    for (const record of await result(records.getAll())) {
      record.document.water[0] ^= 0xff;
      await result(records.put(record));
    }
    database.close();
  });
  await reload(page);
  await message(page, 'Your last work is back, without its water.').waitFor();
  assert.deepEqual(await withFur(page, (fur) => [fur.meanWetness, fur.groomed]), [0, true]);
});

test('a file of the person\'s own is there again after a reload', async () => {
  // At once, while the otter is still on its way.
  const page = await open(simple);
  const bytes = [...tetrahedron().glb()];
  await withFur(page, (fur, given) => fur.loadModel(new Uint8Array(given), { name: 'mine.glb' }), bytes);
  await untilKept(page, '"mine.glb"');
  await reload(page);
  assert.equal(await withFur(page, (fur) => fur.modelName), 'mine.glb');
});

test('two tabs keep each their own, and a later one goes on with what no other has open', async () => {
  const first = await open(simple);
  await work(first);
  await untilKept(first, hasWork);
  const second = await another(first, simple);
  assert.equal(await message(second, 'Your last work').count(), 0, 'the first tab has it open');
  await second.selectOption('#model', 'torus');
  await untilKept(second, '{"src":"torus"}');
  await second.close();
  const third = await another(first, simple);
  assert.equal(await withFur(third, (fur) => fur.modelName), 'torus');
  await reload(first);
  assert.equal(await withFur(first, (fur) => fur.groomed), true);
});

test('a link wins over what is kept, which it leaves alone and offers', async () => {
  const first = await open(simple);
  await work(first);
  const before = await scene(first);
  await untilKept(first, hasWork);
  const page = await another(first, simple);
  await first.close();
  await page.goto(new URL(`${simple}&src=torus`, site.url).href);
  await page.waitForFunction(() => document.querySelector('wet-fur').loaded && !document.getElementById('bar').inert);
  assert.equal(await withFur(page, (fur) => fur.modelName), 'torus');
  const loaded = loads(page);
  await message(page, 'is saved').getByText('Show it').click();
  assert.equal(await loaded, 'otter');
  await withFur(page, (fur) => fur.pause());
  assert.deepEqual({ ...await scene(page), wet: 0 }, { ...before, wet: 0 });
  const back = loads(page);
  await page.click('#undo');
  assert.equal(await back, 'torus');
});

test('a browser that keeps nothing says so once, asks before the page is left, and breaks nothing else', async () => {
  const page = await open(simple, {
    scripts: [() => { IDBFactory.prototype.open = () => { throw new DOMException('not in private windows', 'SecurityError'); }; }],
  });
  assert.equal(await message(page, 'does not keep').count(), 0, 'there is nothing to keep yet');
  await work(page);
  await message(page, 'not in private windows').waitFor();
  await page.keyboard.press('Escape');
  await withFur(page, (fur) => { fur.settings.furLength = 0.1; });
  await page.evaluate(() => dispatchEvent(new Event('pagehide')));
  await page.waitForFunction(() => !dispatchEvent(new Event('beforeunload', { cancelable: true })));
  assert.equal(await message(page, 'does not keep').count(), 0);
  assert.deepEqual(page.problems, []);
});

test('a picture that is to be the same at every visit is not kept', async () => {
  const page = await open(`${simple}&autoplay=0`);
  await work(page);
  await page.evaluate(() => dispatchEvent(new Event('pagehide')));
  assert.deepEqual(await page.evaluate(async () => (await indexedDB.databases()).map(({ name }) => name)), []);
});

test('undo leads back to the model before, with its groom, its water and its own steps, and redo to the next', async () => {
  const page = await open(`${simple}&src=torus`);
  await work(page);
  const ring = await scene(page);
  await page.selectOption('#model', 'sphere');
  await untilShown(page, 'sphere');
  await withFur(page, (fur) => fur.splash({ u: 0.5, v: 0.5 }, { radius: 0.2, amount: 0.5 }));
  const sphere = await scene(page);
  assert.notEqual(sphere.wet, ring.wet);
  await withFur(page, (fur) => fur.openEditor());  // the way back is not lost with the program
  await withFur(page, (fur) => { fur.src = 'plane'; });
  await untilShown(page, 'plane');
  assert.equal(await withFur(page, (fur) => fur.undo()), true);
  assert.deepEqual(await scene(page), sphere);
  assert.equal(await withFur(page, (fur) => fur.undo()), true);
  assert.equal(await withFur(page, (fur) => fur.meanWetness), 0);
  assert.equal(await withFur(page, (fur) => fur.undo()), true);
  assert.deepEqual(await scene(page), ring);
  await page.waitForFunction(() => document.getElementById('model').value === 'torus');
  assert.equal(await withFur(page, (fur) => fur.undo() && fur.groomed), false);
  await withFur(page, (fur) => { fur.redo(); fur.redo(); fur.redo(); });
  assert.deepEqual(await scene(page), sphere);
  await withFur(page, (fur) => fur.closeEditor());
  assert.equal(await withFur(page, (fur) => fur.redo()), true);
  assert.equal((await scene(page)).name, 'plane');
  assert.equal(await withFur(page, (fur) => fur.canRedo), false);
  assert.deepEqual(page.problems, []);
});

test('a model of the panel is one that undo leads back from, and that closing the panel leaves', async () => {
  const page = await open(`${simple}&editor=1`);
  await page.waitForFunction(() => wetFur.editorOpen);
  await withFur(page, (fur) => { fur.src = 'sphere'; });
  await untilShown(page, 'sphere');
  await page.locator('wet-fur').focus();
  await page.keyboard.press('Control+z');
  await untilShown(page, 'otter');
});

test('a reset is undone in one step', async () => {
  const page = await open(`${simple}&src=torus`);
  await work(page);
  const before = await scene(page);
  await page.click('#reset');
  await page.waitForFunction(() => wetFur.meanWetness === 0 && !wetFur.groomed);
  await page.click('#undo');
  assert.deepEqual(await scene(page), before);
});

for (const editor of [0, 1]) {
  test(`Ctrl+S saves the scene ${editor ? 'with' : 'without'} the editor`, async () => {
    const page = await open(`${simple}&src=sphere&editor=${editor}`);
    await page.waitForFunction((open) => wetFur.editorOpen === open, Boolean(editor));
    for (const focus of ['body', 'wet-fur']) {
      await page.evaluate((where) => {
        document.activeElement.blur();
        if (where !== 'body') wetFur.shadowRoot.querySelector('canvas').focus();
      }, focus);
      const download = page.waitForEvent('download');
      await page.keyboard.press('Control+s');
      const file = await download;
      assert.equal(file.suggestedFilename(), 'sphere.glb');
      assert.equal(readFileSync(await file.path()).toString('latin1', 0, 4), 'glTF');
    }
    assert.deepEqual(page.problems, []);
  });
}

test('strokes that are packed for a link read back, within their bounds', async () => {
  const strokes = [['droplet', 0.12, 0.5, 0.05, 0.1, -2, 3, 100, 7, 0.25, 0.5, 1, 130, 9, 0.125, 0.3, 0.5], ['shake', 0, 0, 0.05, 0, 0, 0, 9000, 0, 0, 0, 1]];
  const packed = await packStrokes(JSON.stringify(strokes));
  assert.match(packed, /^[A-Za-z0-9_-]+$/);
  const back = JSON.parse(await unpackStrokes(packed));
  assert.deepEqual(back[0].slice(0, 7), strokes[0].slice(0, 7));
  assert.deepEqual(back[0].slice(7), [0, 7, 0.25, 0.5, 1, 30, 9, 0.125, 0.3, 0.5]);
  assert.equal(back[1][7], 90, 'nobody waits out a pause');
  // What was dried off since is nobody's.
  const soak = ['soak', 0, 0, 0.05, 0, 0, 0, 140, 0, 0, 0, 1];
  assert.deepEqual(JSON.parse(await unpackStrokes(await packStrokes(JSON.stringify([strokes[0], soak])))).length, 1);
  assert.equal(await packStrokes('[]'), null);
  for (const bad of ['', 'AAAA', '%', packed.slice(2)]) await assert.rejects(unpackStrokes(bad));
  const long = Array.from({ length: 40 }, (_, i) => ['droplet', 0.1, 0.5, 0.05, 0, 0, 3, 90 * i, 7, 0.2, 0.2, 1]);
  assert.equal(await packStrokes(JSON.stringify(long)), null, 'more than half a minute of water');
});

test('a link takes the water along, and says when it does not fit', async () => {
  const page = await open(`${simple}&src=sphere&layers=8&dryRate=0`, { permissions });
  const { x, y } = await spotOnModel(page);
  await page.mouse.move(x, y);
  await page.mouse.down();
  for (let i = 0; i < 5; i++) await page.mouse.move(x + 9 * i, y + 2 * i);
  await page.mouse.up();
  assert.equal(await copyLink(page), 'Link copied');
  const link = new URL(await page.evaluate(() => navigator.clipboard.readText()));
  assert.ok(link.searchParams.get('strokes'));
  const wet = await withFur(page, (fur) => fur.meanWetness);
  const second = await another(page, link.search);
  const seen = await withFur(second, (fur) => ({ wet: fur.meanWetness, undo: fur.canUndo, problems: fur.warnings }));
  assert.ok(Math.abs(seen.wet - wet) < 0.25 * wet, `${seen.wet} of ${wet}`);
  assert.equal(seen.undo, false);
  assert.deepEqual(seen.problems, []);
  await second.close();
  await withFur(page, (fur) => {
    let seed = 1;
    const next = () => { seed = (seed * 1664525 + 1013904223) % 2 ** 32; return seed / 2 ** 32; };
    const many = Array.from({ length: 2500 }, () => [0, Math.floor(200 * next()), next() / 2, next() / 2, 1]).flat();
    fur.replay(JSON.stringify([['splash', 0.02, 0.5, 0.05, 0, 0, 3, ...many]]));
  });
  // Of too many strokes what they have wet goes along.
  await withFur(page, (fur) => { fur.paused = true; });
  assert.equal(await copyLink(page), 'Link copied');
  const whole = new URL(await page.evaluate(() => navigator.clipboard.readText()));
  assert.ok(whole.searchParams.get('water') && !whole.searchParams.get('strokes') && whole.search.length < 8400);
  const third = await another(page, `${whole.search}&autoplay=0`);
  const [there, here] = [await withFur(third, (fur) => fur.meanWetness), await withFur(page, (fur) => fur.meanWetness)];
  assert.ok(Math.abs(there - here) < 0.05 * here, `${there} of ${here}`);
  assert.equal((await withFur(third, (fur) => fur.warnings)).length, 0);
  await third.close();
});

test('a visit that goes on with the water of a link shares all of it again', async () => {
  const page = await open(`${simple}&src=sphere&dryRate=0`, { permissions });
  const linkOf = async (tab) => {
    await copyLink(tab);
    return new URL(await tab.evaluate(() => navigator.clipboard.readText())).search;
  };
  // More than a link can paint again in its time: it takes the water itself.
  await withFur(page, (fur) => {
    for (let i = 0; i < 40; i++) {
      fur.splash({ u: 0.3 + 0.01 * (i % 8), v: 0.3 + 0.01 * Math.floor(i / 8) }, { radius: 0.1, amount: 0.8 });
      fur.step(1 / 60, 61);
    }
  });
  const link = await linkOf(page);
  assert.match(link, /&water=/);
  await page.goto(new URL(link, site.url).href);
  await page.waitForFunction(() => window.wetFur?.meanWetness > 0 && !document.getElementById('bar').inert);
  const wet = await withFur(page, (fur) => {
    fur.splash({ u: 0.7, v: 0.7 }, { radius: 0.1, amount: 0.8 });
    fur.cameraOrbit = '1 0.3 4';
    fur.settings.curl = 0.5;
    return fur.meanWetness;
  });
  await untilKept(page, hasWork);
  await reload(page);
  await message(page, 'Your last work is back').waitFor();
  const again = await linkOf(page);
  assert.match(again, /&water=/, 'not the later stroke alone');
  const other = await another(page, again);
  await other.waitForFunction(() => wetFur.meanWetness > 0);
  const shared = await withFur(other, (fur) => fur.meanWetness);
  assert.ok(Math.abs(shared - wet) < 0.1 * wet, `${shared} of ${wet}`);
});

test('a link to a file of one\'s own says what it is without', async () => {
  const page = await open(simple, { permissions });
  await withFur(page, async (fur, bytes) => {
    await fur.loadModel(new Uint8Array(bytes), { name: 'mine.glb' });
    fur.setWetness(0.5);
  }, [...tetrahedron().glb()]);
  assert.equal(await copyLink(page), 'Link copied, without the file itself and the water');
});

test('strokes in a link that are none are told, and the rest of it is shown', async () => {
  const page = await open(`${simple}&src=sphere&strokes=AAAA`);
  await message(page, 'water could not be read').waitFor();
  assert.equal(await withFur(page, (fur) => fur.modelName), 'sphere');
});

test('where a link leads to no model the page says so and is all there with another', async () => {
  for (const [src, why] of [['models/away.glb', 'away.glb: the server has no such file (404)'], ['page.js', 'page.js']]) {
    const page = await open(`${simple}&src=${src}`);
    await page.waitForFunction(() => !document.getElementById('bar').inert);
    await message(page, why).waitFor();
    await message(page, 'The bunny is shown instead').waitFor();
    assert.equal(await page.locator('wet-fur .message').isVisible(), false);
    assert.equal(await withFur(page, (fur) => fur.modelName), 'bunny');
    assert.equal(await withFur(page, (fur) => fur.ready.then(() => 'ready')), 'ready');
    await page.click('#coat');
    await page.click('[data-coat=wool]');
    assert.equal(await withFur(page, (fur) => fur.preset), 'wool');
    assert.equal(await page.locator('#model').inputValue(), 'bunny');
  }
});
