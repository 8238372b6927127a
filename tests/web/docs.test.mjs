// The tutorials and the reference in dist/docs: what pages refer to is there, their figures are what the element understands, nothing stands in
// the way of who reads them by keyboard, screen reader or phone, and figures really come to life.
import assert from 'node:assert/strict';
import { existsSync, readFileSync, readdirSync, statSync } from 'node:fs';
import { dirname, join, normalize, relative } from 'node:path';
import { test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { outdated, wantedFile } from '../../tools/docs/pictures.mjs';
import { WetFurElement } from '../../web/element.js';
import { axeFindings, dist, root, startBrowser } from './support.mjs';

const site = startBrowser({ subfolder: true });
const docs = join(dist, 'docs');
const pages = readdirSync(docs, { recursive: true }).filter((name) => name.endsWith('.html')).map((name) => ({ name, html: readFileSync(join(docs, name), 'utf8') }));
const written = pages.filter(({ name }) => !name.startsWith('three'));
const { settingsTable, equations } = await (await import(pathToFileURL(join(dist, 'core.js')))).loadCore();

const decoded = (text) => text.replace(/&quot;/g, '"').replace(/&lt;/g, '<').replace(/&gt;/g, '>').replace(/&amp;/g, '&');
/** The tags of that name as their attributes. */
const tagsOf = (html, name) => [...html.matchAll(new RegExp(`<${name}((?:\\s+[\\w-]+(?:="[^"]*")?)*)\\s*/?>`, 'g'))].map(([, text]) =>
  Object.fromEntries([...text.matchAll(/([\w-]+)(?:="([^"]*)")?/g)].map(([, key, value]) => [key, decoded(value ?? '')])));
const idsOf = (html) => [...html.matchAll(/\sid="([^"]+)"/g)].map(([, id]) => decoded(id));

test('fourteen tutorials, the reference and the table of figures are there, in the order of their numbers', () => {
  const index = written.find(({ name }) => name === 'index.html').html;
  const numbers = [...index.matchAll(/<a href="tutorials\/[\w-]+\.html">(\d+)\. /g)].map(([, number]) => Number(number));
  assert.deepEqual(numbers, Array.from({ length: 14 }, (_, i) => i + 1));
  for (const name of ['papers', ...['index', 'element', 'companions', 'package', 'core', 'settings', 'views', 'files', 'errors'].map((page) => `reference/${page}`)])
    assert.ok(written.some((page) => page.name === `${name}.html`), name);
});

test('every link is relative and leads to a page, an anchor or a file that is there', () => {
  const anchors = new Map(pages.map(({ name, html }) => [name, new Set(idsOf(html))]));
  const broken = [];
  for (const { name, html } of [...pages, { name: '../index.html', html: readFileSync(join(dist, 'index.html'), 'utf8') }]) {
    for (const [, , given] of html.replace(/<wet-fur(?!-)[^>]*>/g, '').matchAll(/\s(href|src)="([^"]*)"/g)) {
      const address = decoded(given);
      if (/^(\w+:|\/)/.test(address)) broken.push(`${name}: ${address} is not relative`);
      const [path, anchor] = address.split('#'), file = path ? normalize(join(dirname(join(docs, name)), path)) : join(docs, name);
      if (!existsSync(file) || !statSync(file).isFile()) broken.push(`${name}: ${address} is not there`);
      else if (anchor && !anchors.get(relative(docs, file))?.has(anchor)) broken.push(`${name}: ${address} has no such anchor`);
    }
  }
  assert.deepEqual(broken, []);
});

test('the page leads to the tutorials by its button Learn', () => {
  assert.match(readFileSync(join(dist, 'index.html'), 'utf8'), /<a id="learn" href="docs\/index\.html"/);
});

test('no formula has an error, no id stands twice, and every picture has a size and a text', () => {
  let formulas = 0;
  for (const { name, html } of written) {
    formulas += html.match(/<math/g)?.length ?? 0;
    assert.ok(!/katex-error|\$\$|<!-- block/.test(html.replace(/<pre[\s\S]*?<\/pre>/g, '')), name);
    const ids = idsOf(html.replace(/<pre[\s\S]*?<\/pre>/g, ''));
    assert.deepEqual(ids.filter((id, i) => ids.indexOf(id) !== i), [], `${name}: ids that stand twice`);
    for (const { src, alt, width, height } of tagsOf(html, 'img')) assert.ok(alt !== undefined && Number(width) > 0 && Number(height) > 0, `${name}: ${src}`);
  }
  assert.ok(formulas > 100, `${formulas} formulas`);
});

test('the still pictures are of what the figures show now, and none has more than 25 KB', () => {
  const wanted = new Map(JSON.parse(readFileSync(wantedFile, 'utf8')));
  assert.deepEqual(outdated(wanted).map(([name]) => name), [], 'npm run docs draws them anew');
  for (const name of readdirSync(join(docs, 'pictures'))) assert.ok(statSync(join(docs, 'pictures', name)).size <= 25 * 1024, name);
});

// --- figures ---

const fieldOf = (name) => settingsTable.find((field) => field.name === name.replace(/^type[1-4]\./, ''));
function isIn(field, value) {
  if (field.type === 'choice') return field.options.includes(value);
  if (field.type === 'bool') return typeof value === 'boolean';
  if (field.type === 'color') return /^#[0-9a-f]{6}$/.test(value);
  return typeof value === 'number' && value >= field.min && value <= field.max && (field.type === 'float' || Number.isInteger(value));
}

test('live figures have attributes, settings and methods that the element knows, within their ranges, and a picture that stands for them', () => {
  const known = new Set([...WetFurElement.observedAttributes, 'id', 'slot', 'style', 'data-set', 'data-call']);
  let figures = 0;
  for (const { name, html } of written) {
    for (const given of tagsOf(html, 'wet-fur')) {
      figures += 1;
      const what = `${name}: ${given.id}`;
      assert.ok(given.id && given.alt && given.src, what);
      for (const key of Object.keys(given)) assert.ok(known.has(key), `${what}: ${key}`);
      for (const [key, value] of Object.entries(JSON.parse(given['data-set'] ?? '{}'))) {
        assert.ok(fieldOf(key), `${what}: ${key} is no setting`);
        assert.ok(isIn(fieldOf(key), value), `${what}: ${key} ${value}`);
      }
      for (const [method] of JSON.parse(given['data-call'] ?? '[]')) assert.equal(typeof WetFurElement.prototype[method], 'function', `${what}: ${method}`);
      assert.match(html, new RegExp(`id="${given.id}"[^>]*><img slot="poster" src="[^"]*${given.id}\\.webp"`), what);
    }
  }
  assert.ok(figures >= 50, `${figures} figures`);
});

test('controls name a figure of their page, a setting or method that there is, and values that it takes', () => {
  const options = new Set(['preset', 'tool', 'lightRig', 'quality', 'src', 'wetness']);
  for (const { name, html } of written) {
    const figures = new Set(tagsOf(html, 'wet-fur').map(({ id }) => id));
    for (const kind of ['slider', 'choice', 'button', 'readout', 'steps', 'plot']) {
      for (const given of tagsOf(html, `wet-fur-${kind}`)) {
        const what = `${name}: ${JSON.stringify(given)}`;
        if (kind !== 'plot' || given.for) assert.ok(figures.has(given.for), what);
        if (given.setting && !options.has(given.setting)) assert.ok(fieldOf(given.setting), what);
        if (given.method) assert.equal(typeof WetFurElement.prototype[given.method], 'function', what);
        if (given.setting && given.values && fieldOf(given.setting)?.type === 'choice')
          for (const value of given.values.split(',')) assert.ok(fieldOf(given.setting).options.includes(value.split('=')[0]), `${what}: ${value}`);
        for (const { f } of JSON.parse(given.equations ?? '[]')) assert.equal(typeof equations[f], 'function', what);
      }
    }
    for (const { 'data-set': set } of tagsOf(html, 'section')) for (const [key, value] of Object.entries(JSON.parse(set ?? '{}'))) assert.ok(isIn(fieldOf(key), value), `${name}: ${key}`);
  }
});

// --- in the browser ---

/** Pages as they are without the figures' scripts, which take most of the time. */
const withoutScripts = (page) => page.route(/\.js$/, (route) => route.fulfill({ contentType: 'text/javascript', body: '' }));

/** One style makes all pages dark: these have all that it knows. */
const eachKind = ['index.html', 'tutorials/clumps.html', 'reference/settings.html', 'reference/core.html'];

/** Formulas and code that run out of their column, and formulas that their number lies over. */
const crowded = (page) => page.evaluate(() => {
  const runsOut = [...document.querySelectorAll('.formula, pre')].filter(({ scrollWidth, clientWidth }) => scrollWidth > clientWidth + 1);
  const meet = (a, b) => a.right > b.left + 1 && a.left < b.right - 1 && a.bottom > b.top + 2 && a.top < b.bottom - 2;
  const over = [...document.querySelectorAll('.formula:has(.tag)')].filter((one) => {
    const number = one.querySelector('.tag').getBoundingClientRect();
    return [...one.querySelectorAll('.base')].filter((part) => !part.closest('.tag')).some((part) => meet(part.getBoundingClientRect(), number));
  });
  return [...runsOut, ...over].map(({ textContent }) => textContent.slice(0, 60));
});

test('without the figures\' scripts pages are complete; axe finds nothing on any, in light and dark, none is wider than a phone, and formulas and code fit', async () => {
  const page = await site.open('docs/index.html', { wait: false, bypassCSP: true, prepare: withoutScripts, viewport: { width: 1280, height: 800 } });
  for (const { name } of written) {
    await page.setViewportSize({ width: 1280, height: 800 });
    await page.goto(new URL(`docs/${name}`, site.url).href);
    assert.deepEqual(await axeFindings(page, { iframes: false }), [], name);
    assert.deepEqual(await crowded(page), [], name);
    if (eachKind.includes(name)) {
      await page.emulateMedia({ colorScheme: 'dark' });
      assert.deepEqual(await axeFindings(page, { only: ['color-contrast'], iframes: false }), [], `${name}, dark`);
      await page.emulateMedia({ colorScheme: 'light' });
    }
    await page.setViewportSize({ width: 390, height: 844 });
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390, `${name} is wider than a phone`);
    assert.deepEqual(await crowded(page), [], `${name} on a phone`);
    const unseen = await page.$$eval('wet-fur > img', (all) => all.filter((one) => !one.checkVisibility()).length), idle = await page.$$eval('.controls', (all) => all.filter((one) => one.checkVisibility()).length);
    assert.deepEqual([unseen, idle], [0, 0], `${name}: without scripts each figure is its picture, and nothing that does not work is shown`);
  }
});

test('the figures of a page come to life with their settings as one scrolls to them', async () => {
  const page = await site.open('docs/tutorials/fins.html', { wait: false, viewport: { width: 480, height: 500 } });
  const seen = [];
  for (const id of ['outline', 'both']) {
    await page.locator(`#${id}`).scrollIntoViewIfNeeded();
    await page.waitForFunction((name) => document.getElementById(name).loaded, id);
    seen.push(await page.evaluate((name) => {
      const fur = document.getElementById(name);
      return [fur.modelName, fur.settings.technique, fur.settings.layers, fur.warnings.length];
    }, id));
  }
  assert.deepEqual(seen, [['fins-outline', 'shells', 16, 0], ['bunny', 'shells', 16, 0]]);
  assert.deepEqual(page.problems, []);
});

test('the page that draws our layers with three.js shows a furry ring, and water changes it', async () => {
  const page = await site.open('docs/three/index.html', { wait: false, viewport: { width: 240, height: 200 } });
  await page.waitForFunction(() => 'ready' in document.documentElement.dataset);
  assert.equal(await page.textContent('#message'), '');
  const ring = page.locator('#canvas'), before = await ring.screenshot();
  await page.locator('#soak').click();
  const after = await ring.screenshot();
  assert.ok(before.length > 20000, 'fur is no even surface');
  assert.ok(!before.equals(after));
  assert.deepEqual(page.problems, []);
});
