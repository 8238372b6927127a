// The recipes of examples/: each is built and worked in the browser.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { join, relative, sep } from 'node:path';
import { after, before, test } from 'node:test';
import { buildExample, builtExamples, exampleNames, prepareExamples } from '../../tools/examples.mjs';
import { serve } from '../../tools/serve.mjs';
import { dist, root, startBrowser } from './support.mjs';

const site = startBrowser();
let server;

before(async () => {
  prepareExamples(dist);
  server = await serve({ folder: builtExamples });
});
after(() => server?.close());

const lighter = () => {
  // Heard from the start: a picture may come before a test asks for it.
  document.addEventListener('picture-change', ({ target }) => { window.comparisonDrawn ||= target.localName === 'wet-fur-compare'; }, true);
  const lighten = () => document.querySelectorAll('wet-fur:not([quality])').forEach((fur) => {
    fur.setAttribute('quality', 'low');
    customElements.whenDefined('wet-fur').then(() => Object.assign(fur.settings, { layers: 8, tileSize: '64' }));
  });
  new MutationObserver(lighten).observe(document, { childList: true, subtree: true });
};
const open = (address, options) => site.open(address, { scripts: [lighter], wait: false, viewport: { width: 800, height: 700 }, ...options });

/** The figure of a page or a frame is there, and its slider sets it. */
async function worksIn(frame) {
  await frame.waitForFunction(() => document.querySelector('wet-fur')?.loaded);
  const curl = () => frame.evaluate(() => Number(document.querySelector('wet-fur').settings.curl.toFixed(3)));
  const start = await curl();
  const slider = frame.getByRole('slider', { name: 'Curl' });
  await slider.focus();
  await slider.press('ArrowRight');
  assert.equal(await curl(), Number((start + 0.01).toFixed(3)));
}

async function isSound(page) {
  assert.deepEqual(page.problems, []);
  assert.deepEqual(await page.evaluate(() => window.violations), []);
}

const addressOf = async (name) => new URL(`${relative(builtExamples, await buildExample(name, dist)).split(sep).join('/')}/`, server.url).href;

for (const name of exampleNames.filter((one) => one !== 'server-side' && one !== 'iframe')) {
  test(`${name}: builds, shows a figure, and its slider sets it`, async () => {
    const page = await open(await addressOf(name));
    await worksIn(page);
    if (['react', 'vue', 'svelte'].includes(name)) await framework(page);
    if (name === 'csp') await drawsUnderThePolicy(page);
    await isSound(page);
  });
}

/** Pictures of two states and a plot come without anything that the policy does not let pass. */
async function drawsUnderThePolicy(page) {
  await page.evaluate(() => document.querySelector('wet-fur-compare').scrollIntoView({ block: 'end' }));
  await page.waitForFunction(() => window.comparisonDrawn);
  await page.evaluate(() => document.querySelector('wet-fur-plot').scrollIntoView());
  await page.waitForFunction(() => document.querySelector('wet-fur-plot').shadowRoot.querySelector('path.curve'));
}

/** What it is told, it shows; a figure that it takes away and brings back is found again. */
async function framework(page) {
  await page.getByRole('button', { name: 'Soak' }).click();
  await page.waitForFunction(() => parseInt(document.querySelector('output').textContent, 10) > 90);
  await page.getByRole('button', { name: 'Take it away' }).click();
  assert.equal(await page.locator('wet-fur').count(), 0);
  assert.match(await page.locator('wet-fur-slider [part=error]').textContent(), /no figure with the id “fig”/);
  await page.getByRole('button', { name: 'Bring it back' }).click();
  await worksIn(page);
}

test('iframe: a page without any script shows a figure in a frame', async () => {
  const page = await open(await addressOf('iframe'));
  const frame = await (await page.waitForSelector('iframe')).contentFrame();
  await worksIn(frame);
  assert.equal(await page.evaluate(() => document.scripts.length), 0);
  await isSound(page);
});

test('server-side: Node renders the page, and its figure comes alive in the browser', async () => {
  await buildExample('server-side', dist);
  const child = spawn(process.execPath, ['server.mjs'], { cwd: join(builtExamples, 'server-side'), env: { ...process.env, PORT: '0' }, stdio: ['ignore', 'pipe', 'inherit'] });
  try {
    const address = await new Promise((resolve, reject) => {
      child.stdout.once('data', (text) => resolve(String(text).trim()));
      child.once('exit', (status) => reject(new Error(`server.mjs: exit ${status}`)));
    });
    const html = await (await fetch(address)).text();
    assert.match(html, /<wet-fur id="fig" src="torus" alt="A furry ring\. Click to wet its fur\." tool="droplet" camera-controls><\/wet-fur>/);
    assert.match(html, /<b>[1-9]\d+<\/b> strands/);
    const page = await open(address);
    await worksIn(page);
    await isSound(page);
  } finally {
    child.kill();
  }
});

test('recipes name the versions that they are tested with, and say what they are', () => {
  const { devDependencies } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
  const list = readFileSync(join(root, 'examples/README.md'), 'utf8');
  for (const name of exampleNames) {
    assert.ok(existsSync(join(root, 'examples', name, 'README.md')), name);
    assert.ok(list.includes(`(${name})`), `${name} is not in examples/README.md`);
    const manifest = join(root, 'examples', name, 'package.json');
    if (!existsSync(manifest)) continue;
    const { dependencies = {}, devDependencies: own = {} } = JSON.parse(readFileSync(manifest, 'utf8'));
    for (const [what, version] of Object.entries({ ...dependencies, ...own })) if (what !== 'wet-fur') assert.equal(version, devDependencies[what], `${name}: ${what}`);
  }
});
