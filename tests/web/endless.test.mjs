// No coat, however wet, takes a picture that never ends: a GPU that is kept busy is reset, and all the page's pictures are lost.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { startBrowser, withFur } from './support.mjs';

const site = startBrowser({ rasteriser: 'swiftshader' });  // with which pictures have been endless
// Of eight pictures, each of a twentieth of a second. What does not come back in this time never will.
const patience = 120000;

const wetnesses = [0, 0.3, 0.6, 0.85, 1, 1.5];
// Seconds that each picture comes after the one before, and the steps in which they go by: as on a quick and on a slow machine.
const after = [[0, 0], [0.5, 1 / 60], [0.5, 1 / 60], [4, 1 / 10]];
const qualities = ['low', 'medium', 'high', 'auto'];
const distances = { near: 1.6, middle: 4, far: 12, 'inside the coat': 0.6 };

/** What `work` gives, or an error that names the case. The browser is not asked again: it would not answer. */
async function beforeLong(begun, work) {
  let timer;
  const late = new Promise((_, reject) => {
    timer = setTimeout(() => reject(new Error(`no picture after ${patience / 1000} s: ${begun()}`)), patience);
  });
  return Promise.race([work, late]).finally(() => clearTimeout(timer));
}

/** In the page: so wet, and then at every time a picture from every other distance, each waited for. Gives those that took the context. */
const drawAll = (fur, { state, wetness, after, distances }) => {
  const pixel = new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true });
  const lost = [];
  let time = 0;
  fur.setWetness(wetness);
  for (const [i, [seconds, step]] of after.entries()) {
    time += seconds;
    let steps = seconds && Math.round(seconds / step);
    for (const [name, distance] of Object.entries(distances).filter((_, d) => (d + i) % 2 === 0)) {
      const picture = `${state}, ${time} s, ${name}`;
      console.debug(picture);  // the last words of a page that hangs
      fur.cameraOrbit = `0.6 0.2 ${distance}`;
      fur.step(step, steps);
      steps = 0;
      pixel.drawImage(fur.shadowRoot.querySelector('canvas'), 0, 0);
      pixel.getImageData(0, 0, 1, 1);
      if (fur.state !== 'ready') lost.push(picture);
    }
  }
  return lost;
};

test('every coat is drawn, however wet, for however long, from wherever, in every quality', async () => {
  // A loop without an end is one of a single ray, and every loop of the shaders is bounded (tests/render/loops.test.mjs): few
  // pixels of every case find what is left, all cases together over a quarter of a million rays. Each coat meets each quality, and each
  // of both meets each wetness: a third of all threes. Another quality grows another coat, which takes longest: so it changes
  // least often.
  const page = await site.open('?src=plain-bunny&ui=0&autoplay=0', { viewport: { width: 24, height: 18 } });
  let begun = 'nothing yet', pictures = 0;
  page.on('console', (message) => {
    if (message.type() !== 'debug') return;
    begun = message.text();
    pictures += 1;
  });
  const presets = await withFur(page, (fur) => {
    fur.pause();
    return fur.presets.map(({ name }) => name);
  });
  assert.ok(presets.length >= 11);
  for (const [p, preset] of presets.entries()) {
    await withFur(page, (fur, name) => { fur.preset = name; }, preset);
    for (const [q, quality] of qualities.entries()) {
      await withFur(page, (fur, name) => { fur.quality = name; }, quality);
      for (const wetness of wetnesses.filter((_, w) => (p + q + w) % 3 === 0)) {
        const state = `${preset}, quality ${quality}, wetness ${wetness}`;
        assert.deepEqual(await beforeLong(() => begun, withFur(page, drawAll, { state, wetness, after, distances })), []);
      }
    }
  }
  assert.ok(pictures >= presets.length * qualities.length * (wetnesses.length / 3) * after.length * Object.keys(distances).length / 2);
  assert.deepEqual(page.problems, []);
});
