// Solids as signed distances, or nearly: functions of a place p = [x, y, z] that are below 0 inside. Any unit of length.
import { clamp, mixed } from './vectors.mjs';

const { abs, cos, exp, max, min, sin, sqrt } = Math;

// Math.hypot() is ten times as slow.
const size = (x, y, z) => sqrt(x * x + y * y + z * z);

/** The union, rounded over where both are nearer than k. */
export const union = (a, b, k) => min(a, b) - (max(k - abs(a - b), 0) ** 2) / (4 * k);
/** What of a lies outside of b. */
export const without = (a, b, k) => -union(-a, b, k);
export const both = (a, b, k) => -union(-a, -b, k);

export const ball = (p, c, r) => size(p[0] - c[0], p[1] - c[1], p[2] - c[2]) - r;

/** An ellipsoid with half axes r. */
export function egg(p, c, r) {
  const x = (p[0] - c[0]) / r[0], y = (p[1] - c[1]) / r[1], z = (p[2] - c[2]) / r[2];
  const far = size(x, y, z);
  return (far * (far - 1)) / max(size(x / r[0], y / r[1], z / r[2]), 1e-6);
}

/** How far along from a to b the place nearest to p is, 0..1. */
export function along(p, a, b) {
  const x = b[0] - a[0], y = b[1] - a[1], z = b[2] - a[2];
  return clamp(((p[0] - a[0]) * x + (p[1] - a[1]) * y + (p[2] - a[2]) * z) / (x * x + y * y + z * z));
}

/** From a to b, its radius from r to s. */
export function limb(p, a, b, r, s) {
  const x = b[0] - a[0], y = b[1] - a[1], z = b[2] - a[2], dx = p[0] - a[0], dy = p[1] - a[1], dz = p[2] - a[2];
  const t = clamp((dx * x + dy * y + dz * z) / (x * x + y * y + z * z));
  return size(dx - t * x, dy - t * y, dz - t * z) - mixed(r, s, t);
}

/** A bent limb through all points [x, y, z, radius]. */
export function bent(p, points, k) {
  let all = limb(p, points[0], points[1], points[0][3], points[1][3]);
  for (let i = 2; i < points.length; ++i) all = union(all, limb(p, points[i - 1], points[i], points[i - 1][3], points[i][3]), k);
  return all;
}

/** A groove of that depth where `far` is 0; below 0 a ridge. It is added to a solid. */
export const groove = (far, depth, width) => depth * exp(-((far / width) ** 2));

// --- ways to place a shape: p as the shape sees it ---

/** Turned about the axis through c that is parallel to y. */
export const turned = ([x, y, z], c, angle) => {
  const co = cos(angle), si = sin(angle);
  return [c[0] + co * (x - c[0]) - si * (z - c[2]), y, c[2] + si * (x - c[0]) + co * (z - c[2])];
};
/** The same about an axis that is parallel to x, y or z (0, 1, 2): right-handed. */
export const turnedAbout = (axis, p, c, angle) => {
  const i = (axis + 1) % 3, j = (axis + 2) % 3, co = cos(angle), si = sin(angle), out = [...p];
  out[i] = c[i] + co * (p[i] - c[i]) + si * (p[j] - c[j]);
  out[j] = c[j] - si * (p[i] - c[i]) + co * (p[j] - c[j]);
  return out;
};
/** Both halves are as the half with x > 0; within `round` of the middle there is no crease. */
export const mirrored = (at, round) => (p) => at([sqrt(p[0] ** 2 + round ** 2), p[1], p[2]]);

/** `points` [x, y, z, radius] and `steps` - 1 more between each two of them, on a smooth curve (Catmull and Rom 1974). */
export function curve(points, steps) {
  const at = (i) => points[max(0, min(points.length - 1, i))];
  const out = [];
  for (let i = 0; i + 1 < points.length; ++i) for (let s = 0; s < steps; ++s) {
    const t = s / steps, [a, b, c, d] = [at(i - 1), at(i), at(i + 1), at(i + 2)];
    out.push(b.map((x, k) => x + 0.5 * t * (c[k] - a[k] + t * (2 * a[k] - 5 * x + 4 * c[k] - d[k] + t * (3 * (x - c[k]) + d[k] - a[k])))));
  }
  return [...out, points.at(-1)];
}

/** A tube along such a curve. In steps short enough it has no creases, nor the bulges that bent() has where limbs meet. */
export function tube(p, points) {
  let all = Infinity;
  for (let i = 1; i < points.length; ++i) {
    const a = points[i - 1], b = points[i];
    all = min(all, limb(p, a, b, a[3], b[3]));
  }
  return all;
}
