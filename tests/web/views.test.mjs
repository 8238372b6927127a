// Views for study, by their names: the browser's compiler takes their shaders too.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { difference, light, picture, startBrowser, untilStill, withFur } from './support.mjs';

const site = startBrowser();

test('every view is drawn in WebGL, wet and with fins, and leaves the picture as it was', async () => {
  const page = await site.open(`?${light}&view=exploded&viewLayer=0.3&fins=1&shadows=depth&dryRate=0`);
  assert.deepEqual(await withFur(page, (fur) => [fur.view, fur.viewLayer]), ['exploded', 0.3]);
  const views = await withFur(page, (fur) => {
    fur.pause();
    fur.setWetness(0.5);
    fur.step(1 / 60, 300);  // until the water has come to rest and the fur has sunk
    return fur.settingsTable.find((field) => field.name === 'view').options;
  });
  const show = async (view) => {
    await withFur(page, (fur, name) => { fur.view = name; }, view);
    return picture(page);
  };
  await show('final');
  await untilStill(page);
  const before = await picture(page);
  for (const view of views.slice(1)) assert.ok(difference(before, await show(view), 8) > 0.01, view);
  assert.equal(difference(before, await show('final')), 0);
  assert.deepEqual(page.problems, []);
  assert.deepEqual(await withFur(page, (fur) => fur.warnings), []);
});
