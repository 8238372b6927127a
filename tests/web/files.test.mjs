// Files that people bring, good and bad: a typed error, and the old scene as it was.
import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { badModels, furnished, hugeImage, incomplete, tetrahedron } from './glb.mjs';
import { difference, light, picture, sleep, startBrowser, untilShown, untilStill, withFur } from './support.mjs';

const site = startBrowser();
let page;
before(async () => {
  page = await site.open(`?${light}&dryRate=0`, { keep: true });
  await withFur(page, (fur) => {
    fur.splash({ u: 0.5, v: 0.5 });
    fur.step(1 / 60, 1800);  // until it has come to rest
  });
});
after(() => page?.context().close());

const scene = () => withFur(page, (fur) => ({
  hash: fur.wetnessHash, state: fur.getState(), triangles: fur.stats.triangles, name: fur.modelName, life: fur.state,
}));

/** Hands a file to loadModel(); gives the error's { code, message }, or null. */
const load = (name, bytes) => withFur(page, async (fur, given) => {
  const file = new File([Uint8Array.from(atob(given.base64), (c) => c.charCodeAt(0))], given.name);
  return fur.loadModel(file).then(() => null, ({ code, message }) => ({ code, message }));
}, { name, base64: bytes.toString('base64') });

/** Drops files on the window as a person would. */
const drop = (files) => page.evaluate((list) => {
  const transfer = new DataTransfer();
  for (const { name, base64 } of list)
    transfer.items.add(new File([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], name));
  document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: transfer, bubbles: true, cancelable: true }));
}, files.map(([name, bytes]) => ({ name, base64: Buffer.from(bytes).toString('base64') })));

for (const [what, bytes] of Object.entries({ ...badModels, 'an image of 20,000 pixels': hugeImage })) {
  test(`${what} is a typed error, and the old scene stays`, async () => {
    const before = await scene();
    const error = await load('spoilt.glb', bytes);
    assert.ok(error, 'an error');
    assert.match(error.code, /^(bad-file|too-large)$/);
    assert.match(error.message, /spoilt\.glb/);
    assert.deepEqual(await scene(), before);
    const shown = page.locator('#messages .message', { hasText: error.message }).first();
    assert.equal(await shown.getAttribute('role'), 'alert');
    await shown.getByRole('button', { name: 'Dismiss' }).click();
  });
}

test('a dropped file that is no model is refused by name', async () => {
  const before = await scene();
  await drop([['holiday.txt', 'hello']]);
  await page.waitForSelector('#messages .message:has-text("holiday.txt")');
  await page.keyboard.press('Escape');
  assert.equal(await page.locator('#messages .message').count(), 0);
  assert.deepEqual(await scene(), before);
});

test('a .gltf dropped together with its buffer is shown; alone, its buffer is missed by name', async () => {
  const { json, binary } = tetrahedron({ uri: 'parts/four%20corners.bin' });
  const text = Buffer.from(JSON.stringify(json));
  await drop([['four.gltf', text]]);
  await page.waitForSelector('#messages .message:has-text("four.gltf")');
  await page.keyboard.press('Escape');
  await drop([['four.gltf', text], ['four corners.bin', binary]]);
  await untilShown(page, 'four.gltf');
  assert.equal(await withFur(page, (fur) => fur.stats.triangles), 4);
  assert.equal(await page.$eval('#model', (select) => select.selectedOptions[0].textContent), 'four.gltf');
  assert.equal(await withFur(page, (fur) => fur.meanWetness), 0);  // another model, and a dry one
});

test('a good .glb is shown, and a picture that cannot be decoded is only a warning', async () => {
  const brokenImage = tetrahedron({
    change: (json) => {
      json.images = [{ uri: 'data:image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAQAAAAECAYAAACp8Z5+' }];
      json.textures = [{ source: 0 }];
      json.materials = [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }];
      json.meshes[0].primitives[0].material = 0;
    },
  });
  const error = await load('painted.glb', brokenImage.glb());
  assert.equal(error, null);
  assert.ok(await withFur(page, (fur) => fur.warnings.some((text) => text.includes('picture'))));
});

const pyramid = 'v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nv 0 1.5 0\nf 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n';

test('an .obj from the file dialog is shown', async () => {
  await page.setInputFiles('#file', { name: 'pyramid.obj', mimeType: 'text/plain', buffer: Buffer.from(pyramid) });
  await untilShown(page, 'pyramid.obj');
  assert.equal(await withFur(page, (fur) => fur.stats.triangles), 6);
  assert.equal(await page.$eval('#model', (select) => select.selectedOptions[0].textContent), 'pyramid.obj');
});

test('a spoilt .obj is refused by name, line and reason, and the old scene stays', async () => {
  const before = await scene();
  const error = await load('fox.obj', Buffer.from(`${pyramid}f 1 2 6\n`));
  assert.deepEqual(error, {
    code: 'bad-file', message: 'fox.obj, line 11: a face refers to vertex 6, but only 5 are defined so far',
  });
  assert.deepEqual(await scene(), before);
  await page.keyboard.press('Escape');
});

test('save() says what it leaves out, and can be asked before', async () => {
  assert.equal(await load('incomplete.gltf', incomplete), null);
  const seen = await withFur(page, async (fur) => {
    const told = [], before = fur.warnings.length;
    fur.addEventListener('warning', ({ detail }) => told.push(detail.message));
    const lost = await fur.lostBySaving();
    const asking = [...told];
    const bytes = await fur.save();
    const saved = fur.warnings.slice(before);
    await fur.loadModel(bytes, { name: 'saved.glb' });
    return { lost, asking, told, saved, again: await fur.lostBySaving() };
  });
  assert.deepEqual(seen.lost, ['the image file "gone.png", which stays beside it']);
  assert.deepEqual(seen.asking, []);
  assert.deepEqual(seen.told, seen.lost.map((what) => `save() leaves out ${what}`));
  assert.deepEqual(seen.saved, seen.told);
  assert.deepEqual(seen.again, seen.lost);
});

test('a document is saved whole, and opens as it was', async () => {
  assert.equal(await load('furnished.glb', furnished), null);
  const [bytes, same] = await withFur(page, async (fur) => {
    fur.setWetness(0.5);
    fur.step(1 / 60, 5);
    await fur.groom('length', 0.7);
    const now = () => JSON.stringify([[...fur.fur.document.groom].slice(0, 5000), fur.wetnessHash, fur.getState()]);
    const before = now(), saved = await fur.save();
    await fur.loadModel(saved, { name: 'furnished.glb' });
    return [[...saved], now() === before];
  });
  assert.ok(same);
  const before = JSON.parse(furnished.subarray(20, 20 + furnished.readUInt32LE(12))), file = Buffer.from(bytes);
  const { extensions, extensionsUsed, ...after } = JSON.parse(file.subarray(20, 20 + file.readUInt32LE(12)));
  assert.equal(extensions.WETFUR_fur.version, 2);
  assert.deepEqual(extensions.KHR_lights_punctual, before.extensions.KHR_lights_punctual);
  for (const key of Object.keys(after)) if (!/^buffer/.test(key)) assert.deepEqual(after[key], before[key], key);
});

test('a scene that is saved while it is wet is wet when it opens', async () => {
  const [before, after] = await withFur(page, async (fur) => {
    fur.setWetness(0.5);
    const wet = fur.meanWetness;
    await fur.loadModel(await fur.save(), { name: 'wet.glb' });
    return [wet, fur.meanWetness];
  });
  assert.ok(before > 0.1);
  assert.ok(Math.abs(after - before) < 0.02, `${after} of ${before}`);
});

test('a saved .fo opens again with the same triangles', async () => {
  const [before, after] = await withFur(page, async (fur) => {
    const triangles = fur.stats.triangles;
    await fur.loadModel(await fur.saveFo(), { name: 'again.fo' });
    return [triangles, fur.stats.triangles];
  });
  assert.equal(after, before);
  assert.equal(await withFur(page, (fur) => fur.modelName), 'again.fo');
});

/** Waits until the coat that would be saved is `wanted` (or no more), a property of the page's window. */
const untilCoat = (same) => page.waitForFunction(async (expected) => {
  const now = await wetFur.saveTypeSet();
  return window.wanted.every((byte, i) => byte === now[i]) === expected;
}, same, { polling: 200 });

test('a dropped .fts is the coat until a setting that grows another changes', async () => {
  const coat = await withFur(page, async (fur) => {
    fur.settings.density = 0.2;
    window.wanted = await fur.saveTypeSet();
    fur.settings.density = 0.9;
    fur.step(1 / 60);
    let text = '';
    for (const byte of window.wanted) text += String.fromCharCode(byte);
    return btoa(text);
  });
  // Until it has grown the picture keeps the coat before it.
  await page.waitForFunction(() => wetFur.stats.strands > 600);
  await untilStill(page);
  const dense = await picture(page), again = await picture(page);
  await drop([['curls.fts', Buffer.from(coat, 'base64')]]);
  await untilCoat(true);
  // The picture keeps the dense coat until the other has grown.
  await page.waitForFunction(() => wetFur.stats.strands < 600);
  await untilStill(page);
  const apart = difference(dense, await picture(page), 10);
  assert.ok(apart > 100 * difference(dense, again, 10) && apart > 0.01, `${apart}`);
  await withFur(page, (fur) => { fur.settings.wind = 0; fur.settings.density = 0.5; });
  await untilCoat(false);
});

test('a type set moves over to the editor and back', async () => {
  await withFur(page, async (fur) => {
    await fur.loadTypeSet(window.wanted);
    await fur.openEditor();
  });
  await untilCoat(true);
  await withFur(page, (fur) => fur.closeEditor());
  await untilCoat(true);
});

test('a spoilt .fts is a typed error, and coat and scene stay', async () => {
  const before = await scene();
  await drop([['fox.fts', 'no fur']]);
  await page.waitForSelector('#messages .message:has-text("fox.fts: a type set has 3194888 bytes; this file has 6")');
  await page.keyboard.press('Escape');
  await untilCoat(true);
  assert.deepEqual(await scene(), before);
});

test('wrong states, settings and options warn or throw, and nothing breaks', async () => {
  const seen = await withFur(page, (fur) => {
    const codes = ['{', '[]', '{"version":999}'].map((text) => {
      try { fur.setState(text); return null; } catch (error) { return error.code; }
    });
    fur.settings.layers = 1e9;
    fur.settings.wind = NaN;
    fur.tool = 'hammer';
    fur.cameraOrbit = 'left a bit';
    return { codes, layers: fur.settings.layers, wind: fur.wind, tool: fur.tool };
  });
  assert.deepEqual(seen.codes, ['bad-file', 'bad-file', 'unsupported-version']);
  assert.deepEqual([seen.layers, seen.wind, seen.tool], [128, 0, 'droplet']);
  assert.deepEqual(page.problems, []);
});
