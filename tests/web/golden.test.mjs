// The page draws every golden scene (tests/golden) as its picture shows it, which the program without a window drew.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { judge, mapFile, running, scenes, settling, size, solidOf } from '../golden/golden.mjs';
import { picture, startBrowser, withFur } from './support.mjs';

const site = startBrowser({ rasteriser: 'swiftshader' });  // another one than draws for the native tests
// Multisampling is decided when a page opens: one page for scenes with and one for those without.
const pages = new Map();
const pageFor = ({ samples = 0 }) => {
  const quality = samples ? 'medium' : 'low';
  if (!pages.has(quality)) pages.set(quality, site.open(`?src=sphere&ui=0&motion=full&quality=${quality}&layers=8&autoplay=0`, { viewport: size, keep: true }));
  return pages.get(quality);
};

// In the order in which the program takes its options.
const show = (page, scene) => withFur(page, async (fur, { model, preset, settings = {}, camera, groom = [], wetness, splashes = [], seconds, map, solid, settling, runs }) => {
  fur.setState('{"version":1}');
  fur.resetCamera();
  const loaded = new Promise((resolve, reject) => {
    fur.addEventListener('load', resolve, { once: true });
    fur.addEventListener('error', ({ detail }) => reject(new Error(detail.message)), { once: true });
  });
  if (solid) fur.loadModel(new File([solid], 'solid.obj'));
  else if (fur.src === model) fur.reload();
  else fur.src = model;
  await loaded;
  if (preset) fur.preset = preset;
  for (const [name, value] of Object.entries(settings)) fur.settings[name] = value;
  if (camera) fur.cameraOrbit = camera;
  if (map) await fur.loadLengthMap(Uint8Array.from(map));
  for (const [edit, value, ...direction] of groom) await fur.groom(edit, value, direction.length ? direction : undefined);
  if (wetness !== undefined) fur.setWetness(wetness);
  if (splashes.length > 0) fur.step(settling, 2);
  for (const [x, y] of splashes) fur.splash({ x, y });
  fur.step(settling, runs ? 1 : 2);
  fur.step(1 / 60, Math.round(60 * (runs + (seconds ?? 0))));
  return fur.warnings.splice(0);
}, { ...scene, solid: solidOf(scene), settling, runs: running(scene), map: mapFile(scene) && [...readFileSync(mapFile(scene))] });

for (const scene of scenes) {
  test(`${scene.name} looks on the page as its picture does`, { timeout: 600000 }, async (t) => {
    const page = await pageFor(scene);
    assert.deepEqual(await show(page, scene), []);
    const { text, wrong } = judge(scene, await picture(page), 'web');
    t.diagnostic(text);
    assert.equal(wrong, '');
    assert.deepEqual(page.problems, []);
  });
}
