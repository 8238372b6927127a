// npm run poster: web/otter.webp, which the page shows until the otter is there: the model alone, as the first picture has it.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { buildNative } from './build.mjs';
import { inline } from './photograph.mjs';
import { command, root, run, say } from './process.mjs';
import { chromiumPath, needs, setUp } from './setup.mjs';

const side = 900, quality = 0.72;

/** A PNG as WebP with its transparency. */
async function webp(file) {
  const { chromium } = await import('playwright-core');
  const browser = await chromium.launch({ executablePath: chromiumPath() });
  try {
    const tab = await browser.newPage();
    const text = await tab.evaluate(async ([source, share]) => {
      const bitmap = await createImageBitmap(await (await fetch(source)).blob()), canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
      canvas.getContext('2d').drawImage(bitmap, 0, 0);
      const bytes = new Uint8Array(await (await canvas.convertToBlob({ type: 'image/webp', quality: share })).arrayBuffer());
      return Array.from(bytes, (byte) => String.fromCharCode(byte)).join('');
    }, [inline(file), quality]);
    return Buffer.from(text, 'latin1');
  } finally {
    await browser.close();
  }
}

await command(async () => {
  setUp({ packages: [needs.headless, needs.browser], npm: true });
  const program = await buildNative('wet-fur-render'), file = join(root, 'build/poster.png');
  mkdirSync(join(root, 'build'), { recursive: true });
  run(program, ['otter', '-o', file, '--size', `${side}x${side}`, '--transparent', '--behaviour', 'none'], { quiet: true });
  const bytes = await webp(file);
  writeFileSync(join(root, 'web/otter.webp'), bytes);
  say(`${readFileSync(file).length} bytes as PNG, ${bytes.length} as WebP`);
});
