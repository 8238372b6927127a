// web/coats.webp: a ball of every preset's fur, side by side, without a background, for the demo page's chooser.
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { inline } from './photograph.mjs';
import { run } from './process.mjs';
import { chromiumPath } from './setup.mjs';

const side = 112;  // twice as many pixels as web/coats.js shows
const view = '0.35,0.28,3.15';

/** On black and on white: what differs is the background. */
function pictures(program, name, folder) {
  return ['000000', 'ffffff'].map((ground) => {
    const file = join(folder, `swatch-${name}-${ground}.png`);
    run(program, ['sphere', '-o', file, '--preset', name, '--size', `${4 * side}x${4 * side}`, '--camera', view, '--ground', '0',
      '--backgroundTop', `#${ground}`, '--backgroundBottom', `#${ground}`], { quiet: true });
    return inline(file);
  });
}

/** Runs in the page: pairs of pictures to one image as data URL. */
async function compose(pairs, size) {
  const load = async (src) => {
    const image = new Image();
    image.src = src;
    await image.decode();
    return image;
  };
  const sheet = Object.assign(document.createElement('canvas'), { width: size * pairs.length, height: size }).getContext('2d');
  sheet.imageSmoothingQuality = 'high';
  for (const [index, pair] of pairs.entries()) {
    const [black, white] = await Promise.all(pair.map(load));
    const { width, height } = black;
    const pixels = (image) => {
      const context = new OffscreenCanvas(width, height).getContext('2d');
      context.drawImage(image, 0, 0);
      return context.getImageData(0, 0, width, height);
    };
    const [on, other] = [pixels(black), pixels(white)];
    for (let i = 0; i < on.data.length; i += 4) {
      const through = [0, 1, 2].reduce((sum, c) => sum + other.data[i + c] - on.data[i + c], 0) / 3;
      const alpha = Math.max(0, 255 - through);
      for (let c = 0; c < 3; c++) on.data[i + c] = alpha > 0 ? Math.min(255, (on.data[i + c] * 255) / alpha) : 0;
      on.data[i + 3] = alpha;
    }
    const cut = new OffscreenCanvas(width, height);
    cut.getContext('2d').putImageData(on, 0, 0);
    sheet.drawImage(cut, index * size, 0, size, size);
  }
  return sheet.canvas.toDataURL('image/webp', 0.82);
}

/** @param {string} program wet-fur-render @param {{ name: string }[]} presets @param {string} folder for what comes between */
export async function drawSwatches(program, presets, folder, file) {
  const pairs = presets.map(({ name }) => pictures(program, name, folder));
  const { chromium } = await import('playwright-core');
  const browser = await chromium.launch({ executablePath: chromiumPath() });
  try {
    const tab = await browser.newPage();
    const url = await tab.evaluate(`(${compose})(${JSON.stringify(pairs)}, ${side})`);
    writeFileSync(file, Buffer.from(url.slice(url.indexOf(',') + 1), 'base64'));
  } finally {
    await browser.close();
  }
}
