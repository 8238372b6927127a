// How the element and the pages behave as guests: for screen readers, in layouts, in frameworks, for those who go back.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { axeFindings, lighten, startBrowser, withFur } from './support.mjs';

const site = startBrowser();
const embed = (options = {}) => site.open('embed.html', { scripts: [lighten], ...options });

for (const [name, path] of [['the demo page', 'index.html?src=sphere&quality=low&layers=8&autoplay=0'], ['a page with figures', 'embed.html']]) {
  test(`axe finds nothing on ${name}, in light and in dark`, async () => {
    const page = await site.open(path, { scripts: [lighten], bypassCSP: true, viewport: { width: 800, height: 600 } });
    for (const colorScheme of ['light', 'dark']) {
      await page.emulateMedia({ colorScheme });
      assert.deepEqual(await axeFindings(page), [], colorScheme);
    }
  });
}

test('with forced colours the page shows what is chosen, what cannot be pressed and where the focus is, and axe finds nothing', async () => {
  const page = await site.open('index.html?src=sphere&quality=low&layers=8&autoplay=0', { scripts: [lighten], bypassCSP: true, viewport: { width: 800, height: 600 } });
  await page.emulateMedia({ forcedColors: 'active' });
  const colors = await page.evaluate(() => {
    const system = (color) => {
      const probe = document.body.appendChild(Object.assign(document.createElement('i'), { style: `forced-color-adjust: none; color: ${color}` }));
      const found = getComputedStyle(probe).color;
      probe.remove();
      return found;
    };
    const style = (button) => (button ? [getComputedStyle(button).backgroundColor, getComputedStyle(button).color] : null);
    const first = (selector) => [...document.querySelectorAll(selector)].find((one) => one.checkVisibility());
    const pressed = first('.bar button[aria-pressed="true"]'), plain = first('.bar button[aria-pressed="false"]:enabled'), disabled = first('.bar button:disabled');
    plain.focus();
    return { pressed: style(pressed), plain: style(plain), disabled: style(disabled), chosen: [system('Highlight'), system('HighlightText')], gray: system('GrayText') };
  });
  assert.deepEqual(colors.pressed, colors.chosen);
  assert.notDeepEqual(colors.plain, colors.pressed);
  assert.equal(colors.disabled[1], colors.gray);
  await page.keyboard.press('ArrowRight');
  assert.notEqual(await page.evaluate(() => getComputedStyle(document.activeElement).outlineStyle), 'none');
  assert.deepEqual(await axeFindings(page), []);
});

test('nothing on the page moves while figures load', async () => {
  const page = await embed({ viewport: { width: 480, height: 600 } });
  const shifts = await page.evaluate(() => new Promise((resolve) => {
    // Of what is in a figure's own tree, as its progress bar, there is no node.
    const told = ({ node, previousRect, currentRect }) => (node ? [`${node.nodeName}: ${previousRect.top} to ${currentRect.top}`] : []);
    new PerformanceObserver((list) => resolve(list.getEntries().flatMap(({ sources }) => sources.flatMap(told)))).observe({ type: 'layout-shift', buffered: true });
    setTimeout(resolve, 300, []);  // there are none to tell of
  }));
  assert.deepEqual(shifts, []);
});

test('at 400 % zoom a page with figures is no wider than its window, and the figure has room', async () => {
  const page = await embed({ viewport: { width: 320, height: 256 }, wait: false });
  await page.waitForFunction(() => customElements.get('wet-fur'));
  const { width, figure } = await page.evaluate(() => ({ width: document.documentElement.scrollWidth, figure: document.querySelector('wet-fur').getBoundingClientRect().width }));
  assert.equal(width, 320);
  assert.ok(figure > 200 && figure <= 320, `${figure}`);
});

test('a figure that is moved to another place of the document keeps its water and goes on', async () => {
  const page = await embed({ viewport: { width: 480, height: 600 } });
  const before = await withFur(page, (fur) => {
    fur.settings.stayWet = true;
    fur.splash({ u: 0.5, v: 0.5 }, { radius: 0.2, amount: 0.5 });
    return fur.meanWetness;
  });
  assert.ok(before > 0);
  await page.evaluate(() => {
    const place = document.createElement('section');
    document.querySelector('main').prepend(place);
    place.append(document.querySelector('wet-fur'));
  });
  await withFur(page, (fur) => fur.ready);
  const after = await withFur(page, (fur) => {
    fur.step(0.1, 1);
    return { wet: fur.meanWetness, state: fur.state, model: fur.modelName };
  });
  assert.deepEqual({ ...after, wet: 0 }, { wet: 0, state: 'ready', model: 'bunny' });
  assert.ok(Math.abs(after.wet - before) < 0.05 * before, `${after.wet} and ${before}`);
  assert.deepEqual(page.problems, []);
});

test('who goes on to another page and comes back finds the figures alive', async () => {
  const page = await embed({ viewport: { width: 480, height: 600 } });
  await page.goto(new URL('docs/papers.html', site.url).href);
  await page.goBack();
  await page.waitForFunction(() => document.querySelector('wet-fur')?.loaded);
  await withFur(page, (fur) => fur.splash({ u: 0.5, v: 0.5 }, { radius: 0.2, amount: 0.5 }));
  assert.ok(await withFur(page, (fur) => fur.meanWetness) > 0);
  assert.deepEqual(page.problems, []);
});
