// Where letters are first placed.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { roomForText } from '../../web/letters.js';

const area = { left: 100, top: 40, width: 800, height: 600 };
/** Of the letters' rectangle: corners and middles of its sides. */
const edges = ({ x, y, size }, wide) => [-1, 0, 1].flatMap((i) => [-1, 0, 1].map((j) => [x + (i * wide * size) / 2, y + (j * 0.75 * size) / 2]));
const inDisc = (cx, cy, r) => (x, y) => Math.hypot(x - cx, y - cy) < r;

test('letters are first placed all on the model, as large as fit there', () => {
  const isOn = inDisc(620, 300, 150), wide = 2.6;
  const place = roomForText(wide, area, isOn);
  assert.ok(edges(place, wide).every(([x, y]) => isOn(x, y)), JSON.stringify(place));
  // As wide as that they would be a chord of the disc, a little above its middle or below.
  assert.ok(place.size > 60, `${place.size} is small`);
  const larger = { ...place, size: 1.6 * place.size };
  assert.ok(!edges(larger, wide).every(([x, y]) => isOn(x, y)));
});

test('on a large model they are in the middle, no larger than most of what is free', () => {
  const { x, y, size } = roomForText(2, area, () => true);
  assert.ok(Math.abs(x - 500) < 10 && Math.abs(y - 340) < 10, `${x}, ${y}`);
  assert.ok(size <= 150 && size > 140, `${size}`);
});

test('where there is no room for them they are in the middle of the area', () => {
  assert.deepEqual(roomForText(2, area, () => false), { x: 500, y: 340, size: 150 });
});
