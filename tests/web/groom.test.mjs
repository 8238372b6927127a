// Comb and scissors on the page: strokes, undo, the way into the editor and back, files.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { PNG } from 'pngjs';
import { difference, light, picture, plain, spotOnModel, startBrowser, untilStill, withFur } from './support.mjs';

const site = startBrowser();

async function stroke(page, tool) {
  await withFur(page, (fur, name) => { fur.tool = name; }, tool);
  const spot = await spotOnModel(page);
  await page.mouse.move(spot.x - 30, spot.y);
  await page.mouse.down();
  await page.mouse.move(spot.x + 30, spot.y, { steps: 6 });
  await page.mouse.up();
  await untilStill(page);
}

const saved = (page) => withFur(page, async (fur) => btoa(Array.from(await fur.save(), (byte) => String.fromCharCode(byte)).join('')));

test('a stroke of the comb lays the fur, and undo raises it', async () => {
  const page = await site.open(`?${light}&dryRate=0&src=sphere`);
  await untilStill(page);
  const before = await picture(page);
  await stroke(page, 'comb');
  assert.equal(await withFur(page, (fur) => fur.groomed), true);
  assert.ok(difference(before, await picture(page), 16) > 0.01);
  assert.equal(await withFur(page, (fur) => fur.undo()), true);
  await untilStill(page);
  assert.equal(await withFur(page, (fur) => fur.groomed), false);
  assert.ok(difference(before, await picture(page), 16) < 0.001);
  assert.deepEqual(page.problems, []);
});

test('Space combs and trims the middle, for those who use no pointer', async () => {
  const page = await site.open(`?${light}&dryRate=0&src=sphere`);
  for (const tool of ['comb', 'trim']) {
    await withFur(page, (fur, name) => { fur.tool = name; fur.shadowRoot.querySelector('canvas').focus(); }, tool);
    await page.keyboard.press(' ');
    assert.equal(await withFur(page, (fur) => fur.groomed), true, tool);
    await page.keyboard.press('Control+z');
    assert.equal(await withFur(page, (fur) => fur.groomed), false, tool);
  }
});

test('the buttons Comb and Trim choose their tools, and Reset takes their work away', async () => {
  const page = await site.open(`?${plain}&dryRate=0&src=sphere`);
  for (const tool of ['comb', 'trim']) {
    await page.click(`[data-tool=${tool}]`);
    assert.equal(await withFur(page, (fur) => fur.tool), tool);
  }
  await withFur(page, (fur) => fur.groom('length', 0.5));
  assert.equal(await withFur(page, (fur) => fur.groomed), true);
  await page.click('#reset');
  await page.waitForFunction(() => !wetFur.groomed);
});

test('the editor takes the groom over and gives it back', async () => {
  const page = await site.open(`?${plain}&dryRate=0&src=sphere`, { viewport: { width: 800, height: 400 } });
  await stroke(page, 'comb');
  await stroke(page, 'trim');
  await stroke(page, 'whisker');
  const before = await saved(page);
  await page.click('#editor');
  await page.waitForFunction(() => wetFur.editorOpen);
  assert.equal(await saved(page), before);
  await page.click('#editor');
  await page.waitForFunction(() => !wetFur.editorOpen);
  assert.equal(await saved(page), before);
  assert.deepEqual(page.problems, []);
});

test('a whisker is planted where it is pressed, and plucked there', async () => {
  const page = await site.open(`?${light}&dryRate=0&src=sphere&whiskerWidth=0.02&whiskerLength=1&whiskerHairs=8&whiskerColor=000000`);
  await untilStill(page);
  const before = await picture(page);
  await stroke(page, 'whisker');
  assert.equal(await withFur(page, (fur) => fur.groomed), true);
  assert.ok(difference(before, await picture(page), 24) > 0.0005);
  await stroke(page, 'pluck');
  assert.equal(await withFur(page, (fur) => fur.groomed), false);
  assert.ok(difference(before, await picture(page), 16) < 0.001);
  // Two steps: the plucking, then the planting.
  assert.equal(await withFur(page, (fur) => fur.undo()), true);
  assert.equal(await withFur(page, (fur) => fur.groomed), true);
  assert.equal(await withFur(page, (fur) => fur.undo()), true);
  assert.equal(await withFur(page, (fur) => fur.groomed), false);
  assert.deepEqual(page.problems, []);
});

test('a saved scene opens with its groom and its settings', async () => {
  const page = await site.open(`?${light}&dryRate=0&src=torus&tipColor=336699`);
  await stroke(page, 'trim');
  await withFur(page, (fur) => fur.groom('comb'));
  await untilStill(page);
  const shown = await picture(page);
  await withFur(page, async (fur) => {
    const scene = await fur.save();
    fur.src = 'sphere';
    await new Promise((resolve) => fur.addEventListener('load', resolve, { once: true }));
    fur.settings.tipColor = '#000000';
    await fur.loadModel(scene, { name: 'scene.glb' });
  });
  await untilStill(page);
  assert.equal(await withFur(page, (fur) => fur.settings.tipColor), '#336699');
  assert.equal(await withFur(page, (fur) => fur.groomed), true);
  assert.ok(difference(shown, await picture(page), 24) < 0.01);
});

/** Drops a file on the page. */
const drop = (page, name, bytes) => page.evaluate(([base64, file]) => {
  const transfer = new DataTransfer();
  transfer.items.add(new File([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], file, { type: 'image/png' }));
  document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: transfer, bubbles: true, cancelable: true }));
}, [bytes.toString('base64'), name]);
const question = () => [...document.body.children].map((element) => element.shadowRoot?.querySelector('dialog[open]')).find(Boolean);

test('a picture that is dropped on any model asks what it is, and keys answer', async () => {
  const page = await site.open(`?${light}&dryRate=0&src=sphere`);
  await untilStill(page);
  const image = new PNG({ width: 4, height: 4 });
  image.data.forEach((_, at) => { image.data[at] = at % 4 === 3 || at < 32 ? 255 : 0; });
  const bytes = PNG.sync.write(image);
  await drop(page, 'lengths.png', bytes);
  await page.waitForFunction(question);
  assert.equal(await page.evaluate(`(${question})().querySelectorAll('button').length`), 9);
  await page.keyboard.press('Escape');
  await page.waitForFunction(`!(${question})()`);
  assert.equal(await withFur(page, (fur) => fur.groomed), false, 'Escape means no use');
  await drop(page, 'lengths.png', bytes);
  await page.waitForFunction(question);
  for (const key of ['ArrowDown', 'ArrowDown', 'ArrowDown', 'Enter']) await page.keyboard.press(key);  // length
  await page.waitForFunction(() => wetFur.groomed);
  assert.equal(await withFur(page, (fur) => fur.undo()), true);
  assert.equal(await withFur(page, (fur) => fur.groomed), false);
});

test('what a dropped picture cannot do is told, and one that cannot be read is not asked about', async () => {
  const page = await site.open(`?${light}&src=sphere`), told = page.locator('#messages .message p');
  const opaque = new PNG({ width: 4, height: 4 });
  opaque.data.fill(255);
  await drop(page, 'opaque.png', PNG.sync.write(opaque));
  await page.waitForFunction(question);
  await page.evaluate(`(${question})().querySelector('button[value=alpha]').click()`);
  await told.filter({ hasText: 'opaque.png: the picture is opaque all over' }).waitFor();
  await drop(page, 'broken.png', Buffer.from('not a picture'));
  await told.filter({ hasText: 'broken.png: ' }).waitFor();
  assert.equal(await page.evaluate(`Boolean((${question})())`), false);
});

test('pictures that are no pictures, and uses that are none, are typed errors and change nothing', async () => {
  const page = await site.open(`?${light}&src=sphere`);
  const refused = await withFur(page, async (fur) => {
    const code = (promise) => promise.then(() => null, (error) => error.code);
    const pixel = await (await fetch('icon.svg')).blob();
    return [await code(fur.loadLengthMap(new Uint8Array([1, 2, 3]))), await code(fur.loadPicture(new Uint8Array([1, 2, 3]), { as: 'color' })), await code(fur.loadPicture(pixel, { as: 'taste' }))];
  });
  assert.deepEqual(refused.slice(0, 2), ['bad-file', 'bad-file']);
  assert.ok(refused[2]);
  assert.equal(await withFur(page, (fur) => fur.groomed), false);
});

test('hostile pictures are typed errors that name the file, and what it was dropped on stays', async () => {
  const page = await site.open(`?${light}&src=sphere`);
  const whole = PNG.sync.write(new PNG({ width: 16, height: 16 }));
  const sized = (width, height) => {
    const bytes = Buffer.from(whole);
    bytes.writeUInt32BE(width, 16);
    bytes.writeUInt32BE(height, 20);
    return bytes;
  };
  const hostile = [
    ['nothing.png', Buffer.alloc(0), 'bad-file'], ['magic.png', Buffer.from('GIF89a, as it says'), 'bad-file'], ['cut.png', whole.subarray(0, 40), 'bad-file'],
    ['cut.jpg', Buffer.from([0xff, 0xd8, 0xff, 0xe0, 0, 16]), 'bad-file'], ['flat.png', sized(0, 4), 'bad-file'], ['huge.png', sized(100000, 100000), 'too-large'], ['long.png', sized(1, 8193), 'too-large'],
  ].map(([name, bytes, code]) => [name, bytes.toString('base64'), code]);
  const seen = await withFur(page, async (fur, files) => {
    const before = fur.getState(), wrong = [];
    for (const [name, base64, code] of files)
      for (const as of ['color', 'typeColor', 'skin', 'length', 'direction']) {
        const file = new File([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], name, { type: 'image/png' });
        const error = await fur.loadPicture(file, { as }).then(() => null, (one) => one);
        if (error?.code !== code || !error.message.includes(name) || (code === 'too-large' && !error.message.includes('8192'))) wrong.push([name, as, error?.code, error?.message]);
      }
    return { wrong, same: fur.getState() === before, groomed: fur.groomed, undo: fur.canUndo };
  }, hostile);
  assert.deepEqual(seen, { wrong: [], same: true, groomed: false, undo: false });
});

test('a dropped picture becomes the skin, in one step of undo, and is in the saved file', async () => {
  const page = await site.open(`?${light}&src=sphere&density=0.1`);
  await untilStill(page);
  const before = await picture(page);
  const image = new PNG({ width: 2, height: 2 });
  image.data.forEach((_, at) => { image.data[at] = [0, 255, 0, 255][at % 4]; });
  await drop(page, 'skin.png', PNG.sync.write(image));
  await page.waitForFunction(question);
  for (const key of ['ArrowDown', 'ArrowDown', 'Enter']) await page.keyboard.press(key);
  await page.waitForFunction(() => wetFur.settings['skin.picture']);
  await untilStill(page);
  const green = await picture(page);
  assert.ok(difference(before, green, 16) > 0.05);
  const views = await withFur(page, async (fur) => {
    const file = await fur.save();
    const length = new DataView(file.buffer, file.byteOffset).getUint32(12, true);
    const { skinPicture } = JSON.parse(new TextDecoder().decode(file.subarray(20, 20 + length))).extensions.WETFUR_fur;
    fur.undo();
    return skinPicture;
  });
  assert.equal(views.mimeType, 'image/png');
  await untilStill(page);
  assert.ok(difference(before, await picture(page), 2) < 0.001, 'undo takes it away');
});

test('a map that was saved is dropped back as what it was, by its name', async () => {
  const page = await site.open(`?${light}&src=sphere`);
  await untilStill(page);
  const before = await picture(page);
  // A paint map, all of it blue.
  const image = new PNG({ width: 4, height: 4 });
  image.data.forEach((_, at) => { image.data[at] = at % 4 >= 2 ? 255 : 0; });
  await page.evaluate((base64) => {
    const transfer = new DataTransfer();
    const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    transfer.items.add(new File([bytes], 'sphere-map-paint.png', { type: 'image/png' }));
    document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: transfer, bubbles: true, cancelable: true }));
  }, PNG.sync.write(image).toString('base64'));
  await page.waitForFunction(() => wetFur.groomed);
  await untilStill(page);
  const after = await picture(page);
  const at = 4 * (Math.floor(after.height / 2) * after.width + Math.floor(after.width / 2));
  assert.ok(after.data[at + 2] > after.data[at] + 40, 'it is blue');
  assert.ok(difference(before, after, 16) > 0.02);
});

test('paint of the editor shows, stays when the editor is closed, and is in the saved file', async () => {
  const page = await site.open(`?${plain}&dryRate=0&src=sphere&paintColor=0040ff&groomStrength=1&brushRadius=0.3`, { viewport: { width: 800, height: 400 } });
  await page.click('#editor');
  await page.waitForFunction(() => wetFur.editorOpen);
  await stroke(page, 'paint');
  assert.equal(await withFur(page, (fur) => fur.groomed), true);
  await page.click('#editor');
  await page.waitForFunction(() => !wetFur.editorOpen);
  await withFur(page, (fur) => { fur.tool = 'none'; });
  await untilStill(page);
  const painted = await picture(page);
  const json = await withFur(page, async (fur) => {
    const file = await fur.save();
    const length = new DataView(file.buffer, file.byteOffset).getUint32(12, true);
    return JSON.parse(new TextDecoder().decode(file.subarray(20, 20 + length)));
  });
  assert.ok(json.extensions.WETFUR_fur.groom.paint > 0);
  assert.equal(json.meshes[0].primitives[0].material, 1, 'other programs show what is painted');
  assert.equal(json.images[0].mimeType, 'image/png');
  await withFur(page, (fur) => fur.groom('clearPaint'));
  await untilStill(page);
  assert.ok(difference(painted, await picture(page), 16) > 0.01);
  assert.equal(await withFur(page, (fur) => fur.groomed), false);
  assert.deepEqual(page.problems, []);
});

test('a link takes the groom along; where it does not fit it says so and offers the file', async () => {
  const page = await site.open(`?${plain}&src=sphere`, { permissions: ['clipboard-read', 'clipboard-write'] });
  const copy = async () => {
    await page.evaluate(() => document.querySelector('#messages').replaceChildren());
    await page.click('#share');
    await page.click('#link');
    const said = await (await page.waitForSelector('#messages .message p')).textContent();
    return [said, new URL(await page.evaluate(() => navigator.clipboard.readText())).search];
  };
  await withFur(page, (fur) => fur.groom('length', 0.5));
  const [said, link] = await copy();
  assert.equal(said, 'Link copied');
  const groomOf = (fur) => [...fur.fur.document.groom];
  const second = await site.open(link);
  await second.waitForFunction(() => wetFur.groomed);  // it unfolds while the sphere is shown
  assert.deepEqual(await withFur(second, groomOf), await withFur(page, groomOf));
  assert.equal(await withFur(second, (fur) => fur.canUndo), false);
  await second.close();
  await withFur(page, (fur) => {
    const { groom } = fur.fur.document;
    let seed = 1;
    for (let i = 16; i < 16 + 40000; i++) groom[i] = (seed = (seed * 1664525 + 1013904223) % 2 ** 32) >>> 24;
    fur.fur.takeParts({ groom });
  });
  assert.equal((await copy())[0], 'Link copied, without the groom');
});

test('hair, water and strokes of a link that unfold to too much are told by name, and the rest of it is shown', async () => {
  const { deflated, mostUnpacked } = await import('../../web/packed.js');
  const bomb = await deflated(new Uint8Array(mostUnpacked + 1));
  for (const [part, what] of [['hair', 'long hair'], ['water', 'water'], ['strokes', 'water']]) {
    const page = await site.open(`?${plain}&src=plane&curl=0.5&${part}=${bomb}`);
    await page.waitForSelector(`#messages .message:has-text("link's ${what} could not be read")`);
    assert.deepEqual(await withFur(page, (fur) => [fur.haired, fur.meanWetness, fur.settings.curl]), [false, 0, 0.5]);
    await page.close();
  }
});

test('a groom in a link that is none, or unfolds to too much, is told, and the rest of it is shown', async () => {
  const { deflated, mostUnpacked } = await import('../../web/packed.js');
  const bomb = await deflated(new Uint8Array(mostUnpacked + 1));
  assert.ok(bomb.length < 8192);
  for (const groom of ['AAAA', bomb, await deflated(new Uint8Array(64))]) {
    const page = await site.open(`?${plain}&src=plane&groom=${groom}`);
    await page.waitForSelector('#messages .message:has-text("groom could not be read")');
    assert.equal(await withFur(page, (fur) => fur.groomed), false);
    await page.close();
  }
});
