// The page and the windowless program draw the same scene alike.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { PNG } from 'pngjs';
import { difference, dist, picture, root, startBrowser, withFur } from './support.mjs';

const site = startBrowser();
const program = join(root, 'build/native-release/wet-fur-render');

function nativePicture(model, settings, splashes) {
  const folder = mkdtempSync(join(tmpdir(), 'wet-fur-'));
  const file = join(folder, 'native.png');
  const fields = Object.entries(settings).flatMap(([name, value]) => [`--${name}`, String(value)]);
  const run = spawnSync(program, [model === 'bunny' ? join(dist, 'models/bunny.glb') : model, '-o', file,
    '--size', '480x360', '--samples', '0', ...splashes.flatMap((at) => ['--splash', at.join()]), ...fields], { encoding: 'utf8' });
  assert.equal(run.status, 0, run.stderr);
  const png = PNG.sync.read(readFileSync(file));
  rmSync(folder, { recursive: true });
  return png;
}

async function webPicture(model, settings, splashes) {
  const query = new URLSearchParams({ src: model, quality: 'low', ui: '0', ...settings });
  const page = await site.open(`index.html?${query}`);
  await withFur(page, (fur, spots) => {
    fur.pause();
    for (const [x, y] of spots) fur.splash({ x, y }, { radius: fur.settings.brushRadius, amount: fur.settings.brushFlow });
    fur.step(0.6, 2);  // over half a second the fur settles at once
  }, splashes);
  return picture(page);
}

const spots = [[190, 200], [215, 190], [240, 200], [205, 225], [235, 230], [260, 215]];
const scenes = [
  ['the dry bunny', 'bunny', { layers: 32, dryRate: 0 }, []],
  ['a bunny with wet flanks', 'bunny', { layers: 32, dryRate: 0, brushRadius: 0.1, brushFlow: 0.8 }, spots],
  ['a bunny of glass strands that shade each other', 'bunny',
    { layers: 24, strandModel: 'marschner', shadows: 'layers', lightYaw: 2.6, dryRate: 0 }, []],
  ['a red torus with long fur in the wind', 'torus', { layers: 24, furLength: 0.2, tipColor: '#c03020', wind: 0.6, gust: 0, motion: 'full' }, []],
];

for (const [name, model, settings, splashes] of scenes) {
  test(`${name} looks the same natively and on the page`, { timeout: 120000 }, async (t) => {
    assert.ok(existsSync(program), 'wet-fur-render is built before the page tests');
    const { motion, ...fields } = settings;
    const native = nativePicture(model, fields, splashes);
    const web = await webPicture(model, settings, splashes);
    assert.deepEqual([web.width, web.height], [native.width, native.height]);
    const share = difference(native, web, 5);
    t.diagnostic(`${(100 * share).toFixed(3)} % of pixels differ by more than 5/255`);
    // Two rasterisers may round an edge or a mip level differently; whole strands or layers may not differ.
    assert.ok(share <= 0.005, `${(100 * share).toFixed(2)} % of pixels differ by more than 5/255, 0.5 % may`);
  });
}
