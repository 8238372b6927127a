// Eyeballs, and lids: shells round them that turn about the line from corner to corner.
import { turnedBody, withNormals } from './animal.mjs';
import { add, cross, dot, scaled, sub, unit } from './vectors.mjs';

const { PI, abs, asin, atan2, cos, exp, max, min, sin } = Math;
const radians = PI / 180;

/** { side, at, radius, gaze, across, up } of the eye of a side (1 left, -1 right), of the left one's `at`, `radius`, `gaze` and where its inner corner lies: `nose`. */
export function eyeOf(side, { at, radius, gaze, nose }) {
  const mirror = ([x, y, z]) => [side * x, y, z], g = unit(mirror(gaze)), n = mirror(nose), across = scaled(unit(sub(n, scaled(g, dot(n, g)))), -1);
  const up = cross(g, scaled(across, -side));
  return { side, at: mirror(at), radius, gaze: g, across, up: scaled(up, up[1] > 0 ? 1 : -1) };
}

/** Of a place on the eyeball: how far from the middle of the iris, along the lids (from the nose) and across them, in degrees. */
export function onEye({ at, gaze, across, up }, p) {
  const n = unit(sub(p, at));
  return [atan2(dot(n, across), dot(n, gaze)) / radians, asin(max(-1, min(1, dot(n, up)))) / radians];
}

/** The cornea stands out by a share of the radius. `uv1`: as seen along the gaze. */
export function eyeball({ at, radius, gaze, across, up }, { bulge = 0.05, rings: count = 12, segments = 20 } = {}) {
  const sizeAt = (angle) => radius * (1 + bulge * exp(-((angle / (28 * radians)) ** 2)));
  const rings = Array.from({ length: count - 1 }, (_, i) => {
    const angle = (PI * (i + 1)) / count, r = sizeAt(angle);
    return { at: add(at, scaled(gaze, r * cos(angle))), radius: [r * sin(angle), r * sin(angle)] };
  });
  const body = turnedBody(rings, [across, cross(across, gaze)], segments, [add(at, scaled(gaze, sizeAt(0))), add(at, scaled(gaze, -radius))]);
  const off = (p, axis) => dot(sub(p, at), axis) / (radius * (1 + bulge));
  return { ...body, uv1: body.positions.map((p) => [0.5 + 0.49 * off(p, across), 0.5 - 0.49 * off(p, up)]) };
}

/**
 * The colours of an eyeball as seen along its gaze, `size` * `size`: `at(x, y)` of places -1..1 along the lids and upwards. What it mirrors of the
 * sky is a spot of white above the pupil: that of a smooth ball in the light of one lamp would be a point.
 */
export const eyeColours = (size, at) => Array.from({ length: size * size }, (_, i) => {
  const x = 2 * ((i % size) + 0.5) / size - 1, y = 1 - (2 * (Math.floor(i / size) + 0.5)) / size, spot = max(0, min(1, (1 - ((x - 0.02) ** 2 + (1.5 * (y - 0.37)) ** 2) / 0.028) * 1.6));
  return at(x, y).map((c) => c + (0.92 - c) * spot);
});

const kInner = 1.035, kRim = 2;  // the rim's radius, and its rows

/**
 * `sign`: 1 for the upper lid, -1 for the lower; `edge(t)`: degrees across where it ends, so far from the nose; `outer`: its radius, in those of
 * the eye; `columns`, `rows`. A sheet with a rim that reaches down to the eyeball.
 */
export function lid({ at, radius, gaze, across, up }, { sign, edge, outer, columns = 18, rows = 7 }) {
  const place = (t, f, r) => {
    const flat = add(scaled(gaze, cos(f * radians)), scaled(up, sin(f * radians)));
    return add(at, scaled(add(scaled(flat, cos(t * radians)), scaled(across, sin(t * radians))), r * radius));
  };
  const positions = [], cells = [];
  for (let i = 0; i <= columns; ++i) {
    const t = -84 + (168 * i) / columns, from = edge(t);
    positions.push(place(t, from + sign * 2, kInner), place(t, from, 0.5 * (kInner + outer)));
    for (let j = 0; j < rows - kRim; ++j) positions.push(place(t, from + sign * (3 + (104 - sign * from) * (j / (rows - kRim - 1)) ** 1.4), outer));
  }
  for (let i = 0; i < columns; ++i) for (let j = 0; j + 1 < rows; ++j) {
    const [a, b, c, d] = [i * rows + j, (i + 1) * rows + j, (i + 1) * rows + j + 1, i * rows + j + 1];
    cells.push([a, b, c], [a, c, d]);
  }
  const made = withNormals({ positions, cells }), v = (columns >> 1) * rows + 3;
  // Outwards, whichever way its corners run.
  return dot(made.normals[v], sub(made.positions[v], at)) > 0 ? made : withNormals({ positions, cells: cells.map((cell) => [...cell].reverse()) });
}

// What light that goes from hair to hair makes of a colour: brighter and warmer than a bare surface shows it.
const kFurLight = [0.8, 0.7, 0.58];

/**
 * The colour of a lid whose fur would have the colour `fur`, at a place as onEye() says: dark along its edges, which are so many degrees across.
 * Programs take the colour of fur as shares of light, that of bare parts as sRGB.
 */
export function lidColour(fur, [t, f], edges) {
  const off = min(...edges.map((edge) => abs(f - edge))), dark = max(0, min(1, (9 - off) / 6)), hairs = 0.86 + 0.28 * abs(sin(1.7 * t + 0.6 * sin(0.5 * f)) * cos(0.23 * f + 0.9 * t));
  return fur.map((x, k) => kFurLight[k] * x ** 0.62 * hairs * (1 - 0.75 * dark));
}

/** A turn by `degrees` about a unit axis, as a pose has turns. */
function about([x, y, z], degrees) {
  const c = cos(degrees * radians), s = sin(degrees * radians), k = 1 - c;
  // R = yaw pitch roll: its third column and its second row.
  const pitch = asin(-max(-1, min(1, k * y * z - s * x))), yaw = atan2(k * x * z + s * y, k * z * z + c), roll = atan2(k * x * y + s * z, k * y * y + c);
  return [pitch, yaw, roll].map((angle) => angle / radians);
}

/** A pose with the lids of both eyes closed by so many degrees. */
export function lidTurns(eye, upper, lower) {
  const turn = {};
  for (const [name, side] of [['L', 1], ['R', -1]]) {
    const { gaze, up } = eyeOf(side, eye), axis = cross(up, gaze);
    turn[`lidUpper${name}`] = about(axis, upper), turn[`lidLower${name}`] = about(axis, -lower);
  }
  return { turn };
}
