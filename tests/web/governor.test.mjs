// The quality governor on the page: work goes when frames become too slow, and comes back.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { PNG } from 'pngjs';
import { difference, picture, sleep, startBrowser, untilStill, withFur } from './support.mjs';

const site = startBrowser({ viewport: { width: 240, height: 180 } });
// The level rises by a step every second and a half at most, from the lowest eight; a failed try waits four more.
const patience = 300000;

/** Every draw of triangles of the page is repeated window.repeats times: real work, not a wait. */
const repeatDraws = () => {
  window.repeats = 1;
  const { drawElementsInstanced } = WebGL2RenderingContext.prototype;
  WebGL2RenderingContext.prototype.drawElementsInstanced = function repeated(...args) {
    // Nothing is hidden by what was drawn just before.
    for (let i = 0; i < window.repeats; i++) {
      if (i > 0) this.clear(this.DEPTH_BUFFER_BIT);
      drawElementsInstanced.apply(this, args);
    }
  };
};

const open = (query, options) => site.open(`?ui=0&layers=16&src=sphere&dryRate=0&${query}`, { fast: false, ...options });
const stats = (page) => withFur(page, (fur) => fur.stats);
const level = (page) => withFur(page, (fur) => fur.stats.level);

/** Frames in the wind for half a second or ten frames, whichever takes longer: milliseconds each. */
const frameTime = (page) => withFur(page, async () => {
  const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
  for (let i = 0; i < 10; i++) await frame();  // the first ones do more
  const start = await frame();
  let frames = 0, now = start;
  while (frames < 10 || now - start < 500) {
    now = await frame();
    frames++;
  }
  return (now - start) / frames;
});

test('work is taken out of the picture while it is too slow, and comes back', { timeout: 1200000 }, async (t) => {
  const page = await open('wind=1&motion=full&quality=auto', { scripts: [repeatDraws] });
  // A budget that this machine holds with ease, whatever machine it is.
  await withFur(page, (fur) => { fur.frameBudget = 1000; });
  await page.waitForFunction(() => wetFur.stats.level === 0, null, { timeout: patience });  // while its coat grew it had less time
  const easy = await frameTime(page);
  assert.equal(await level(page), 0);
  const full = (await stats(page)).pixels;
  await withFur(page, (fur, budget) => { fur.frameBudget = budget; }, 3 * easy);
  await page.evaluate(() => { window.repeats = 12; });
  await page.waitForFunction(() => wetFur.stats.level > 2, null, { timeout: patience });
  const slow = await stats(page);
  t.diagnostic(`${easy.toFixed(0)} ms a frame; 12 times the work: level ${slow.level}, ${slow.pixels} of ${full} pixels, ${slow.frameTime.toFixed(0)} ms`);
  assert.ok(slow.pixels < 0.75 * full, `${slow.pixels} of ${full} pixels`);
  await page.evaluate(() => { window.repeats = 1; });
  await page.waitForFunction(() => wetFur.stats.level <= 1, null, { timeout: patience });
  assert.ok((await stats(page)).pixels > slow.pixels);
  assert.deepEqual(page.problems, []);
});

test('a picture that stays is drawn once more, as well as it can be', { timeout: 600000 }, async () => {
  const page = await open('wind=1&motion=full&quality=auto');
  await withFur(page, (fur) => { fur.frameBudget = 4; });  // no machine that draws this in software
  await page.waitForFunction(() => wetFur.stats.level > 2, null, { timeout: patience });
  const canvasWidth = () => withFur(page, (fur) => fur.shadowRoot.querySelector('canvas').width);
  assert.equal(await canvasWidth(), 240);
  await withFur(page, (fur) => { fur.wind = 0; });
  await page.waitForFunction(() => wetFur.stats.level === 0, null, { timeout: patience });
  const drawn = await untilStill(page);
  await sleep(1000);
  assert.equal((await stats(page)).framesDrawn, drawn);
  assert.equal((await stats(page)).pixels, 240 * 180);
});

test('a machine on which one whole frame takes long shows all of a picture that stays, in its own time', { timeout: 1200000 }, async (t) => {
  const page = await open('wind=1&motion=full&quality=auto', { scripts: [repeatDraws] });
  await withFur(page, (fur) => { fur.frameBudget = 4; });
  await page.waitForFunction(() => wetFur.stats.level > 2, null, { timeout: patience });
  // More and more work, until the best picture is out of reach at once. The time of a frame is that of some before it.
  await page.evaluate(() => { window.repeats = 4, window.addedAt = 0; });
  await page.waitForFunction(() => {
    const { level, frameTime, framesDrawn } = wetFur.stats;
    if (framesDrawn > window.addedAt + 12 && frameTime <= 250) window.repeats *= 1.5, window.addedAt = framesDrawn;
    return level === 7 && frameTime > 250;
  }, null, { timeout: patience, polling: 200 });
  await withFur(page, (fur) => fur.pause());
  await page.waitForFunction(() => wetFur.stats.level === 0, null, { timeout: patience });
  t.diagnostic(`${(await stats(page)).frameTime.toFixed(0)} ms a moving frame`);
  const shot = async () => PNG.sync.read(await page.screenshot());
  const shown = await shot();
  await withFur(page, (fur) => { fur.step(0); });
  assert.equal(difference(shown, await shot(), 2), 0);
  assert.deepEqual(page.problems, []);
});

test('steps and saved pictures are the best there are, however slow the machine', { timeout: 600000 }, async () => {
  const page = await open('wind=1&motion=full&quality=auto');
  await withFur(page, (fur) => { fur.frameBudget = 4; });
  await page.waitForFunction(() => wetFur.stats.level > 2, null, { timeout: patience });
  await withFur(page, (fur) => { fur.pause(); fur.wind = 0; fur.step(1 / 60, 240); });
  assert.equal(await level(page), 0);
  const slow = await picture(page);
  assert.equal(await level(page), 0);
  const other = await open('autoplay=0&motion=full&quality=auto');
  await withFur(other, (fur) => fur.step(1 / 60, 240));
  // The wind has left the fur a hair's breadth aside.
  assert.ok(difference(slow, await picture(other), 40) < 0.02);
});

test('low, medium and high stay what they are', { timeout: 600000 }, async () => {
  const page = await open('wind=1&motion=full&quality=low', { scripts: [repeatDraws] });
  await withFur(page, (fur) => { fur.frameBudget = 4; });
  await page.evaluate(() => { window.repeats = 4; });
  const { framesDrawn } = await stats(page);
  await page.waitForFunction((n) => wetFur.stats.framesDrawn > n + 30, framesDrawn, { timeout: patience });
  assert.equal(await level(page), 0);
});
