// <wet-fur> among other things on a page, from a sub-folder of its host.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { lighten, recordContexts, sleep, startBrowser, untilStill, withFur } from './support.mjs';

const site = startBrowser({ subfolder: true });
const centreOf = (page, index) => page.evaluate((i) => {
  const box = document.querySelectorAll('wet-fur')[i].getBoundingClientRect();
  return [box.left + box.width / 2, box.top + box.height / 2];
}, index);
const open = ({ scripts = [], ...options }) => site.open('embed.html', { ...options, scripts: [...scripts, lighten] });
const scrollY = (page) => page.evaluate(() => Math.round(window.scrollY));

test('the page scrolls over an element with the wheel until it is clicked', async () => {
  const page = await open({ viewport: { width: 480, height: 600 } });
  await withFur(page, (fur) => fur.scrollIntoView({ block: 'center' }));
  await page.mouse.move(...await centreOf(page, 0));
  const distance = () => withFur(page, (fur) => fur.getCameraOrbit().distance);
  const [start, top] = [await distance(), await scrollY(page)];
  await page.mouse.wheel(0, 60);
  await page.waitForFunction((y) => window.scrollY > y + 30, top);
  assert.equal(await distance(), start);
  await page.mouse.move(...await centreOf(page, 0));
  await page.mouse.click(...await centreOf(page, 0));
  const after = await scrollY(page);
  await page.mouse.wheel(0, 100);
  await page.waitForFunction((d) => document.querySelector('wet-fur').getCameraOrbit().distance > d, start);
  assert.equal(await scrollY(page), after);
  assert.deepEqual(page.problems, []);
  assert.deepEqual(await page.evaluate(() => window.violations), []);
});

test('a finger that starts on an element scrolls the page and wets nothing; a tap wets it', async () => {
  const page = await open({ viewport: { width: 480, height: 600 }, hasTouch: true });
  await withFur(page, (fur) => fur.scrollIntoView({ block: 'center' }));
  const [x, y] = await centreOf(page, 0);
  const top = await scrollY(page);
  const touch = await page.context().newCDPSession(page);
  const send = (type, ...points) => touch.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([px, py]) => ({ x: px, y: py })) });
  await send('touchStart', [x, y]);
  for (let i = 1; i <= 12; i++) await send('touchMove', [x, y - 12 * i]);
  await send('touchEnd');
  await page.waitForFunction((from) => window.scrollY > from + 60, top);
  assert.equal(await withFur(page, (fur) => fur.meanWetness), 0);
  await page.touchscreen.tap(...await centreOf(page, 0));
  assert.ok(await withFur(page, (fur) => fur.meanWetness) > 0);
});

test('letters are stamped, the model shakes them off, strokes are painted again, and all water is accounted for', async () => {
  const page = await open({ viewport: { width: 480, height: 600 } });
  const balance = (w) => w.painted + w.rained - (w.held + w.film + w.drops + w.hair + w.dripped + w.evaporated + w.removed);
  const seen = await withFur(page, (fur) => {
    Object.assign(fur, { paused: true, dryRate: 0 });
    fur.stamp('WET', { size: 80 });
    const stamped = fur.meanWetness;
    fur.step(1 / 60, 60);
    const still = fur.waterAccounts;
    fur.shake();
    fur.step(1 / 60, 90);
    const shaken = fur.waterAccounts;
    fur.undo();
    const undone = fur.meanWetness;
    let refused = '';
    try { fur.replay('{}'); } catch (error) { refused = error.code; }
    return { stamped, still, shaken, undone, refused, strokes: fur.recordedStrokes };
  });
  assert.ok(seen.stamped > 0.01 && seen.stamped < 0.5, `${seen.stamped} of the model is wet`);
  assert.ok(seen.shaken.held + seen.shaken.film < 0.9 * (seen.still.held + seen.still.film));
  for (const accounts of [seen.still, seen.shaken]) assert.ok(Math.abs(balance(accounts)) < 1e-5, JSON.stringify(accounts));
  assert.equal(seen.refused, 'bad-file');
  assert.deepEqual(JSON.parse(seen.strokes).map(([what]) => what), ['splash', 'shake', 'undo']);  // letters are splashes
  assert.deepEqual(page.problems, []);
});

test('an element out of sight is not loaded before it comes near, and draws nothing once it has left', async () => {
  const page = await open({ viewport: { width: 480, height: 400 } });
  const ring = (work, argument) => page.evaluate(`(${work})(document.getElementById('ring'), ${JSON.stringify(argument) ?? 0})`);
  assert.equal(await ring((fur) => fur.loaded), false);
  await ring((fur) => fur.scrollIntoView({ block: 'center' }));
  await page.waitForFunction(() => document.getElementById('ring').loaded);
  const drawn = await ring((fur) => fur.stats.framesDrawn);
  await page.waitForFunction((n) => document.getElementById('ring').stats.framesDrawn > n + 2, drawn);  // wind
  await page.evaluate(() => window.scrollTo(0, 0));
  await page.waitForFunction(() => document.getElementById('ring').state === 'suspended');
  const left = await ring((fur) => fur.stats.framesDrawn);
  await sleep(700);
  assert.equal(await ring((fur) => fur.stats.framesDrawn), left);
  await ring((fur) => fur.scrollIntoView({ block: 'center' }));
  await page.waitForFunction((n) => document.getElementById('ring').stats.framesDrawn > n, left);
});

test('two elements share the program and the context, and no state; one that is removed gives back what it had there', async () => {
  let fetches = 0;
  const page = await open({
    viewport: { width: 480, height: 600 },
    scripts: [recordContexts],
    prepare: (tab) => tab.on('request', (request) => { if (request.url().endsWith('.wasm')) fetches++; }),
  });
  await page.evaluate(() => document.getElementById('ring').scrollIntoView({ block: 'center' }));
  await page.waitForFunction(() => document.getElementById('ring').loaded);
  assert.equal(fetches, 1);
  const seen = await page.evaluate(() => {
    const [bunny, ring] = document.querySelectorAll('wet-fur');
    bunny.setWetness(1);
    ring.settings.furLength = 0.3;
    return { bunny: [bunny.meanWetness, bunny.settings.furLength], ring: [ring.meanWetness, ring.settings.furLength], coat: ring.settings.tipColor };
  });
  assert.ok(seen.bunny[0] > 0.3 && seen.ring[0] === 0);
  assert.notEqual(seen.bunny[1], seen.ring[1]);
  assert.equal(seen.coat, '#7b6f80');
  const before = await page.evaluate(() => {
    const { alive, objects } = contextsHeld();
    document.querySelector('wet-fur').remove();
    return { alive, objects };
  });
  await page.waitForFunction(({ alive, objects }) => contextsHeld().alive === alive && contextsHeld().objects < objects - 10, before);
  await page.evaluate(() => document.getElementById('ring').step(1 / 60, 2));
  assert.deepEqual(page.problems, []);
});

test('with reveal="interaction" nothing is loaded before the person asks, by pointer or key, and the focus stays', async () => {
  const page = await open({ viewport: { width: 480, height: 600 } });
  const state = await page.evaluate(async () => {
    const fur = document.createElement('wet-fur');
    Object.assign(fur, { reveal: 'interaction', src: 'plane', alt: 'A meadow', id: 'asked', cameraControls: true });
    window.dismissed = 0;
    fur.addEventListener('poster-dismissed', () => { window.dismissed += 1; });
    document.body.prepend(fur);
    await new Promise((resolve) => setTimeout(resolve, 300));
    return fur.state;
  });
  assert.equal(state, 'idle');
  const ask = page.locator('#asked').getByRole('button', { name: 'Show the model' });
  const cue = page.locator('#asked [part=interaction-prompt]');
  assert.ok(await cue.isVisible());
  await page.keyboard.press('Tab');
  assert.equal(await page.evaluate(() => document.activeElement.shadowRoot?.activeElement.className), 'cover poster');
  assert.equal(await page.evaluate(() => window.dismissed), 0);
  await page.keyboard.press('Enter');
  await page.waitForFunction(() => document.getElementById('asked').loaded);
  assert.equal(await ask.isVisible(), false);
  assert.equal(await cue.isVisible(), false);
  assert.equal(await page.evaluate(() => window.dismissed), 1);
  const yaw = () => page.evaluate(() => document.getElementById('asked').getCameraOrbit().yaw);
  const before = await yaw();
  await page.keyboard.press('ArrowLeft');
  assert.notEqual(await yaw(), before, 'keys go on to what was revealed');
});

test('a picture that the page gives as poster can fill the element, whatever its own shape', async () => {
  const page = await open({ viewport: { width: 800, height: 600 } });
  const shown = await page.evaluate(async () => {
    const fur = document.createElement('wet-fur'), image = document.createElement('img');
    Object.assign(fur, { reveal: 'manual', src: 'plane', alt: 'A meadow' });
    Object.assign(fur.style, { width: '600px', height: '200px', aspectRatio: 'auto' });
    Object.assign(image, { slot: 'poster', src: `data:image/svg+xml,${encodeURIComponent('<svg xmlns="http://www.w3.org/2000/svg" width="900" height="900"/>')}` });
    Object.assign(image.style, { width: '100%', height: '100%' });
    fur.append(image);
    document.body.prepend(fur);
    await image.decode();
    const { width, height } = image.getBoundingClientRect();
    return { width, height };
  });
  assert.deepEqual(shown, { width: 600, height: 200 });
});

test('the cue may be another one, or none; with reveal="manual" the page dismisses the poster', async () => {
  const page = await open({ viewport: { width: 480, height: 600 } });
  const seen = await page.evaluate(async () => {
    const fur = document.createElement('wet-fur');
    Object.assign(fur, { reveal: 'interaction', src: 'plane', interactionPrompt: 'none', quality: 'low', id: 'asked' });
    fur.append(Object.assign(document.createElement('b'), { slot: 'interaction-prompt', textContent: 'Stroke me' }));
    document.body.prepend(fur);
    const shown = () => fur.firstChild.checkVisibility();
    const out = { none: shown() };
    fur.interactionPrompt = 'auto';
    out.own = shown();
    fur.reveal = 'manual';
    out.manual = shown();
    out.state = fur.state;
    const dismissed = new Promise((resolve) => fur.addEventListener('poster-dismissed', resolve, { once: true }));
    fur.dismissPoster();
    await dismissed;
    return { ...out, loaded: fur.loaded };
  });
  assert.deepEqual(seen, { none: false, own: true, manual: false, state: 'idle', loaded: true });
});

test('createWetFur draws on a canvas of the page', async () => {
  const page = await open({ viewport: { width: 480, height: 400 } });
  const seen = await page.evaluate(async () => {
    const { createWetFur } = await import(new URL('index.js', location.href).href);
    const canvas = document.body.appendChild(document.createElement('canvas'));
    canvas.style.cssText = 'display:block;width:120px;height:90px';
    const fur = await createWetFur(canvas, { src: 'plane', layers: 8, tool: 'droplet', furLength: 0.3 });
    const before = fur.wetnessAt(0.5, 0.5);
    fur.splash({ u: 0.5, v: 0.5 }, { radius: 0.1, amount: 0.5 });
    fur.step(1 / 60);
    const out = { before, after: fur.wetnessAt(0.5, 0.5), layers: fur.stats.layers, length: fur.get('furLength'), width: canvas.width };
    fur.dispose();
    const refused = await createWetFur(document.createElement('canvas'), { src: 'away.glb' }).catch((error) => error.code);
    return { ...out, refused };
  });
  assert.equal(seen.before, 0);
  assert.ok(seen.after > 0.3);
  assert.deepEqual([seen.layers, seen.width, seen.refused], [8, 120, 'network']);
  await untilStill(page);
});

test('the light-rig attribute is the light, what is set after it stays over it, and an unknown one warns', async () => {
  const page = await open({ viewport: { width: 480, height: 600 } });
  const seen = await page.evaluate(async () => {
    const fur = document.createElement('wet-fur');
    for (const [name, value] of Object.entries({ 'light-rig': 'night', quality: 'low', src: 'plane', loading: 'eager', exposure: 1.5 }))
      fur.setAttribute(name, value);
    Object.assign(fur.settings, { layers: 8, fins: false });
    document.body.append(fur);
    await fur.ready;
    const look = () => [fur.settings.keyColor, fur.settings.rimLight > 0, fur.settings.exposure];
    const night = look(), changed = fur.lightRig;
    fur.lightRig = 'daylight';
    const day = look(), named = fur.lightRig;
    const undone = fur.undo() && look();
    fur.lightRig = 'disco';
    const { warnings } = fur;
    fur.remove();
    return { night, changed, day, named, undone, warnings };
  });
  assert.deepEqual([seen.changed, seen.named], [undefined, 'daylight'], 'the rig whose light it is, while nothing of it is changed');
  assert.deepEqual(seen.night, ['#9db8ff', true, 1.5]);
  assert.deepEqual(seen.day, ['#ffffff', false, 1]);
  assert.deepEqual(seen.undone, seen.night, 'one step of undo');
  assert.equal(seen.warnings.length, 1);
  assert.match(seen.warnings[0], /disco.*daylight.*night/);
});

test('the wetness attribute is how wet the first model comes, without a step of undo; set later it wets what is shown', async () => {
  const page = await open({ viewport: { width: 480, height: 600 } });
  const seen = await page.evaluate(async () => {
    const fur = document.createElement('wet-fur');
    for (const [name, value] of Object.entries({ wetness: '0.5', 'dry-rate': 0, paused: '', quality: 'low', src: 'plane', loading: 'eager' }))
      fur.setAttribute(name, value);
    Object.assign(fur.settings, { layers: 8, fins: false });
    document.body.append(fur);
    await fur.ready;
    const came = [fur.meanWetness, fur.undo()];
    const option = fur.wetness;
    fur.wetness = 7;
    const more = fur.meanWetness;
    for (const none of ['much', '', null]) fur.wetness = none;
    const kept = fur.meanWetness, { warnings } = fur;
    const loaded = new Promise((resolve) => { fur.addEventListener('load', resolve, { once: true }); });
    fur.src = 'sphere';
    await loaded;
    const next = fur.meanWetness;
    fur.remove();
    return { came, option, more, kept, next, warnings };
  });
  assert.ok(Math.abs(seen.came[0] - 0.5) < 0.01, `${seen.came[0]}: of 0.5, but for steps of a byte`);
  assert.equal(seen.came[1], false);
  assert.ok(seen.more > 0.99, `${seen.more}: 7 is more than there may be`);
  assert.equal(seen.kept, seen.more, 'what is no number wets nothing');
  assert.equal(seen.next, 0, 'another model comes as its file has it');
  assert.deepEqual(seen.warnings, []);
});

test('the preset attribute is the coat, what is set beside it stays over it, and it can be changed', async () => {
  const page = await open({ viewport: { width: 480, height: 600 } });
  const seen = await page.evaluate(async () => {
    const fur = document.createElement('wet-fur');
    for (const [name, value] of Object.entries({ seed: 5, preset: 'velvet', quality: 'low', src: 'plane', loading: 'eager' }))
      fur.setAttribute(name, value);
    Object.assign(fur.settings, { layers: 8, fins: false, furLength: 0.1 });
    document.body.append(fur);
    await fur.ready;
    const first = [fur.seed, fur.settings.density, fur.settings.furLength.toFixed(3), fur.preset];
    fur.preset = 'wool';
    const second = [fur.preset, fur.getAttribute('preset'), fur.seed, fur.settings.layers];
    fur.settings.density = 0.5;
    const third = fur.preset;
    fur.preset = 'fox';
    const { warnings } = fur;
    fur.remove();
    return { first, second, third, warnings };
  });
  assert.deepEqual(seen.first, [5, 1, '0.100', '']);
  assert.deepEqual(seen.second, ['wool', 'wool', 5, 8]);
  assert.equal(seen.third, '');
  assert.equal(seen.warnings.length, 1);
  assert.match(seen.warnings[0], /fox.*chinchilla/);
});
