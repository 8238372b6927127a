// The editor panel: fetched on demand, and the scene moves into it and back.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { PNG } from 'pngjs';
import { difference, picture, startBrowser, untilStill, withFur } from './support.mjs';

const site = startBrowser();

test('the editor takes over water, settings, camera and model, and gives them back', async () => {
  const requested = [];
  const page = await site.open('?quality=low&layers=8&fins=0&dryRate=0&furLength=0.2', {
    viewport: { width: 800, height: 400 },
    prepare: (tab) => tab.on('request', (request) => requested.push(request.url())),
  });
  assert.ok(!requested.some((url) => url.includes('wet-fur-editor')), 'a visitor does not download the editor');
  await withFur(page, (fur) => { fur.splash({ x: 400, y: 220 }); fur.cameraOrbit = '0.6 0.3 3.2'; fur.tool = 'dry'; });
  await untilStill(page);
  const scene = () => withFur(page, (fur) => [fur.wetnessHash, fur.getState(), fur.tool, fur.stats.triangles]);
  const before = await scene();
  const plain = await picture(page);

  await page.click('#editor');
  await page.waitForFunction(() => wetFur.editorOpen);
  await untilStill(page);
  assert.deepEqual(await scene(), before);
  assert.equal(await withFur(page, (fur) => fur.canUndo), false, 'the history begins anew');
  assert.ok(difference(plain, await picture(page), 16) < 0.02, 'a saved picture shows the scene without the panel');
  const shot = await page.screenshot({ clip: { x: 500, y: 0, width: 300, height: 400 } });
  await page.click('#editor');
  await page.waitForFunction(() => !wetFur.editorOpen);
  await untilStill(page);
  assert.deepEqual(await scene(), before);
  assert.notDeepEqual(await page.screenshot({ clip: { x: 500, y: 0, width: 300, height: 400 } }), shot);
  assert.deepEqual(page.problems, []);
  assert.deepEqual(await page.evaluate(() => window.violations), []);
});

test('the panel takes the pointer and the keys that are meant for it, the picture takes the others', async () => {
  const page = await site.open('?quality=low&layers=8&fins=0&src=sphere&editor=1&dryRate=0', { viewport: { width: 800, height: 400 } });
  await page.waitForFunction(() => wetFur.editorOpen);
  await untilStill(page);
  await page.mouse.move(600, 59);  // a label
  await page.mouse.down();
  await page.mouse.up();
  const orbit = await withFur(page, (fur) => fur.getCameraOrbit());
  assert.equal(await withFur(page, (fur) => fur.meanWetness), 0);
  await page.mouse.click(200, 60);
  await page.mouse.move(320, 220);
  await page.mouse.down();
  await page.mouse.up();
  assert.ok(await withFur(page, (fur) => fur.meanWetness) > 0);
  assert.deepEqual(await withFur(page, (fur) => fur.getCameraOrbit()), orbit);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  assert.equal(await withFur(page, (fur) => fur.meanWetness), 0);
});

test('on a tall window the panel shows the tile of the coat that is drawn', async () => {
  const page = await site.open('?quality=low&layers=8&fins=0&src=plane&editor=1&dryRate=0', { viewport: { width: 640, height: 1060 } });
  await page.waitForFunction(() => wetFur.editorOpen);
  const strands = async () => {
    await untilStill(page);
    const { data } = PNG.sync.read(await page.screenshot({ clip: { x: 300, y: 0, width: 328, height: 1060 } }));
    let white = 0;
    for (let i = 0; i < data.length; i += 4) white += data[i] === 255 && data[i + 1] === 255 && data[i + 2] === 255;
    return white;
  };
  const many = await strands();
  assert.ok(many > 1000, `${many} white pixels`);
  await withFur(page, (fur) => { fur.settings.density = 0.05; });
  const few = await strands();
  assert.ok(few < many / 3, `${few} of ${many} white pixels`);
  assert.deepEqual(page.problems, []);
});

test('the panel saves the coat as a file that gives the same coat again', async () => {
  const page = await site.open('?quality=low&layers=8&fins=0&src=plane&editor=1&preset=wool', { viewport: { width: 640, height: 1060 } });
  await page.waitForFunction(() => wetFur.editorOpen);
  await untilStill(page);
  let download;
  page.on('download', (event) => { download = event; });
  await page.mouse.move(450, 640);
  await page.mouse.wheel(0, 100);
  await untilStill(page);
  // Nobody but the panel knows where its buttons are: down the left half of it, below the plot of coverage.
  for (let y = 860; y < 1030 && !download; y += 11) {
    await page.mouse.click(370, y);
    await untilStill(page);
  }
  assert.equal(download?.suggestedFilename(), 'wool.fts');
  const bytes = readFileSync(await download.path());
  const same = await withFur(page, async (fur, base64) => {
    const given = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    const saved = await fur.saveTypeSet();
    return given.length === saved.length && given.every((byte, i) => byte === saved[i]);
  }, bytes.toString('base64'));
  assert.ok(same, `${bytes.length} bytes`);
  assert.deepEqual(page.problems, []);
});
