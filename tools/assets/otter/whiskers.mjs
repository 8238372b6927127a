// Whiskers on the pads of the muzzle, on brow, cheek and chin, as steps for assets/Dress.h.
import { surfaceOf } from '../nets.mjs';
import { add, dot, scaled, unit } from '../vectors.mjs';
import { eye, solid } from './shape.mjs';

const { onSurface, normal } = surfaceOf(solid);
const { PI, cos, sin } = Math;
const degrees = PI / 180;
const text = (list) => list.map((x) => Number(x.toFixed(4))).join(' ');

/** One near p on the skin, that leaves it towards `way`, but never flat; decimetres. */
function whisker(fit, colour, length, width, p, way) {
  const at = onSurface(p, 8), n = normal(at), straight = unit(way), out = unit(add(straight, scaled(n, Math.max(0.2, 0.85 - dot(straight, n)))));
  return `whisker ${colour} ${text([fit.size(length), fit.size(width)])} ${text(fit.of(at))} ${text(out)}`;
}

// Rows one above the other; `t`: along them, from the front to the side.
const pad = Array.from({ length: 6 }, (_, row) => Array.from({ length: 7 }, (_, i) => ({ row, t: (i + 0.5 * (row % 2)) / 6.5 }))).flat().map(({ row, t }) => {
  const around = (18 + 74 * t) * degrees, up = (-27 + 12.5 * row) * degrees, spread = sin(91 * row + 37 * t);
  return {
    at: [0.185 + 0.23 * sin(around) * cos(up), 2.7 + 0.19 * sin(up), 3.47 + 0.23 * cos(around) * cos(up)],
    way: [0.75 + 0.35 * t, -0.22 + 0.1 * row - 0.22 * t + 0.06 * spread, 0.42 - 0.75 * t + 0.06 * spread],
    length: (0.42 + 0.75 * Math.sqrt(t)) * (1 - 0.08 * row) * (1 + 0.12 * spread),
  };
});
const brow = [0, 1, 2, 3, 4].map((i) => ({ at: [eye.at[0] - 0.1 + 0.055 * i, eye.at[1] + 0.21 - 0.009 * i * i, eye.at[2] + 0.02 - 0.05 * i], way: [0.1 + 0.22 * i, 0.9, 0.25 - 0.2 * i], length: 0.34 + 0.05 * (i % 3) }));
const cheek = [0, 1, 2].map((i) => ({ at: [0.6, 2.66 + 0.05 * i, 2.98 - 0.1 * i], way: [1, -0.15 + 0.15 * i, -0.35], length: 0.5 - 0.06 * i }));
const chin = [0, 1, 2].map((i) => ({ at: [0.06 + 0.06 * i, 2.46, 3.5 - 0.07 * i], way: [0.3 + 0.2 * i, -0.8, 0.3 - 0.2 * i], length: 0.22 }));

export const whiskers = (fit) => [1, -1].flatMap((side) => [[pad, '#efe6d4', 0.011], [brow, '#d9ccb4', 0.009], [cheek, '#e6dbc6', 0.009], [chin, '#e6dbc6', 0.008]]
  .flatMap(([all, colour, width]) => all.map(({ at: [x, y, z], way: [dx, dy, dz], length }) => whisker(fit, colour, length, width, [side * x, y, z], [side * dx, dy, dz]))));
