// The elements that go with <wet-fur> in a text, on one page.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { axeFindings, root, startBrowser } from './support.mjs';

const site = startBrowser();
const html = readFileSync(join(root, 'tests/web/companions.html'), 'utf8');
const policy = "default-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self'; script-src 'self' 'wasm-unsafe-eval'; require-trusted-types-for 'script'";
let page;

/** The page with another body. */
const withBody = (body) => html.replace(/<body>.*<\/body>/s, `<body>${body}</body>`);
const open = (text, options = {}) => site.open('companions-page.html', {
  viewport: { width: 900, height: 700 }, keep: true,
  prepare: (tab) => tab.route('**/companions-page.html', (route) => route.fulfill({ contentType: 'text/html', body: text, headers: { 'Content-Security-Policy': policy } })),
  ...options,
});
/** Evaluates in the page; elements with an id are globals there. */
const see = (work, argument) => page.evaluate(work, argument);
const until = (work) => page.waitForFunction(work);
const lighter = () => addEventListener('DOMContentLoaded', () => {
  for (const fur of document.querySelectorAll('wet-fur')) customElements.whenDefined('wet-fur').then(() => Object.assign(fur.settings, { layers: 8, tileSize: '64', dryRate: 0 }));
});

before(async () => { page = await open(html, { scripts: [lighter] }); });
after(() => page?.context().close());

test('a page with companions alone gets <wet-fur> with them; all of them know their figure, label, range and unit', async () => {
  await until(() => window.strands.shadowRoot.querySelector('output').value !== '–');
  const seen = await see(() => {
    const range = (id) => {
      const input = document.getElementById(id).shadowRoot.querySelector('input');
      return [input.labels[0].textContent, Number(input.min), Number(input.max), Number(input.step), input.ariaValueText];
    };
    const texts = (id, selector) => [...document.getElementById(id).shadowRoot.querySelectorAll(selector)].map(({ textContent }) => textContent);
    return {
      curl: range('curl'), wet: range('wet'), sun: range('sun'), theta: range('theta'),
      view: texts('view', '.pick'), coats: texts('coat', 'option').length, fins: window.fins.value, tip: window.tip.value === fig.settings.tipColor,
      dry: window.dry.shadowRoot.querySelector('slot').textContent, notices: texts('steps', '[part=error]'), figure: document.getElementById('curl').figure === window.fig,
    };
  });
  assert.deepEqual(seen, {
    curl: ['Curl', 0, 1, 0.01, '0.25'], wet: ['Wetness', 0, 1, 0.01, '0 %'], sun: ['Light direction', -3.1416, 3.1416, 0.1, '-42°'], theta: ['Bend', 0, 1.5, 0.05, '46°'],
    view: ['Picture', 'Skin', 'Tangents'], coats: 11, fins: true, tip: true, dry: 'Dry', notices: [''], figure: true,
  });
});

test('sliders and choices are worked by keys, set the figure, and follow it', async () => {
  await page.locator('#curl input').focus();
  await page.keyboard.press('ArrowRight');
  assert.ok(Math.abs(await see(() => fig.settings.curl) - 0.26) < 1e-6);
  await see(() => { fig.settings.curl = 0.5; });
  assert.equal(await see(() => document.getElementById('curl').value), 0.5);
  await page.locator('#view').getByRole('radio', { name: 'Skin' }).focus();
  await page.keyboard.press('ArrowRight');
  assert.equal(await see(() => fig.settings.view), 'tangents');
  await see(() => { fig.settings.view = 'final'; });
  assert.equal(await page.locator('#view').getByRole('radio', { name: 'Picture' }).isChecked(), true);
  await page.locator('#fins').getByLabel('Fins').click();
  assert.equal(await see(() => fig.settings.fins), false);
  await page.locator('#coat select').selectOption({ label: 'Wool' });
  assert.equal(await see(() => fig.preset), 'wool');
});

test('a choice may call a method with its values; a slider keeps what a person has set while its tag says nothing new', async () => {
  await see(() => {
    const choice = Object.assign(document.createElement('wet-fur-choice'), { id: 'soak', method: 'setWetness' });
    choice.setAttribute('values', '0=Dry, 0.5=Half wet');
    choice.setAttribute('for', 'fig');
    document.getElementById('controls').append(choice);
  });
  await page.locator('#soak select').selectOption({ label: 'Half wet' });
  await until(() => Math.abs(fig.meanWetness - 0.5) < 1e-3);
  await page.locator('#soak select').selectOption({ label: 'Dry' });
  await until(() => fig.meanWetness === 0);
  await page.locator('#theta input').focus();
  await page.keyboard.press('End');
  await see(() => { theta.label = 'How far it bends'; });
  await until(() => theta.shadowRoot.querySelector('label').textContent === 'How far it bends');
  assert.equal(await see(() => theta.value), 1.5);
  await see(() => theta.setAttribute('value', '0.6'));
  await until(() => theta.value === 0.6);
});

test('a drag at the slider for water is one step of undo', async () => {
  const wetness = await see(() => {
    const input = document.getElementById('wet').shadowRoot.querySelector('input');
    const out = [];
    for (const value of [0.2, 0.5, 0.6]) {
      input.value = value;
      input.dispatchEvent(new Event('input', { bubbles: true, composed: true }));
      out.push(fig.meanWetness);
    }
    input.dispatchEvent(new Event('change'));
    fig.undo();
    return [...out, fig.meanWetness].map((one) => Number(one.toFixed(3)));
  });
  assert.deepEqual(wetness, [0.2, 0.5, 0.6, 0]);
});

test('a button calls the method with its arguments, and tells what it throws', async () => {
  await page.getByRole('button', { name: 'Splash' }).click();
  assert.ok(await see(() => fig.meanWetness) > 0);
  await page.getByRole('button', { name: 'Dry', exact: true }).click();
  assert.equal(await see(() => fig.meanWetness), 0);
  await see(() => Object.assign(window.splash, { method: 'replay' }).setAttribute('args', '["{}"]'));
  await until(() => window.splash.shadowRoot.querySelector('[part=error]').textContent === '');
  await page.getByRole('button', { name: 'Splash' }).click();
  await until(() => /^Replay: ./.test(window.splash.shadowRoot.querySelector('[part=error]').textContent));
});

test('two states are pictures of the moment; the figure stays as it is, and undo leads where it led', async () => {
  await see(() => {
    fig.settings.view = 'final';
    states.scrollIntoView({ block: 'center' });
  });
  const pixel = (side) => see((name) => {
    const canvas = states.shadowRoot.querySelector(`.${name} canvas`);
    return [...canvas.getContext('2d').getImageData(canvas.width / 2, canvas.height / 2, 1, 1).data].join();
  }, side);
  await until(() => states.shadowRoot.querySelector('.after canvas').width > 300);
  const [skin, fur] = [await pixel('before'), await pixel('after')];
  assert.notEqual(skin, fur);
  const seen = await see(() => new Promise((resolve) => {
    states.addEventListener('picture-change', () => {
      fig.undo();
      resolve({ view: fig.settings.view, curl: fig.settings.curl });
    }, { once: true });
    fig.settings.curl = 0.7;
    fig.settings.wind = 0.2;
    fig.settings.wind = 0;
  }));
  assert.equal(seen.view, 'final');
  assert.ok(Math.abs(seen.curl - 0.7) < 1e-6, 'undo took the wind back, no state of a picture');
});

test('a state may be seen from elsewhere; the figure is not', async () => {
  const orbit = await see(() => {
    states.scrollIntoView({ block: 'center' });
    return fig.cameraOrbitText;
  });
  const taken = (before) => see((text) => new Promise((resolve) => {
    states.addEventListener('picture-change', () => {
      const data = (side) => states.shadowRoot.querySelector(`.${side} canvas`).toDataURL();
      resolve(data('before') === data('after'));
    }, { once: true });
    states.setAttribute('before', text);
  }), before);
  const after = await see(() => states.getAttribute('after')), was = await see(() => states.getAttribute('before'));
  assert.ok(await taken(after), 'the same of both');
  assert.ok(!await taken(JSON.stringify({ ...JSON.parse(after), cameraOrbit: '100deg 40deg 3' })), 'the first from elsewhere');
  assert.equal(await see(() => fig.cameraOrbitText), orbit);
  await taken(was);
});

test('states that are asked for while pictures are taken are the ones that are shown', async () => {
  const same = await see(() => new Promise((resolve) => {
    states.scrollIntoView({ block: 'center' });
    const was = states.getAttribute('before');
    fig.toBlob = (...options) => {  // the first of the two pictures
      delete fig.toBlob;
      const picture = fig.toBlob(...options);
      states.addEventListener('picture-change', () => {
        const data = (side) => states.shadowRoot.querySelector(`.${side} canvas`).toDataURL();
        resolve(data('before') === data('after'));
        states.setAttribute('before', was);
      }, { once: true });
      states.setAttribute('before', states.getAttribute('after'));
      return picture;
    };
    states.setAttribute('before', '{"view": "tangents"}');
  }));
  assert.ok(same);
});

test('the divider moves by key and pointer, the other way round where lines begin at the right', async () => {
  const handle = page.locator('#two [part=divider]');
  await handle.focus();
  await page.keyboard.press('ArrowRight');
  assert.equal(await see(() => two.position), 52);
  await page.keyboard.press('End');
  assert.equal(await handle.getAttribute('aria-valuenow'), '100');
  await see(() => {
    two.position = 50;
    two.dir = 'rtl';
    two.position = 50;
  });
  await page.keyboard.press('ArrowRight');
  assert.equal(await see(() => two.position), 48);
  const box = await page.locator('#two').boundingBox(), at = await handle.boundingBox();
  assert.ok(Math.abs(at.x + at.width / 2 - (box.x + 0.52 * box.width)) < 2);
  await see(() => {
    two.dir = 'ltr';
    two.position = 50;
  });
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width * 0.25, box.y + box.height / 2);
  await page.mouse.up();
  assert.ok(Math.abs(await see(() => two.position) - 25) < 2);
});

test('of two figures side by side one that is turned turns the other', async () => {
  await see(() => window.two.scrollIntoView({ block: 'center' }));
  await until(() => window.left.loaded && window.right.loaded);
  await page.locator('#right').focus();
  await see(() => {
    window.right.shadowRoot.querySelector('canvas').focus();
    window.right.cameraOrbit = '40deg 20deg 4';
  });
  await until(() => window.left.cameraOrbitText === window.right.cameraOrbitText);
  assert.match(await see(() => window.left.cameraOrbitText), /^0\.69/);
});

test('a plot draws what the equations give, and follows the figure and its sliders', async () => {
  await see(() => window.clump.scrollIntoView({ block: 'center' }));
  await until(() => window.clump.shadowRoot.querySelectorAll('path.curve').length === 4);  // two curves, and two in the legend
  await see(() => { wet.value = 0.5; });  // the figure is out of sight
  await until(() => /w is 0.5/.test(window.clump.shadowRoot.querySelector('svg').getAttribute('aria-label')));
  await page.locator('#clump summary').click();
  const rows = await see(() => [...window.clump.shadowRoot.querySelectorAll('tbody tr')].map((row) => [...row.children].map((cell) => Number(cell.textContent))));
  const expected = await see(async () => {
    const { equations } = await (await import('./core.js')).loadCore();
    return Array.from({ length: 11 }, (_, i) => [i / 10, equations.clumpProfile(i / 10, 0.5, 16), equations.wetDarkening(i / 10, 0.7)]);
  });
  rows.forEach((row, i) => row.forEach((value, j) => assert.ok(Math.abs(value - expected[i][j]) < 0.006, `row ${i}: ${row} is not ${expected[i]}`)));
  const shape = () => see(() => window.bend.shadowRoot.querySelector('path.c0').getAttribute('d'));
  const before = await shape();
  await page.locator('#theta input').focus();
  await page.keyboard.press('ArrowLeft');
  assert.notEqual(await shape(), before);
});

test('steps change the figure as one reads, and back; the current one is marked', async () => {
  const at = (id) => see((name) => document.getElementById(name).scrollIntoView({ block: 'center' }), id);
  await see(() => document.getElementById('steps').scrollIntoView({ block: 'center' }));
  await until(() => document.getElementById('shown').loaded);
  await see(() => scrollTo(0, 0));
  await until(() => document.getElementById('steps').current === -1);
  const before = await see(() => Number(window.shown.settings.density.toFixed(2)));
  assert.notEqual(before, 0.9);
  await at('three');
  await until(() => document.getElementById('three').ariaCurrent === 'step' && Math.abs(window.shown.meanWetness - 0.5) < 0.05);
  const now = () => see(() => [window.shown.settings.view, Number(window.shown.settings.density.toFixed(2)), document.querySelectorAll('[aria-current]').length]);
  assert.deepEqual(await now(), ['final', 0.9, 1]);
  await at('one');
  await until(() => document.getElementById('steps').current === 0);
  assert.deepEqual(await now(), ['skin', before, 1], 'density is as it was before the steps');
  await see(() => scrollTo(0, 0));
  await until(() => document.getElementById('steps').current === -1);
  assert.equal((await now())[2], 0);
});

test('companions follow a figure that is exchanged, removed or moved', async () => {
  await see(() => {
    window.old = fig;
    fig.replaceWith(Object.assign(document.createElement('wet-fur'), { id: 'fig', src: 'plane', quality: 'low', loading: 'eager' }));
  });
  await until(() => document.getElementById('fig').loaded);
  await page.locator('#curl input').focus();
  await page.keyboard.press('Home');
  assert.equal(await see(() => document.getElementById('fig').settings.curl), 0);
  await see(() => document.getElementById('fig').remove());
  const notice = () => see(() => document.getElementById('curl').shadowRoot.querySelector('[part=error]').textContent);
  await until(() => document.getElementById('curl').figure === null);
  assert.match(await notice(), /no figure with the id “fig”/);
  assert.equal(await page.locator('#curl input').isDisabled(), true);
  await see(() => document.querySelector('main').prepend(Object.assign(document.createElement('wet-fur'), { id: 'fig', src: 'plane', quality: 'low' })));
  await until(() => document.getElementById('curl').figure !== null);
  assert.equal(await notice(), '');
});

test('axe-core finds nothing, in light and in dark', async () => {
  for (const colorScheme of ['light', 'dark']) {
    await page.emulateMedia({ colorScheme });
    assert.deepEqual(await axeFindings(page), [], colorScheme);
  }
});

test('a choice of lights shows the one that the figure has, and none when something of it was changed', async () => {
  const seen = await see(async () => {
    const choice = document.createElement('wet-fur-choice');
    for (const [name, value] of Object.entries({ for: 'fig', setting: 'lightRig', values: 'daylight,night' })) choice.setAttribute(name, value);
    document.body.append(choice);
    const shown = async (set) => {
      set();
      for (let i = 0; i < 3; i++) await new Promise((resolve) => { requestAnimationFrame(resolve); });
      return choice.value;
    };
    const out = [await shown(() => {}), await shown(() => { fig.lightRig = 'night'; }), await shown(() => { fig.settings.lightYaw = 2; }), await shown(() => { fig.lightRig = 'daylight'; })];
    choice.remove();
    return out;
  });
  assert.deepEqual(seen, ['daylight', 'night', undefined, 'daylight']);
});

test('a read-out of the time between pictures shows a dash as long as none is known', async () => {
  const seen = await see(() => ['left', 'right'].map((id) => {
    const figure = document.getElementById(id), readout = document.createElement('wet-fur-readout');
    Object.defineProperty(figure, 'stats', { value: { frameTime: id === 'left' ? 0 : 12.5 }, configurable: true });
    for (const [name, value] of Object.entries({ for: id, value: 'frameTime', digits: 1 })) readout.setAttribute(name, value);
    document.body.append(readout);
    const text = readout.shadowRoot.querySelector('output').value;
    readout.remove();
    delete figure.stats;
    return text;
  }));
  assert.deepEqual(seen, ['–', '12.5\u00a0ms']);
});

test('companions that come and go leave no nodes and no listeners behind', async () => {
  const session = await page.context().newCDPSession(page);
  const counted = async () => {
    await session.send('HeapProfiler.collectGarbage');
    const { nodes, jsEventListeners } = await session.send('Memory.getDOMCounters');
    return [nodes, jsEventListeners];
  };
  const tags = [
    ['slider', { setting: 'curl' }], ['choice', { setting: 'view' }], ['button', { method: 'shake' }], ['readout', { value: 'frameTime' }],
    ['compare', { before: '{}', after: '{}' }], ['steps', {}], ['plot', { equations: '[{"f": "furShadow", "args": ["x", 0.5, 0.5]}]' }],
  ];
  const comeAndGo = (times) => see(async ([given, n]) => {
    for (let i = 0; i < n; i++) {
      const all = given.map(([tag, attributes]) => {
        const one = document.createElement(`wet-fur-${tag}`);
        for (const [name, value] of Object.entries({ for: 'fig', ...attributes })) one.setAttribute(name, value);
        return one;
      });
      document.body.append(...all);
      await new Promise((resolve) => { requestAnimationFrame(resolve); });
      for (const one of all) one.remove();
      await new Promise((resolve) => { setTimeout(resolve); });
    }
  }, [tags, times]);
  await comeAndGo(3);
  const [nodes, listeners] = await counted();
  await comeAndGo(20);
  const [nodesAfter, listenersAfter] = await counted();
  assert.ok(nodesAfter <= nodes + 60 && listenersAfter <= listeners + 10, `${nodes} nodes became ${nodesAfter}, ${listeners} listeners ${listenersAfter}`);
});

test('what is set before an element is on the page is taken over', async () => {
  const seen = await see(async () => {
    const slider = Object.assign(document.createElement('wet-fur-slider'), { value: 0.25 });
    const compare = Object.assign(document.createElement('wet-fur-compare'), { position: 30 });
    document.querySelector('main').append(slider, compare);
    const out = [slider.value, compare.position];
    slider.remove();
    compare.remove();
    return out;
  });
  assert.deepEqual(seen, [0.25, 30]);
});

test('nothing on the page breaks its policy, and nothing goes wrong', async () => {
  assert.deepEqual(page.problems, []);
  assert.deepEqual(await see(() => window.violations), []);
});

const mistakes = [
  ['<wet-fur-slider setting="curls"></wet-fur-slider>', /There is no setting “curls”/],
  ['<wet-fur-slider setting="view"></wet-fur-slider>', /“view” is no number/],
  ['<wet-fur-slider setting="curl" min="2"></wet-fur-slider>', /min 2 is not less than max 1/],
  ['<wet-fur-slider setting="curl" max="a lot"></wet-fur-slider>', /max="a lot" is not a number/],
  ['<wet-fur-choice setting="view" method="act"></wet-fur-choice>', /of a setting or of a method/],
  ['<wet-fur-choice setting="curl"></wet-fur-choice>', /needs values/],
  ['<wet-fur-button method="insertAdjacentHTML" args=\'["beforeend", "<b>"]\'></wet-fur-button>', /no method “insertAdjacentHTML” to call/],
  ['<wet-fur-button method="shake" args="[1"></wet-fur-button>', /args is not JSON/],
  ['<wet-fur-readout value="constructor"></wet-fur-readout>', /no value “constructor”/],
  ['<wet-fur-compare for="fig" before=\'{"src": "torus"}\'></wet-fur-compare>', /put two figures/],
  ['<wet-fur-compare><p>One</p></wet-fur-compare>', /needs two figures/],
  ['<wet-fur-steps><section data-set=\'{"viw": "skin"}\'>A</section></wet-fur-steps>', /no setting “viw”/],
  ['<wet-fur-steps><section data-call=\'[["remove"]]\'>A</section></wet-fur-steps>', /no method “remove”/],
  ['<wet-fur-plot equations=\'[{"f": "nothing"}]\'></wet-fur-plot>', /no equation “nothing”/],
  ['<wet-fur-plot equations=\'[{"f": "furShadow", "args": ["y"]}]\'></wet-fur-plot>', /neither x nor a parameter/],
  ['<wet-fur-readout for="elsewhere" value="wetness"></wet-fur-readout>', /no figure with the id “elsewhere”/],
];
test('each mistake in a tag stands in the element as text', async () => {
  // All of it is in the window: a plot asks for its equations when it comes near.
  const viewport = { width: 900, height: 2000 };
  const other = await open(withBody(`<wet-fur id="fig" src="plane" loading="lazy" reveal="manual"></wet-fur>${mistakes.map(([tag]) => tag).join('\n')}`), { wait: false, viewport });
  try {
    const texts = () => other.evaluate(() => [...document.body.children].slice(1).map((one) => one.shadowRoot?.querySelector('[part=error]')?.textContent ?? ''));
    await other.waitForFunction((n) => [...document.body.children].slice(1).filter((one) => one.shadowRoot?.querySelector('[part=error]')?.textContent).length === n, mistakes.length);
    (await texts()).forEach((text, i) => assert.match(text, mistakes[i][1], mistakes[i][0]));
  } finally {
    await other.context().close();
  }
});
