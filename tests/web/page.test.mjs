// The demo page in Chromium: what a visitor does, and what it shows.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { join } from 'node:path';
import { test } from 'node:test';
import { root } from '../../tools/process.mjs';
import { difference, light, luminanceAt, picture, plain, sleep, spotOnModel, startBrowser, untilStill, withFur } from './support.mjs';

const site = startBrowser();
const plainBackground = 'backgroundTop=ff00ff&backgroundBottom=ff00ff&ground=0';

test('the page draws a furry bunny, without an error or a breach of its policy', async () => {
  const page = await site.open(`?${plainBackground}`);
  const shot = await picture(page);
  const isBackground = (i) => [0, 1, 2].every((c) => Math.abs(shot.data[i + c] - shot.data[c]) < 12);
  let covered = 0;
  for (let i = 0; i < shot.data.length; i += 4) covered += isBackground(i) ? 0 : 1;
  const share = covered / (shot.data.length / 4);
  assert.ok(share > 0.12 && share < 0.8, `the bunny covers ${(share * 100).toFixed(1)} % of the picture`);
  // Fur, not one flat colour: neighbours differ from strand to strand.
  const { x, y } = await spotOnModel(page);
  const values = [];
  for (let dy = -12; dy <= 12; dy++) for (let dx = -12; dx <= 12; dx++) values.push(luminanceAt(shot, x + dx, y + dy));
  const mean = values.reduce((sum, v) => sum + v, 0) / values.length;
  const deviation = Math.sqrt(values.reduce((sum, v) => sum + (v - mean) ** 2, 0) / values.length);
  assert.ok(deviation > 4, `luminance deviates by ${deviation.toFixed(1)} of 255 within 25 pixels`);
  assert.deepEqual(page.problems, []);
  assert.deepEqual(await page.evaluate(() => window.violations), []);
  assert.deepEqual(await withFur(page, (fur) => fur.warnings), []);
});

test('a press wets the fur there and darkens it; undo and redo take it away and bring it back', async () => {
  const page = await site.open(`?${plain}&dryRate=0`);
  const spot = await spotOnModel(page);
  const wetness = () => withFur(page, (fur, at) => fur.wetnessAt(at.u, at.v), spot);
  const before = await picture(page);
  assert.equal(await wetness(), 0);
  await page.mouse.move(spot.x, spot.y);
  await page.mouse.down();
  for (let i = 0; i < 6; i++) await page.mouse.move(spot.x + 8 * Math.cos(i), spot.y + 8 * Math.sin(i));
  await page.mouse.move(spot.x, spot.y);
  await page.mouse.up();
  await untilStill(page);
  assert.ok(await withFur(page, (fur) => fur.meanWetness) > 0);
  const wet = await picture(page);
  const darker = luminanceAt(before, spot.x, spot.y, 9) - luminanceAt(wet, spot.x, spot.y, 9);
  assert.ok(darker > 6, `darker by ${darker.toFixed(1)} of 255`);
  const there = await wetness();
  await page.click('#undo');
  assert.equal(await withFur(page, (fur) => fur.meanWetness), 0);
  await page.keyboard.press('Control+y');
  await untilStill(page);
  assert.ok(Math.abs(await wetness() - there) < 0.1);  // it has run on from the end of the stroke again
  await page.click('#reset');
  assert.equal(await withFur(page, (fur) => fur.meanWetness), 0);
  assert.deepEqual(page.problems, []);
});

test('water dries with time, and at once under the dry brush', async () => {
  const page = await site.open(`?${light}&src=sphere&dryRate=0.2`);
  await withFur(page, (fur) => { fur.pause(); fur.setWetness(0.8); });
  const mean = () => withFur(page, (fur) => fur.meanWetness);
  const soaked = await mean();
  assert.ok(soaked > 0.2);
  await withFur(page, (fur) => fur.step(1 / 30, 30));
  const later = await mean();
  assert.ok(later < soaked && later > 0, `${soaked} after a second ${later}`);
  const spot = await spotOnModel(page);
  const at = () => withFur(page, (fur, { u, v }) => fur.wetnessAt(u, v), spot);
  const before = await at();
  await withFur(page, (fur) => { fur.settings.dryRate = 0; fur.tool = 'dry'; fur.play(); });
  await page.mouse.move(spot.x, spot.y);
  await page.mouse.down();
  await page.mouse.up();
  assert.ok(await at() < before);
});

test('nothing is drawn while it is dry, still and untouched', async () => {
  const page = await site.open(`?${light}`);
  const drawn = await untilStill(page);
  await sleep(1000);
  assert.equal(await withFur(page, (fur) => fur.stats.framesDrawn), drawn);
  await page.mouse.move(200, 200);  // a pointer that passes over is no reason either
  await sleep(300);
  assert.equal(await withFur(page, (fur) => fur.stats.framesDrawn), drawn);
  // Nor is a step taken: nobody asks for a frame in which it could be.
  assert.equal(await page.evaluate(async () => {
    const ask = window.requestAnimationFrame;
    let asked = 0;
    window.requestAnimationFrame = (work) => { asked += 1; return ask.call(window, work); };
    await new Promise((resolve) => setTimeout(resolve, 500));
    window.requestAnimationFrame = ask;
    return asked;
  }), 0);
});

test('wind moves the fur until it is switched off', async () => {
  const page = await site.open(`?${plain}&src=sphere`);
  const still = await untilStill(page);
  const calm = await picture(page);
  await page.click('#wind');
  assert.equal(await page.getAttribute('#wind', 'aria-pressed'), 'true');
  await page.waitForFunction((n) => wetFur.stats.framesDrawn > n + 8, still);
  assert.ok(difference(calm, await picture(page), 8) > 0.01);
  await page.click('#wind');
  await untilStill(page);
});

test('a scene brings its look, keeps it through a reset, and gives back the one before to the next model', async () => {
  const page = await site.open(`?${light}&src=sphere&furLength=0.07&ui=1`);
  const look = () => withFur(page, (fur) => ({ length: fur.settings.furLength.toFixed(2), view: fur.view, pitch: fur.getCameraOrbit().pitch.toFixed(2) }));
  const choose = async (act) => {
    const loads = withFur(page, (fur) => new Promise((resolve) => fur.addEventListener('load', ({ detail }) => resolve(detail.name), { once: true })));
    await act();
    return loads;
  };
  const own = await look();
  assert.equal(await choose(() => page.selectOption('#model', 'fins-outline')), 'fins-outline');
  const scene = await look();
  assert.equal(scene.view, 'fins');
  await withFur(page, (fur) => { fur.settings.furLength = 0.3; fur.setWetness(0.5); });
  await choose(() => page.click('#reset'));
  assert.deepEqual(await look(), scene);
  assert.equal(await withFur(page, (fur) => fur.meanWetness), 0);
  assert.equal(await choose(() => page.selectOption('#model', 'torus')), 'torus');
  assert.deepEqual(await look(), own);
  assert.deepEqual(page.problems, []);
});

test('someone who asked for less motion gets no wind, unless motion is full', async () => {
  const page = await site.open(`?${light}&src=sphere&wind=1`, { reducedMotion: 'reduce' });
  const still = await untilStill(page);
  await withFur(page, (fur) => { fur.motion = 'full'; });
  await page.waitForFunction((n) => wetFur.stats.framesDrawn > n + 5, still);
});

test('step() gives the same water and the same pixels at every run', async () => {
  const run = async () => {
    const page = await site.open(`?${light}&autoplay=0&wind=0.5&motion=full`);
    await withFur(page, (fur) => {
      for (let i = 0; i < 10; i++) {
        fur.splash({ u: 0.1 + 0.08 * i, v: 0.9 - 0.07 * i }, { radius: 0.1, amount: 0.6 });
        fur.splash({ x: 200 + 8 * i, y: 200 });
        fur.step(1 / 60, 3);
      }
    });
    return [await withFur(page, (fur) => fur.wetnessHash), await picture(page)];
  };
  const [first, second] = [await run(), await run()];
  assert.equal(first[0], second[0]);
  assert.equal(difference(first[1], second[1]), 0);
});

test('the bar knows at once what was changed on the canvas', async () => {
  const page = await site.open(`?${plain}&src=sphere`);
  await untilStill(page);
  assert.ok(await page.isDisabled('#undo'));
  const { x, y } = await spotOnModel(page);
  await page.mouse.move(x, y);
  await page.keyboard.down('Control');
  await page.mouse.down();
  await page.mouse.move(x + 30, y);  // the light; it is still held
  await page.waitForFunction(() => !document.getElementById('undo').disabled);
  await page.mouse.up();
  await page.keyboard.up('Control');
  assert.deepEqual(page.problems, []);
});

test('keys turn, zoom, wet, undo and reset once the canvas has the focus', async () => {
  const page = await site.open(`?${light}`);
  const orbit = () => withFur(page, (fur) => fur.getCameraOrbit());
  const start = await orbit();
  await page.keyboard.press('ArrowLeft');
  assert.deepEqual(await orbit(), start);
  await page.keyboard.press('Tab');
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('+');
  const moved = await orbit();
  assert.notEqual(moved.yaw, start.yaw);
  assert.notEqual(moved.pitch, start.pitch);
  assert.ok(moved.distance < start.distance);
  await page.keyboard.press('Home');
  assert.deepEqual(await orbit(), start);
  await page.keyboard.press('Space');
  assert.ok(await withFur(page, (fur) => fur.meanWetness) > 0);
  await page.keyboard.press('Control+z');
  assert.equal(await withFur(page, (fur) => fur.meanWetness), 0);
});

test('keys move the tool over the model, and what they wet is told', async () => {
  const page = await site.open(`?${light}&src=sphere`);
  await withFur(page, (fur) => {
    fur.shadowRoot.querySelector('canvas').focus();
    fur.addEventListener('cursor-move', ({ detail }) => { window.spot = detail.wetness; });
  });
  const yaw = () => withFur(page, (fur) => fur.getCameraOrbit().yaw);
  const before = await yaw();
  for (let i = 0; i < 3; i++) await page.keyboard.press('Shift+ArrowRight');
  assert.equal(await page.evaluate(() => window.spot), 0);
  assert.equal(await yaw(), before);
  for (let i = 0; i < 3; i++) await page.keyboard.press('Space');
  assert.ok(await page.evaluate(() => window.spot) > 0.2);
  await page.waitForFunction(() => wetFur.shadowRoot.querySelector('polygon').points.numberOfItems === 64);
  await page.waitForFunction(() => /^Here \d+ percent\. Wetness \d+ percent$/.test(wetFur.shadowRoot.querySelector('[role=status]').textContent));
  assert.match(await withFur(page, (fur) => fur.shadowRoot.querySelector('canvas').getAttribute('aria-description')), /Shift with arrow keys/);
  assert.deepEqual(page.problems, []);
});

test('the brush shows its footprint under the mouse, and none beside the model', async () => {
  const page = await site.open(`?${light}&src=sphere`);
  const spot = await spotOnModel(page);
  await page.mouse.move(spot.x, spot.y);
  await page.waitForFunction(() => wetFur.shadowRoot.querySelector('polygon').getAttribute('points'));
  const ring = (await withFur(page, (fur) => fur.shadowRoot.querySelector('polygon').getAttribute('points'))).split(' ').map(Number);
  const mean = (axis) => ring.reduce((sum, v, i) => sum + (i % 2 === axis ? v : 0), 0) / (ring.length / 2);
  assert.ok(Math.hypot(mean(0) - spot.x, mean(1) - spot.y) < 12, `round ${mean(0)}, ${mean(1)}, not ${spot.x}, ${spot.y}`);
  await page.mouse.move(4, 4);
  await page.waitForFunction(() => !wetFur.shadowRoot.querySelector('polygon').getAttribute('points'));
});

test('the tools of water are behind one button: rain, hose, shaking, letters and all of it off again', async () => {
  const page = await site.open(`?${plain}&dryRate=0&src=sphere`, { viewport: { width: 390, height: 700 } });
  const tool = () => withFur(page, (fur) => fur.tool);
  assert.equal(await page.isVisible('#waters'), false);
  for (const name of ['rain', 'hose', 'towel', 'dryer', 'dry']) {
    await page.focus('#water');
    await page.keyboard.press('Enter');
    await page.click(`[data-tool=${name}]`);
    assert.equal(await tool(), name);
    assert.equal(await page.getAttribute('#water', 'aria-pressed'), 'true');
    await page.keyboard.press('Escape');
    assert.equal(await page.isVisible('#waters'), false);
  }
  await page.click('#water');
  const box = await (await page.$('#waters')).boundingBox();
  assert.ok(box.x >= 0 && box.x + box.width <= 390 && box.y + box.height <= 700, JSON.stringify(box));
  await page.fill('#letters input', 'WET');
  await page.keyboard.press('Enter');
  // A ghost first: placed, sized and turned by keys.
  const ghost = () => page.$eval('#ghost span', (one) => ({ ...one.getBoundingClientRect().toJSON(), turned: one.style.rotate, text: one.textContent }));
  const first = await ghost();
  assert.equal(first.text, 'WET');
  assert.equal(await withFur(page, (fur) => fur.meanWetness), 0);
  for (const key of ['ArrowLeft', '+', ']']) await page.keyboard.press(key);
  const placed = await ghost();
  assert.ok(placed.x < first.x && placed.width > first.width && placed.turned === '0.1rad', JSON.stringify(placed));
  await page.keyboard.press('Enter');
  assert.equal(await page.isVisible('#ghost'), false);
  const stamped = await withFur(page, (fur) => fur.meanWetness);
  assert.ok(stamped > 0.005, `${stamped} of it is wet`);
  await page.click('#water');
  await page.click('#shake');
  await page.waitForFunction(() => wetFur.waterAccounts.drops > 0);
  await page.click('#clear');
  assert.equal(await withFur(page, (fur) => fur.meanWetness), 0);
  assert.deepEqual(page.problems, []);
});

test('letters are dragged, sized and turned as a ghost; a click stamps them there; Escape leaves, and so does a button', async () => {
  const page = await site.open(`?${plain}&dryRate=0&src=sphere`, { viewport: { width: 600, height: 600 } });
  const offer = async () => {
    await page.click('#water');
    await page.fill('#letters input', 'o');
    await page.keyboard.press('Enter');
  };
  const box = () => page.$eval('#ghost span', (one) => one.getBoundingClientRect().toJSON());
  await offer();
  const { width } = await box();
  await page.mouse.move(300, 300);
  await page.mouse.wheel(0, -300);
  assert.ok((await box()).width > 1.2 * width);
  await page.keyboard.down('Shift');
  await page.mouse.wheel(0, 200);
  await page.keyboard.up('Shift');
  assert.notEqual(await page.$eval('#ghost span', (one) => one.style.rotate), '0rad');
  const middle = async () => {
    const { left, right, top, bottom } = await box();
    return [(left + right) / 2, (top + bottom) / 2];
  };
  const [x, y] = await middle();
  await page.mouse.down();
  await page.mouse.move(260, 250, { steps: 3 });
  await page.mouse.up();
  const [newX, newY] = await middle();
  assert.ok(Math.hypot(newX - x + 40, newY - y + 50) < 4, 'it went along');
  const hint = page.locator('.message', { hasText: 'Drag the letters' });
  assert.equal(await hint.count(), 1);
  await page.keyboard.press('Escape');
  assert.equal(await page.isVisible('#ghost'), false);
  assert.equal(await hint.count(), 0);
  await offer();
  await hint.getByText('Leave').click();
  assert.equal(await page.isVisible('#ghost'), false);
  assert.equal(await withFur(page, (fur) => fur.meanWetness), 0);
  await offer();
  await page.mouse.click(300, 300);
  assert.ok(await withFur(page, (fur) => fur.meanWetness) > 0);
  assert.deepEqual(page.problems, []);
});

test('under Water all of it is soaked at once, stays wet, and dries as fast as a slider says; a link holds it', async () => {
  const page = await site.open(`?${plain}&src=sphere&autoplay=0`);
  await page.click('#water');
  assert.match(await page.$eval('#drying + span', (one) => one.textContent), /^Dries in \d+ min$/);
  await page.click('#soak');
  const mean = () => withFur(page, (fur) => fur.meanWetness);
  assert.ok(await mean() > 0.9);
  await page.click('#stay-wet');
  assert.equal(await page.getAttribute('#stay-wet', 'aria-pressed'), 'true');
  assert.equal(await page.isDisabled('#drying'), true);
  assert.equal(await page.$eval('#drying + span', (one) => one.textContent), 'Stays wet');
  await withFur(page, (fur) => { fur.dryRate = 0.2; fur.step(1 / 30, 90); });
  const kept = await mean();  // some has run off
  assert.ok(kept > 0.7, `${kept}`);
  await page.click('#stay-wet');
  await page.fill('#drying', '100');
  assert.ok(await withFur(page, (fur) => fur.dryRate) > 0.1);
  assert.equal(await page.$eval('#drying + span', (one) => one.textContent), 'Dries in 10 s');
  await withFur(page, (fur) => fur.step(1 / 30, 90));
  assert.ok(await mean() < kept - 0.1);
  assert.equal(await withFur(page, (fur) => JSON.parse(fur.getState()).settings.stayWet), undefined);
  await page.click('#stay-wet');
  assert.equal(await withFur(page, (fur) => JSON.parse(fur.getState()).settings.stayWet), true);
  assert.deepEqual(page.problems, []);
});

test('the tool reaches the bunny wherever fur covers the picture, and nothing beside it', async () => {
  const page = await site.open(`?${light}&${'ground=0&autoplay=0'}`, { viewport: { width: 200, height: 160 } });
  const shots = [];
  for (const color of ['#000000', '#ffffff']) {
    await withFur(page, (fur, one) => Object.assign(fur.settings, { backgroundTop: one, backgroundBottom: one }), color);
    shots.push(await picture(page));
  }
  const [black, white] = shots;
  const hits = await withFur(page, (fur) => Array.from({ length: 200 * 160 }, (_, i) => Number(fur.pick({ x: i % 200 + 0.5, y: Math.floor(i / 200) + 0.5 }) !== null)));
  const cover = (x, y) => 1 - [0, 1, 2].reduce((sum, k) => sum + white.data[4 * (200 * y + x) + k] - black.data[4 * (200 * y + x) + k], 0) / 765;
  let [covered, missed, bare, caught] = [0, 0, 0, 0];
  for (let y = 3; y < 157; y++) {
    for (let x = 3; x < 197; x++) {
      const hit = hits[200 * y + x];
      const near = () => [-3, 0, 3].every((dy) => [-3, 0, 3].every((dx) => cover(x + dx, y + dy) < 0.1));
      if (cover(x, y) >= 0.5) [covered, missed] = [covered + 1, missed + 1 - hit];
      else if (near()) [bare, caught] = [bare + 1, caught + hit];
    }
  }
  assert.ok(covered > 3000 && missed <= 0.01 * covered, `${missed} of ${covered} missed`);
  assert.ok(caught <= 0.002 * bare, `${caught} of ${bare} caught`);
});

test('a recorded session is replayed to the same water as in the native program', async () => {
  const page = await site.open(`?${light}&src=sphere&dryRate=0.02`);
  const hash = await withFur(page, (fur) => {
    fur.pause();
    // As tests/app/AppWaterGLTest.cpp replays it.
    fur.replay('[[0,0.2,0.6,0.05,0,0,3,0,100,0.3,0.3,1],[3,0.2,0.8,0.05,0,1,3,5,300,0.3,0.3,1,40,310,0.3,0.3,1,60,310,0.3,0.3,0],'
      + '[2,0.2,0.8,0.05,0,0,3,70,300,0.3,0.3,1,110,300,0.3,0.3,0],[100,0.05,0.8,0.05,0,0,3,120,200,0.3,0.3,1,120,220,0.3,0.3,1],'
      + '[4,0.2,0.5,0.05,0,0,3,130,310,0.3,0.3,1],[104,0,0,0.05,0,0,0,135,0,0,0,1],[5,0.2,0.8,0.05,0,0,3,150,300,0.2,0.2,1,170,300,0.2,0.2,0],'
      + '[105,0,0,0.05,0,0,0,171,0,0,0,1],[0,0.1,0.6,0.05,0,0,3,200,120,0.3,0.3,1]]');
    return fur.wetnessHash;
  });
  const native = spawnSync(join(root, 'build/native-release/wet-fur-gl-tests'), ['--gtest_filter=AppWater.ARecordedSession*'], { encoding: 'utf8' });
  assert.equal(hash, /^on every platform: a recorded session ([0-9a-f]{16})$/m.exec(native.stdout)?.[1], native.stderr);
});

test('mouse, wheel and two fingers move the camera; a double click beside the model resets it', async () => {
  const page = await site.open(`?${light}`, { hasTouch: true });
  const orbit = () => withFur(page, (fur) => fur.getCameraOrbit());
  const start = await orbit();
  await page.mouse.move(20, 20);
  await page.mouse.down();
  await page.mouse.move(120, 40, { steps: 4 });
  await page.mouse.up();
  assert.notEqual((await orbit()).yaw, start.yaw);
  await page.mouse.wheel(0, 300);
  await page.waitForFunction((d) => wetFur.getCameraOrbit().distance > d, start.distance);
  await page.mouse.dblclick(20, 20);
  assert.deepEqual(await orbit(), start);

  const touch = await page.context().newCDPSession(page);
  const send = (type, ...points) => touch.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  await send('touchStart', [200, 30]);
  await send('touchStart', [200, 30], [280, 30]);
  for (let i = 1; i <= 5; i++) await send('touchMove', [200 - 10 * i, 30], [280 + 10 * i, 30]);
  await send('touchEnd');
  const pinched = await orbit();
  assert.ok(pinched.distance < start.distance * 0.8, `${start.distance} -> ${pinched.distance}`);
});

test('the canvas has the pixels of the screen, and follows a resize', async () => {
  const page = await site.open(`?quality=auto&layers=8&fins=0&ui=0&src=sphere&exposure=0.3`, { deviceScaleFactor: 2, viewport: { width: 300, height: 200 } });
  const size = () => withFur(page, (fur) => {
    const canvas = fur.shadowRoot.querySelector('canvas');
    return [canvas.width, canvas.height];
  });
  assert.deepEqual(await size(), [600, 400]);
  await page.setViewportSize({ width: 240, height: 320 });
  await page.waitForFunction(() => wetFur.shadowRoot.querySelector('canvas').width === 480);
  assert.deepEqual(await size(), [480, 640]);
  const shot = await picture(page);
  assert.ok(Math.abs(luminanceAt(shot, 240, 320, 4) - luminanceAt(shot, 10, 10, 4)) > 10);
  const other = await picture(page, { width: 128, height: 96 });
  assert.deepEqual([other.width, other.height], [128, 96]);
  assert.deepEqual(await size(), [480, 640]);
  await withFur(page, (fur) => { fur.quality = 'low'; });
  assert.deepEqual(await size(), [240, 320]);
});

test('a coat that is chosen on the page changes the fur; undo takes it back, and the link holds it', async () => {
  const page = await site.open(`?${plain}&src=sphere`, { permissions: ['clipboard-read', 'clipboard-write'] });
  const before = await picture(page);
  const original = await withFur(page, (fur) => fur.getState());
  await page.click('#coat');
  assert.equal(await page.$$eval('#coats button', (list) => list.length), 13);
  const pressed = () => page.$$eval('#coats [aria-pressed=true]', (list) => list.map((one) => one.dataset.coat));
  assert.deepEqual(await pressed(), ['original']);
  await page.click('#coats [data-coat=chinchilla]');
  assert.equal(await withFur(page, (fur) => fur.preset), 'chinchilla');
  assert.deepEqual(await pressed(), ['chinchilla']);
  await untilStill(page);
  assert.ok(difference(before, await picture(page), 16) > 0.05);
  await page.click('#coats [data-coat=original]');
  assert.equal(await withFur(page, (fur) => fur.getState()), original);
  await page.click('#coats [data-coat=chinchilla]');
  await page.keyboard.press('Escape');
  await page.click('#share');
  await page.click('#link');
  await page.waitForSelector('#messages .message');
  const link = await page.evaluate(() => navigator.clipboard.readText());
  await page.click('#undo');
  assert.equal(await withFur(page, (fur) => fur.preset), '');
  assert.equal(await withFur(page, (fur) => fur.getState()), original);
  const other = await site.open(new URL(link).search);
  assert.equal(await withFur(other, (fur) => fur.preset), 'chinchilla');
  await other.click('#coat');
  assert.equal(await other.$eval('#coats [aria-pressed=true]', (one) => one.dataset.coat), 'chinchilla');
  assert.deepEqual(page.problems, []);
  assert.deepEqual(await page.evaluate(() => window.violations), []);
});

test('the coats are reached by keys, and are on the screen of a phone', async () => {
  const page = await site.open(`?${plain}&src=plane`, { viewport: { width: 390, height: 600 } });
  await page.focus('#coat');
  await page.keyboard.press('Enter');
  const focused = () => page.evaluate(() => document.activeElement.dataset.coat ?? document.activeElement.id);
  await page.waitForFunction(() => document.activeElement.dataset.coat === 'original');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowRight');
  assert.equal(await focused(), 'chinchilla');
  await page.keyboard.press('Enter');
  assert.equal(await withFur(page, (fur) => fur.preset), 'chinchilla');
  for (let i = 0; i < 11; i++) await page.keyboard.press('ArrowRight');
  assert.equal(await focused(), 'own-coats', 'the last one is the end');
  const { left, right, width, height } = await page.evaluate(() => document.activeElement.getBoundingClientRect().toJSON());
  assert.ok(left >= 0 && right <= 390, `scrolled to where it is seen: ${left} to ${right}`);
  assert.ok(width >= 44 && height >= 44, `room for a finger: ${width} x ${height}`);
  await page.keyboard.press('Escape');
  assert.equal(await page.isHidden('#coats'), true);
  assert.equal(await focused(), 'coat');
});

test('wetness is announced politely', async () => {
  const page = await site.open(`?${light}&src=sphere`);
  await withFur(page, (fur) => fur.setWetness(0.9));
  await page.waitForFunction(() => /Wetness \d+ percent/.test(wetFur.shadowRoot.querySelector('[aria-live=polite]').textContent));
});

test('a coat that takes long shows how far it is, and the page answers meanwhile', async () => {
  const page = await site.open(`?${light}&src=sphere`);
  const seen = await withFur(page, async (fur) => {
    const bar = fur.shadowRoot.querySelector('[part=coat-progress]');
    const fractions = [];
    let shown = false, frames = 0;
    const done = new Promise((resolve) => {
      fur.addEventListener('progress', ({ detail }) => {
        if (detail.stage !== 'coat') return;
        fractions.push(detail.fraction);
        shown ||= !bar.hidden;
        if (detail.fraction === 1) resolve();
      });
    });
    const strands = fur.stats.strands;
    fur.settings.layers = 128;
    fur.settings.tileSize = '512';
    const count = () => { frames += 1; if (bar) requestAnimationFrame(count); };
    requestAnimationFrame(count);
    await done;
    return { fractions, shown, frames, hidden: bar.hidden, strands, after: fur.stats.strands };
  });
  assert.ok(seen.shown && seen.hidden, 'the bar comes and goes');
  assert.deepEqual(seen.fractions, [...seen.fractions].sort((a, b) => a - b));
  assert.equal(seen.fractions.at(-1), 1);
  // One report a frame, and the first and last frames may fall on either side.
  assert.ok(seen.frames >= seen.fractions.length - 2, `frames go on while it grows: ${seen.frames} of ${seen.fractions.length}`);
  assert.ok(seen.after > 3 * seen.strands, `${seen.strands} strands, then ${seen.after}`);
  assert.deepEqual(page.problems, []);
});
