// Animals on the page: what it begins with, what they do and when they keep still.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { recordContexts, startBrowser, untilShown, untilStill, withFur } from './support.mjs';

const site = startBrowser({ viewport: { width: 160, height: 120 } });
/** They are drawn as cheaply as can be; what is said of the look alone leaves the first model. */
const cheap = 'quality=low&layers=8&fins=0&shadows=none';
const animal = `?src=otter&${cheap}&refine=0&ui=0&dryRate=0`;

const until = (page, work, argument) => page.waitForFunction(work, argument);

test('the page begins with the otter, a hint and some drops; who does something has seen it', async () => {
  const page = await site.open('?quality=low');
  assert.equal(await withFur(page, (fur) => fur.modelName), 'otter');
  assert.equal(await page.inputValue('#model'), 'otter');
  await until(page, () => document.getElementById('hint').textContent.includes('the otter'));
  await until(page, () => wetFur.waterAccounts.painted > 0);
  assert.equal(await withFur(page, (fur) => fur.recordedStrokes), '[]');
  await page.mouse.move(20, 20);
  await page.mouse.down();
  await page.mouse.up();
  await until(page, () => document.getElementById('hint').textContent === '');
  assert.deepEqual(page.problems, []);
});

test('addresses from before the otter show the bunny; who says less motion gets no drops', async () => {
  for (const [query, model] of [[`?${cheap}`, 'bunny'], ['?light=sunset&quality=low', 'bunny'], ['?tool=comb&quality=low&motion=reduced', 'otter'], ['?behaviour=none&quality=low', 'otter']]) {
    const page = await site.open(query);
    assert.equal(await withFur(page, (fur) => fur.modelName), model, query);
    if (query.includes('reduced')) {
      await untilStill(page);
      assert.equal(await withFur(page, (fur) => fur.waterAccounts.painted), 0);
    }
  }
});

test('an animal acts as it is told, and tells when it begins and ends', async () => {
  const page = await site.open(`${animal}&behaviour=none`);
  const actions = await withFur(page, (fur) => fur.actions);
  assert.ok(['stand', 'sit', 'groom', 'shake'].every((name) => actions.includes(name)), actions);
  await untilStill(page);
  await withFur(page, (fur) => {
    window.told = [];
    for (const type of ['action-start', 'action-end']) fur.addEventListener(type, ({ detail }) => window.told.push(`${type} ${detail.action}`));
  });
  assert.equal(await withFur(page, (fur) => fur.act('fly')), false);
  assert.equal(await withFur(page, (fur) => fur.act('groom')), true);
  await until(page, () => wetFur.action === 'groom');
  await until(page, () => wetFur.action === 'stand');
  await untilStill(page);
  assert.deepEqual((await page.evaluate(() => window.told)).slice(-4), ['action-end stand', 'action-start groom', 'action-end groom', 'action-start stand']);
  assert.deepEqual(page.problems, []);
});

test('wet enough it shakes itself, and not a drop is lost', async () => {
  const page = await site.open(animal);
  await withFur(page, (fur) => {
    window.shakes = 0;
    fur.addEventListener('action-start', ({ detail }) => { window.shakes += detail.action === 'shake'; });
    fur.setWetness(0.8);
  });
  await until(page, () => window.shakes > 0 && wetFur.action !== 'shake');
  const { held, film, drops, hair, dripped, evaporated, removed, painted, rained } = await withFur(page, (fur) => fur.waterAccounts);
  assert.ok(held < 0.9 * painted, `${held} of ${painted} held`);
  assert.ok(Math.abs(painted + rained - (held + film + drops + hair + dripped + evaporated + removed)) < 1e-3 * painted);
});

test('none and less motion keep it still; a pointer that moves wakes one that dozes', async () => {
  for (const still of ['behaviour=none', 'motion=reduced']) {
    const page = await site.open(`${animal}&${still}`);
    const drawn = await untilStill(page);
    await page.waitForTimeout(300);
    assert.equal(await withFur(page, (fur) => fur.stats.framesDrawn), drawn, still);
  }
  const page = await site.open(animal);
  await withFur(page, (fur) => { for (let i = 0; i < 8; ++i) fur.step(0.1, 100); });
  const asleep = await untilStill(page);
  await page.mouse.move(100, 100);
  await page.mouse.move(120, 110);
  await page.waitForFunction((drawn) => wetFur.stats.framesDrawn > drawn + 3, asleep);
});

test('the menu of actions is there for animals alone, and the bar stays one row', async () => {
  const page = await site.open(`?src=otter&${cheap}&behaviour=none`, { viewport: { width: 1280, height: 640 } });
  assert.ok(await page.isVisible('#act'));
  assert.ok(await page.$eval('#bar', (bar) => bar.offsetHeight) < 70, 'one row');
  await page.click('#act');
  const names = await page.$$eval('#acts button', (list) => list.map((one) => one.textContent));
  assert.deepEqual(names.slice(0, 3), ['Stand', 'Sit', 'Groom']);
  assert.equal(await page.getAttribute('#acts button:last-child', 'aria-pressed'), 'false');
  await page.click('#acts [data-action=sit]');
  await until(page, () => document.querySelector('#acts [data-action=sit]').getAttribute('aria-pressed') === 'true');
  await page.keyboard.press('Escape');
  await page.selectOption('#model', 'sphere');
  await untilShown(page, 'sphere');
  await until(page, () => !document.querySelector('#act').checkVisibility());
  assert.deepEqual(page.problems, []);
});

test('the program holds at most 48 MB with the otter', async () => {
  const page = await site.open('?quality=low', { scripts: [recordContexts] });
  await withFur(page, (fur) => fur.setWetness(1));
  await withFur(page, (fur) => fur.step(1 / 60, 60));
  const megabytes = await page.evaluate(() => window.programMemory()) / 2 ** 20;
  assert.ok(megabytes <= 48, `${megabytes.toFixed(1)} MB`);
});
