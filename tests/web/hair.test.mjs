// Long hair on the page: who fetches its program, what edits and values do, and that nothing of it is lost on the way.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { difference, light, picture, startBrowser, untilStill, withFur } from './support.mjs';

const site = startBrowser({ reducedMotion: 'reduce' });
const query = `?${light}&src=sphere&furLength=0.02`;

/** Opens the page and notes which programs it fetches. */
async function open(address = query) {
  const requested = [];
  const page = await site.open(address, { prepare: (tab) => tab.on('request', (request) => requested.push(request.url())) });
  const fetched = (name) => requested.some((url) => url.endsWith(`${name}.wasm`));
  return { page, fetched };
}

/** A head of hair by the element's own methods. */
const grow = (page) => withFur(page, async (fur) => {
  await fur.hair('addScalp');
  await fur.hair('cover', 1);
  fur.setHairValue(0, 'guideLength', 0.5);
  await fur.hair('plant', 40);
});
/** The bytes that a method of the element gives, as base64: thousands of numbers take long to come over. */
const given = (page, method) => withFur(page, async (fur, name) => {
  const bytes = await fur[name]();
  let text = '';
  for (let at = 0; at < bytes.length; at += 4096) text += String.fromCharCode(...bytes.subarray(at, at + 4096));
  return btoa(text);
}, method);
const takes = (page, method, base64, name) => withFur(page, (fur, file) => (
  fur[file.method](new File([Uint8Array.from(atob(file.base64), (c) => c.charCodeAt(0))], file.name))), { method, base64, name });
const scalps = (page) => withFur(page, (fur) => fur.scalps);

test('a model without hair fetches nothing of it; the first scalp does, and is seen', async () => {
  const { page, fetched } = await open();
  const bare = await picture(page);
  assert.deepEqual(await scalps(page), []);
  assert.ok(!fetched('wet-fur-hair'));
  await grow(page);
  await untilStill(page);
  assert.ok(fetched('wet-fur-hair'));
  const [scalp] = await scalps(page);
  assert.equal(scalp.guides, 40);
  assert.equal(scalp.wisps, 300);
  assert.equal(scalp.values.guideLength, 0.5);
  assert.ok(difference(await picture(page), bare, 8) > 0.1);
  assert.deepEqual(page.problems, []);
});

test('what is not glTF is read by the larger program, which is fetched for it', async () => {
  const { page, fetched } = await open();
  assert.ok(!fetched('wet-fur-hair'));
  await takes(page, 'loadModel', Buffer.from('v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n').toString('base64'), 'corner.obj');
  assert.ok(fetched('wet-fur-hair'));
  assert.deepEqual(await withFur(page, (fur) => [fur.modelName, fur.stats.triangles]), ['corner.obj', 4]);
  assert.deepEqual(page.problems, []);
});

test('each edit and each value is one step of undo, back to the bare model', async () => {
  const { page } = await open();
  await grow(page);
  const undone = [];
  for (let i = 0; i < 4; ++i) {
    await withFur(page, (fur) => fur.undo());
    undone.push((await scalps(page)).map(({ guides, values }) => [guides, values.guideLength]));
  }
  // Planting, the value, what the scalp covers, the scalp.
  assert.deepEqual(undone, [[[0, 0.5]], [[0, 0.6]], [[0, 0.6]], []]);
  for (let i = 0; i < 4; ++i) await withFur(page, (fur) => fur.redo());
  assert.equal((await scalps(page))[0].guides, 40);
});

test('a saved scene brings its hair to a page that has the viewer alone', async () => {
  const first = await open();
  await grow(first.page);
  await withFur(first.page, (fur) => fur.setHairValue(0, 'name', 'mane'));
  const bytes = await given(first.page, 'save');
  const { page, fetched } = await open();
  assert.ok(!fetched('wet-fur-hair'));
  await takes(page, 'loadModel', bytes, 'mane.glb');
  assert.ok(fetched('wet-fur-hair'));
  const [scalp] = await scalps(page);
  assert.deepEqual([scalp.name, scalp.guides, scalp.values.guideLength], ['mane', 40, 0.5]);
  assert.equal(await withFur(page, (fur) => fur.state), 'ready');
  // Undo leads back to the model before, which has none.
  await withFur(page, (fur) => fur.undo());
  assert.deepEqual(await scalps(page), []);
  assert.deepEqual(page.problems, []);
});

test('hair goes over to the editor and back', async () => {
  const { page, fetched } = await open(query.replace('&ui=0', ''));
  await grow(page);
  const before = await scalps(page);
  await withFur(page, (fur) => fur.openEditor());
  assert.ok(fetched('wet-fur-editor'));
  assert.deepEqual(await scalps(page), before);
  await withFur(page, (fur) => fur.closeEditor());
  assert.deepEqual(await scalps(page), before);
});

test('strands go into a .hair file, and come from one', async () => {
  const first = await open();
  await grow(first.page);
  const bytes = await given(first.page, 'saveHair');
  assert.equal(atob(bytes.slice(0, 8)).slice(0, 4), 'HAIR');
  const { page } = await open();
  await takes(page, 'loadHair', bytes, 'locks.hair');
  const [scalp] = await scalps(page);
  assert.deepEqual([scalp.name, scalp.guides], ['locks', 128]);
  const failure = await withFur(page, (fur) => fur.loadHair(new File([new Uint8Array(40)], 'zeros.hair')).catch(({ code, message }) => ({ code, message })));
  assert.equal(failure.code, 'bad-file');
  assert.match(failure.message, /zeros\.hair/);
  assert.equal((await scalps(page)).length, 1);
});

test('what cannot be done is told and changes nothing', async () => {
  const { page } = await open();
  await withFur(page, (fur) => {
    window.told = [];
    fur.addEventListener('warning', ({ detail }) => window.told.push(detail.message));
  });
  await withFur(page, (fur) => fur.hair('plant', 20));
  assert.match((await page.evaluate(() => window.told)).join(), /no scalp yet/);
  assert.deepEqual(await scalps(page), []);
  await withFur(page, (fur) => fur.hair('addScalp'));
  const failure = await withFur(page, (fur) => {
    try {
      fur.setHairValue(0, 'nonsense', 1);
    } catch ({ code, message }) {
      return { code, message };
    }
  });
  assert.deepEqual([failure?.code, /nonsense/.test(failure?.message)], ['bad-file', true]);
  const refused = await withFur(page, (fur) => Promise.all([fur.hair('plantt', 60), fur.hair('plant', NaN), fur.groom('comb-it')].map((edit) => edit.then(() => null, ({ code }) => code))));
  assert.deepEqual(refused, ['bad-file', 'bad-file', 'bad-file']);
});
