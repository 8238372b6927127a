// A picture that stays gets better, and then nothing is drawn.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { PNG } from 'pngjs';
import { difference, light, picture, plain, sleep, startBrowser, untilStill, withFur } from './support.mjs';

const site = startBrowser();
const samples = 64;
const refining = light.replace('refine=0', 'refine=1');
const open = (query = '', options) => site.open(`?${refining}&src=sphere&dryRate=0${query}`, { viewport: { width: 160, height: 120 }, refine: true, ...options });
const drawn = (page) => withFur(page, (fur) => fur.stats.framesDrawn);
const shot = async (page) => PNG.sync.read(await page.screenshot());

test('a picture that stays gets better, then nothing is drawn; a change starts afresh', async (t) => {
  const page = await open();
  const first = await untilStill(page);
  await sleep(1000);
  assert.equal(await drawn(page), first);
  const shown = await shot(page);
  assert.equal(difference(shown, await picture(page, { samples }), 1), 0);
  await untilStill(page);  // the canvas had another picture meanwhile
  const single = await picture(page, { samples: 1 });
  assert.ok(difference(shown, single, 8) > 0.05, 'it has less grain');
  const before = await untilStill(page);
  await withFur(page, (fur) => { fur.tipColor = '#4040ff'; });
  const after = await untilStill(page);
  t.diagnostic(`${after - before} pictures after a change`);
  assert.ok(after - before >= samples && after - before < samples + 30, `${after - before} pictures`);
  const changed = await shot(page);
  assert.ok(difference(shown, changed, 30) > 0.1);
  assert.equal(difference(changed, await picture(page, { samples }), 1), 0);
  assert.deepEqual(page.problems, []);
});

test('the same picture is gathered in another visit and on a slower page', async () => {
  const page = await open();
  const busy = await open('', { scripts: [() => {
    const ask = window.requestAnimationFrame;
    window.requestAnimationFrame = (work) => ask.call(window, (time) => {
      const end = performance.now() + 40;
      while (performance.now() < end);
      work(time);
    });
  }] });
  await untilStill(page);
  await untilStill(busy);
  assert.equal(difference(await shot(page), await shot(busy)), 0);
});

test('what is paused, steps or has refine="false" stays a picture that was drawn once', async () => {
  const page = await open();
  await untilStill(page);
  await withFur(page, (fur) => { fur.pause(); fur.step(1 / 60, 2); });
  const stepped = await drawn(page);
  await sleep(800);
  assert.equal(await drawn(page), stepped);
  const once = await shot(page);
  assert.equal(difference(once, await picture(page), 0), 0);
  await withFur(page, (fur) => { fur.refine = false; fur.play(); });
  await untilStill(page);
  assert.equal(difference(once, await shot(page), 0), 0);
  await withFur(page, (fur) => fur.setAttribute('refine', 'true'));
  await untilStill(page);
  assert.ok(difference(once, await shot(page), 8) > 0.05);
  await withFur(page, (fur) => fur.removeAttribute('refine'));
  assert.equal(await withFur(page, (fur) => fur.refine), true);
});

test('what always moves gathers nothing', async () => {
  const page = await open('&wind=1&motion=full', { fast: false });
  await sleep(1500);
  const [single, other] = [await withFur(page, (fur) => { fur.pause(); return fur.stats.framesDrawn; }), await shot(page)];
  await withFur(page, (fur) => fur.step(0));
  assert.ok(single > 5);
  assert.equal(difference(other, await shot(page), 2), 0);
});

test('a panel that moves alone leaves the picture as it has become', { timeout: 600000 }, async () => {
  const page = await site.open(`?${plain.replace('refine=0', 'refine=1')}&ui=0&src=sphere&dryRate=0&editor=1`, { viewport: { width: 640, height: 300 } });
  await page.waitForFunction(() => document.querySelector('wet-fur').editorOpen);
  await page.waitForFunction((n) => wetFur.stats.framesDrawn >= n, samples, { timeout: 300000 });
  const before = await untilStill(page);
  const model = { clip: { x: 60, y: 60, width: 200, height: 180 } };
  const part = async () => PNG.sync.read(await page.screenshot(model));
  const shown = await part();
  for (let y = 60; y < 280; y += 20) await page.mouse.move(560, y);
  await untilStill(page);
  assert.equal(await drawn(page), before);
  assert.equal(difference(shown, await part(), 0), 0);
  assert.deepEqual(page.problems, []);
});
