// A stylised head: smooth unions of round shapes, and a mesh of their surface. Decimetres, about the middle between the ears; x to
// the head's left, y up, z to the front.

import { ball, bent, both, egg, groove, limb, mirrored, turned, union, without } from '../../tools/assets/sculpt.mjs';
import { relaxed, surfaceNets, surfaceOf, triangulated } from '../../tools/assets/nets.mjs';
import { clamp, squared } from '../../tools/assets/vectors.mjs';

const { abs, hypot, max, min, sqrt } = Math;

// --- the head; `p` has x >= 0: its left half ---

const eye = [0.32, -0.03, 0.585], eyeball = 0.19;

function skull(p) {
  let d = egg(p, [0, 0.4, -0.12], [0.74, 0.77, 0.92]);
  d = union(d, egg(p, [0, 0.4, 0.36], [0.58, 0.55, 0.47]), 0.3);      // forehead
  d = union(d, egg(p, [0, -0.3, 0.3], [0.56, 0.72, 0.5]), 0.35);      // face
  d = union(d, limb(p, [0.46, -0.5, 0.06], [0.1, -0.9, 0.58], 0.15, 0.13), 0.3);  // jaw
  d = union(d, egg(p, [0, -0.93, 0.69], [0.17, 0.14, 0.12]), 0.2);    // chin
  d = union(d, ball(p, [0.4, -0.28, 0.5], 0.22), 0.25);               // cheeks
  return d;
}

function eyes(p, head) {
  let d = without(head, egg(p, [0.32, 0.01, 0.87], [0.2, 0.12, 0.17]), 0.22);
  d = union(d, bent(p, [[0.1, 0.17, 0.79, 0.05], [0.3, 0.245, 0.765, 0.06], [0.53, 0.15, 0.58, 0.05]], 0.1), 0.22);  // brow
  d = union(d, egg(p, eye, [eyeball * 1.08, eyeball * 0.88, eyeball]), 0.07);
  if (p[2] < 0.5) return d;
  // Where the lids meet: an arc that hangs through; above it the fold of the upper lid, which stands out over the lower one.
  const across = (p[0] - eye[0] - 0.005) / 0.19, open = max(0, 1 - across ** 4);
  const over = p[1] - (eye[1] - 0.085 + 0.065 * across * across), fold = p[1] - (eye[1] + 0.1 - 0.07 * across * across);
  d += open * (groove(over + 0.008, 0.024, 0.022) + groove(fold, 0.02, 0.03) - groove(over - 0.035, 0.014, 0.035));
  return d;
}

function nose(p, head) {
  let d = union(head, limb(p, [0, 0.12, 0.75], [0, -0.28, 0.96], 0.05, 0.075), 0.15);
  d = union(d, ball(p, [0, -0.31, 0.975], 0.085), 0.07);
  d = union(d, egg(p, [0.09, -0.345, 0.875], [0.058, 0.055, 0.085]), 0.07);
  return d + groove(hypot(p[0] - 0.05, (p[1] + 0.4) * 1.2, (p[2] - 0.9) * 0.6), 0.045, 0.035);  // nostrils
}

function mouth(p, head) {
  let d = union(head, egg(p, [0, -0.62, 0.68], [0.25, 0.19, 0.155]), 0.18);
  d = union(d, bent(p, [[0, -0.575, 0.84, 0.04], [0.06, -0.568, 0.838, 0.045], [0.235, -0.64, 0.72, 0.016]], 0.04), 0.05);  // upper lip
  d = union(d, bent(p, [[0, -0.7, 0.822, 0.052], [0.09, -0.694, 0.808, 0.046], [0.225, -0.648, 0.725, 0.016]], 0.04), 0.05);  // lower lip
  if (p[2] < 0.55) return d;
  const line = -0.634 - 0.012 * clamp(p[0] / 0.24) ** 2;
  d += groove(hypot(p[1] - line, max(0, p[0] - 0.22)), 0.032 * clamp(1.8 - p[0] / 0.17), 0.03);
  d += groove(hypot(p[0], max(0, abs(p[1] + 0.485) - 0.03)), 0.014, 0.028);            // below the nose
  return d + groove(hypot(p[0] * 0.5, p[1] + 0.79), 0.025, 0.055);                     // above the chin
}

function ear(p, head) {
  const c = [0.69, -0.1, -0.12], q = turned(p, c, 0.35);
  const tall = (q[1] - c[1]) / 0.25, long = (q[2] - c[2]) / (0.145 + 0.03 * tall), ring = hypot(tall, long);
  // A shell that is thin across x, with a thicker rim.
  let d = egg(q, c, [0.06, 0.28, 0.17]);
  d = union(d, hypot((ring - 1) * 0.17, q[0] - c[0] - 0.03) - 0.036, 0.05);
  d = union(d, egg(q, [c[0] - 0.03, c[1] + 0.01, c[2] + 0.03], [0.1, 0.2, 0.1]), 0.08);   // to the head
  d = without(d, egg(q, [c[0] + 0.085, c[1] - 0.02, c[2] + 0.02], [0.06, 0.14, 0.08]), 0.06);
  d = union(d, ball(q, [c[0], c[1] - 0.24, c[2] + 0.06], 0.06), 0.08);                    // lobe
  d = union(d, egg(q, [c[0], c[1] - 0.05, c[2] + 0.15], [0.04, 0.06, 0.035]), 0.06);      // in front of the hole
  return union(head, d, 0.09);
}

function bust(p, head) {
  let neck = limb(p, [0, -0.4, -0.2], [0, -1.6, -0.3], 0.43, 0.46);
  neck = union(neck, limb(p, [0.5, -0.42, -0.2], [0.09, -1.52, 0.14], 0.1, 0.07), 0.2);  // the muscle from ear to breastbone
  neck = union(neck, limb(p, [0, -0.95, 0.1], [0, -1.35, 0.1], 0.13, 0.12), 0.2);
  let trunk = bent(p, [[0, -1.55, -0.36, 0.36], [0.72, -1.77, -0.38, 0.3], [1.1, -1.95, -0.35, 0.31]], 0.3);
  trunk = union(trunk, egg(p, [0, -2.05, -0.2], [0.95, 0.55, 0.5]), 0.3);
  trunk = union(trunk, bent(p, [[0.1, -1.58, 0.18, 0.055], [0.5, -1.57, 0.08, 0.06], [0.95, -1.58, -0.14, 0.065]], 0.1), 0.16);  // collarbone
  trunk = both(union(neck, trunk, 0.28), egg(p, [0, -0.95, -0.2], [1.34, 1.25, 1.6]), 0.12);  // ends in a curve
  return union(head, trunk, 0.16);
}

const headAt = mirrored((p) => bust(p, ear(p, mouth(p, nose(p, eyes(p, skull(p)))))), 0.01);
const { onSurface, normal } = surfaceOf(headAt);

// --- its mesh, on a grid that is finer about the face ---

// Where the mesh is finer: about the face, and there again about eyes, mouth and ears: { at, reach }.
const face = [0, -0.3, 0.75];
const details = [[[0.32, -0.04, 0.76], 0.26], [[-0.32, -0.04, 0.76], 0.26], [[0, -0.62, 0.84], 0.26], [[0, -0.32, 0.93], 0.2], [[0.72, -0.1, -0.12], 0.36], [[-0.72, -0.1, -0.12], 0.36]];
function warped(u) {
  const d = u.map((x, k) => x - face[k]), far = d[0] ** 2 + d[1] ** 2 + d[2] ** 2, scale = 0.5 + (0.85 * far) / (far + 1.7);
  let p = d.map((x, k) => face[k] + x * scale);
  for (const [at, reach] of details) {
    const off = p.map((x, k) => x - at[k]), drawn = 0.5 * Math.exp(-(off[0] ** 2 + off[1] ** 2 + off[2] ** 2) / reach ** 2);
    p = p.map((x, k) => x - drawn * off[k]);
  }
  return p;
}

/** { positions, normals, cells, fit }: in the unit sphere, and what takes decimetres there. */
export function headMesh() {
  const cell = 0.076, nets = surfaceNets((u) => headAt(warped(u)), [-25 * cell, -40 * cell, -24 * cell], cell, [50, 63, 44], 2);
  const { positions, cells } = triangulated(relaxed({ positions: nets.positions.map(warped), cells: nets.cells }, onSurface, 4));
  const normals = positions.map(normal);
  const middle = [0, 1, 2].map((k) => (min(...positions.map((p) => p[k])) + max(...positions.map((p) => p[k]))) / 2);
  const radius = sqrt(max(...positions.map((p) => squared(p, middle))));
  const fit = (p) => p.map((x, k) => (x - middle[k]) / radius);
  return { positions: positions.map(fit), normals, cells, fit, radius };
}

// --- what lies on it, decimetres; `side`: 1 left, -1 right ---

/** The place of the skin near p, and the normal there. */
export function skinNear(p) {
  const at = onSurface(p, 8);
  return { at, normal: normal(at) };
}
/** Along the brow, from the nose (t = 0) outwards (1). */
export const browAt = (side, t) => skinNear([side * (0.115 + 0.43 * t), 0.185 + 0.23 * t - 0.235 * t * t, 0.86 - 0.22 * t * t]);
/** Along the seam of the lids, from the inner corner (-1) to the outer (1). */
export const lidAt = (side, t) => skinNear([side * (eye[0] + 0.005 + 0.19 * t), eye[1] - 0.075 + 0.065 * t * t, 0.77 - 0.06 * t * t]);
