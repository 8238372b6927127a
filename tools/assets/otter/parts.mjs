// What the otter has beside its body: eyeballs, lids and claws.
import { turnedBody } from '../animal.mjs';
import { eyeball, eyeOf, lid } from '../eyes.mjs';
import { add, cross, scaled, sub, unit } from '../vectors.mjs';
import { eye, fore, hind, toes } from './shape.mjs';

const onSide = (side, [x, y, z]) => [side * x, y, z];
const numbered = (name, side) => name + (side > 0 ? 'L' : 'R');

// Where the edges of the lids are, degrees above the gaze, at so many from the inner to the outer corner.
const open = (t) => Math.max(0, 1 - (t / 56) ** 2);
/** Those of both sides; `edgesAt(t)`: [upper, lower]. */
export const edgesAt = (t) => lids.map(({ edge }) => edge(t));
const lids = [
  { name: 'lidUpper', sign: 1, edge: (t) => -2 + 40 * open(t - 3) ** 0.8, outer: 1.12 },
  { name: 'lidLower', sign: -1, edge: (t) => -2 - 30 * open(t + 3) ** 0.9, outer: 1.09 },
];

function eyes(side) {
  const frame = eyeOf(side, eye);
  return [
    { ...eyeball(frame, { rings: 10, segments: 16 }), joint: numbered('eye', side), material: 'eye' },
    ...lids.map(({ name, ...which }) => ({ ...lid(frame, { ...which, columns: 14, rows: 6 }), joint: numbered(name, side), material: 'lids' })),
  ];
}

function claw(side, { middle, to }) {
  const tip = onSide(side, to), way = unit(sub(tip, onSide(side, middle))), across = unit(cross([0, 1, 0], way)), size = to[3];
  const at = (t) => add(add(tip, scaled(way, size * (0.2 + 1.45 * t))), [0, size * (0.45 - 1.05 * t * t), 0]);
  const rings = [0, 0.35, 0.7, 0.92].map((t) => ({ at: at(t), radius: [0.42, 0.5].map((r) => r * size * Math.sqrt(1 - t)) }));
  return { ...turnedBody(rings, [across, cross(way, across)], 6, [at(-0.1), at(1)]), root: tip, material: 'claws' };
}

/** [{ positions, normals, cells, material, joint, or root: the place of the skin with which it goes }] */
export const parts = () => [1, -1].flatMap((side) => [...eyes(side), ...[...toes(fore), ...toes(hind)].map((toe) => claw(side, toe))]);
