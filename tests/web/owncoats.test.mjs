// Coats of one's own beside the presets: kept, worn, renamed, saved as files, dropped and deleted.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { plain, startBrowser, untilStill, withFur } from './support.mjs';

const site = startBrowser();
const openPage = (options = {}, query = '') => site.open(`?${plain}&src=sphere${query}`, options);
const ownNames = (page) => page.$$eval('#coats [data-own]', (list) => list.map((one) => one.textContent));
const coatOf = (page) => withFur(page, (fur) => [fur.settings.curl, fur.settings.rootColor, fur.settings['type1.name']]);

/** Keeps the coat that is shown, in the page's dialog. */
async function keep(page, name) {
  if (await page.isHidden('#coats')) await page.click('#coat');
  await page.click('#own-coats');
  await page.fill('.own-coats form input', name);
  await page.click('.own-coats form button');
  await page.locator('.own-coats [role=status]', { hasText: name }).waitFor();
}
const close = (page) => page.click('.own-coats button:text-is("Close")');

/** Drops a file on the window as a person would. */
const drop = (page, name, bytes) => page.evaluate(([base64, file]) => {
  const transfer = new DataTransfer();
  transfer.items.add(new File([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))], file));
  document.body.dispatchEvent(new DragEvent('drop', { dataTransfer: transfer, bubbles: true, cancelable: true }));
}, [Buffer.from(bytes).toString('base64'), name]);

test('a coat that is kept stands beside the presets, is worn in one step of undo, and outlives the page', async () => {
  const page = await openPage({ keep: true });
  await withFur(page, (fur) => {
    fur.settings.curl = 0.75;
    fur.settings.rootColor = '#204060';
  });
  await keep(page, 'Blue "fox" & co');
  await close(page);
  assert.deepEqual(await ownNames(page), ['Blue "fox" & co']);
  const pressed = () => page.$$eval('#coats [aria-pressed=true]', (list) => list.map((one) => one.textContent));
  assert.deepEqual(await pressed(), ['Blue "fox" & co']);
  const image = await page.$eval('#coats [data-own] i', (one) => getComputedStyle(one).backgroundImage);
  assert.match(image, /^url\("blob:/, 'with a picture of how it looks');
  await page.click('#coats [data-coat=wool]');
  assert.notEqual((await coatOf(page))[0], 0.75);
  await page.click('#coats [data-own]');
  await page.waitForFunction(() => wetFur.settings.curl === 0.75);
  assert.deepEqual(await coatOf(page), [0.75, '#204060', 'Blue "fox" & co']);
  assert.deepEqual(await pressed(), ['Blue "fox" & co']);
  await withFur(page, (fur) => fur.undo());
  assert.equal(await withFur(page, (fur) => fur.preset), 'wool');

  await page.goto(new URL(`?${plain}&src=torus`, site.url).href);
  await page.waitForFunction(() => wetFur.loaded);
  await page.click('#coat');
  await page.waitForSelector('#coats [data-own]');
  await page.click('#coats [data-own]');
  await page.waitForFunction(() => wetFur.settings.curl === 0.75);
  assert.deepEqual(page.problems, []);
  assert.deepEqual(await page.evaluate(() => window.violations), []);
  await page.context().close();
});

test('it is renamed, saved as a file that brings it to another browser, and deleted when asked twice', async () => {
  const page = await openPage({ keep: true });
  await withFur(page, (fur) => {
    fur.settings.curl = 0.5;
    return fur.setTypePicture(1, new Blob([Uint8Array.from(atob('iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQAAAABJRU5ErkJggg=='), (c) => c.charCodeAt(0))], { type: 'image/png' }));
  });
  await keep(page, 'First');
  const field = page.locator('.own-coats li input');
  await field.fill('Snow leopard');
  await field.press('Enter');
  await page.waitForSelector('.own-coats li button[aria-label="Delete Snow leopard"]');
  const coming = page.waitForEvent('download');
  await page.click('.own-coats li button:text-is("Save file")');
  const file = await coming;
  assert.equal(file.suggestedFilename(), 'Snow-leopard.coat');
  const bytes = readFileSync(await file.path());
  assert.equal(JSON.parse(bytes).name, 'Snow leopard');
  assert.ok(JSON.parse(bytes).picture.length > 50, 'with its colour map');
  await page.click('.own-coats li button:text-is("Delete")');
  assert.deepEqual(await page.locator('.own-coats li').count(), 1);
  await page.click('.own-coats li button:text-is("For good?")');
  await page.waitForFunction(() => document.querySelectorAll('.own-coats li').length === 0);
  await close(page);
  assert.deepEqual(await ownNames(page), []);
  await page.context().close();

  const other = await openPage();
  await drop(other, 'Snow-leopard.coat', bytes);
  await other.waitForFunction(() => wetFur.settings.curl === 0.5);
  assert.equal(await withFur(other, (fur) => fur.settings['type1.name']), 'Snow leopard');
  assert.ok(await withFur(other, (fur) => fur.settings['type1.picture']));
  await untilStill(other);
  assert.deepEqual(other.problems, []);
});

test('a spoilt coat is a typed error that names it, and the coat stays', async () => {
  const page = await openPage();
  const before = await withFur(page, (fur) => fur.getState());
  for (const [text, said] of [['{"wetFurCoat":1', 'it is no JSON object'], ['{"wetFurCoat":7}', 'this program reads up to 1'], ['{"wetFurCoat":1,"picture":"AAAA"}', 'picture is no PNG, JPEG or WebP'], ['', 'type set']]) {
    await drop(page, 'fox.coat', text);
    await page.waitForSelector(`#messages .message:has-text("fox.coat"):has-text("${said}")`);
    await page.keyboard.press('Escape');
  }
  assert.equal(await withFur(page, (fur) => fur.getState()), before);
});

test('coats of types go out and in by method, also what the editor has', async () => {
  const page = await openPage();
  const seen = await withFur(page, async (fur) => {
    fur.settings['type3.preset'] = 'otter';
    fur.settings['type3.frizz'] = 0.5;
    const coat = await fur.saveCoat({ name: 'Damp otter', type: 3 });
    await fur.loadTypeSet(coat, { type: 2 });
    await fur.openEditor();
    const again = await fur.saveCoat({ type: 2 });
    await fur.closeEditor();
    return [fur.settings['type2.frizz'], fur.settings['type2.name'], new TextDecoder().decode(coat) === new TextDecoder().decode(again), fur.settings.frizz];
  });
  assert.deepEqual(seen, [0.5, 'Damp otter', true, 0]);
  assert.deepEqual(page.problems, []);
});

test('markings of the menu Groom are in the colour beside them, and Plain takes them away', async () => {
  const page = await openPage({}, '&dryRate=0');
  await page.click('#groom');
  await page.fill('#pattern-color', '#102030');
  await page.click('[data-pattern=tabby]');
  await page.waitForFunction(() => wetFur.groomed);
  assert.deepEqual(await withFur(page, (fur) => [fur.undo(), fur.groomed, fur.canUndo]), [true, false, false], 'one step');
  await withFur(page, (fur) => fur.redo());
  await page.click('[data-pattern=clearPaint]');
  await page.waitForFunction(() => !wetFur.groomed);
  await withFur(page, (fur) => fur.undo());
  assert.equal(await withFur(page, (fur) => fur.groomed), true);
  assert.deepEqual(page.problems, []);
});
