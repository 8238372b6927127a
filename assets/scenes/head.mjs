// A stylised head: smooth unions of round shapes, and a mesh of their surface. Decimetres, about the middle between the ears; x to
// the head's left, y up, z to the front.

const { abs, hypot, max, min, sqrt } = Math;

// --- shapes: signed distances, or nearly ---

const mixed = (a, b, t) => a + (b - a) * t;
const clamp = (x) => max(0, min(1, x));
/** The union, rounded over where both are nearer than k. */
const union = (a, b, k) => min(a, b) - (max(k - abs(a - b), 0) ** 2) / (4 * k);
/** What of a lies outside of b. */
const without = (a, b, k) => -union(-a, b, k);
const both = (a, b, k) => -union(-a, -b, k);
const ball = (p, c, r) => hypot(p[0] - c[0], p[1] - c[1], p[2] - c[2]) - r;
function egg(p, c, r) {
  const x = (p[0] - c[0]) / r[0], y = (p[1] - c[1]) / r[1], z = (p[2] - c[2]) / r[2];
  const far = hypot(x, y, z);
  return (far * (far - 1)) / max(hypot(x / r[0], y / r[1], z / r[2]), 1e-6);
}
/** From a to b, its radius from r to s. */
function limb(p, a, b, r, s) {
  const way = [b[0] - a[0], b[1] - a[1], b[2] - a[2]], from = [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
  const t = clamp((from[0] * way[0] + from[1] * way[1] + from[2] * way[2]) / (way[0] ** 2 + way[1] ** 2 + way[2] ** 2));
  return hypot(from[0] - t * way[0], from[1] - t * way[1], from[2] - t * way[2]) - mixed(r, s, t);
}
/** A bent limb through all points [x, y, z, radius]. */
const bent = (p, points, k) => points.slice(1).reduce((all, b, i) => {
  const a = points[i], d = limb(p, a, b, a[3], b[3]);
  return all === undefined ? d : union(all, d, k);
}, undefined);
const turned = ([x, y, z], c, angle) => {
  const cos = Math.cos(angle), sin = Math.sin(angle);
  return [c[0] + cos * (x - c[0]) - sin * (z - c[2]), y, c[2] + sin * (x - c[0]) + cos * (z - c[2])];
};

/** A groove of that depth where `far` is 0; below 0 a ridge. */
const groove = (far, depth, width) => depth * Math.exp(-((far / width) ** 2));

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

function headAt(place) {
  const p = [sqrt(place[0] ** 2 + 1e-4), place[1], place[2]];  // no crease in the middle
  return bust(p, ear(p, mouth(p, nose(p, eyes(p, skull(p))))));
}

// --- its mesh: surface nets (Gibson 1998) on a grid that is finer about the face ---

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

function gradient(p) {
  const e = 2e-3;
  return [0, 1, 2].map((k) => {
    const a = [...p], b = [...p];
    a[k] -= e, b[k] += e;
    return (headAt(b) - headAt(a)) / (2 * e);
  });
}
function onSurface(p, steps = 3) {
  for (let i = 0; i < steps; ++i) {
    const g = gradient(p), far = headAt(p) / max(g[0] ** 2 + g[1] ** 2 + g[2] ** 2, 0.05);
    p = p.map((x, k) => x - max(-0.03, min(0.03, far * g[k])));
  }
  return p;
}

function surfaceNets(at, low, cell, counts) {
  const [nx, ny, nz] = counts.map((n) => n + 1), values = new Float64Array(nx * ny * nz);
  const corner = (i, j, k) => i + nx * (j + ny * k), place = (i, j, k) => [low[0] + cell * i, low[1] + cell * j, low[2] + cell * k];
  for (let k = 0; k < nz; ++k) for (let j = 0; j < ny; ++j) for (let i = 0; i < nx; ++i) values[corner(i, j, k)] = at(place(i, j, k));
  const places = [], numbers = new Map(), cells = [];
  const vertex = (i, j, k) => {
    const key = corner(i, j, k), known = numbers.get(key);
    if (known !== undefined) return known;
    const sum = [0, 0, 0, 0];
    for (let e = 0; e < 12; ++e) {
      const axis = e >> 2, a = [0, 0, 0], b = [0, 0, 0];
      a[(axis + 1) % 3] = b[(axis + 1) % 3] = e & 1, a[(axis + 2) % 3] = b[(axis + 2) % 3] = (e >> 1) & 1, b[axis] = 1;
      const va = values[corner(i + a[0], j + a[1], k + a[2])], vb = values[corner(i + b[0], j + b[1], k + b[2])];
      if (va < 0 === vb < 0) continue;
      const t = va / (va - vb);
      a.forEach((x, n) => (sum[n] += mixed(x, b[n], t)));
      ++sum[3];
    }
    places.push([i, j, k].map((x, n) => low[n] + cell * (x + sum[n] / sum[3])));
    numbers.set(key, places.length - 1);
    return places.length - 1;
  };
  for (let k = 1; k < nz - 1; ++k) for (let j = 1; j < ny - 1; ++j) for (let i = 1; i < nx - 1; ++i) {
    const here = values[corner(i, j, k)] < 0;
    for (let axis = 0; axis < 3; ++axis) {
      const step = [0, 0, 0];
      step[axis] = 1;
      if (here === values[corner(i + step[0], j + step[1], k + step[2])] < 0) continue;
      const s = [0, 0, 0], t = [0, 0, 0];
      s[(axis + 1) % 3] = 1, t[(axis + 2) % 3] = 1;
      const quad = [[0, 0], [1, 0], [1, 1], [0, 1]].map(([a, b]) => vertex(i - a * s[0] - b * t[0], j - a * s[1] - b * t[1], k - a * s[2] - b * t[2]));
      cells.push(here ? quad : quad.reverse());
    }
  }
  return { places, cells };
}

/** Vertices evenly among their neighbours, and on the surface. */
function relaxed(positions, quads, rounds) {
  const near = positions.map(() => new Set());
  for (const quad of quads) quad.forEach((v, i) => near[v].add(quad[(i + 1) % 4]).add(quad[(i + 3) % 4]));
  for (let round = 0; round < rounds; ++round) {
    positions = positions.map((p, v) => {
      const mean = [0, 0, 0];
      for (const other of near[v]) positions[other].forEach((x, k) => (mean[k] += x / near[v].size));
      return onSurface(p.map((x, k) => mixed(x, mean[k], 0.5)), 1);
    });
  }
  return positions.map((p) => onSurface(p));
}

const squared = (a, b) => a.reduce((sum, x, k) => sum + (x - b[k]) ** 2, 0);

/** { positions, normals, cells, fit }: in the unit sphere, and what takes decimetres there. */
export function headMesh() {
  const cell = 0.076, nets = surfaceNets((u) => headAt(warped(u)), [-25 * cell, -40 * cell, -24 * cell], cell, [50, 63, 44]);
  const positions = relaxed(nets.places.map(warped), nets.cells, 4);
  const cells = nets.cells.flatMap(([a, b, c, d]) =>
    (squared(positions[a], positions[c]) <= squared(positions[b], positions[d]) ? [[a, b, c], [a, c, d]] : [[a, b, d], [b, c, d]]));
  const normals = positions.map((p) => {
    const g = gradient(p), length = hypot(...g);
    return g.map((x) => x / length);
  });
  const middle = [0, 1, 2].map((k) => (min(...positions.map((p) => p[k])) + max(...positions.map((p) => p[k]))) / 2);
  const radius = sqrt(max(...positions.map((p) => squared(p, middle))));
  const fit = (p) => p.map((x, k) => (x - middle[k]) / radius);
  return { positions: positions.map(fit), normals, cells, fit, radius };
}

// --- what lies on it, decimetres; `side`: 1 left, -1 right ---

/** The place of the skin near p, and the normal there. */
export function skinNear(p) {
  const at = onSurface(p, 8), g = gradient(at), length = hypot(...g);
  return { at, normal: g.map((x) => x / length) };
}
/** Along the brow, from the nose (t = 0) outwards (1). */
export const browAt = (side, t) => skinNear([side * (0.115 + 0.43 * t), 0.185 + 0.23 * t - 0.235 * t * t, 0.86 - 0.22 * t * t]);
/** Along the seam of the lids, from the inner corner (-1) to the outer (1). */
export const lidAt = (side, t) => skinNear([side * (eye[0] + 0.005 + 0.19 * t), eye[1] - 0.075 + 0.065 * t * t, 0.77 - 0.06 * t * t]);
