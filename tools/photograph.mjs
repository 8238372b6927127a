// What a browser makes of pictures: contact sheets of an HTML page, and WebP files.
import { readFileSync } from 'node:fs';
import { chromiumPath } from './setup.mjs';

/** A PNG as an address to put into the page. */
export const inline = (file) => `data:image/png;base64,${readFileSync(file).toString('base64')}`;

/** Writes the whole body of `html` to `file`, a .jpg. */
export async function photograph(html, file, { quality = 85 } = {}) {
  await withTab(async (tab) => {
    await tab.setContent(html);
    await tab.locator('body').screenshot({ path: file, type: 'jpeg', quality });
  });
}

/** What `work` gives for an empty page. */
export async function withTab(work) {
  const { chromium } = await import('playwright-core');
  const browser = await chromium.launch({ executablePath: chromiumPath(), args: ['--no-sandbox'] });
  try {
    return await work(await browser.newPage());
  } finally {
    await browser.close();
  }
}

/** PNG files side by side as the bytes of a WebP file; of at most so many, in as good a quality up to that as fits. */
export async function webpOf(tab, files, { quality, alpha = true, most = Infinity }) {
  return Buffer.from(await tab.evaluate(packed, [files.map(inline), quality, alpha, most === Infinity ? null : most]), 'latin1');
}

/** In the page. */
async function packed([sources, best, alpha, most]) {
  const bitmaps = await Promise.all(sources.map(async (source) => createImageBitmap(await (await fetch(source)).blob())));
  const gap = 2, width = bitmaps.reduce((sum, bitmap) => sum + bitmap.width, gap * (bitmaps.length - 1));
  let blob;
  // Rather smaller than of a quality that shows.
  for (let scale = 1, quality = best; ; quality -= 0.06) {
    if (quality < 0.3) scale *= 0.85, quality = 0.5;
    const canvas = new OffscreenCanvas(Math.round(width * scale), Math.round(bitmaps[0].height * scale)), context = canvas.getContext('2d', { alpha });
    context.scale(scale, scale);
    bitmaps.reduce((x, bitmap) => { context.drawImage(bitmap, x, 0); return x + bitmap.width + gap; }, 0);
    blob = await canvas.convertToBlob({ type: 'image/webp', quality });
    if (most === null || blob.size <= most) break;
  }
  return Array.from(new Uint8Array(await blob.arrayBuffer()), (byte) => String.fromCharCode(byte)).join('');
}
