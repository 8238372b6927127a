// The body of a river otter (Lontra canadensis), standing. Decimetres; x to its left, y up from the ground, z to its front.
import { ball, bent, curve, egg, groove, limb, mirrored, tube, turnedAbout, union, without } from '../sculpt.mjs';
import { clamp, smooth } from '../vectors.mjs';

const { abs, sqrt } = Math;

export const eye = { at: [0.285, 3.07, 3.3], radius: 0.115 };
export const ear = [0.56, 3.1, 2.52];

/** A shape that lies within a ball is left out where that is so far that it changes nothing. */
const joined = (d, p, centre, radius, k, shape) => (ball(p, centre, radius) >= d + k ? d : union(d, shape(p), k));

const trunkLine = curve([[0, 1.66, -2.1, 0.6], [0, 1.76, -1.55, 0.78], [0, 1.9, -0.8, 0.83], [0, 1.9, 0, 0.8], [0, 1.82, 0.75, 0.78], [0, 1.95, 1.45, 0.69], [0, 2.33, 1.98, 0.6], [0, 2.74, 2.42, 0.53]], 3);
export const tailLine = curve([[0, 1.7, -2.05, 0.52], [0, 1.4, -2.65, 0.4], [0, 1, -3.4, 0.31], [0, 0.62, -4.3, 0.235], [0, 0.36, -5.2, 0.165], [0, 0.2, -6, 0.115], [0, 0.15, -6.55, 0.075]], 4);

function trunk(p) {
  let d = tube(p, trunkLine);
  d = union(d, egg(p, [0, 1.52, -0.35], [0.72, 0.66, 1.25]), 0.4);   // belly
  d = union(d, egg(p, [0, 1.62, 1.2], [0.56, 0.6, 0.6]), 0.35);      // breast
  return union(d, tube(p, tailLine), 0.3);
}

function foreLeg(p) {
  let d = egg(p, [0.46, 1.5, 1.08], [0.34, 0.52, 0.48]);
  d = union(d, bent(p, [[0.55, 1.5, 1.1, 0.33], [0.67, 0.95, 0.88, 0.25], [0.7, 0.34, 1.1, 0.19]], 0.15), 0.2);
  return union(d, paw(p, fore), 0.12);
}
function hindLeg(p) {
  let d = egg(p, [0.44, 1.42, -1.42], [0.42, 0.58, 0.6]);
  d = union(d, bent(p, [[0.5, 1.45, -1.5, 0.45], [0.7, 1, -1.12, 0.34], [0.72, 0.4, -1.6, 0.21]], 0.15), 0.2);
  return union(d, paw(p, hind), 0.14);
}

/** Paws: `heel`, `ball` [x, y, z, radius] of the sole; toes fan out by `fan` from `ball`, `reach` long. */
export const fore = { heel: [0.7, 0.26, 1.12, 0.18], ball: [0.71, 0.15, 1.36, 0.15], fan: 0.3, reach: 0.36, thick: 0.075, turn: 0.08 };
export const hind = { heel: [0.72, 0.3, -1.62, 0.2], ball: [0.74, 0.16, -1.12, 0.16], fan: 0.26, reach: 0.46, thick: 0.082, turn: 0.12 };
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
  const web = [sole[0] + 0.5 * reach * Math.sin(turn), 0.085, sole[2] + 0.45 * reach];
  d = union(d, egg(p, web, [0.24, 0.05, 0.5 * reach]), 0.06);
  for (const { from, middle, to } of toesOf.get(which)) d = union(d, bent(p, [from, middle, to], 0.03), 0.035);
  // It stands on the ground.
  return without(d, p[1] + 0.0, 0.06);
}

function skull(p) {
  let d = egg(p, [0, 2.98, 2.75], [0.6, 0.45, 0.66]);
  d = union(d, egg(p, [0.34, 2.84, 2.88], [0.33, 0.33, 0.4]), 0.25);      // cheeks
  d = union(d, egg(p, [0, 2.84, 3.34], [0.38, 0.28, 0.36]), 0.22);        // muzzle
  d = union(d, limb(p, [0, 3.14, 3.05], [0, 2.97, 3.56], 0.19, 0.15), 0.2);
  d = union(d, egg(p, [0, 2.63, 3.36], [0.23, 0.13, 0.27]), 0.1);         // chin
  return union(d, egg(p, [0.18, 2.8, 3.52], [0.215, 0.185, 0.2]), 0.09);  // whisker pads
}

function eyes(p, head) {
  let d = union(head, egg(p, [0.27, 3.2, 3.16], [0.17, 0.09, 0.16]), 0.14);       // brow
  d = union(d, ball(p, eye.at, eye.radius * 1.28), 0.07);
  return without(d, ball(p, [eye.at[0] + 0.03, eye.at[1] + 0.005, eye.at[2] + 0.06], eye.radius * 1.1), 0.03);
}

const noseTip = [0, 2.97, 3.7];
/** Below 0 on the leather of the nose. */
export const noseField = (p) => egg([abs(p[0]), p[1], p[2]], [0, 2.962, 3.735], [0.185, 0.125, 0.12]);
function nose(p, head) {
  let d = union(head, egg(p, noseTip, [0.17, 0.11, 0.1]), 0.05);
  d = union(d, egg(p, [0.11, 2.95, 3.7], [0.075, 0.07, 0.075]), 0.03);
  d += groove(sqrt((p[0] - 0.085) ** 2 + ((p[1] - 2.935) * 1.5) ** 2 + ((p[2] - 3.78) * 0.5) ** 2), 0.05, 0.035);  // nostrils
  return d + groove(sqrt(p[0] ** 2 + Math.max(0, abs(p[1] - 2.84) - 0.09) ** 2) * (p[2] > 3.5 ? 1 : 9), 0.03, 0.022);
}

/** How far above the line of the mouth a place is. */
export const overMouth = (p) => p[1] - (2.665 + 0.55 * Math.max(0, abs(p[0]) - 0.05) ** 2 + 0.16 * smooth(3.4, 3.15, p[2]));
/** Below 0 within the lips. */
export const mouthField = (p) => Math.max(abs(overMouth(p)) - 0.028, 3.12 - p[2], abs(p[0]) - 0.36, 2.3 - p[1]);
function mouth(p, head) {
  if (p[2] < 3.05) return head;
  return head + groove(overMouth(p), 0.075 * smooth(3.08, 3.22, p[2]), 0.03);
}

const earSeen = (p) => turnedAbout(1, p, ear, -0.75);
/** Below 0 in the hollow of the ear. */
export const earField = (p) => {
  const q = earSeen([abs(p[0]), p[1], p[2]]);
  return Math.max(sqrt(((q[0] - ear[0]) / 0.115) ** 2 + ((q[1] - ear[1] - 0.02) / 0.125) ** 2) - 1, (ear[2] - 0.03 - q[2]) * 8) * 0.12;
};
function earOn(p, head) {
  const q = earSeen(p);
  let d = egg(q, [ear[0], ear[1], ear[2]], [0.17, 0.18, 0.075]);
  d = union(d, egg(q, [ear[0] - 0.05, ear[1] - 0.08, ear[2] - 0.05], [0.15, 0.13, 0.12]), 0.08);
  d = without(d, egg(q, [ear[0] + 0.01, ear[1] + 0.01, ear[2] + 0.085], [0.1, 0.115, 0.075]), 0.04);
  return union(head, d, 0.07);
}

function headOf(p) {
  let d = eyes(p, skull(p));
  d = mouth(p, nose(p, d));
  return ball(p, ear, 0.3) < d + 0.1 ? earOn(p, d) : d;
}

export const solid = mirrored((p) => {
  let d = trunk(p);
  d = joined(d, p, [0.6, 0.95, 1.15], 1.25, 0.2, foreLeg);
  d = joined(d, p, [0.6, 0.9, -1.3], 1.4, 0.25, hindLeg);
  return joined(d, p, [0, 2.95, 2.95], 1.15, 0.25, headOf);
}, 0.015);

/** Below 0 on the soles. */
export const padField = (p) => p[1] - 0.05 + 0.6 * Math.max(0, abs(p[0]) > 0.2 ? 0 : 1);

export const box = [[-1.3, -0.1, -6.8], [1.3, 3.7, 4]];

/** How long edges are to be. */
export function sizeAt(p) {
  const q = [abs(p[0]), p[1], p[2]], near = (c, inner, outer, size) => size + 0.15 * clamp((ball(q, c, 0) - inner) / (outer - inner)) * (outer - inner);
  let size = 0.17;
  size = Math.min(size, near([0, 2.95, 3], 0.7, 1.6, 0.085), near(eye.at, 0.2, 0.5, 0.04), near([0, 2.8, 3.55], 0.32, 0.8, 0.045), near(ear, 0.22, 0.6, 0.05));
  for (const { ball: b, reach } of [fore, hind]) size = Math.min(size, near([b[0], 0.1, b[2] + 0.5 * reach], 0.4, 1, 0.055));
  return Math.min(size, 0.08 + 0.1 * clamp((p[2] + 6.6) / 2.5));
}
