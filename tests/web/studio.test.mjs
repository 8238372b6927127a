// What the editor's sections "Picture" and "Versions" make: pictures, films and scenes that are kept.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { PNG } from 'pngjs';
import { difference, picture, plain, startBrowser, untilStill, withFur } from './support.mjs';

const site = startBrowser();
const query = `?${plain}&dryRate=0&src=sphere&editor=1`;
const viewport = { width: 640, height: 420 };

/** Rows of the panel from its title down, open sections among them. */
const rowHeight = 29, firstRow = 63;
const row = (index) => firstRow + rowHeight * index;
const panelX = 480;

async function openEditor(options = {}) {
  const page = await site.open(query, { viewport, acceptDownloads: true, ...options });
  await page.waitForFunction(() => wetFur.editorOpen);
  await untilStill(page);
  return page;
}
async function press(page, x, index) {
  await page.mouse.click(x, row(index));
  await untilStill(page);
}
const readPng = async (download) => PNG.sync.read(readFileSync(await download.path()));
const alphaAt = ({ data, width }, x, y) => data[4 * (y * width + x) + 3];

test('the panel saves what is seen without the panel, with or without what is behind the model', async () => {
  const page = await openEditor();
  await withFur(page, (fur) => { fur.tool = 'comb'; });
  const whole = await picture(page);
  await press(page, panelX, 1);
  const shown = await page.screenshot({ clip: { x: 0, y: 0, width: 280, height: 420 } });
  const save = async () => (await Promise.all([page.waitForEvent('download'), page.mouse.click(panelX, row(5))]))[0];
  const first = await save();
  assert.equal(first.suggestedFilename(), 'sphere.png');
  const saved = await readPng(first);
  assert.deepEqual([saved.width, saved.height], [640, 420]);
  // The page's picture has the browser's multisampling, the file has ours.
  assert.ok(difference(whole, saved, 24) < 0.05, `${difference(whole, saved, 24)}`);
  await untilStill(page);
  await press(page, 312, 4);
  const clear = await readPng(await save());
  assert.deepEqual([alphaAt(clear, 0, 0), alphaAt(clear, 639, 419), alphaAt(clear, 320, 210)], [0, 0, 255]);
  assert.ok(clear.data.some((value, i) => i % 4 === 3 && value > 0 && value < 255), 'strands at the outline are half there');
  await untilStill(page);
  assert.deepEqual(await page.screenshot({ clip: { x: 0, y: 0, width: 280, height: 420 } }), shown, 'what is shown is as it was');

  // The element does the same.
  const own = await picture(page, { width: 320, height: 210, transparent: true });
  assert.deepEqual([own.width, alphaAt(own, 0, 0), alphaAt(own, 160, 105)], [320, 0, 255]);
  assert.deepEqual(page.problems, []);
});

test('a film is one turn at thirty frames a second, can be given up, and leaves the view as it was', async () => {
  const page = await openEditor({ viewport: { width: 640, height: 400 } });
  const before = await withFur(page, (fur) => fur.getCameraOrbit());
  await press(page, panelX, 1);
  await press(page, 390, 6);  // the shortest turn, or nearly
  await page.mouse.click(540, row(8));
  await page.waitForFunction((yaw) => Math.abs(wetFur.getCameraOrbit().yaw - yaw) > 0.05, before.yaw);
  await page.keyboard.press('Escape');
  await untilStill(page);
  assert.deepEqual(await withFur(page, (fur) => fur.getCameraOrbit()), before);
  assert.equal(await withFur(page, (fur) => fur.state), 'ready');

  const download = page.waitForEvent('download');
  await page.mouse.click(540, row(8));
  const film = await download;
  assert.equal(film.suggestedFilename(), 'sphere-turn.webm');
  const told = await page.evaluate(async (base64) => {
    const video = document.createElement('video');
    video.src = URL.createObjectURL(new Blob([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], { type: 'video/webm' }));
    await new Promise((resolve, reject) => {
      video.onloadeddata = resolve;
      video.onerror = () => reject(new Error(video.error.message));
    });
    return { size: [video.videoWidth, video.videoHeight], duration: video.duration };
  }, readFileSync(await film.path()).toString('base64'));
  assert.deepEqual(told.size, [640, 400]);
  assert.ok(told.duration >= 2 && told.duration < 8, `${told.duration}`);
  assert.ok(Math.abs(told.duration * 30 - Math.round(told.duration * 30)) < 0.01, 'a whole number of frames');
  assert.deepEqual(await withFur(page, (fur) => fur.getCameraOrbit()), before);
  assert.deepEqual(page.problems, []);
});

test('a version is gone back to with all that it had, undone in one step, renamed, deleted, and outlives the page', async () => {
  const page = await openEditor({ keep: true });
  const scene = () => withFur(page, (fur) => [fur.wetnessHash, fur.settings.furLength, fur.modelName, fur.cameraOrbitText]);
  await withFur(page, (fur) => {
    fur.cameraOrbit = '0.6 0.3 3.2';
    fur.setWetness(0.6);
    fur.settings.furLength = 0.2;
  });
  await untilStill(page);
  const wet = await scene();
  await press(page, panelX, 2);
  await page.mouse.click(400, row(3));
  await untilStill(page);
  await page.keyboard.type('Wet & "long"');
  await press(page, 570, 3);
  const untilKept = (names) => page.waitForFunction(async (expected) => {
    const database = await new Promise((resolve) => { indexedDB.open('wet-fur-versions').onsuccess = ({ target }) => resolve(target.result); });
    const all = await new Promise((resolve) => { database.transaction('versions').objectStore('versions').getAll().onsuccess = ({ target }) => resolve(target.result); });
    database.close();
    return JSON.stringify(all.map(({ name }) => name)) === JSON.stringify(expected);
  }, names);
  await untilKept(['Wet & "long"']);

  await withFur(page, (fur) => {
    fur.cameraOrbit = '1.2 0.1 3.6';
    fur.setWetness(0);
    fur.settings.furLength = 0.05;
  });
  await untilStill(page);
  const dry = await scene();
  assert.notDeepEqual(dry, wet);
  // Below the name and the time of the first version.
  const answers = 223;
  await page.mouse.click(420, answers);
  await page.waitForFunction(() => wetFur.settings.furLength > 0.19);
  await untilStill(page);
  assert.deepEqual(await scene(), wet);
  await withFur(page, (fur) => fur.undo());
  await untilStill(page);
  assert.deepEqual(await scene(), dry, 'one step of undo brings back what there was');

  // Another visit has it still.
  await page.reload();
  await page.waitForFunction(() => document.querySelector('wet-fur').editorOpen);
  await untilStill(page);
  await press(page, panelX, 2);
  await page.mouse.click(420, answers);
  await page.waitForFunction(() => wetFur.settings.furLength > 0.19);
  await untilStill(page);
  await page.mouse.click(495, answers);
  await untilStill(page);
  await page.keyboard.press('Control+a');
  await page.keyboard.type('Soaked');
  await page.keyboard.press('Enter');
  await untilKept(['Soaked']);
  await untilStill(page);
  await page.mouse.click(570, answers);
  await untilStill(page);
  await page.mouse.click(440, answers);
  await untilKept([]);
  assert.deepEqual(page.problems, []);
  await page.context().close();
});
