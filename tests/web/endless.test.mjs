// No coat, however wet, takes a picture that never ends: a GPU that is kept busy is reset, and all the page's pictures are lost.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { startBrowser, withFur } from './support.mjs';

const site = startBrowser();
// Of a case: a picture takes a twentieth of a second. What does not come back in this time never will.
const patience = 120000;

const wetnesses = [0, 0.3, 0.6, 0.85, 1, 1.5];
const after = [0, 30, 60, 300];  // steps of 1/60 s
const qualities = ['low', 'medium', 'high', 'auto'];
const distances = { near: 1.6, middle: 4, far: 12, 'inside the coat': 0.6 };

/** What `work` gives, or an error that names the case. The browser is not asked again: it would not answer. */
async function beforeLong(name, work) {
  let timer;
  const late = new Promise((_, reject) => {
    timer = setTimeout(() => reject(new Error(`no picture after ${patience / 1000} s: ${name}`)), patience);
  });
  return Promise.race([work, late]).finally(() => clearTimeout(timer));
}

/** Draws one picture and waits for the GPU. */
const draw = (page, distance) => withFur(page, (fur, way) => {
  fur.cameraOrbit = `0.6 0.2 ${way}`;
  fur.step(0, 0);
  const picture = new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true });
  picture.drawImage(fur.shadowRoot.querySelector('canvas'), 0, 0);
  picture.getImageData(0, 0, 1, 1);
  return fur.state !== 'ready';
}, distance);

test('every coat is drawn, however wet, for however long, from wherever, in every quality', async () => {
  const page = await site.open('?ui=0&autoplay=0', { viewport: { width: 96, height: 72 } });
  const presets = await withFur(page, (fur) => {
    fur.pause();
    return fur.presets.map(({ name }) => name);
  });
  assert.ok(presets.length >= 11);
  for (const preset of presets) {
    await withFur(page, (fur, name) => { fur.preset = name; }, preset);
    for (const wetness of wetnesses) {
      let stepped = 0;
      await withFur(page, (fur, amount) => fur.setWetness(amount), wetness);
      for (const steps of after) {
        const state = `${preset}, wetness ${wetness}, ${steps} steps`;
        await beforeLong(state, withFur(page, (fur, n) => fur.step(1 / 60, n), steps - stepped));
        stepped = steps;
        for (const quality of qualities) {
          await withFur(page, (fur, name) => { fur.quality = name; }, quality);
          for (const [name, distance] of Object.entries(distances)) {
            const lost = await beforeLong(`${state}, ${name}, quality ${quality}`, draw(page, distance));
            assert.equal(lost, false, `${state}, ${name}, quality ${quality}`);
          }
        }
      }
    }
  }
  assert.deepEqual(page.problems, []);
});
