// Where letters are first placed.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { roomForText } from '../../web/letters.js';

const area = { left: 100, top: 40, width: 800, height: 600 };
/** Of the letters' rectangle: corners and middles of its sides. */
const edges = ({ x, y, size }, wide) => [-1, 0, 1].flatMap((i) => [-1, 0, 1].map((j) => [x + (i * wide * size) / 2, y + (j * 0.75 * size) / 2]));
const inDisc = (cx, cy, r) => (x, y) => Math.hypot(x - cx, y - cy) < r;
/** A model whose atlas lies over the area, in pieces that are so far apart in it. */
const spots = (isOn, apart = () => 0) => (x, y) => (isOn(x, y) ? { u: (x - area.left) / area.width + apart(x, y), v: (y - area.top) / area.height } : null);

test('letters are first placed all on the model, as large as fit there', () => {
  const isOn = inDisc(620, 300, 150), wide = 2.6;
  const place = roomForText(wide, area, spots(isOn));
  assert.ok(edges(place, wide).every(([x, y]) => isOn(x, y)), JSON.stringify(place));
  // As wide as that they would be a chord of the disc, a little above its middle or below.
  assert.ok(place.size > 60, `${place.size} is small`);
  const larger = { ...place, size: 1.6 * place.size };
  assert.ok(!edges(larger, wide).every(([x, y]) => isOn(x, y)));
});

test('on a large model they are in the middle, no larger than most of what is free', () => {
  const { x, y, size } = roomForText(2, area, spots(() => true));
  assert.ok(Math.abs(x - 500) < 10 && Math.abs(y - 340) < 10, `${x}, ${y}`);
  assert.ok(size <= 150 && size > 140, `${size}`);
});

test('they are on one piece of the model, not on a head and the back behind it', () => {
  const isOn = inDisc(500, 340, 250), split = 450, wide = 2.6;
  const { x, size } = roomForText(wide, area, spots(isOn, (at) => (at < split ? 0 : 0.4)));
  assert.ok(x - (wide * size) / 2 > split, `${x} and ${size} cross ${split}`);
  // Half of what fits on the whole, at least, and three quarters of that to be nearer to the middle.
  assert.ok(size > 0.37 * roomForText(wide, area, spots(isOn)).size);
});

test('they are on several pieces where each has room for small letters alone', () => {
  const isOn = inDisc(500, 340, 250), whole = roomForText(2.6, area, spots(isOn));
  assert.deepEqual(roomForText(2.6, area, spots(isOn, (x) => 0.4 * Math.floor(x / 60))), whole);
});

test('where there is no room for them they are in the middle of the area', () => {
  assert.deepEqual(roomForText(2, area, () => null), { x: 500, y: 340, size: 150 });
});
