// The demo page's address: allow-listed, clamped, and a link that restores the scene.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { makeLink, readLink } from '../../web/link.js';
import { orbitText, parseOrbit } from '../../web/orbit.js';
import { asksForScene, modelOf } from '../../web/visit.js';
import { light, plain, startBrowser, withFur } from './support.mjs';

const site = startBrowser();
const page = 'https://example.org/fur/index.html';

test('a link gives back source, state and tool', () => {
  const state = '{"version":1,"settings":{"furLength":0.2},"note":"ä€😀"}';
  const read = readLink(makeLink(`${page}?wind=1#x`, { src: 'torus', state, tool: 'dry' }));
  assert.deepEqual({ ...read }, { src: 'torus', state, tool: 'dry', settings: [], warnings: [] });
});

test('what is not allowed warns and is left out', () => {
  const bad = readLink(`${page}?src=https://elsewhere.org/a.glb&tool=hammer&quality=&dt=x&frames=1e9&ui=yes&state=%25&motion=full`);
  assert.equal(bad.src ?? bad.tool ?? bad.quality ?? bad.dt ?? bad.ui ?? bad.state, undefined);
  assert.equal(bad.frames, 10000);
  assert.equal(bad.motion, 'full');
  assert.equal(bad.warnings.length, 7);
  for (const src of ['javascript:alert(1)', 'data:model/gltf-binary,x', '//elsewhere.org/a.glb', 'blob:https://example.org/1'])
    assert.equal(readLink(`${page}?src=${encodeURIComponent(src)}`).src, undefined, src);
  assert.equal(readLink(`${page}?src=models/bunny.glb`).src, 'models/bunny.glb');
});

test('a light rig of the address is set before the settings beside it', async () => {
  const view = await site.open(`?${light}&src=plane&rimLight=0.25&light=night`);
  const seen = await withFur(view, (fur) => [fur.settings.keyColor, fur.settings.rimLight, fur.warnings.length]);
  assert.deepEqual(seen, ['#9db8ff', 0.25, 0]);
});

test('an address says how wet the model comes', async () => {
  const view = await site.open(`?${light}&src=plane&wetness=0.4&dryRate=0&autoplay=0`);
  const seen = await withFur(view, (fur) => [fur.meanWetness, fur.warnings.length]);
  assert.ok(Math.abs(seen[0] - 0.4) < 0.01 && seen[1] === 0, `${seen}`);
  assert.match(readLink(`${page}?wetness=2`).warnings[0], /wetness.*outside 0 to 1/);
  const wet = readLink(`${page}?wetness=0.4`);
  assert.deepEqual([modelOf(wet), asksForScene(wet)], ['otter', true], 'of the page as it is now, and over the work of before');
  assert.ok(asksForScene(readLink(`${page}?wetness=0`)), 'dry is asked for, too');
  assert.ok(!asksForScene(readLink(page)));
});

test('an overlong state, value or list of parameters is not read', () => {
  assert.equal(readLink(`${page}?state=${'A'.repeat(9000)}`).state, undefined);
  assert.equal(readLink(`${page}?wind=${'1'.repeat(600)}`).settings.length, 0);
  assert.equal(readLink(`${page}?${'a=1&'.repeat(200)}`).settings.length, 100);
});

test('a camera text reads back, in either unit', () => {
  const orbit = { yaw: 0.5, pitch: -0.25, distance: 3, target: [0, 0.5, 0] };
  assert.deepEqual(parseOrbit(orbitText(orbit)), orbit);
  assert.ok(Math.abs(parseOrbit('90deg 0.1rad 2').yaw - Math.PI / 2) < 1e-12);
  assert.deepEqual(parseOrbit('90deg 0.1rad 2.5m'), parseOrbit('90deg 0.1rad 2.5'));
  for (const text of ['', '1 2', '1 2 0', '1 2 NaN', '0x1 2 3', '1 2 3 4', '1deg 2 3deg']) assert.equal(parseOrbit(text), null, text);
});

test('unknown parameters and out-of-range settings warn; the page still works', async () => {
  const tab = await site.open(`?${light}&src=sphere&furLength=99&nonsense=1&view=upside&preset=fox&camera=1,2&wind=0`);
  const seen = await withFur(tab, (fur) => ({ warnings: fur.warnings, furLength: fur.settings.furLength, view: fur.view }));
  assert.ok(Math.abs(seen.furLength - 0.4) < 1e-6);  // a float
  assert.equal(seen.view, 'final');
  for (const word of ['furLength', 'nonsense', 'view', 'preset', 'camera'])
    assert.ok(seen.warnings.some((text) => text.includes(word)), `a warning about ${word} among: ${seen.warnings.join('; ')}`);
  // The person is told, too, however many there are.
  const told = await tab.locator('#messages .message p').allTextContents();
  assert.equal(told.length, 1);
  assert.match(told[0], /^Not all of the link could be used: .*; and 2 more/);
  assert.deepEqual(tab.problems, []);
});

test('a state that cannot be read, or is too long, is told on the page', async () => {
  for (const [query, what] of [['state=%25%25garbled', /state: "%%garbled" cannot be read/], [`groom=${'x'.repeat(9000)}`, /groom: .* is longer than 8192 characters/]]) {
    const tab = await site.open(`?${light}&src=sphere&${query}`);
    assert.match(await tab.locator('#messages .message p').textContent(), what);
  }
});

test('the copied link restores settings, camera, model and tool', async () => {
  const first = await site.open(`?${plain}&src=torus`, { permissions: ['clipboard-read', 'clipboard-write'] });
  await withFur(first, (fur) => {
    fur.settings.furLength = 0.21;
    fur.settings.tipColor = '#112233';
    fur.cameraOrbit = '0.7 0.2 4.5';
  });
  await first.click('#water');
  await first.click('[data-tool=dry]');
  await first.click('#share');
  await first.click('#link');
  await first.waitForSelector('#messages .message');
  const link = await first.evaluate(() => navigator.clipboard.readText());
  const state = await withFur(first, (fur) => fur.getState());
  const second = await site.open(new URL(link).search);
  const seen = await withFur(second, (fur) => ({ state: fur.getState(), tool: fur.tool, src: fur.src, undo: fur.canUndo }));
  assert.deepEqual(JSON.parse(seen.state), JSON.parse(state));
  assert.equal(seen.tool, 'dry');
  assert.equal(seen.src, 'torus');
  assert.equal(seen.undo, false);  // a link is where the scene starts
});

test('a preset of the address is the coat, and fields beside it stay over it', async () => {
  const tab = await site.open(`?furLength=0.06&${light}&src=sphere&preset=wool`);
  const seen = await withFur(tab, (fur) => {
    const wool = fur.presets.find(({ name }) => name === 'wool').settings;
    return { wool, now: Object.fromEntries(Object.keys(wool).map((name) => [name, fur.settings[name]])), layers: fur.settings.layers };
  });
  for (const [name, value] of Object.entries({ ...seen.wool, furLength: 0.06 })) {
    if (typeof value === 'number') assert.ok(Math.abs(seen.now[name] - value) < 1e-6, name);
    else assert.equal(seen.now[name], value, name);
  }
  assert.equal(seen.layers, 8);
  assert.equal(await withFur(tab, (fur) => fur.canUndo), false);
  assert.deepEqual(await withFur(tab, (fur) => fur.warnings), []);
});

test('a preset of the address is a coat for the model: its light, backdrop and camera stay what it brought', async () => {
  const look = (address) => site.open(address).then((tab) => withFur(tab, (fur) => ({ settings: { ...fur.settings }, orbit: fur.cameraOrbit, coat: fur.preset, coatFields: fur.settingsTable.filter(({ coat }) => coat).map(({ name }) => name) })));
  const own = await look(`?${light}&src=otter`), dressed = await look(`?${light}&src=otter&preset=persian`);
  assert.equal(dressed.coat, 'persian');
  assert.equal(dressed.orbit, own.orbit);
  const changed = Object.keys(own.settings).filter((name) => own.settings[name] !== dressed.settings[name]);
  assert.ok(changed.includes('furLength'));
  assert.deepEqual(changed.filter((name) => !dressed.coatFields.includes(name)), []);
});

test('a preset that there is not warns once and names those that there are', async () => {
  const tab = await site.open(`?${light}&src=sphere&preset=fox`);
  const warnings = await withFur(tab, (fur) => fur.warnings);
  assert.equal(warnings.length, 1);
  for (const name of await withFur(tab, (fur) => fur.presets.map((preset) => preset.name))) assert.ok(warnings[0].includes(name), name);
});

test('dt, frames and autoplay=0 give the same still picture at every visit', async () => {
  const visit = async () => {
    const tab = await site.open(`?${light}&src=sphere&wind=0.8&motion=full&dt=0.02&frames=25&autoplay=0`);
    const first = await withFur(tab, (fur) => [fur.stats.framesDrawn, fur.paused]);
    await tab.waitForTimeout(400);
    assert.equal(await withFur(tab, (fur) => fur.stats.framesDrawn), first[0]);
    assert.equal(first[1], true);
    return (await tab.screenshot()).toString('base64');
  };
  assert.equal(await visit(), await visit());
});
