// A picture of an HTML page, for contact sheets.
import { readFileSync } from 'node:fs';
import { chromiumPath } from './setup.mjs';

/** A PNG as an address to put into the page. */
export const inline = (file) => `data:image/png;base64,${readFileSync(file).toString('base64')}`;

/** Writes the whole body of `html` to `file`, a .jpg. */
export async function photograph(html, file, { quality = 85 } = {}) {
  const { chromium } = await import('playwright-core');
  const browser = await chromium.launch({ executablePath: chromiumPath() });
  try {
    const tab = await browser.newPage();
    await tab.setContent(html);
    await tab.locator('body').screenshot({ path: file, type: 'jpeg', quality });
  } finally {
    await browser.close();
  }
}
