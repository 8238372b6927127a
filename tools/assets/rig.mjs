// Joints, and how much of each a vertex takes. At rest no joint is turned: each only stands off from its parent.
import { along, limb } from './sculpt.mjs';
import { far, sub } from './vectors.mjs';

/**
 * Joints from rows [name, parent or null, [x, y, z] in the space of the model], parents first.
 * `joint(name)`: its number; `place(name)`: where it is at rest.
 */
export function skeleton(rows) {
  const number = new Map(rows.map(([name], i) => [name, i]));
  const joints = rows.map(([name, parent, at], i) => {
    const of = parent === null ? -1 : number.get(parent);
    if (of === undefined || of >= i) throw new Error(`the joint ${name} comes before its parent ${parent}`);
    return { name, parent: of, at, offset: of < 0 ? at : sub(at, rows[of][2]) };
  });
  const joint = (name) => {
    if (!number.has(name)) throw new Error(`there is no joint ${name}`);
    return number.get(name);
  };
  return { joints, joint, place: (name) => joints[joint(name)].at };
}

/** Rows for both sides: names end in L, at x > 0, and in R. */
export const sides = (rows) => ['L', 'R'].flatMap((side) => rows.map(([name, parent, [x, y, z]]) =>
  [name + side, typeof parent === 'string' && parent.startsWith('+') ? parent.slice(1) + side : parent, [side === 'L' ? x : -x, y, z]]));

/**
 * Which bone a place belongs to: the one that is fewest of its own radii away. `bones`: { joint, from, to, radius, end, only }; `only(p)`:
 * places that it may have.
 */
export function boneAt(bones, p) {
  let best, least = Infinity;
  for (const bone of bones) {
    if (bone.only && !bone.only(p)) continue;
    const radius = bone.radius + ((bone.end ?? bone.radius) - bone.radius) * along(p, bone.from, bone.to);
    const share = (limb(p, bone.from, bone.to, 0, 0)) / radius;
    if (share < least) least = share, best = bone;
  }
  return best;
}

function neighbours({ positions, cells }) {
  const near = positions.map(() => new Set());
  for (const cell of cells) cell.forEach((v, i) => near[v].add(cell[(i + 1) % 3]).add(cell[(i + 2) % 3]));
  return near.map((set) => [...set]);
}

/**
 * For each vertex [[joint, weight], ...]: all of its bone at first, then spread over the surface, so that nothing crosses from one leg
 * to the other. `width(p)`: how far it spreads.
 */
export function boneWeights(mesh, { joint }, bones, width, { rounds = 48 } = {}) {
  const { positions } = mesh, near = neighbours(mesh), count = 1 + Math.max(...bones.map((bone) => joint(bone.joint)));
  let shares = positions.map((p) => {
    const row = new Float64Array(count);
    row[joint(boneAt(bones, p).joint)] = 1;
    return row;
  });
  // A step to the mean of neighbours at a distance e spreads by a variance of about e^2 / 2.
  const step = positions.map((p, v) => {
    const edge = near[v].reduce((sum, w) => sum + far(p, positions[w]), 0) / near[v].length;
    return Math.min(0.9, (2 * width(p) ** 2) / (rounds * edge * edge));
  });
  for (let round = 0; round < rounds; ++round)
    shares = shares.map((row, v) => {
      const out = new Float64Array(count), own = 1 - step[v], others = step[v] / near[v].length;
      for (let j = 0; j < count; ++j) out[j] = own * row[j];
      for (const w of near[v]) for (let j = 0; j < count; ++j) out[j] += others * shares[w][j];
      return out;
    });
  return shares.map((row) => fourOf([...row].map((weight, j) => [j, weight])));
}

/** The four greatest, with a sum of 1. */
export function fourOf(weights) {
  const best = weights.filter(([, weight]) => weight > 0.004).sort((a, b) => b[1] - a[1]).slice(0, 4), sum = best.reduce((all, [, w]) => all + w, 0);
  return best.map(([j, weight]) => [j, weight / sum]);
}

/** The same as bytes, of which four add up to 255. */
export function weightBytes(weights) {
  const joints = [0, 0, 0, 0], bytes = [0, 0, 0, 0];
  weights.forEach(([j, weight], i) => (joints[i] = j, bytes[i] = Math.round(255 * weight)));
  bytes[0] += 255 - bytes.reduce((a, b) => a + b, 0);
  return { joints: joints.map((j, i) => (bytes[i] > 0 ? j : 0)), bytes };
}
