// Bodies for the scenes that ship. Each is a list of patches: functions of (s, t) in 0..1, which give a place on the
// body and the normal there, and which part of the scene the patch belongs to. meshOf() lays them out side by
// side in one square atlas, so that a map over it can be painted by places instead of by texture coordinates.

const add = (a, b) => a.map((x, i) => x + b[i]);
const scale = (a, k) => a.map((x) => x * k);
const unit = (a) => scale(a, 1 / Math.hypot(...a));

// The six sides of a cube [-1, 1]^3: where (0, 0) is, and the ways along s and t; s cross t points outwards.
const sides = [
  [[1, -1, 1], [0, 0, -2], [0, 2, 0]], [[-1, -1, -1], [0, 0, 2], [0, 2, 0]],
  [[-1, 1, 1], [2, 0, 0], [0, 0, -2]], [[-1, -1, -1], [2, 0, 0], [0, 0, 2]],
  [[-1, -1, 1], [2, 0, 0], [0, 2, 0]], [[1, -1, -1], [-2, 0, 0], [0, 2, 0]],
];
const onSide = ([corner, along, up], s, t) => add(corner, add(scale(along, s), scale(up, t)));

/** A sphere whose patches are the sides of a cube, blown up. `part` is handed to what paints it. */
export const sphere = ({ centre = [0, 0, 0], radius = 1, cells = 12, part = 0 } = {}) => sides.map((side) => ({
  cells,
  part,
  at: (s, t) => {
    // Equal angles instead of equal steps: cells of nearly one size.
    const normal = unit(onSide(side, s, t).map((x) => Math.tan((x * Math.PI) / 4)));
    return { position: add(centre, scale(normal, radius)), normal };
  },
}));

/** A rod along x with round ends, all in one patch: s along it, t round it. `half` is half the length of its straight part. */
export const rod = ({ half = 1, radius = 0.5, cells = 36 } = {}) => [{
  cells,
  part: 0,
  at: (s, t) => {
    const quarter = (Math.PI / 2) * radius, way = Math.max(0, Math.min(1, s)) * 2 * (quarter + half) - quarter - half;
    const x = Math.max(-half, Math.min(half, way)), tilt = (way - x) / radius, round = 2 * Math.PI * t;
    const normal = [Math.sin(tilt), -Math.cos(tilt) * Math.cos(round), Math.cos(tilt) * Math.sin(round)];
    return { position: add([x, 0, 0], scale(normal, radius)), normal };
  },
}];

/**
 * Vertices, texture coordinates and triangles of patches, and the way back from an atlas texel to the body. Rays that
 * cross the fur at a slant look beyond a patch: `gutterShare` of its cell, on each side, is there for them.
 */
export function meshOf(patches, gutterShare = 0.18) {
  const columns = Math.ceil(Math.sqrt(patches.length)), pitch = 1 / columns, gutter = gutterShare * pitch, inner = pitch - 2 * gutter;
  const mesh = { positions: [], normals: [], uv: [], indices: [] };
  patches.forEach(({ cells, at }, number) => {
    const base = mesh.positions.length / 3, corner = [number % columns, Math.floor(number / columns)];
    for (let j = 0; j <= cells; ++j) {
      for (let i = 0; i <= cells; ++i) {
        const { position, normal } = at(i / cells, j / cells);
        mesh.positions.push(...position);
        mesh.normals.push(...normal);
        mesh.uv.push(corner[0] * pitch + gutter + (inner * i) / cells, corner[1] * pitch + gutter + (inner * j) / cells);
      }
    }
    const vertex = (i, j) => base + j * (cells + 1) + i;
    for (let j = 0; j < cells; ++j) {
      for (let i = 0; i < cells; ++i) {
        mesh.indices.push(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1));
        mesh.indices.push(vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1));
      }
    }
  });

  /** What lies at (u, v): a place of the patch there, in its gutter one beyond its border; after the last patch, one of the last. */
  const placeAt = (u, v) => {
    const column = Math.min(columns - 1, Math.floor(u / pitch)), row = Math.min(columns - 1, Math.floor(v / pitch));
    const patch = patches[Math.min(row * columns + column, patches.length - 1)];
    const along = (x, cell) => (x - cell * pitch - gutter) / inner;
    return { ...patch.at(along(u, column), along(v, row)), part: patch.part };
  };
  return { mesh, placeAt };
}
