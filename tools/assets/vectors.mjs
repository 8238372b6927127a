// Arithmetic on [x, y, z].

export const add = (a, b) => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const sub = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scaled = (a, k) => [a[0] * k, a[1] * k, a[2] * k];
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const length = (a) => Math.sqrt(dot(a, a));
export const squared = (a, b) => (a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2 + (a[2] - b[2]) ** 2;
export const far = (a, b) => Math.sqrt(squared(a, b));
export const unit = (a, or = [0, 1, 0]) => {
  const size = length(a);
  return size > 1e-12 ? scaled(a, 1 / size) : or;
};
export const between = (a, b, t) => [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t];
/** The part of a across the unit vector n. */
export const across = (a, n) => sub(a, scaled(n, dot(a, n)));

export const mixed = (a, b, t) => a + (b - a) * t;
export const clamp = (x, low = 0, high = 1) => Math.max(low, Math.min(high, x));
/** From a at 0 and below to b at 1 and above: places, directions, colours. */
export const blend = (a, b, t) => a.map((x, k) => mixed(x, b[k], clamp(t)));
/** From 0 at `low` to 1 at `high`, which may be below it. */
export const smooth = (low, high, x) => {
  const t = clamp((x - low) / (high - low));
  return t * t * (3 - 2 * t);
};

/** How far hair leans that is to lie along `way`: `lean` radians across the unit vector `normal`, and less where its way leads along that. */
export function leaning(way, normal, lean, full = 0.35) {
  const flat = across(way, normal), size = length(flat);
  return size < 1e-3 ? [0, 0, 0] : scaled(flat, (1 / size) * lean * smooth(0, full, size));
}
