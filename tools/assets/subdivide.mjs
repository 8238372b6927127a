// A finer, rounder mesh where one is wanted (Loop 1987).
const key = (a, b) => (a < b ? `${a} ${b}` : `${b} ${a}`);
const sides = ([a, b, c]) => [[a, b], [b, c], [c, a]];

function edgesOf(cells) {
  const edges = new Map();
  for (const cell of cells) for (let k = 0; k < 3; ++k) {
    const [a, b, opposite] = [cell[k], cell[(k + 1) % 3], cell[(k + 2) % 3]], edge = edges.get(key(a, b)) ?? { a, b, opposite: [] };
    edge.opposite.push(opposite);
    edges.set(key(a, b), edge);
  }
  return edges;
}

/** The triangles that stand for one with `middles` on some of its sides. */
function parted([a, b, c], [x, y, z]) {
  const count = [x, y, z].filter((v) => v !== undefined).length;
  if (count === 0) return [[a, b, c]];
  if (count === 3) return [[a, x, z], [x, b, y], [z, y, c], [x, y, z]];
  // Turned until the first side is parted and, where two are, the last one is not.
  if (x === undefined || (count === 2 && y === undefined)) return parted([b, c, a], [y, z, x]);
  return count === 1 ? [[a, x, c], [x, b, c]] : [[a, x, c], [x, b, y], [x, y, c]];
}

/**
 * { positions, cells }: triangles with all corners where `within(p)` is true become four, those next to them two or three, and the corners there
 * move; edges with one triangle stay a line.
 */
export function subdivided({ positions, cells }, within = () => true) {
  const edges = edgesOf(cells), near = positions.map(() => []), border = positions.map(() => []), inside = positions.map(within);
  for (const { a, b, opposite } of edges.values()) for (const [v, other] of [[a, b], [b, a]]) (near[v].push(other), opposite.length === 1 && border[v].push(other));
  const sum = (...terms) => [0, 1, 2].map((k) => terms.reduce((total, [weight, v]) => total + weight * positions[v][k], 0));
  const moved = positions.map((p, v) => {
    if (border[v].length) return inside[v] && border[v].length === 2 ? sum([0.75, v], ...border[v].map((u) => [0.125, u])) : p;
    const count = near[v].length, weight = count === 3 ? 3 / 16 : 3 / (8 * Math.max(count, 1));
    return inside[v] && count ? sum([1 - count * weight, v], ...near[v].map((u) => [weight, u])) : p;
  });
  const middle = new Map();
  for (const [name, { a, b, opposite }] of edges) {
    if (!inside[a] || !inside[b]) continue;
    middle.set(name, moved.length);
    moved.push(opposite.length === 2 ? sum([0.375, a], [0.375, b], ...opposite.map((v) => [0.125, v])) : sum([0.5, a], [0.5, b]));
  }
  return { positions: moved, cells: cells.flatMap((cell) => parted(cell, sides(cell).map(([from, to]) => middle.get(key(from, to))))) };
}
