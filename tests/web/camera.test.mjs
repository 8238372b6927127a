// The element's camera by its attributes, as users of <model-viewer> know them.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { parseFov, parseTarget } from '../../web/orbit.js';
import { difference, light, picture, startBrowser, untilStill, withFur } from './support.mjs';

const site = startBrowser();

test('a target and a field of view read back, in either form', () => {
  assert.deepEqual(parseTarget('0 0.5m -1'), [0, 0.5, -1]);
  for (const text of ['', '1 2', '1 2 x', 'auto']) assert.equal(parseTarget(text), null, text);
  for (const text of ['45deg', '45', 45]) assert.ok(Math.abs(parseFov(text) - Math.PI / 4) < 1e-12, `${text}`);
  assert.equal(parseFov('0.5rad'), 0.5);
  assert.equal(parseFov('auto'), 0.6);
  assert.ok(Number.isNaN(parseFov('wide')));
});

test('auto-rotate turns the view once nobody has been there for three seconds, and pauses when somebody is', async () => {
  const page = await site.open(`?${light}&src=torus&autoplay=0`);
  const seen = await withFur(page, (fur) => {
    const yaw = () => fur.getCameraOrbit().yaw;
    const after = (seconds) => { fur.step(0.1, Math.round(10 * seconds)); return yaw(); };
    const start = yaw();
    const never = after(5);
    fur.autoRotate = true;
    const first = yaw();
    const turned = after(2);
    fur.shadowRoot.querySelector('canvas').focus();
    return { start, never, first, turned };
  });
  assert.equal(seen.never, seen.start);
  assert.ok(Math.abs(seen.first - seen.turned - 2 * Math.PI / 32) < 1e-3, `turned by ${seen.first - seen.turned}`);
  await page.keyboard.press('+');  // somebody is there
  const paused = await withFur(page, (fur) => {
    const at = fur.getCameraOrbit().yaw;
    fur.step(0.1, 28);
    const still = fur.getCameraOrbit().yaw === at;
    fur.step(0.1, 10);
    const again = fur.getCameraOrbit().yaw < at;
    fur.motion = 'reduced';
    const before = fur.getCameraOrbit().yaw;
    fur.step(0.1, 40);
    return { still, again, reduced: fur.getCameraOrbit().yaw === before };
  });
  assert.deepEqual(paused, { still: true, again: true, reduced: true });
});

test('it goes on by itself while it is shown', async () => {
  const page = await site.open(`?${light}&src=plane`);
  const yaw = await withFur(page, (fur) => { fur.setAttribute('auto-rotate', ''); return fur.getCameraOrbit().yaw; });
  await page.waitForFunction((from) => wetFur.getCameraOrbit().yaw < from - 0.05, yaw);
  await withFur(page, (fur) => fur.removeAttribute('auto-rotate'));
  await untilStill(page);
});

test('camera-target says where the camera looks, field-of-view how wide; both hold from the start, and what is no such thing warns', async () => {
  const page = await site.open('embed.html');
  const seen = await page.evaluate(async () => {
    const fur = document.createElement('wet-fur');
    for (const [name, value] of Object.entries({ src: 'sphere', loading: 'eager', quality: 'low', 'camera-target': '0 0.4 0.1', 'camera-orbit': '20deg 10deg 4', 'field-of-view': '60deg' }))
      fur.setAttribute(name, value);
    Object.assign(fur.settings, { layers: 8, fins: false });
    document.body.prepend(fur);
    await fur.ready;
    const out = { first: fur.getCameraOrbit(), fov: fur.fieldOfView };
    fur.cameraOrbit = '1 0.2 3';
    out.kept = fur.getCameraOrbit();
    fur.cameraTarget = '0 0 0';
    out.moved = fur.getCameraOrbit().target;
    fur.fieldOfView = 'wide';
    fur.cameraTarget = 'there';
    out.warnings = fur.warnings.length;
    return out;
  });
  const near = (list, wanted) => list.every((value, i) => Math.abs(value - wanted[i]) < 1e-6);
  assert.ok(near(seen.first.target, [0, 0.4, 0.1]) && Math.abs(seen.first.distance - 4) < 1e-6, JSON.stringify(seen.first));
  assert.ok(near(seen.kept.target, [0, 0.4, 0.1]) && Math.abs(seen.kept.yaw - 1) < 1e-6);
  assert.deepEqual(seen.moved, [0, 0, 0]);
  assert.equal(seen.fov, '60deg');
  assert.equal(seen.warnings, 2);
});

test('a wider field of view shows the model smaller, up to 90 degrees', async () => {
  const page = await site.open(`?${light}&src=sphere&autoplay=0&backgroundTop=ff00ff&backgroundBottom=ff00ff&ground=0`);
  const wide = async (fov) => {
    await withFur(page, (fur, value) => { fur.fieldOfView = value; }, fov);
    const { data } = await picture(page);
    let covered = 0;
    for (let i = 0; i < data.length; i += 4) covered += [0, 1, 2].some((c) => Math.abs(data[i + c] - data[c]) > 12) ? 1 : 0;
    return covered;
  };
  const [usual, wider] = [await wide('auto'), await wide(70)];
  assert.ok(wider < 0.4 * usual, `${wider} of ${usual} pixels`);
  assert.equal(await wide(120), await wide(90));
});

test('what lies over the edges pushes the model aside on the screen, not in a saved picture', async () => {
  const page = await site.open(`?${light}&src=sphere&autoplay=0`);
  await withFur(page, (fur) => fur.step(0.1, 20));
  const plain = await picture(page);
  const picks = (x, y) => withFur(page, (fur, at) => fur.pick(at) !== null, { x, y });
  assert.ok(await picks(240, 60));
  await withFur(page, (fur) => { fur.setPadding({ left: 200, top: 100 }); fur.step(0.1, 20); });
  assert.equal(await picks(240, 60), false);
  assert.ok(await picks(340, 230));
  assert.ok(difference(plain, await picture(page), 16) < 0.01);
});

test('a free camera turns where it is, flies while the right button is held, and is in the state', async () => {
  const page = await site.open(`?${light}&src=plane&autoplay=0&cameraMode=free&wind=0`);
  const camera = () => withFur(page, (fur) => fur.getCameraOrbit());
  const eye = ({ yaw, pitch, distance, target: [x, y, z] }) =>
    [x + distance * Math.sin(yaw) * Math.cos(pitch), y + distance * Math.sin(pitch), z + distance * Math.cos(yaw) * Math.cos(pitch)];
  const apart = (a, b) => Math.hypot(...eye(a).map((at, i) => at - eye(b)[i]));
  await page.mouse.move(240, 180);
  await page.keyboard.press('w');
  const start = await camera();
  await page.mouse.down({ button: 'right' });
  await page.mouse.move(300, 150);
  const turned = await camera();
  assert.ok(Math.abs(turned.yaw - start.yaw) > 0.05 && apart(turned, start) < 0.01, 'from where it is');
  await page.keyboard.down('w');
  await withFur(page, (fur) => fur.step(0.1, 5));
  await page.keyboard.up('w');
  const flown = await camera();
  assert.ok(Math.abs(apart(flown, turned) - 0.6) < 0.02, `${apart(flown, turned)}`);
  await page.keyboard.down('Control');
  await withFur(page, (fur) => fur.step(0.1, 5));
  await page.keyboard.up('Control');
  assert.ok(eye(await camera())[1] < eye(flown)[1] - 0.5, 'down');
  await page.mouse.up({ button: 'right' });
  const state = await withFur(page, (fur) => JSON.parse(fur.getState()));
  assert.equal(state.settings.cameraMode, 'free');
  const back = await withFur(page, (fur, json) => { fur.resetCamera(); fur.step(0.1, 20); fur.setState(json); return fur.getCameraOrbit(); }, JSON.stringify(state));
  assert.ok(apart(back, state.camera) < 0.01, 'as it was');
});
