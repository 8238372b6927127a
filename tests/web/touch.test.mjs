// Hands, balls, breath and animations on the page.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { tentacle } from '../bench/models.mjs';
import { difference, light, picture, plain, sleep, spotOnModel, startBrowser, untilStill, withFur } from './support.mjs';

const site = startBrowser();

async function drag(page, from, to) {
  await page.mouse.move(...from);
  await page.mouse.down();
  for (let i = 1; i <= 12; ++i) {
    await page.mouse.move(...[0, 1].map((k) => from[k] + ((to[k] - from[k]) * i) / 12));
    await sleep(20);
  }
  await page.mouse.up();
}

test('petted fur lies over, comes back, and leaves nothing to undo', async () => {
  const page = await site.open(`?${plain}&src=sphere&furLength=0.25&brushRadius=0.4`);
  await untilStill(page);
  const before = await picture(page), { x, y } = await spotOnModel(page);
  await page.click('[data-tool=pet]');
  await page.mouse.move(x - 60, y);
  await page.mouse.down();
  for (let i = 0; i <= 12; ++i) await page.mouse.move(x - 60 + 10 * i, y);
  await untilStill(page);
  assert.ok(difference(before, await picture(page), 16) > 0.01);
  await page.mouse.up();
  await untilStill(page);
  assert.ok(difference(before, await picture(page), 2) < 0.001);
  assert.equal(await withFur(page, (fur) => fur.undo()), false);
  assert.deepEqual(page.problems, []);
});

test('a ball can be dragged over the fur, and goes with its tool, which the page tells', async () => {
  const page = await site.open(`?${plain}&src=sphere`);
  await untilStill(page);
  const before = await picture(page), { x, y } = await spotOnModel(page);
  await page.click('[data-tool=ball]');
  await drag(page, [x - 40, y], [x + 10, y]);
  await untilStill(page);
  const at = ({ data, width }) => data[4 * (y * width + x + 10)] - data[4 * (y * width + x + 10) + 1];
  assert.ok(at(await picture(page)) > at(before) + 30, 'red');
  await page.click('[data-tool=ball]');
  await page.waitForSelector('#messages .message:has-text("No tool")');
  await untilStill(page);
  assert.ok(difference(before, await picture(page), 2) < 0.001);
  assert.deepEqual(page.problems, []);
});

test('idle fur breathes for some seconds, then nothing is drawn', async () => {
  const page = await site.open(`?${light.replace('breath=0', 'breath=1')}&src=sphere&motion=full`);
  const drawn = () => withFur(page, (fur) => fur.stats.framesDrawn);
  const first = await drawn();
  await page.waitForFunction((n) => wetFur.stats.framesDrawn > n + 5, first);
  await untilStill(page);
  const last = await drawn();
  await sleep(1000);
  assert.equal(await drawn(), last);
  const calm = await site.open(`?${light.replace('breath=0', 'breath=1')}&src=sphere`, { reducedMotion: 'reduce' });
  const still = await untilStill(calm);
  await sleep(500);
  assert.equal(await withFur(calm, (fur) => fur.stats.framesDrawn), still);
});

const openTentacle = (page) =>
  withFur(page, (fur, base64) => fur.loadModel(new File([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], 'tentacle.glb')),
    tentacle(24, 32).toString('base64'));

test('a model with an animation plays it, holds it and says its name', async () => {
  const page = await site.open(`?${light}&src=sphere`);
  await openTentacle(page);
  assert.deepEqual(await withFur(page, (fur) => fur.animations), ['wave']);
  const offered = await page.$$eval('#animation option', (options) => options.map(({ text, selected }) => [text, selected]));
  assert.deepEqual(offered, [['No animation', false], ['wave', true]]);
  const pick = (value) => page.$eval('#animation', (picker, chosen) => {
    picker.value = chosen;
    picker.dispatchEvent(new Event('change'));
    return wetFur.animation;
  }, value);
  assert.equal(await pick('0'), 0);
  assert.equal(await pick('1'), 1);
  await withFur(page, (fur) => { fur.pause(); fur.step(1 / 60, 10); });
  const early = await picture(page);
  await withFur(page, (fur) => fur.step(1 / 60, 30));
  assert.ok(difference(early, await picture(page), 16) > 0.02);
  await withFur(page, (fur) => { fur.settings.animationSpeed = 0; fur.play(); });
  await untilStill(page);
  assert.deepEqual(page.problems, []);
});

test('the bar holds an animation, plays it on and sets its speed, by finger and by keys, on a phone', async () => {
  const page = await site.open(`?${plain}&src=sphere`, { viewport: { width: 390, height: 760 }, hasTouch: true });
  assert.equal(await page.isVisible('#player'), false, 'nothing to play');
  await openTentacle(page);
  const speed = () => withFur(page, (fur) => fur.animationSpeed);
  const told = () => page.$eval('#speed', (slider) => [slider.ariaValueText, slider.nextElementSibling.textContent]);
  await page.focus('#speed');
  await page.keyboard.press('ArrowRight');
  assert.equal(await speed(), 1.05);
  assert.deepEqual(await told(), ['1.05 x', 'Speed 1.05 x']);
  assert.equal((await page.textContent('#hold')).trim(), 'Hold');
  await page.tap('#hold');
  assert.equal(await speed(), 0);
  assert.equal((await page.textContent('#hold')).trim(), 'Play');
  await untilStill(page);
  await page.tap('#hold');
  assert.equal(await speed(), 1.05, 'as fast as before');
  assert.equal((await page.textContent('#hold')).trim(), 'Hold');
  await page.selectOption('#animation', '0');
  assert.ok(await page.isDisabled('#hold') && await page.isDisabled('#speed'));
  for (const box of await page.$$eval('#player :is(select, button, input)', (controls) => controls.map((one) => one.getBoundingClientRect().toJSON())))
    assert.ok(box.height >= 44 && box.left >= 0 && box.right <= 390, JSON.stringify(box));
  assert.deepEqual(page.problems, []);
});

test('someone who asked for less motion presses Play to see an animation', async () => {
  const page = await site.open(`?${plain}&src=sphere`, { reducedMotion: 'reduce' });
  await openTentacle(page);
  const still = await untilStill(page);
  assert.equal((await page.textContent('#hold')).trim(), 'Play');
  await page.click('#hold');
  await page.waitForFunction((n) => wetFur.stats.framesDrawn > n + 5, still);
  assert.equal((await page.textContent('#hold')).trim(), 'Hold');
  assert.deepEqual(page.problems, []);
});
