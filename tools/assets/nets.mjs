// From a solid (sculpt.mjs) to a mesh of its surface: surface nets (Gibson 1998) on a grid. A mesh is { positions, cells }: triangles or
// quads, counter-clockwise seen from outside.
import { mixed, squared } from './vectors.mjs';

const { max, min } = Math;

/** { gradient(p), onSurface(p, steps), normal(p) } of a solid; `step`: of differences; `most`: how far one step to the surface may go. */
export function surfaceOf(at, { step = 2e-3, most = 0.03 } = {}) {
  const gradient = (p) => [0, 1, 2].map((k) => {
    const a = [...p], b = [...p];
    a[k] -= step, b[k] += step;
    return (at(b) - at(a)) / (2 * step);
  });
  const onSurface = (p, steps = 3) => {
    for (let i = 0; i < steps; ++i) {
      const g = gradient(p), far = at(p) / max(g[0] ** 2 + g[1] ** 2 + g[2] ** 2, 0.05);
      p = p.map((x, k) => x - max(-most, min(most, far * g[k])));
    }
    return p;
  };
  const normal = (p) => {
    const g = gradient(p), size = Math.hypot(...g);
    return g.map((x) => x / size);
  };
  return { gradient, onSurface, normal };
}

const kBlock = 4;

// The solid at every corner of the grid. Of blocks that are farther from its surface than they are large only the sign is true.
function sampled(at, low, cell, [nx, ny, nz], steep) {
  const values = new Float64Array(nx * ny * nz), reach = steep * kBlock * cell * Math.sqrt(3) / 2;
  const place = (i, j, k) => [low[0] + cell * i, low[1] + cell * j, low[2] + cell * k], half = (kBlock - 1) / 2;
  for (let z = 0; z < nz; z += kBlock) for (let y = 0; y < ny; y += kBlock) for (let x = 0; x < nx; x += kBlock) {
    const middle = at(place(x + half, y + half, z + half)), near = Math.abs(middle) < reach;
    for (let k = z; k < min(nz, z + kBlock); ++k) for (let j = y; j < min(ny, y + kBlock); ++j) for (let i = x; i < min(nx, x + kBlock); ++i)
      values[i + nx * (j + ny * k)] = near ? at(place(i, j, k)) : middle;
  }
  return values;
}

/** Quads on a grid of `counts` cells, each a cube of that side, whose first corner is `low`. `at` changes by at most `steep` a unit. */
export function surfaceNets(at, low, cell, counts, steep = 1.5) {
  const sizes = counts.map((n) => n + 1), [nx, ny, nz] = sizes, values = sampled(at, low, cell, sizes, steep);
  const corner = (i, j, k) => i + nx * (j + ny * k);
  const positions = [], numbers = new Map(), cells = [];
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
    positions.push([i, j, k].map((x, n) => low[n] + cell * (x + sum[n] / sum[3])));
    numbers.set(key, positions.length - 1);
    return positions.length - 1;
  };
  const strides = [1, nx, nx * ny];
  for (let k = 1; k < nz - 1; ++k) for (let j = 1; j < ny - 1; ++j) for (let i = 1; i < nx - 1; ++i) {
    const from = corner(i, j, k), here = values[from] < 0;
    for (let axis = 0; axis < 3; ++axis) {
      if (here === values[from + strides[axis]] < 0) continue;
      const s = [0, 0, 0], t = [0, 0, 0];
      s[(axis + 1) % 3] = 1, t[(axis + 2) % 3] = 1;
      const quad = [[0, 0], [1, 0], [1, 1], [0, 1]].map(([a, b]) => vertex(i - a * s[0] - b * t[0], j - a * s[1] - b * t[1], k - a * s[2] - b * t[2]));
      cells.push(here ? quad : quad.reverse());
    }
  }
  return { positions, cells };
}

/** Vertices evenly among their neighbours, and on the surface. */
export function relaxed({ positions, cells }, onSurface, rounds) {
  const near = positions.map(() => new Set());
  for (const cell of cells) cell.forEach((v, i) => near[v].add(cell[(i + 1) % cell.length]).add(cell[(i + cell.length - 1) % cell.length]));
  for (let round = 0; round < rounds; ++round) {
    positions = positions.map((p, v) => {
      const mean = [0, 0, 0];
      for (const other of near[v]) positions[other].forEach((x, k) => (mean[k] += x / near[v].size));
      return onSurface(p.map((x, k) => mixed(x, mean[k], 0.5)), 1);
    });
  }
  return { positions: positions.map((p) => onSurface(p)), cells };
}

/** Quads cut along their shorter diagonal. */
export const triangulated = ({ positions, cells }) => ({
  positions,
  cells: cells.flatMap(([a, b, c, d]) => (squared(positions[a], positions[c]) <= squared(positions[b], positions[d]) ? [[a, b, c], [a, c, d]] : [[a, b, d], [b, c, d]])),
});
