// The shape of a small sturdy pony, of the Shetland kind: smooth unions of muscles and bones. Decimetres; the withers are 10 above
// the ground. x to the animal's left, y up, z to the front; the middle of the back is at z = 0.
//
// Proportions after the rules that judges of ponies use: the head is 0.4 of the height, the chest over half of it deep, the body
// a little longer than high, forelegs straight under the withers, points of hock straight under the buttocks.
import { fromBox, limbAlong, loft } from '../lofts.mjs';
import { jawed } from '../jaws.mjs';
import { ball, both, egg, limb, mirrored, union, without } from '../sculpt.mjs';
import { add, dot, scaled, sub, unit } from '../vectors.mjs';

const { hypot, max } = Math;

// --- trunk ---

/** From the buttocks to the breast: [z, top, bottom, half width]. */
const trunk = loft({ from: [0, 0, 0], way: [0, 0, 1], front: [0, 1, 0] }, [
  [-5.0, 8.9, 7.2, 0.8], [-4.5, 9.45, 6.4, 1.35], [-3.8, 9.8, 5.7, 1.72], [-3.0, 9.93, 5.2, 1.95], [-2.1, 9.82, 4.8, 2.15], [-1.1, 9.6, 4.48, 2.3], [-0.1, 9.48, 4.34, 2.34],
  [0.9, 9.55, 4.36, 2.25], [1.7, 9.8, 4.48, 2.06], [2.5, 9.96, 4.66, 1.84], [3.2, 9.9, 4.95, 1.66], [3.9, 9.3, 5.35, 1.5], [4.5, 8.5, 5.85, 1.22], [4.85, 7.9, 6.5, 0.85],
]);

function barrel(p) {
  let d = trunk(p);
  d = union(d, limb(p, [0.3, 9.05, -3.8], [0.28, 9.05, 2.0], 0.7, 0.55), 0.5);                // the muscles along the spine
  return union(d, limb(p, [0, 9.3, 1.3], [0, 9.5, 3.0], 0.36, 0.42), 0.6);                    // withers
}

const hamstrings = limbAlong([[0.72, 8.6, -4.6, 0.6], [0.95, 7.5, -4.98, 0.68], [1.18, 6.2, -4.75, 0.62], [1.2, 5.0, -4.35, 0.4]]);
function hindquarters(p, d) {
  d = union(d, egg(p, [0.9, 8.55, -3.3], [1.02, 1.2, 1.55]), 0.9);                            // croup
  d = union(d, egg(p, [1.25, 7.1, -3.75], [0.92, 1.9, 1.36]), 1.0);                           // thigh
  d = union(d, hamstrings(p), 0.8);
  return union(d, limb(p, [1.6, 6.9, -2.7], [1.45, 5.6, -2.85], 0.46, 0.46), 1.2);              // stifle
}

const blade = limbAlong([[0.8, 9.0, 2.4, 0.5], [1.2, 7.9, 3.3, 0.62], [1.32, 6.7, 4.15, 0.62]]);
function shoulder(p, d) {
  d = union(d, blade(p), 0.5);
  d = union(d, egg(p, [1.46, 6.1, 3.3], [0.6, 1.0, 1.05]), 0.9);                              // triceps
  d = union(d, egg(p, [0.3, 7.4, 4.3], [0.75, 1.1, 0.62]), 0.7);
  d = union(d, egg(p, [0, 6.0, 4.1], [0.6, 1.0, 0.68]), 0.8);
  return union(d, egg(p, [0.6, 6.4, 4.15], [0.8, 1.1, 0.6]), 0.8);                            // breast
}

// --- legs: of the left side ---

const forearm = limbAlong([[1.36, 5.9, 3.1, 0.8], [1.28, 4.85, 3.05, 0.66], [1.2, 3.95, 3.12, 0.5], [1.15, 3.35, 3.16, 0.42], [1.13, 2.9, 3.17, 0.4], [1.12, 2.5, 3.13, 0.33], [1.1, 1.85, 3.1, 0.3], [1.1, 1.4, 3.1, 0.32]]);
const forePastern = limbAlong([[1.1, 1.4, 3.1, 0.33], [1.1, 1.1, 3.14, 0.36], [1.1, 0.8, 3.32, 0.33], [1.1, 0.55, 3.5, 0.37]]);
function foreleg(p) {
  let d = forearm(p);
  d = union(d, limb(p, [1.46, 5.45, 2.62], [1.34, 4.8, 2.75], 0.36, 0.3), 0.3);               // elbow
  d = union(d, egg(p, [1.13, 2.95, 3.28], [0.38, 0.44, 0.34]), 0.16);                         // knee
  d = union(d, egg(p, [1.13, 2.85, 2.93], [0.22, 0.32, 0.22]), 0.14);
  d = union(d, limb(p, [1.12, 2.6, 2.98], [1.1, 1.3, 2.9], 0.2, 0.22), 0.16);                 // tendons
  d = union(d, ball(p, [1.1, 1.12, 2.86], 0.26), 0.16);
  return union(d, forePastern(p), 0.1);
}
const gaskin = limbAlong([[1.45, 5.9, -3.0, 0.74], [1.36, 5.15, -3.6, 0.74], [1.24, 4.45, -4.3, 0.55], [1.16, 3.9, -4.8, 0.43], [1.12, 3.45, -4.97, 0.41], [1.1, 2.9, -4.97, 0.36], [1.09, 2.1, -4.9, 0.31], [1.08, 1.4, -4.84, 0.32]]);
const hindPastern = limbAlong([[1.08, 1.4, -4.84, 0.33], [1.08, 1.12, -4.8, 0.36], [1.08, 0.8, -4.62, 0.33], [1.08, 0.55, -4.46, 0.37]]);
const achilles = limbAlong([[1.2, 5.1, -4.5, 0.36], [1.13, 4.55, -5.0, 0.22], [1.1, 4.1, -5.36, 0.2], [1.1, 3.6, -5.3, 0.22], [1.1, 3.0, -5.2, 0.22], [1.09, 2.0, -5.1, 0.2], [1.08, 1.35, -5.06, 0.22]]);
function hindleg(p) {
  let d = union(gaskin(p), achilles(p), 0.2);
  d = union(d, ball(p, [1.08, 1.15, -5.08], 0.26), 0.16);
  return union(d, hindPastern(p), 0.1);
}

/** A cone that leans to the front, cut off level with the ground: `at`, its middle there. */
export function hoof(p, at) {
  const lean = 0.42, y = p[1] - at[1];
  const q = [p[0] - at[0], y, p[2] - at[2] + lean * y];
  const r = 0.55 - 0.2 * y, far = hypot(q[0], q[2] * (q[2] > 0 ? 0.86 : 0.98));
  const wall = (far - r) * 0.88, rim = 0.66 + 0.24 * q[2];                                    // the hairline falls to the heels
  return both(both(wall, -y, 0.07), (y - rim) * 0.9, 0.12);
}
export const hoofAt = { fore: [1.1, 0, 3.62], hind: [1.08, 0, -4.34] };

// --- neck ---

// Along a straight line from the chest to the poll: [s, crest, underline, half width].
const neckWay = unit([0, 0.88, 0.47]), neckBack = [0, neckWay[2], -neckWay[1]];
const throat = loft({ from: [0, 8.0, 3.1], way: neckWay, front: neckBack }, [
  [-0.6, 1.5, -2.3, 1.55], [0.6, 1.42, -2.02, 1.38], [1.7, 1.32, -1.7, 1.22], [2.8, 1.22, -1.4, 1.06], [3.8, 1.07, -1.18, 0.93], [4.6, 0.6, -1.02, 0.8], [5.0, 0.3, -0.95, 0.68],
]);
const mound = limbAlong([[0, 9.7, 2.9, 0.36], [0, 10.75, 3.5, 0.4], [0, 11.55, 4.1, 0.4], [0, 12.05, 4.72, 0.35], [0, 12.3, 5.4, 0.28]]);

function neck(p) {
  const d = union(throat(p), mound(p), 0.45);                                                 // a thick crest
  return union(d, limb(p, [0.62, 11.2, 5.7], [0.85, 7.8, 4.6], 0.34, 0.5), 0.4);              // the muscle from jaw to breast
}

// --- head: along `u` from poll to muzzle, `v` to its front ---

export const headSize = 1.1;
export const poll = [0, 12.75, 6.15], headWay = unit([0, -0.74, 0.67]), headFront = [0, headWay[2], -headWay[1]];
export const headPlace = ([x, v, u]) => add(add([headSize * x, poll[1], poll[2]], scaled(headWay, headSize * u)), scaled(headFront, headSize * v));
/** A direction likewise. */
export const headTurn = ([x, v, u]) => add(add([x, 0, 0], scaled(headWay, u)), scaled(headFront, v));
export const inHead = (p) => {
  const from = sub(p, poll);
  return scaled([p[0], dot(from, headFront), dot(from, headWay)], 1 / headSize);
};

/** [u, front, back, half width]. */
const skull = loft({ from: [0, 0, 0], way: [0, 0, 1], front: [0, 1, 0] }, [
  [0.0, -0.08, -1.1, 0.55], [0.5, 0.1, -1.6, 0.68], [1.0, 0.17, -1.84, 0.74], [1.5, 0.13, -1.72, 0.65], [2.0, 0.02, -1.44, 0.52], [2.5, -0.06, -1.23, 0.47], [3.0, -0.1, -1.14, 0.44], [3.45, -0.14, -1.16, 0.45], [3.78, -0.28, -1.1, 0.4],
]);
const brow = limbAlong([[0.5, -0.02, 1.0, 0.13], [0.64, 0, 1.32, 0.13], [0.52, -0.06, 1.66, 0.11]]);

/** Its middle and radius (head), and where it looks (head). */
export const eye = { at: [0.585, -0.27, 1.38], radius: 0.3, gaze: unit([0.88, 0.14, 0.45]) };
const nostril = limbAlong([[0.33, -0.34, 3.46, 0.05], [0.4, -0.42, 3.62, 0.09], [0.41, -0.55, 3.72, 0.1], [0.36, -0.64, 3.68, 0.05]]);
const wing = limbAlong([[0.27, -0.32, 3.4, 0.17], [0.33, -0.3, 3.62, 0.13], [0.31, -0.42, 3.84, 0.11], [0.3, -0.6, 3.86, 0.1]]);

// The line of the mouth: how far above it a place is, and how far before its corners.
const corners = 3.14;
const overMouth = ([, v, u]) => v + 0.97 + 0.1 * (u - 3.9);
/** How far from where the lips meet. */
export const fromLips = (p) => hypot(overMouth(inHead(p)), max(0, corners - inHead(p)[2]));

function head(place) {
  const p = inHead(place);
  let d = skull(p);
  d = union(d, egg(p, [0, -0.25, 1.0], [0.62, 0.38, 0.9]), 0.3);                              // forehead
  d = union(d, egg(p, [0.52, -1.08, 0.98], [0.28, 0.7, 0.72]), 0.2);                          // cheek
  d = union(d, limb(p, [0.54, -0.62, 1.55], [0.4, -0.55, 2.5], 0.17, 0.09), 0.3);             // its ridge
  d = union(d, brow(p), 0.32);
  d = union(d, egg(p, eye.at, [eye.radius * 0.72, eye.radius * 1.12, eye.radius * 1.12]), 0.2);
  d = union(d, limb(p, [0, -0.26, 1.6], [0, -0.36, 3.2], 0.32, 0.25), 0.25);                  // bridge of the nose
  d = union(d, egg(p, [0, -0.7, 3.7], [0.42, 0.38, 0.38]), 0.2);                              // upper lip
  d = union(d, wing(p), 0.15);                                                                // nostrils
  d = union(d, egg(p, [0, -1.1, 3.5], [0.31, 0.2, 0.4]), 0.14);                               // lower lip, chin
  d = without(d, nostril(p), 0.06);
  d = without(d, ball(p, eye.at, eye.radius * 0.86), 0.12);                                   // the eyeball fills it
  return d * headSize;
}

// --- ears ---

export const ear = { base: headPlace([0.42, 0.0, 0.24]), tip: add(headPlace([0.42, 0.0, 0.24]), [0.24, 1.1, 0.24]) };
const onEar = (t, forward, out = 0) => add(add(ear.base, scaled(sub(ear.tip, ear.base), t)), [out, 0, forward]);
const earFlesh = limbAlong([[...onEar(-0.15, 0), 0.27], [...onEar(0.2, 0.01), 0.31], [...onEar(0.55, 0.02), 0.26], [...onEar(0.85, 0.02), 0.15], [...onEar(1, 0.03), 0.07]]);
const earBowl = limbAlong([[...onEar(0.12, 0.28, 0.1), 0.12], [...onEar(0.36, 0.25, 0.07), 0.22], [...onEar(0.62, 0.22, 0.03), 0.16], [...onEar(0.86, 0.16), 0.04]]);
// The inside, as it is seen from the front.
const earPatch = limbAlong([[0.14, 0.12], [0.38, 0.19], [0.62, 0.14], [0.86, 0.04]].map(([t, r]) => { const [x, y] = onEar(t, 0, 0.03); return [x, y, 0, r]; }));
const ears = (p) => without(earFlesh(p), earBowl(p), 0.07);

// --- tail: the dock, from which hair hangs ---

export const dock = [[0, 9.3, -4.4, 0.5], [0, 9.1, -5.15, 0.42], [0, 8.35, -5.68, 0.28], [0, 7.55, -5.8, 0.22], [0, 6.9, -5.8, 0.14]];
const tail = limbAlong(dock);

// --- where other materials are than fur: fields that are below 0 there ---

const onBothSides = (at) => (p) => at([Math.abs(p[0]), p[1], p[2]]);
const hairline = (p, at) => p[1] - (0.6 + 0.24 * (p[2] - at[2] + 0.42 * p[1]));
export const fields = {
  hooves: onBothSides((p) => (p[1] > 1.3 ? 1 : hairline(p, p[2] > 0 ? hoofAt.fore : hoofAt.hind))),
  innerEar: onBothSides((p) => (p[1] < 12 ? 1 : max(earPatch([p[0], p[1], 0]), ear.base[2] + 0.22 * (p[1] - ear.base[1]) - 0.06 - p[2]))),
  nose: onBothSides((p) => (p[1] > 11.5 || p[2] < 7 ? 1 : headSize * (nostril(inHead(p)) - 0.03))),
  mouth: (p) => (p[1] > 11.5 || p[2] < 7 ? 1 : jaw.mouth(p)),
};

const boxes = { head: [[0, 8, 4.6], [1.3, 13.6, 10]], ears: [[0.1, 12, 5.4], [1.2, 14.4, 7.2]], fore: [[0.4, 0, 2.2], [2.2, 6.8, 4.4]], hind: [[0.4, 0, -5.8], [2.2, 6.8, -2.2]], tail: [[0, 6.7, -6.2], [0.6, 9.9, -3.8]] };
const joined = (p, d, box, part, k) => (fromBox(p, box) > d + k ? d : union(d, part(p), k));

function half(p) {
  let d = shoulder(p, hindquarters(p, barrel(p)));
  d = union(d, neck(p), 0.9);
  d = joined(p, d, boxes.head, head, 0.4);
  d = joined(p, d, boxes.ears, ears, 0.12);
  d = joined(p, d, boxes.tail, tail, 0.8);
  d = joined(p, d, boxes.fore, (q) => union(foreleg(q), hoof(q, hoofAt.fore), 0.06), 0.7);
  return joined(p, d, boxes.hind, (q) => union(hindleg(q), hoof(q, hoofAt.hind), 0.06), 0.7);
}
export const ponyAt = mirrored(half, 0.01);
/** The same with its mouth open, as it is sculpted. */
export const jaw = jawed(ponyAt, {
  front: mirrored(head, 0.01), over: (p) => headSize * overMouth(inHead(p)), ahead: (p) => { if (p[1] < 8 || p[2] < 6.6) return -9; const [, v, u] = inHead(p); return headSize * Math.min(u - corners, v + 3.5); }, hinge: headPlace([0, -0.9, corners]), degrees: 16, soft: 0.18, lip: 0.05,
  tongue: (p) => headSize * egg(inHead(p), [0, -0.96, 3.45], [0.2, 0.09, 0.3]), palate: (p) => headSize * egg(inHead(p), [0, -0.94, 3.45], [0.26, 0.13, 0.32]),
});
