// Figures of a page share its frames: none waits for ever, the one that a person turns to comes first.
import assert from 'node:assert/strict';
import { test } from 'node:test';

const frames = [];
let clock = 0;
globalThis.requestAnimationFrame = (work) => frames.push(work);
globalThis.cancelAnimationFrame = () => { frames.length = 0; };
Object.assign(globalThis, { innerWidth: 400, innerHeight: 300 });
performance.now = () => clock;

const { askFrame, asksFrame, cancelFrame, LoadingTurn } = await import('../../web/schedule.js');

/** A canvas so far down the page that a pointer may be over. */
const canvasAt = (top, hovered = false) => ({ matches: () => hovered, getBoundingClientRect: () => ({ top, bottom: top + 100, left: 0, right: 100 }) });
/** Figures that go on for ever, each frame taking so many milliseconds; `log`: whose frames come. */
function figures(names, milliseconds, hovered) {
  const log = [];
  const all = names.map((name) => {
    const one = { canvas: canvasAt(0, name === hovered), work: () => {
      clock += milliseconds;
      log.push(name);
      askFrame(one);
    } };
    return one;
  });
  all.forEach(askFrame);
  return { all, log, stop: () => all.forEach(cancelFrame) };
}
const pass = (count) => { for (let i = 0; i < count; i++) frames.splice(0).forEach((work) => work(clock)); };

test('figures that fit into a frame all have it, and only one frame is asked for', () => {
  const { log, stop } = figures(['a', 'b', 'c'], 1);
  assert.equal(frames.length, 1);
  pass(2);
  assert.deepEqual(log, ['a', 'b', 'c', 'a', 'b', 'c']);
  stop();
  assert.equal(frames.length, 0);
});

test('where they do not fit each has its turn, as often as the others', () => {
  const { log, stop } = figures(['a', 'b', 'c', 'd', 'e'], 8);
  pass(10);
  const counts = ['a', 'b', 'c', 'd', 'e'].map((name) => log.filter((one) => one === name).length);
  assert.deepEqual(counts, [4, 4, 4, 4, 4]);
  stop();
});

test('the one under the pointer has every frame, first, and the others share the rest', () => {
  const { log, stop } = figures(['a', 'b', 'c'], 8, 'c');
  pass(4);
  assert.deepEqual(log, ['c', 'a', 'c', 'b', 'c', 'a', 'c', 'b']);
  stop();
});

test('one alone has every frame, however long it takes; one that is withdrawn has none', () => {
  const { all: [one], log, stop } = figures(['a'], 100);
  pass(3);
  assert.equal(log.length, 3);
  assert.ok(asksFrame(one));
  stop();
  pass(1);
  assert.equal(log.length, 3);
  assert.ok(!asksFrame(one));
});

test('figures are loaded one after another: first the one under the pointer, then what the window shows from its top, then the others as they came', async () => {
  const order = [], first = new LoadingTurn(canvasAt(0));
  await first.take();
  const places = { far: canvasAt(2000), farther: canvasAt(3000), lower: canvasAt(250), shown: canvasAt(150), pointed: canvasAt(5000, true) };
  const waiting = Object.entries(places).map(async ([name, canvas]) => {
    const turn = new LoadingTurn(canvas);
    await turn.take();
    order.push(name);
    await null;
    assert.equal(order.at(-1), name);
    turn.end();
    turn.end();
  });
  await null;
  assert.deepEqual(order, []);
  first.end();
  await Promise.all(waiting);
  assert.deepEqual(order, ['pointed', 'shown', 'lower', 'far', 'farther']);
});

test('what the window does not show waits for what it shows, whose file is on its way, and goes if that does not come', async () => {
  const shown = new LoadingTurn(canvasAt(0)), far = new LoadingTurn(canvasAt(2000));
  let gone = false;
  const going = far.take().then(() => { gone = true; });
  for (let i = 0; i < 3; ++i) await new Promise((resolve) => setTimeout(resolve, 110));
  assert.equal(gone, false);
  await shown.take();
  shown.end();
  await going;
  far.end();
  const missing = new LoadingTurn(canvasAt(0)), last = new LoadingTurn(canvasAt(2000)), came = last.take();
  missing.end();
  await came;
  last.end();
});

test('what is scrolled into the window need not wait for what it showed before', async () => {
  const place = { top: 2000 }, shown = new LoadingTurn(canvasAt(0));
  const scrolled = new LoadingTurn({ matches: () => false, getBoundingClientRect: () => ({ ...place, bottom: place.top + 100, left: 0, right: 100 }) });
  const came = scrolled.take();
  await new Promise((resolve) => setTimeout(resolve, 30));  // by then it has been held back
  place.top = 100;
  await came;
  scrolled.end();
  shown.end();
});
