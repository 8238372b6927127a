// The editor panel: fetched on demand, and the scene moves into it and back.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { PNG } from 'pngjs';
import { difference, picture, plain, startBrowser, untilStill, withFur } from './support.mjs';

const site = startBrowser();

test('the editor takes over water, settings, camera and model, and gives them back', async () => {
  const requested = [];
  const page = await site.open(`?${plain}&src=sphere&dryRate=0&furLength=0.2`, {
    viewport: { width: 800, height: 400 },
    prepare: (tab) => tab.on('request', (request) => requested.push(request.url())),
  });
  assert.ok(!requested.some((url) => url.includes('wet-fur-editor')), 'a visitor does not download the editor');
  await withFur(page, (fur) => { fur.splash({ x: 400, y: 220 }); fur.cameraOrbit = '0.6 0.3 3.2'; fur.tool = 'dry'; });
  await untilStill(page);
  const scene = () => withFur(page, (fur) => [fur.wetnessHash, fur.getState(), fur.tool, fur.stats.triangles]);
  const before = await scene();
  const bare = await picture(page);

  await page.click('#editor');
  await page.waitForFunction(() => wetFur.editorOpen);
  await untilStill(page);
  assert.deepEqual(await scene(), before);
  assert.equal(await withFur(page, (fur) => fur.canUndo), true, 'what was done before can be undone there');
  assert.ok(difference(bare, await picture(page), 16) < 0.02, 'a saved picture shows the scene without the panel');
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
  const page = await site.open(`?${plain}&src=sphere&editor=1&dryRate=0`, { viewport: { width: 800, height: 400 } });
  await page.waitForFunction(() => wetFur.editorOpen);
  await untilStill(page);
  await page.mouse.move(600, 30);  // the title
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
  const page = await site.open(`?${plain}&src=plane&editor=1&dryRate=0`, { viewport: { width: 640, height: 1300 } });
  await page.waitForFunction(() => wetFur.editorOpen);
  const strands = async () => {
    await untilStill(page);
    const { data } = PNG.sync.read(await page.screenshot({ clip: { x: 300, y: 0, width: 328, height: 1300 } }));
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
  const page = await site.open(`?${plain}&src=plane&editor=1&preset=wool`, { viewport: { width: 640, height: 1400 } });
  await page.waitForFunction(() => wetFur.editorOpen);
  await untilStill(page);
  let download;
  page.on('download', (event) => { download = event; });
  // Nobody but the panel knows where its buttons are: down the left half of it, below the plot of coverage.
  for (let y = 1120; y < 1370 && !download; y += 11) {
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

const panelWidth = (page) => page.evaluate(() => document.documentElement.style.getPropertyValue('--wet-fur-panel-width'));

test('the panel is as wide as its edge was dragged, the bar beside it and the next visit know', async () => {
  const page = await site.open(`?${plain}&src=sphere&editor=1&dryRate=0`, { viewport: { width: 1000, height: 600 } });
  const opened = async () => {
    await page.waitForFunction(() => document.querySelector('wet-fur').editorOpen);
    await untilStill(page);
  };
  await opened();
  assert.equal(await panelWidth(page), '348px');
  const middle = () => withFur(page, (fur) => {
    // Where the sphere's outline is on the middle row.
    const hits = [...Array(100).keys()].map((i) => i * 10).filter((x) => fur.pick({ x, y: 300 }));
    return (hits[0] + hits.at(-1)) / 2;
  });
  const before = await middle();
  const bar = () => page.evaluate(() => document.getElementById('bar').getBoundingClientRect().right);
  await page.mouse.move(657, 200);
  await untilStill(page);
  await page.mouse.down();
  await page.mouse.move(600, 200);
  await page.mouse.move(507, 200);
  await page.mouse.up();
  await untilStill(page);
  assert.equal(await panelWidth(page), '498px');
  assert.ok(await bar() < 1000 - 498);
  assert.ok(Math.abs(before - await middle() - 75) < 20, `the picture is framed in what is left: ${before} to ${await middle()}`);
  assert.equal(await page.evaluate(() => localStorage.getItem('wet-fur-panel')), 'width 486 sheet 0.450');

  await page.reload();
  await opened();
  assert.equal(await panelWidth(page), '498px');
  await page.evaluate(() => document.querySelector('wet-fur').closeEditor());
  assert.equal(await panelWidth(page), '');
  assert.deepEqual(page.problems, []);
});

const asksForNumber = (page) => withFur(page, (fur) => fur.shadowRoot.activeElement?.inputMode === 'decimal');

/** Presses twice at one row after another until the panel asks for a number, and types it. Gives the row's height. */
async function typeNumber(page, press, [first, step], text) {
  let y = first;
  for (let row = 0; row < 4; row++) {
    y = first + row * step;
    await press(y);
    await untilStill(page);
    if (await asksForNumber(page)) break;
  }
  assert.ok(await asksForNumber(page), 'no slider was found');
  await page.keyboard.type(text);
  await page.keyboard.press('Enter');
  await untilStill(page);
  return y;
}

test('a double click on a slider takes a number from the keyboard', async () => {
  const page = await site.open(`?${plain}&src=sphere&editor=1&dryRate=0`, { viewport: { width: 800, height: 400 } });
  await page.waitForFunction(() => wetFur.editorOpen);
  await untilStill(page);
  const input = await page.context().newCDPSession(page);
  // With times of its own: on a busy machine two clicks may take long to arrive.
  const press = async (y) => {
    let timestamp = Date.now() / 1000;
    for (const clickCount of [1, 2])
      for (const type of ['mouseMoved', 'mousePressed', 'mouseReleased'])
        await input.send('Input.dispatchMouseEvent', { type, x: 700, y, button: type === 'mouseMoved' ? 'none' : 'left', clickCount, timestamp: timestamp += 0.01 });
  };
  // The first slider of the first section: the density.
  const y = await typeNumber(page, press, [179, 29], '0.25');
  assert.equal(await withFur(page, (fur) => fur.settings.density), 0.25);
  await typeNumber(page, press, [y, 0], '7');
  assert.equal(await withFur(page, (fur) => fur.settings.density), 1, 'the end of its range');
  await page.keyboard.press('Control+z');
  assert.equal(await withFur(page, (fur) => fur.settings.density), 0.25, 'one step');
  assert.deepEqual(page.problems, []);
});

test('on a phone a double tap does, and the sheet, open at first, closes and opens by its title', async () => {
  const page = await site.open(`?${plain}&src=sphere&editor=1&dryRate=0`, { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });
  await page.waitForFunction(() => wetFur.editorOpen);
  await untilStill(page);
  assert.equal(await panelWidth(page), '0px');
  for (const title of [490, 820]) {
    await page.touchscreen.tap(60, title);
    await untilStill(page);
  }
  const input = await page.context().newCDPSession(page);
  const press = async (y) => {
    let timestamp = Date.now() / 1000;
    for (let tap = 0; tap < 2; tap++) {
      await input.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [{ x: 250, y }], timestamp: timestamp += 0.05 });
      await input.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [], timestamp: timestamp += 0.05 });
    }
  };
  await typeNumber(page, press, [697, 41], '0.25');
  assert.equal(await withFur(page, (fur) => fur.settings.density), 0.25);
  assert.deepEqual(page.problems, []);
});
