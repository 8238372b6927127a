// Eyeballs, and the lids: shells round them that turn about the line from corner to corner.
import { turnedBody, withNormals } from '../animal.mjs';
import { eye, headPlace, headSize, headTurn } from './shape.mjs';
import { add, cross, scaled, unit } from '../vectors.mjs';

const { PI, cos, sin, max } = Math;
const radians = PI / 180;

/** { at, radius, gaze, across, up }: of the eye of one side (1 left, -1 right). `across`: from the corner at the nose to the outer one. */
export function eyeOf(side) {
  const mirror = ([x, y, z]) => [side * x, y, z], at = mirror(headPlace(eye.at)), gaze = unit(mirror(headTurn(eye.gaze)));
  const nose = headTurn([0, 0, 1]), line = unit(add(nose, scaled(gaze, -(nose[0] * gaze[0] + nose[1] * gaze[1] + nose[2] * gaze[2]))));
  const across = scaled(line, -1), up = cross(gaze, scaled(across, -side));
  return { at, radius: eye.radius * headSize, gaze, across, up: scaled(up, up[1] > 0 ? 1 : -1) };
}

/** Of a place on the eyeball: how far from the middle of the iris, along the lids and across them, in degrees. */
export function onEye(side, p) {
  const { at, gaze, across, up } = eyeOf(side), n = unit(add(p, scaled(at, -1))), of = (way) => n[0] * way[0] + n[1] * way[1] + n[2] * way[2];
  return [Math.atan2(of(across), of(gaze)) / radians, Math.asin(max(-1, Math.min(1, of(up)))) / radians];
}

export function eyeball(side) {
  const { at, radius, gaze, across, up } = eyeOf(side), count = 12;
  // The cornea stands out a little.
  const bulge = (angle) => 1 + 0.05 * Math.exp(-((angle / (0.5 * radians * 57)) ** 2));
  const rings = Array.from({ length: count - 1 }, (_, i) => {
    const angle = (PI * (i + 1)) / count, r = radius * bulge(angle);
    return { at: add(at, scaled(gaze, r * cos(angle))), radius: [r * sin(angle), r * sin(angle)] };
  });
  return turnedBody(rings, [across, cross(across, gaze)], 20, [add(at, scaled(gaze, radius * bulge(0))), add(at, scaled(gaze, -radius))]);
}

// Where the edges of the lids are at so many degrees from the nose to the outer corner.
const open = (t) => max(0, 1 - (t / 56) ** 2);
/** Degrees above the gaze. */
export const edges = { upper: (t) => -4 + 34 * open(t - 4) ** 0.8, lower: (t) => -4 - 22 * open(t + 4) ** 0.9 };
const kInner = 1.035;

/** `which`: upper or lower. A sheet with a rim that reaches down to the eyeball. */
export function lid(side, which) {
  const { at, radius, gaze, across, up } = eyeOf(side), sign = which === 'upper' ? 1 : -1, columns = 18, rows = 7;
  const outer = which === 'upper' ? 1.115 : 1.09;
  const place = (t, f, r) => {
    const flat = add(scaled(gaze, cos(f * radians)), scaled(up, sin(f * radians)));
    return add(at, scaled(add(scaled(flat, cos(t * radians)), scaled(across, sin(t * radians))), r * radius));
  };
  const positions = [], cells = [];
  for (let i = 0; i <= columns; ++i) {
    const t = -84 + (168 * i) / columns, edge = edges[which](t);
    positions.push(place(t, edge + sign * 2, kInner), place(t, edge, 0.5 * (kInner + outer)));
    for (let j = 0; j < rows - 2; ++j) positions.push(place(t, edge + sign * (3 + (104 - sign * edge) * (j / (rows - 3)) ** 1.4), outer));
  }
  const faces = side * sign > 0;
  for (let i = 0; i < columns; ++i) for (let j = 0; j + 1 < rows; ++j) {
    const [a, b, c, d] = [i * rows + j, (i + 1) * rows + j, (i + 1) * rows + j + 1, i * rows + j + 1];
    const quads = [[a, b, c], [a, c, d]];
    cells.push(...quads.map((cell) => (faces ? [...cell].reverse() : cell)));
  }
  const made = withNormals({ positions, cells });
  // Outwards, whichever way its corners run.
  const v = Math.floor(columns / 2) * rows + 3, out = add(made.positions[v], scaled(at, -1)), n = made.normals[v];
  return n[0] * out[0] + n[1] * out[1] + n[2] * out[2] > 0 ? made : withNormals({ positions, cells: cells.map((cell) => [...cell].reverse()) });
}
