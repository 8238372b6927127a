// Even triangles of a wanted size (Botsch and Kobbelt 2004, "A Remeshing Approach to Multiresolution Modeling", 3): long edges are
// split, short ones collapsed, others turned so that vertices have six neighbours, and vertices moved among these on the surface.
import { across, add, between, cross, dot, far, scaled, squared, sub, unit } from './vectors.mjs';

const edgeKey = (a, b) => (a < b ? a * 0x4000000 + b : b * 0x4000000 + a);
const normalOf = (positions, [a, b, c]) => cross(sub(positions[b], positions[a]), sub(positions[c], positions[a]));

/** For each edge { a, b, faces }, by its key. */
function edgesOf(cells) {
  const edges = new Map();
  cells.forEach((cell, face) => cell.forEach((a, i) => {
    const b = cell[(i + 1) % 3], key = edgeKey(a, b), known = edges.get(key);
    if (known) known.faces.push(face);
    else edges.set(key, { a, b, faces: [face] });
  }));
  return edges;
}

/** Numbers vertices anew, without those that no cell has. `keep(v)` is told of each that stays, in order. */
export function compacted({ positions, cells }, keep = () => {}) {
  const numbers = new Map();
  const out = { positions: [], cells: [] };
  for (const cell of cells) out.cells.push(cell.map((v) => {
    if (!numbers.has(v)) numbers.set(v, out.positions.length), out.positions.push(positions[v]), keep(v);
    return numbers.get(v);
  }));
  return out;
}

// The triangles of a cell whose edges i have a vertex middles[i], or undefined.
function pieces([a, b, c], middles, positions) {
  const [ab, bc, ca] = middles, count = middles.filter((v) => v !== undefined).length;
  if (count === 0) return [[a, b, c]];
  if (count === 3) return [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]];
  if (ab === undefined || (count === 1 && bc !== undefined)) return pieces([b, c, a], [bc, ca, ab], positions);
  if (count === 1) return [[a, ab, c], [ab, b, c]];
  if (bc === undefined) return pieces([c, a, b], [ca, ab, bc], positions);
  // Edges ab and bc are cut: the corner at b, and what is left, along its shorter diagonal.
  const rest = squared(positions[a], positions[bc]) < squared(positions[ab], positions[c]) ? [[a, ab, bc], [a, bc, c]] : [[a, ab, c], [ab, bc, c]];
  return [[ab, b, bc], ...rest];
}

/** Cuts edges where `cut(a, b)` gives a place; vertices there are new. */
function withCuts(mesh, cut) {
  const positions = [...mesh.positions], made = new Map();
  const middle = (a, b) => {
    const key = edgeKey(a, b);
    if (!made.has(key)) {
      const place = a < b ? cut(a, b) : cut(b, a);
      made.set(key, place ? positions.push(place) - 1 : undefined);
    }
    return made.get(key);
  };
  const cells = mesh.cells.flatMap(([a, b, c]) => pieces([a, b, c], [middle(a, b), middle(b, c), middle(c, a)], positions));
  return { positions, cells };
}

function split(mesh, sizes, sizeAt) {
  const out = withCuts(mesh, (a, b) => {
    const p = mesh.positions[a], q = mesh.positions[b];
    return far(p, q) > (4 / 3) * 0.5 * (sizes[a] + sizes[b]) ? between(p, q, 0.5) : undefined;
  });
  for (let v = sizes.length; v < out.positions.length; ++v) sizes.push(sizeAt(out.positions[v]));
  return out;
}

const facesAt = ({ positions, cells }) => {
  const faces = positions.map(() => []);
  cells.forEach((cell, face) => cell.forEach((v) => faces[v].push(face)));
  return faces;
};

// The vertices round v.
function ringOf(cells, faces, v) {
  const ring = [];
  for (const face of faces[v]) for (const w of cells[face]) if (w !== v && !ring.includes(w)) ring.push(w);
  return ring;
}

/** One pass, the shortest edges first. Says how many. */
function collapse(mesh, sizes, surface) {
  const { positions, cells } = mesh, faces = facesAt(mesh), gone = new Uint8Array(cells.length);
  const wanted = (a, b) => 0.5 * (sizes[a] + sizes[b]), shareOf = (a, b) => far(positions[a], positions[b]) / wanted(a, b);
  const short = [...edgesOf(cells).values()].map(({ a, b }) => ({ a, b, share: shareOf(a, b) })).filter(({ share }) => share < 4 / 5).sort((x, y) => x.share - y.share);
  let count = 0;
  for (const { a, b } of short) {
    const two = faces[a].filter((face) => cells[face].includes(b));
    if (two.length !== 2 || shareOf(a, b) >= 4 / 5) continue;
    const ringA = ringOf(cells, faces, a), ringB = ringOf(cells, faces, b);
    if (ringA.filter((v) => ringB.includes(v)).length !== 2) continue;
    const place = surface.onSurface(between(positions[a], positions[b], 0.5), 1), isNear = (v) => v === a || v === b || far(place, positions[v]) < (4 / 3) * wanted(a, v);
    const isSound = (face) => {
      if (two.includes(face)) return true;
      const was = normalOf(positions, cells[face]), now = normalOf(cells[face].map((v) => (v === a || v === b ? place : positions[v])), [0, 1, 2]);
      return dot(was, now) > 0.5 * Math.sqrt(dot(was, was) * dot(now, now));
    };
    if (!ringA.every(isNear) || !ringB.every(isNear) || !faces[a].every(isSound) || !faces[b].every(isSound)) continue;
    positions[a] = place;
    sizes[a] = wanted(a, b);
    for (const face of two) {
      gone[face] = 1;
      for (const v of cells[face]) if (v !== b) faces[v] = faces[v].filter((other) => other !== face);
    }
    for (const face of faces[b]) if (!gone[face]) cells[face] = cells[face].map((v) => (v === b ? a : v)), faces[a].push(face);
    faces[b] = [];
    ++count;
  }
  mesh.cells = cells.filter((_, face) => !gone[face]);
  return count;
}

/** One pass: edges far from each other. Says how many. */
function turn(mesh) {
  const { positions, cells } = mesh, edges = edgesOf(cells), still = new Uint8Array(positions.length), valence = new Int32Array(positions.length);
  for (const { a, b } of edges.values()) ++valence[a], ++valence[b];
  let count = 0;
  for (const { a, b, faces: two } of edges.values()) {
    if (two.length !== 2) continue;
    const [c, d] = two.map((face) => cells[face].find((v) => v !== a && v !== b));
    if ([a, b, c, d].some((v) => still[v]) || c === d || edges.has(edgeKey(c, d))) continue;
    const off = (v, change) => (valence[v] + change - 6) ** 2;
    if (off(a, -1) + off(b, -1) + off(c, 1) + off(d, 1) >= off(a, 0) + off(b, 0) + off(c, 0) + off(d, 0)) continue;
    // The first face has the edge from a to b.
    const first = cells[two[0]], forward = first[(first.indexOf(a) + 1) % 3] === b;
    const made = forward ? [[a, d, c], [d, b, c]] : [[a, c, d], [c, b, d]];
    const was = unit(add(unit(normalOf(positions, first)), unit(normalOf(positions, cells[two[1]]))));
    if (made.some((cell) => dot(unit(normalOf(positions, cell), [0, 0, 0]), was) < 0.6)) continue;
    two.forEach((face, i) => (cells[face] = made[i]));
    for (const v of [a, b, c, d]) still[v] = 1;
    ++count;
  }
  return count;
}

/** Vertices move along the surface to the middle of the triangles round them, the larger of which count more. */
function settle(mesh, sizes, surface, rounds) {
  for (let round = 0; round < rounds; ++round) {
    const { positions, cells } = mesh, sums = positions.map(() => [0, 0, 0, 0]), normals = positions.map(() => [0, 0, 0]);
    for (const cell of cells) {
      const n = normalOf(positions, cell), mean = scaled(add(add(positions[cell[0]], positions[cell[1]]), positions[cell[2]]), 1 / 3);
      const weight = Math.sqrt(dot(n, n)) / (sizes[cell[0]] + sizes[cell[1]] + sizes[cell[2]]) ** 2;
      for (const v of cell) {
        mean.forEach((x, k) => (sums[v][k] += weight * x));
        sums[v][3] += weight;
        normals[v] = add(normals[v], n);
      }
    }
    mesh.positions = positions.map((p, v) => {
      if (!(sums[v][3] > 0)) return p;
      const way = sub(scaled(sums[v], 1 / sums[v][3]), p);
      return surface.onSurface(add(p, scaled(across(way, unit(normals[v])), 0.7)), 1);
    });
  }
}

/** A closed mesh of triangles with edges about `sizeAt(place)` long, on that surface (surfaceOf() in nets.mjs). */
export function remeshed(mesh, sizeAt, surface, { rounds = 4 } = {}) {
  const sizes = mesh.positions.map(sizeAt);
  let out = { positions: [...mesh.positions], cells: mesh.cells.map((cell) => [...cell]) };
  for (let round = 0; round < rounds; ++round) {
    out = split(out, sizes, sizeAt);
    for (let pass = 0; pass < 3 && collapse(out, sizes, surface) > 0; ++pass);
    for (let pass = 0; pass < 3 && turn(out) > 0; ++pass);
    const kept = [];
    out = compacted(out, (v) => kept.push(v));
    sizes.splice(0, sizes.length, ...kept.map((v) => sizes[v]));
    settle(out, sizes, surface, round + 1 < rounds ? 1 : 3);
    out.positions.forEach((p, v) => (sizes[v] = sizeAt(p)));
  }
  out.positions = out.positions.map((p) => surface.onSurface(p, 3));
  return out;
}

/**
 * Cuts triangles along the line on which `field` is 0, so that none lies on both sides. Vertices near the line are moved onto it.
 * `surface`: that on which they stay.
 */
export function cutAlong(mesh, field, surface) {
  const positions = [...mesh.positions], values = positions.map(field);
  const nearest = new Map();
  for (const { a, b } of edgesOf(mesh.cells).values()) {
    if (values[a] < 0 === values[b] < 0) continue;
    const t = values[a] / (values[a] - values[b]), place = between(mesh.positions[a], mesh.positions[b], t);
    const [v, share] = t < 0.5 ? [a, t] : [b, 1 - t];
    if (share < 0.3 && share < (nearest.get(v)?.share ?? 1)) nearest.set(v, { share, place });
  }
  for (const [v, { place }] of nearest) positions[v] = surface.onSurface(place, 2), values[v] = 0;
  return withCuts({ positions, cells: mesh.cells }, (a, b) =>
    (values[a] * values[b] < 0 ? surface.onSurface(between(positions[a], positions[b], values[a] / (values[a] - values[b])), 2) : undefined));
}
