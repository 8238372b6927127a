// What goes wrong around the page: no WebGL2, WebAssembly blocked, files that do not come, a lost context.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { difference, light, picture, recordContexts, startBrowser, untilStill, withFur } from './support.mjs';

const site = startBrowser();

const visibleMessage = async (page) => {
  const box = page.locator('wet-fur .message');
  await box.waitFor({ state: 'visible' });
  return box.innerText();
};

test('without WebGL2 the page says so', async () => {
  const page = await site.open('?ui=0', {
    wait: false,
    scripts: [() => {
      const original = OffscreenCanvas.prototype.getContext;
      OffscreenCanvas.prototype.getContext = function getContext(type, ...rest) {
        return type === 'webgl2' ? null : original.call(this, type, ...rest);
      };
    }],
  });
  assert.match(await visibleMessage(page), /WebGL2/);
  assert.equal(await withFur(page, (fur) => fur.state), 'unsupported');
  assert.equal(await withFur(page, (fur) => fur.ready.catch((error) => error.code)), 'webgl-unavailable');
});

test('where the policy blocks WebAssembly the page says so', async () => {
  const page = await site.open('', {
    wait: false,
    prepare: (tab) => tab.route('**/*', async (route) => {
      const response = await route.fetch();
      const headers = { ...response.headers(), 'content-security-policy': "script-src 'self'" };
      await route.fulfill({ response, headers });
    }),
  });
  assert.match(await visibleMessage(page), /WebAssembly/);
  assert.equal(await withFur(page, (fur) => fur.ready.catch((error) => error.code)), 'wasm-blocked');
});

test('without WebAssembly the page says so', async () => {
  const page = await site.open('', { wait: false, scripts: [() => { delete globalThis.WebAssembly; }] });
  assert.match(await visibleMessage(page), /WebAssembly/);
});

for (const [what, pattern, code] of [['the program', '**/wet-fur.wasm', 'wasm-load'], ['its script', '**/wet-fur.mjs*', 'wasm-load'], ['the model', '**/bunny.glb', 'network']]) {
  test(`when ${what} does not come the page says so, and tries again`, async () => {
    const page = await site.open(`?${light}`, { wait: false, prepare: (tab) => tab.route(pattern, (route) => route.abort()) });
    const text = await visibleMessage(page);
    assert.match(text, /wet-fur\.(wasm|mjs)|bunny\.glb/);
    assert.equal(await withFur(page, (fur) => fur.ready.catch((error) => error.code)), code);
    await page.unroute(pattern);
    await page.locator('wet-fur .message button').click();
    await page.waitForFunction(() => wetFur.loaded);
    assert.equal(await page.locator('wet-fur .message').isVisible(), false);
  });
}

test('a src that is not there is a network error that says what would be, and leaves the old scene', async () => {
  const page = await site.open(`?${light}&src=torus`, {
    prepare: (tab) => tab.route('**/away/needs.gltf', (route) => route.fulfill({ body: '{"asset":{"version":"2.0"},"buffers":[{"uri":"gone.bin","byteLength":4}]}' })),
  });
  for (const [src, message] of [
    ['models/away.glb', /^away\.glb: the server has no such file \(404\)$/],
    ['nosuchscene', /^nosuchscene: .*\(404\); models that go by a name are otter, .*bunny, .*five-coats/],
    ['away/needs.gltf', /^gone\.bin: .*\(404\); needs\.gltf needs it$/],
  ]) {
    const error = await withFur(page, (fur, wanted) => new Promise((resolve) => {
      fur.addEventListener('error', (event) => resolve(event.detail), { once: true });
      fur.src = wanted;
    }), src);
    assert.equal(error.code, 'network');
    assert.match(error.message, message);
  }
  assert.equal(await withFur(page, (fur) => fur.modelName), 'torus');
  assert.equal(await withFur(page, (fur) => fur.state), 'ready');
});

test('progress counts the bytes and only ever rises', async () => {
  const page = await site.open(`?${light}`, {
    scripts: [() => {
      window.seen = [];
      addEventListener('progress', (event) => { if (event.detail) window.seen.push(event.detail); }, true);
    }],
  });
  const seen = await page.evaluate(() => window.seen);
  const program = seen.filter((one) => one.stage === 'program');
  assert.ok(program.length > 0 && program.at(-1).loaded === program.at(-1).total && program.at(-1).total > 1e5);
  for (let i = 1; i < seen.length; i++) assert.ok(seen[i].fraction >= seen[i - 1].fraction);
  assert.equal(seen.at(-1).fraction, 1);
});

test('a lost context comes back with water, settings and camera as they were', async () => {
  const page = await site.open(`?${light}&dryRate=0&furLength=0.2`, { scripts: [recordContexts] });
  await withFur(page, (fur) => { fur.splash({ x: 240, y: 200 }); fur.cameraOrbit = '1 0.3 3'; });
  await untilStill(page);
  const before = await picture(page);
  const state = await withFur(page, (fur) => [fur.wetnessHash, fur.getState()]);
  const told = await withFur(page, (fur) => new Promise((resolve) => {
    const states = [];
    fur.addEventListener('context-lost', () => states.push(fur.state));
    fur.addEventListener('context-restored', () => resolve([...states, fur.state]));
    newestContext().getExtension('WEBGL_lose_context').loseContext();
  }));
  assert.deepEqual(told, ['lost', 'ready']);
  await untilStill(page);
  assert.deepEqual(await withFur(page, (fur) => [fur.wetnessHash, fur.getState()]), state);
  // The fur's bend settles anew; a few strands may end a pixel further.
  assert.ok(difference(before, await picture(page), 16) < 0.02);
  assert.deepEqual(page.problems, []);
});

test('while the browser has no context to give the page says so, and it comes back by itself', async () => {
  const page = await site.open(`?${light}`, { scripts: [recordContexts] });
  await withFur(page, (fur) => {
    fur.setWetness(0.4);
    const original = OffscreenCanvas.prototype.getContext;
    OffscreenCanvas.prototype.getContext = function getContext(type, ...rest) {
      return type === 'webgl2' && window.refuses ? null : original.call(this, type, ...rest);
    };
    window.refuses = true;
    newestContext().getExtension('WEBGL_lose_context').loseContext();
  });
  assert.match(await visibleMessage(page), /back in a moment/);
  const during = await withFur(page, async (fur) => {
    fur.step(1 / 60);
    return { state: fur.state, wet: fur.meanWetness > 0.2, refused: await fur.toBlob().catch((error) => error.code) };
  });
  assert.deepEqual(during, { state: 'lost', wet: true, refused: 'webgl-unavailable' });
  await withFur(page, () => { window.refuses = false; });
  await page.waitForFunction(() => document.querySelector('wet-fur').state === 'ready');
  assert.equal(await page.locator('wet-fur .message').isVisible(), false);
  assert.deepEqual(page.problems, []);
});

test('a type set is still the coat after its context was lost', async () => {
  const page = await site.open(`?${light}&src=torus`, { scripts: [recordContexts] });
  const seen = await withFur(page, async (fur) => {
    const given = await fur.saveTypeSet();
    await fur.loadTypeSet(given);
    fur.settings.seed = 7;
    const grown = await fur.saveTypeSet();
    await fur.loadTypeSet(given);
    const back = new Promise((resolve) => fur.addEventListener('context-restored', resolve, { once: true }));
    newestContext().getExtension('WEBGL_lose_context').loseContext();
    await back;
    fur.step(1 / 60);
    const after = await fur.saveTypeSet();
    const same = (a, b) => a.length === b.length && a.every((byte, i) => byte === b[i]);
    return { differed: !same(given, grown), kept: same(given, after) };
  });
  assert.deepEqual(seen, { differed: true, kept: true });
});
