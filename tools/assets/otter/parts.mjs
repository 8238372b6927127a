// What the otter has beside its body: eyeballs, lids and claws.
import { turnedBody, withNormals } from '../animal.mjs';
import { add, cross, scaled, sub, unit } from '../vectors.mjs';
import { eye, fore, hind, toes } from './shape.mjs';

const { PI, cos, sin } = Math;
const onSide = (side, [x, y, z]) => [side * x, y, z];
const numbered = (name, side) => name + (side > 0 ? 'L' : 'R');

/** Where the left eye looks at rest. */
const gaze = unit([0.55, 0.12, 0.83]);

function eyeball(side) {
  const way = onSide(side, gaze), across = unit(cross([0, 1, 0], way)), up = cross(way, across), centre = onSide(side, eye.at);
  const at = (angle) => add(centre, scaled(way, -eye.radius * cos(angle)));
  const rings = Array.from({ length: 9 }, (_, i) => ((i + 1) * PI) / 10).map((angle) => ({ at: at(angle), radius: [eye.radius * sin(angle), eye.radius * sin(angle)] }));
  const body = turnedBody(rings, [across, up], 16, [at(0), at(PI)]);
  const off = (p, axis) => sub(p, centre).reduce((sum, x, k) => sum + x * axis[k], 0) / eye.radius;
  // Its picture as seen from the front.
  return { ...body, uv1: body.positions.map((p) => [0.5 + 0.49 * off(p, across), 0.5 - 0.49 * off(p, up)]), joint: numbered('eye', side), material: 'eye' };
}

/** A shell round the eyeball, `from` to `to` in degrees above the front, about the axis on which it turns. */
function lid(side, name, from, to) {
  const columns = 10, rows = 4, positions = [], cells = [], centre = onSide(side, eye.at);
  const number = (layer, i, j) => (layer * (rows + 1) + j) * (columns + 1) + i;
  for (const radius of [eye.radius * 1.12, eye.radius * 1.02])
    for (let j = 0; j <= rows; ++j) for (let i = 0; i <= columns; ++i) {
      const along = (-84 + (168 * i) / columns) * (PI / 180), angle = (from + ((to - from) * j) / rows) * (PI / 180);
      positions.push(add(centre, scaled([side * sin(along), cos(along) * sin(angle), cos(along) * cos(angle)], radius)));
    }
  const quad = (a, b, c, d, flip) => cells.push(...(flip === (side < 0) ? [[a, b, c], [a, c, d]] : [[a, c, b], [a, d, c]]));
  for (let j = 0; j < rows; ++j) for (let i = 0; i < columns; ++i)
    for (const layer of [0, 1]) quad(number(layer, i, j), number(layer, i + 1, j), number(layer, i + 1, j + 1), number(layer, i, j + 1), layer === 1);
  for (let i = 0; i < columns; ++i) for (const j of [0, rows]) quad(number(0, i, j), number(0, i + 1, j), number(1, i + 1, j), number(1, i, j), j === 0);
  for (let j = 0; j < rows; ++j) for (const i of [0, columns]) quad(number(0, i, j), number(0, i, j + 1), number(1, i, j + 1), number(1, i, j), i === columns);
  return { ...withNormals({ positions, cells }), joint: numbered(name, side), material: 'lids' };
}

function claw(side, { middle, to }) {
  const tip = onSide(side, to), way = unit(sub(tip, onSide(side, middle))), across = unit(cross([0, 1, 0], way)), size = to[3];
  const at = (t) => add(add(tip, scaled(way, size * (0.3 + 1.75 * t))), [0, size * (0.45 - 1.05 * t * t), 0]);
  const rings = [0, 0.35, 0.7, 0.92].map((t) => ({ at: at(t), radius: [0.36, 0.46].map((r) => r * size * Math.sqrt(1 - t)) }));
  return { ...turnedBody(rings, [across, cross(way, across)], 6, [at(-0.1), at(1)]), root: tip, material: 'claws' };
}

/** [{ positions, normals, cells, material, joint, or root: the place of the skin with which it goes }] */
export const parts = () => [1, -1].flatMap((side) => [
  eyeball(side), lid(side, 'lidUpper', 56, 160), lid(side, 'lidLower', -150, -34),
  ...[...toes(fore), ...toes(hind)].map((toe) => claw(side, toe)),
]);
