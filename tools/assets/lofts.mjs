// Solids along curves, for bodies and limbs that have no corners. Each is made once and then asked.
import { curve, tube } from './sculpt.mjs';
import { clamp } from './vectors.mjs';

const { max, min, sqrt } = Math;
const size = (x, y, z) => sqrt(x * x + y * y + z * z);

/** A limb along a curve through points [x, y, z, radius]. */
export function limbAlong(points, steps = 6) {
  const all = curve(points, steps);
  return (p) => tube(p, all);
}

/**
 * A body along a straight axis in the plane x = 0, of elliptic cross-sections: `stations` [s, front, back, half width], where `s` counts
 * along `way` from `from`, front and back along `front`.
 */
export function loft({ from, way, front }, stations) {
  const all = stations.map(([s, a, b, width]) => [s, (a + b) / 2, (a - b) / 2, width]), first = all[0][0], last = all.at(-1)[0];
  const slopes = all.map((at, i) => {
    const a = all[max(0, i - 1)], b = all[min(all.length - 1, i + 1)];
    return at.map((_, k) => (b[k] - a[k]) / (b[0] - a[0]));
  });
  return (p) => {
    const y = p[1] - from[1], z = p[2] - from[2], s = y * way[1] + z * way[2], at = clamp(s, first, last);
    let i = 0;
    while (i < all.length - 2 && at > all[i + 1][0]) ++i;
    const a = all[i], b = all[i + 1], h = b[0] - a[0], t = (at - a[0]) / h, t2 = t * t, t3 = t2 * t;
    const of = (k) => (2 * t3 - 3 * t2 + 1) * a[k] + (t3 - 2 * t2 + t) * h * slopes[i][k] + (3 * t2 - 2 * t3) * b[k] + (t3 - t2) * h * slopes[i + 1][k];
    const half = of(2), width = of(3), end = min(half, width);
    const x = p[0] / width, v = (y * front[1] + z * front[2] - of(1)) / half, over = (s - at) / end, far = size(x, v, over);
    return (far * (far - 1)) / max(size(x / width, v / half, over / end), 1e-6);
  };
}

/** How far p is from the box, at least. */
export const fromBox = (p, [low, high]) => size(max(low[0] - p[0], 0, p[0] - high[0]), max(low[1] - p[1], 0, p[1] - high[1]), max(low[2] - p[2], 0, p[2] - high[2]));
