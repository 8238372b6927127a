// The body of a river otter (Lontra canadensis), standing. Decimetres; x to its left, y up from the ground, z to its front.
import { jawed } from '../jaws.mjs';
import { ball, bent, curve, egg, groove, limb, mirrored, tube, turnedAbout, union, without } from '../sculpt.mjs';
import { clamp, smooth, unit } from '../vectors.mjs';

const { abs, sqrt } = Math;

/** The left eye; where it looks at rest, and to which side its inner corner is. */
export const eye = { at: [0.36, 3.0, 3.275], radius: 0.125, gaze: unit([0.58, 0.14, 0.8]), nose: unit([-0.75, -0.25, 0.6]) };
export const ear = [0.615, 2.98, 2.5];

/** A shape that lies within a ball is left out where that is so far that it changes nothing. */
const joined = (d, p, centre, radius, k, shape) => (ball(p, centre, radius) >= d + k ? d : union(d, shape(p), k));

const trunkLine = curve([[0, 1.5, -2.1, 0.6], [0, 1.62, -1.55, 0.72], [0, 1.75, -0.8, 0.755], [0, 1.74, 0, 0.735], [0, 1.68, 0.75, 0.73], [0, 1.84, 1.45, 0.69], [0, 2.2, 1.95, 0.63], [0, 2.6, 2.38, 0.55]], 8);
export const tailLine = curve([[0, 1.5, -2.05, 0.58], [0, 1.26, -2.65, 0.485], [0, 0.92, -3.4, 0.375], [0, 0.58, -4.3, 0.275], [0, 0.34, -5.2, 0.185], [0, 0.2, -6, 0.11], [0, 0.13, -6.55, 0.035]], 8);

function trunk(p) {
  let d = tube(p, trunkLine);
  d = union(d, egg(p, [0, 1.42, -0.35], [0.7, 0.6, 1.25]), 0.4);   // belly
  d = union(d, egg(p, [0, 1.5, 1.2], [0.55, 0.58, 0.6]), 0.35);      // breast
  return union(d, tube(p, tailLine), 0.3);
}

function foreLeg(p) {
  let d = egg(p, [0.45, 1.4, 1.08], [0.36, 0.52, 0.48]);
  d = union(d, bent(p, [[0.55, 1.38, 1.1, 0.35], [0.66, 0.88, 0.9, 0.27], [0.7, 0.34, 1.1, 0.2]], 0.2), 0.3);
  return union(d, paw(p, fore), 0.12);
}
function hindLeg(p) {
  let d = egg(p, [0.42, 1.3, -1.42], [0.43, 0.57, 0.6]);
  d = union(d, bent(p, [[0.5, 1.32, -1.5, 0.46], [0.68, 0.92, -1.12, 0.36], [0.72, 0.4, -1.6, 0.22]], 0.2), 0.3);
  return union(d, paw(p, hind), 0.14);
}

/** Paws: `heel`, `ball` [x, y, z, radius] of the sole; toes fan out by `fan` from `ball`, `reach` long. */
export const fore = { heel: [0.7, 0.26, 1.12, 0.18], ball: [0.71, 0.15, 1.34, 0.15], fan: 0.33, reach: 0.42, thick: 0.07, turn: 0.08 };
export const hind = { heel: [0.72, 0.3, -1.62, 0.2], ball: [0.74, 0.16, -1.14, 0.165], fan: 0.29, reach: 0.56, thick: 0.076, turn: 0.13 };
/** The five toes of a paw: { from, middle, to } with radii. */
export const toes = ({ ball: [x, y, z], fan, reach, thick, turn }) => [-2, -1, 0, 1, 2].map((i) => {
  const angle = turn + fan * i, far = reach * (1 - 0.05 * i * i), si = Math.sin(angle), co = Math.cos(angle), root = 0.05 * i;
  const at = (share, high) => [x + root + far * share * si, high, z + far * share * co];
  return { from: [...at(0.15, y - 0.02), thick], middle: [...at(0.6, y - 0.01), thick * 0.92], to: [...at(1, thick * 0.95), thick * 0.85] };
});
const toesOf = new Map([fore, hind].map((which) => [which, toes(which)]));

function paw(p, which) {
  const { heel, ball: sole, reach, turn } = which;
  let d = limb(p, heel, sole, heel[3], sole[3]);
  // Webs: a flat egg between the toes.
  const web = [sole[0] + 0.5 * reach * Math.sin(turn), 0.07, sole[2] + 0.42 * reach];
  d = union(d, egg(p, web, [0.5 * reach, 0.045, 0.44 * reach]), 0.05);
  for (const { from, middle, to } of toesOf.get(which)) d = union(d, bent(p, [from, middle, to], 0.03), 0.035);
  return without(d, p[1], 0.06);  // it stands on the ground
}

function skull(p) {
  let d = egg(p, [0, 2.845, 2.7], [0.64, 0.405, 0.66]);
  d = union(d, egg(p, [0.38, 2.72, 2.84], [0.33, 0.33, 0.42]), 0.25);      // cheeks
  d = union(d, egg(p, [0, 2.73, 3.2], [0.46, 0.28, 0.42]), 0.2);           // muzzle
  d = union(d, limb(p, [0, 3.03, 2.95], [0, 2.9, 3.45], 0.22, 0.19), 0.2);
  d = union(d, egg(p, [0, 2.52, 3.24], [0.24, 0.13, 0.3]), 0.1);           // chin
  return union(d, egg(p, [0.215, 2.705, 3.42], [0.25, 0.2, 0.22]), 0.07);  // whisker pads
}

function eyes(p, head) {
  let d = union(head, egg(p, [0.31, 3.1, 3.13], [0.18, 0.08, 0.15]), 0.14);      // brow
  d = union(d, ball(p, eye.at, eye.radius * 1.19), 0.12);
  return without(d, ball(p, eye.at.map((x, k) => x + 0.55 * eye.radius * eye.gaze[k]), eye.radius), 0.03);
}

/** Below 0 on the leather of the nose. */
export const noseField = (p) => egg([abs(p[0]), p[1], p[2]], [0, 2.872, 3.65], [0.215, 0.118, 0.14]);
/** 1 in the nostrils, which are commas that open to the sides. */
export const nostril = ([x, y, z]) => Math.exp(-(((tube([abs(x), y, 3.66], kNostril) + 0.02) / 0.026) ** 2)) * smooth(3.5, 3.6, z);
const kNostril = [[0.06, 2.835, 3.66, 0.02], [0.1, 2.85, 3.66, 0.024], [0.15, 2.835, 3.66, 0.014]];
function nose(p, head) {
  let d = union(head, egg(p, [0, 2.885, 3.6], [0.19, 0.11, 0.1]), 0.05);
  d = union(d, egg(p, [0.14, 2.865, 3.585], [0.075, 0.075, 0.085]), 0.04);
  d += 0.055 * nostril(p);
  return d + groove(p[2] > 3.45 ? sqrt(p[0] ** 2 + Math.max(0, abs(p[1] - 2.7) - 0.1) ** 2) : 1, 0.045, 0.024);   // philtrum
}

// --- the mouth: how far above its line a place is, and how far before its corners ---

const corners = 3.1;
export const overMouth = ([x, y, z]) => y - (2.585 - 0.035 * Math.exp(-(((abs(x) - 0.22) / 0.12) ** 2)) * smooth(3.2, 3.4, z) + 0.05 * smooth(3.4, 3.1, z));
const aheadOfCorners = (p) => p[2] - corners;

const earSeen = (p) => turnedAbout(1, p, ear, 0.6);
/** Below 0 in the hollow of the ear. */
export const earField = (p) => {
  const q = earSeen([abs(p[0]), p[1], p[2]]);
  return Math.max(sqrt(((q[0] - ear[0] - 0.01) / 0.042) ** 2 + ((q[1] - ear[1]) / 0.07) ** 2) - 1, (ear[2] - 0.03 - q[2]) * 8) * 0.1;
};
function earOn(p, head) {
  const q = earSeen(p);
  let d = egg(q, [ear[0], ear[1], ear[2]], [0.165, 0.17, 0.085]);
  d = union(d, egg(q, [ear[0] - 0.05, ear[1] - 0.08, ear[2] - 0.05], [0.15, 0.13, 0.12]), 0.08);
  d = without(d, egg(q, [ear[0] + 0.015, ear[1] + 0.005, ear[2] + 0.075], [0.085, 0.1, 0.1]), 0.04);
  return union(head, d, 0.07);
}

function headOf(p) {
  const d = nose(p, eyes(p, skull(p)));
  return ball(p, ear, 0.3) < d + 0.1 ? earOn(p, d) : d;
}

export const solid = mirrored((p) => {
  let d = trunk(p);
  d = joined(d, p, [0.6, 0.95, 1.15], 1.35, 0.4, foreLeg);
  d = joined(d, p, [0.6, 0.9, -1.3], 1.5, 0.42, hindLeg);
  return joined(d, p, [0, 2.83, 2.9], 1.15, 0.25, headOf);
}, 0.015);

/** The same with its mouth open, as it is sculpted. */
export const jaw = jawed(solid, {
  front: mirrored(headOf, 0.015), over: overMouth, ahead: aheadOfCorners, hinge: [0, 2.63, corners], degrees: 24, soft: 0.16, lip: 0.035,
  tongue: (p) => egg(p, [0, 2.56, 3.36], [0.15, 0.07, 0.24]), palate: (p) => egg(p, [0, 2.58, 3.34], [0.19, 0.1, 0.25]),
});

/** Below 0 on the soles. */
export const padField = (p) => (p[1] > 0.3 || p[2] < -2.2 ? 1 : p[1] - 0.055);

export const box = [[-1.3, -0.1, -6.8], [1.3, 3.7, 4]];

/** How long edges are to be: short where a shape is small, longer away from it, longest on the back and flanks. */
export function sizeAt(p) {
  const q = [abs(p[0]), p[1], p[2]], near = (c, reach, size) => size + 0.2 * Math.max(0, ball(q, c, 0) - reach);
  let size = Math.min(p[1] < 1.2 && p[2] > -2.2 ? 0.2 : 0.26, near([0, 2.85, 3], 0.7, 0.1), near(eye.at, 0.2, 0.04), near([0, 2.7, 3.5], 0.32, 0.055), near(ear, 0.22, 0.055));
  for (const { ball: b, reach } of [fore, hind]) size = Math.min(size, near([b[0], 0.1, b[2] + 0.5 * reach], 0.42, 0.055));
  if (p[2] > corners) size = Math.min(size, 0.036 + 0.15 * Math.max(0, abs(overMouth(jaw.closed(p))) - 0.03));
  return Math.min(size, 0.07 + 0.14 * clamp((p[2] + 6.6) / 2.5));
}
