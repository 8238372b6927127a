// The demo page's bar in windows of every size: what it leaves of the picture, and every way to its controls.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { readTables } from '../../tools/tables.mjs';
import { captions } from '../../web/captions.js';
import { sceneNames } from '../../web/models.js';
import { plain, startBrowser, untilShown, untilStill, withFur } from './support.mjs';

const site = startBrowser();
const sizes = [[1280, 800], [1024, 768], [390, 844], [844, 390], [320, 568], [640, 400]];

const controls = (page) => page.$$eval('#bar button, #bar a, #bar select', (list) => list.filter((one) => one.checkVisibility()).map((one) => {
  one.scrollIntoView({ block: 'nearest', inline: 'nearest' });
  const { left, top, right, bottom, width, height } = one.getBoundingClientRect();
  return { name: one.title || one.labels?.[0]?.title || '', width, height, inside: left >= 0 && top >= 0 && right <= innerWidth && bottom <= innerHeight };
}));

test('in windows of every size the model is clear of the bar, and every control has a name, a label and room for a finger', async () => {
  const page = await site.open(`?${plain}`, { viewport: { width: 1280, height: 800 } });
  for (const [width, height] of sizes) {
    const what = `${width} x ${height}`;
    await page.setViewportSize({ width, height });
    await untilStill(page);
    const isInSight = await page.$eval('#editor', (button) => {
      const { left, top, right, bottom } = button.getBoundingClientRect(), group = button.closest('.group').getBoundingClientRect();
      return left >= group.left && right <= group.right + 1 && top >= group.top && bottom <= group.bottom + 1;
    });
    assert.ok(isInSight, `${what}: the editor is found without scrolling`);
    const list = await controls(page);
    assert.equal(list.length, 20, what);
    for (const one of list) {
      assert.ok(one.name.length > 2);
      assert.ok(one.width >= 44 && one.height >= 44, `${what}: ${one.name} is ${one.width} x ${one.height}`);
      assert.ok(one.inside, `${what}: ${one.name} is cut off`);
    }
    const seen = await withFur(page, (fur) => {
      const bar = document.getElementById('bar');
      const groups = [...bar.querySelectorAll('.group')].filter((one) => one.checkVisibility()).map((one) => one.getBoundingClientRect());
      let behind = 0, models = 0;
      for (let y = 2; y < innerHeight; y += 6) {
        for (let x = 2; x < innerWidth; x += 6) {
          if (!fur.pick({ x, y })) continue;
          models += 1;
          behind += groups.some(({ left, top, right, bottom }) => x > left && x < right && y > top && y < bottom) ? 1 : 0;
        }
      }
      const labels = [...bar.querySelectorAll('#tools span')].filter((one) => one.checkVisibility()).map((one) => one.getBoundingClientRect());
      return {
        behind, share: models * 36 / (innerWidth * innerHeight), labelled: labels.every((box) => box.height > 8 && box.width > 8),
        covered: groups.reduce((sum, box) => sum + box.width * box.height, 0) / (innerWidth * innerHeight),
      };
    });
    assert.equal(seen.behind, 0, `${what}: some of the model is behind the bar`);
    assert.ok(seen.share > 0.08, `${what}: the model covers ${(100 * seen.share).toFixed(1)} %`);
    assert.ok(seen.covered < 0.21, `${what}: the bar covers ${(100 * seen.covered).toFixed(1)} %`);
    assert.ok(seen.labelled, `${what}: labels`);
    if (width === 1280) assert.ok(await page.$eval('#bar', (bar) => bar.offsetHeight) < 70, 'one row');
  }
  assert.deepEqual(page.problems, []);
});

test('what opens beside the bar is on the screen, and leaves the bar free', async () => {
  const page = await site.open(`?${plain}&src=plane`, { viewport: { width: 1280, height: 800 } });
  for (const [width, height] of sizes) {
    await page.setViewportSize({ width, height });
    for (const [opener, panel] of [['water', 'waters'], ['groom', 'grooms'], ['brush', 'brushing'], ['coat', 'coats'], ['share', 'sharing']]) {
      await page.click(`#${opener}`);
      await page.waitForFunction((id) => {
        const { left, top, right, bottom } = document.getElementById(id).getBoundingClientRect();
        const bar = document.elementsFromPoint((left + right) / 2, (top + bottom) / 2);
        const isApart = [...document.querySelectorAll('#bar .group')].filter((group) => group.checkVisibility()).every((group) => {
          const other = group.getBoundingClientRect();
          return left >= other.right || right <= other.left || top >= other.bottom || bottom <= other.top;
        });
        return left >= 0 && top >= 0 && right <= innerWidth && bottom <= innerHeight && bar[0].closest('.panel') && isApart;
      }, panel);
      await page.keyboard.press('Escape');
      await page.waitForSelector(`#${panel}`, { state: 'hidden' });
    }
  }
  assert.deepEqual(page.problems, []);
});

test('every tool that grooms is in the bar or its menu, and those of the editor open it', async () => {
  const page = await site.open(`?${plain}&src=plane`, { viewport: { width: 1280, height: 800 } });
  const offered = await page.$$eval('#tools [data-tool], #grooms [data-tool]', (list) => list.map((one) => one.dataset.tool));
  for (const { name } of readTables().tools.filter(({ worksOn }) => worksOn === 'Groom')) assert.ok(offered.includes(name), name);
  await page.click('#groom');
  await page.click('[data-tool=grow]');
  assert.equal(await withFur(page, (fur) => fur.tool), 'grow');
  assert.equal(await page.getAttribute('#groom', 'aria-pressed'), 'true');
  await page.selectOption('#groom-type', '3');
  assert.deepEqual(await withFur(page, (fur) => [fur.tool, fur.groomType]), ['type', '3']);
  await page.click('[data-tool=edit]');
  await page.waitForFunction(() => wetFur.editorOpen && wetFur.tool === 'edit');
  assert.deepEqual(page.problems, []);
});

test('beside the editor the bar is one row that repeats nothing of the panel', async () => {
  const page = await site.open(`?${plain}&src=plane&editor=1`, { viewport: { width: 1280, height: 800 } });
  await page.waitForFunction(() => wetFur.editorOpen && document.body.classList.contains('editing'));
  const names = async () => page.$$eval('#bar button', (list) => list.filter((one) => one.checkVisibility()).map((one) => one.id));
  assert.deepEqual(await names(), ['reset', 'share', 'fullscreen', 'editor']);
  const { height, right } = await page.$eval('#bar', (bar) => bar.getBoundingClientRect().toJSON());
  assert.ok(height < 70 && right < 1280 - 348, `${height} high, to ${right}`);
  await page.setViewportSize({ width: 844, height: 390 });
  assert.ok(await page.$eval('#scene', (rail) => rail.getBoundingClientRect().right) < 100);
});

test('the bar is one stop for Tab; arrow keys, Home and End go through it, past what is disabled', async () => {
  const page = await site.open(`?${plain}&src=plane`, { viewport: { width: 1280, height: 800 } });
  const focused = () => page.evaluate(() => document.activeElement.dataset.tool ?? document.activeElement.id);
  await page.keyboard.press('Tab');
  assert.equal(await focused(), 'fur');
  await page.keyboard.press('Tab');
  assert.equal(await focused(), 'droplet');
  const after = async (...keys) => {
    for (const key of keys) await page.keyboard.press(key);
    return focused();
  };
  assert.equal(await after('ArrowRight'), 'water');
  assert.equal(await after('ArrowLeft', 'ArrowLeft'), 'editor');
  assert.equal(await after('Home'), 'droplet');
  assert.equal(await after('End', 'ArrowLeft', 'ArrowLeft', 'ArrowLeft', 'ArrowLeft', 'ArrowLeft'), 'open');  // undo and redo are disabled
  assert.equal(await after('ArrowLeft', 'ArrowLeft'), 'model');
  const chosen = await page.inputValue('#model');
  assert.equal(await after('ArrowRight'), 'coat');
  assert.equal(await page.inputValue('#model'), chosen, 'arrows to the sides do not choose');
  await page.keyboard.press('Tab');
  await page.keyboard.press('Shift+Tab');
  assert.equal(await focused(), 'coat', 'the bar is entered where it was left');
  await page.click('#wind');
  await page.focus('#undo');
  await page.keyboard.press('Enter');
  assert.equal(await focused(), 'redo', 'undo is disabled now, and hands on the focus');
  assert.deepEqual(page.problems, []);
});

test('a button that opens tools names the one in hand; arrow keys, Home and End go through what it opens, but for what is typed', async () => {
  const page = await site.open(`?${plain}&src=plane`, { viewport: { width: 1280, height: 800 } });
  const shown = () => page.$eval('#water', (opener) => [opener.textContent.trim(), opener.getAttribute('aria-label')]);
  const focused = () => page.evaluate(() => document.activeElement.dataset.tool ?? document.activeElement.id);
  await page.click('#water');
  await page.focus('[data-tool=rain]');
  const after = async (key) => {
    await page.keyboard.press(key);
    return focused();
  };
  assert.equal(await after('ArrowRight'), 'hose');
  assert.equal(await after('Home'), 'dry');
  assert.equal(await after('ArrowUp'), 'dry', 'the first is the end');
  assert.equal(await after('ArrowDown'), 'rain');
  await page.focus('#drying');
  const dries = await page.inputValue('#drying');
  assert.equal(await after('ArrowRight'), 'drying');
  assert.notEqual(await page.inputValue('#drying'), dries, 'a slider keeps its own keys');
  await page.focus('#letters input');
  await page.keyboard.type('ab');
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.type('-');
  assert.equal(await page.inputValue('#letters input'), 'a-b');
  await page.click('[data-tool=hose]');
  assert.deepEqual(await shown(), ['Hose', 'Water: Hose']);
  await page.keyboard.press('Escape');
  await page.click('[data-tool=comb]');
  assert.deepEqual(await shown(), ['Water', 'Water']);
  assert.deepEqual(page.problems, []);
});

test('size and wetness of the brush are in the bar, and [ and ] change the size unless they are typed', async () => {
  const page = await site.open(`?${plain}&src=plane`, { viewport: { width: 390, height: 844 } });
  const brush = () => withFur(page, (fur) => [fur.brushRadius, fur.brushFlow]);
  await page.click('#brush');
  for (const slider of await page.$$('#brushing input')) {
    await slider.focus();
    await page.keyboard.press('End');
  }
  const table = await withFur(page, (fur) => fur.settingsTable.filter(({ name }) => ['brushRadius', 'brushFlow'].includes(name)).map(({ max }) => max));
  (await brush()).forEach((value, i) => assert.ok(Math.abs(value - table[i]) < 1e-6));
  await page.keyboard.press('[');
  assert.ok((await brush())[0] < table[0]);
  await page.keyboard.press('Escape');
  await withFur(page, (fur) => fur.shadowRoot.querySelector('canvas').focus());
  const [before] = await brush();
  await page.keyboard.press(']');
  assert.ok((await brush())[0] > before);
  await page.click('#water');
  await page.fill('#letters input', '');
  const [typed] = await brush();
  await page.keyboard.type('[]]');
  assert.deepEqual([(await brush())[0], await page.inputValue('#letters input')], [typed, '[]]']);
  const sizes = await page.$$eval('input:not([type]), select, textarea', (list) => list.map((one) => parseFloat(getComputedStyle(one).fontSize)));
  assert.ok(sizes.every((size) => size >= 16), `phones zoom into smaller type: ${sizes}`);
  assert.deepEqual(page.problems, []);
});

test('a scene says what it shows', async () => {
  assert.deepEqual(Object.keys(captions).sort(), [...sceneNames].sort());
  const page = await site.open(`?${plain}&src=fading`, { viewport: { width: 390, height: 844 } });
  const said = () => page.locator('[role=status]#caption').innerText();
  assert.equal(await said(), captions.fading);
  await page.selectOption('#model', 'sphere');
  await untilShown(page, 'sphere');
  await page.waitForFunction(() => document.getElementById('caption').textContent === '');
  assert.equal(await said(), '');
});

test('the whole screen is taken and given back; without a way to it there is no button', async () => {
  const page = await site.open(`?${plain}&src=plane`);
  await page.click('#fullscreen');
  await page.waitForFunction(() => document.fullscreenElement && document.getElementById('fullscreen').ariaPressed === 'true');
  await page.click('#fullscreen');
  await page.waitForFunction(() => !document.fullscreenElement && document.getElementById('fullscreen').ariaPressed === 'false');
  const without = await site.open(`?${plain}&src=plane`, {
    scripts: [() => Object.defineProperty(Document.prototype, 'fullscreenEnabled', { value: false })],
  });
  assert.equal(await without.isVisible('#fullscreen'), false);
});

test('the embed code shows what is seen on a page of its own', async () => {
  const page = await site.open(`?${plain}&src=torus&preset=velvet&wind=0.25`, { permissions: ['clipboard-read', 'clipboard-write'] });
  await withFur(page, (fur) => { fur.cameraOrbit = '0.7 0.2 4.5'; fur.settings.lightIntensity = 0.5; fur.tool = 'comb'; });
  const state = await withFur(page, (fur) => fur.getState());
  await page.click('#share');
  await page.click('#embed');
  await page.waitForSelector('#messages textarea');
  const code = await page.evaluate(() => navigator.clipboard.readText());
  assert.equal(await page.inputValue('#messages textarea'), code);
  assert.match(code, /<wet-fur src="torus" [^>]*preset="velvet"[^>]*wind="0.25"/);
  const other = await site.open('given.html', {
    prepare: (tab) => tab.route('**/given.html', (route) => route.fulfill({ contentType: 'text/html', body: `<!doctype html>${code}` })),
  });
  assert.deepEqual(JSON.parse(await withFur(other, (fur) => fur.getState())), JSON.parse(state));
  assert.equal(await withFur(other, (fur) => fur.tool), 'comb');
  assert.deepEqual(page.problems, []);
});

test('where dark is liked the page is dark, and a link leaves that to whoever opens it', async () => {
  const page = await site.open(`?${plain}&src=plane`, { colorScheme: 'dark', permissions: ['clipboard-read', 'clipboard-write'] });
  const isDark = (color) => color.match(/\d+/g).slice(0, 3).every((part) => part < 100);
  assert.ok(isDark(await page.$eval('#bar .group', (bar) => getComputedStyle(bar).backgroundColor)));
  assert.equal(await withFur(page, (fur) => fur.backgroundBottom), '#17191c');
  assert.equal(await withFur(page, (fur) => fur.canUndo), false);
  await page.click('#share');
  await page.click('#link');
  await page.waitForSelector('#messages .message');
  const other = await site.open(new URL(await page.evaluate(() => navigator.clipboard.readText())).search);
  assert.equal(await withFur(other, (fur) => fur.backgroundBottom), '#e8e2d8');
});

test('where dark is liked, too, the otter takes its light along when it goes, and undo leads to nothing before it', async () => {
  const dark = { colorScheme: 'dark' };
  const settingsOf = (page) => withFur(page, (fur) => JSON.parse(fur.getState()).settings);
  const wanted = await settingsOf(await site.open(`?${plain}&src=bunny`, dark));
  const page = await site.open(`?${plain}&src=otter`, dark);
  assert.equal(await withFur(page, (fur) => fur.canUndo), false);
  assert.notDeepEqual(await settingsOf(page), wanted);
  await withFur(page, (fur) => new Promise((resolve) => {
    fur.addEventListener('load', resolve, { once: true });
    fur.src = 'bunny';
  }));
  assert.deepEqual(await settingsOf(page), wanted);
});
