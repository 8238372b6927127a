// From a description of an animal to its file: mesh, materials, atlas, maps, rig, animations and fur.
import { animalGlb } from './glb.mjs';
import { longHair } from './hair.mjs';
import { surfaceNets, surfaceOf, triangulated } from './nets.mjs';
import { byte, packedPlanes, pictureOf, placesOn } from './paint.mjs';
import { fitOf, laidOut, wornOf } from './program.mjs';
import { compacted, cutAlong, remeshed } from './remesh.mjs';
import { weightBytes } from './rig.mjs';
import { add, scaled, unit } from './vectors.mjs';

/**
 * The surface of a solid as { positions, normals, cells, surface }. `box`: [low, high] corners round it, `cell`: of the first grid, no larger
 * than its finest parts; `sizeAt(p)`: how long edges are to be; `lines`: fields along whose 0 triangles are cut.
 */
export function sculpted({ at, box: [low, high], cell, sizeAt, lines = [], rounds = 4 }) {
  const surface = surfaceOf(at, { step: 0.1 * cell, most: cell });
  const nets = triangulated(surfaceNets(at, low, cell, low.map((x, k) => Math.ceil((high[k] - x) / cell))));
  let mesh = remeshed({ ...nets, positions: nets.positions.map((p) => surface.onSurface(p, 2)) }, sizeAt, surface, { rounds });
  for (const line of lines) mesh = compacted(cutAlong(mesh, line, surface));
  return { ...mesh, normals: mesh.positions.map(surface.normal), surface };
}

/** `materialOf` of a mesh by the middle of each triangle: `at(p)`, a number. */
export function materialsBy({ positions, cells }, at) {
  const known = new Map(cells.map((cell) => [cell, at(scaled(cell.reduce((sum, v) => add(sum, positions[v]), [0, 0, 0]), 1 / 3))]));
  return (cell) => known.get(cell);
}

/** A mesh that was sculpted with its mouth open (jaws.mjs), with its mouth shut. */
export const shut = (mesh, jaw) => ({ ...mesh, positions: mesh.positions.map(jaw.closed), normals: mesh.positions.map((p, v) => jaw.closedWay(p, mesh.normals[v])) });

/** A closed body of rings round an axis: claws, eyeballs. `rings`: [{ at, radius: [across, up] }] from its first pole to its last, `axes`: across, up. */
export function turnedBody(rings, [across, up], segments, [first, last]) {
  const positions = [first], cells = [], ring = (i) => 1 + i * segments;
  for (const { at, radius: [a, b] } of rings)
    for (let k = 0; k < segments; ++k) {
      const angle = (2 * Math.PI * k) / segments;
      positions.push(add(at, add(scaled(across, a * Math.cos(angle)), scaled(up, b * Math.sin(angle)))));
    }
  positions.push(last);
  const end = positions.length - 1, next = (k) => (k + 1) % segments;
  for (let k = 0; k < segments; ++k) {
    cells.push([0, ring(0) + next(k), ring(0) + k], [end, ring(rings.length - 1) + k, ring(rings.length - 1) + next(k)]);
    for (let i = 0; i + 1 < rings.length; ++i) {
      const [a, b, c, d] = [ring(i) + k, ring(i) + next(k), ring(i + 1) + next(k), ring(i + 1) + k];
      cells.push([a, b, c], [a, c, d]);
    }
  }
  return withNormals({ positions, cells });
}

/** Normals from the triangles round each vertex. */
export function withNormals({ positions, cells, ...more }) {
  const normals = positions.map(() => [0, 0, 0]);
  for (const [a, b, c] of cells) {
    const [p, q, r] = [a, b, c].map((v) => positions[v]), u = q.map((x, k) => x - p[k]), w = r.map((x, k) => x - p[k]);
    const n = [u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]];
    for (const v of [a, b, c]) normals[v] = add(normals[v], n);
  }
  return { positions, cells, normals: normals.map((n) => unit(n)), ...more };
}

// As files have them: whoever reads those finds whiskers on the very surface on which they were planted.
const filed = (p) => p.map((x) => Math.round(x * 2048) / 2048);

// All bodies as one mesh, with the material of each triangle and the weights of each vertex.
function gathered(bodies) {
  const all = { positions: [], normals: [], cells: [], materials: [], weights: [], uv1: [] };
  for (const { positions, normals, cells, materialOf, weights, uv1 } of bodies) {
    const base = all.positions.length;
    const none = () => positions.map(() => undefined);
    for (const [key, list] of Object.entries({ positions: positions.map(filed), normals, weights: weights ?? none(), uv1: uv1 ?? none() })) all[key].push(...list);
    for (const cell of cells) {
      all.cells.push(cell.map((v) => base + v));
      all.materials.push(materialOf(cell));
    }
  }
  return all;
}

// Triangles near each other one after the other (Morton 1966), so that files pack.
function inOrder(mesh) {
  const { of } = fitOf(mesh.positions), bits = (x) => Math.min(1023, Math.floor(512 * (x + 1)));
  const code = (cell) => {
    const at = of([0, 1, 2].map((k) => (mesh.positions[cell[0]][k] + mesh.positions[cell[1]][k] + mesh.positions[cell[2]][k]) / 3)).map(bits);
    let out = 0;
    for (let bit = 9; bit >= 0; --bit) for (const x of at) out = 2 * out + ((x >> bit) & 1);
    return out;
  };
  const codes = mesh.cells.map(code), order = [...codes.keys()].sort((a, b) => codes[a] - codes[b] || a - b);
  return { ...mesh, cells: order.map((t) => mesh.cells[t]), materials: order.map((t) => mesh.materials[t]) };
}

// The vertices and triangles of one material; `uv` is one a corner of the whole mesh.
function partOf(mesh, atlas, material, comb) {
  const numbers = new Map(), vertices = [], indices = [];
  mesh.cells.forEach((cell, t) => {
    if (mesh.materials[t] !== material) return;
    cell.forEach((v, k) => {
      const uv = atlas[3 * t + k], key = `${v} ${uv}`;
      if (!numbers.has(key)) {
        numbers.set(key, vertices.length);
        const { joints, bytes } = mesh.weights[v] ? weightBytes(mesh.weights[v]) : {}, position = mesh.positions[v], normal = mesh.normals[v];
        vertices.push({ position, normal, uv, ...joints && { joints, weights: bytes }, ...mesh.uv1[v] && { uv1: mesh.uv1[v] }, ...comb && { comb: comb({ position, normal }) } });
      }
      indices.push(numbers.get(key));
    });
  });
  return { vertices, indices };
}

/** Fur that hangs over a border gets its colour from beyond it: what has another picture or one colour leaves that place to what lies round it. */
const hasAtlas = ({ json }) => !json || json.pbrMetallicRoughness.baseColorTexture?.index === 0;

/**
 * The file of an animal. `bodies`: [{ positions, normals, cells, materialOf(cell), weights }]; `materials`: [{ name, furry?, json? }]; of places
 * { position, normal, part: number of the material }: `colour(place)` gives [r, g, b] where a material has the picture of the atlas,
 * `groom(place)` [length, types 2 to 4], `comb(place)` a lean in radians along the skin; `steps(fit)` dresses it, or `hair(fit)` says what hair.mjs
 * makes long hair of; `pictures`: PNG files beside that of the atlas, which is the first. Without `rig` and `animations` it stands still; without
 * `colour` there is no picture of the atlas, without `state` it is shown in the coat that is there.
 */
export function animalFile(program, { name, rig, bodies, materials, colour, groom, comb, steps = () => [], hair, animations = [], state, pictures = [], colourSize = 512, mapSize = 256 }) {
  const mesh = inOrder(gathered(bodies)), fit = fitOf(mesh.positions);
  const { atlas, glb } = laidOut(program, mesh, steps(fit));
  const parts = materials.map(({ furry }, material) => ({ material, ...partOf(mesh, atlas, material, furry && comb) })).filter(({ indices }) => indices.length);
  const corners = mesh.cells.flat().map((v, i) => ({ position: mesh.positions[v], normal: mesh.normals[v], uv: atlas[i] }));
  const triangles = mesh.cells.map((_, t) => ({ corners: [3 * t, 3 * t + 1, 3 * t + 2], part: mesh.materials[t] }));
  const texels = placesOn(mapSize, corners, triangles).map((place) => groom(place).map(byte));
  const file = animalGlb({
    name, rig, animations, parts,
    materials: materials.map(({ name: label, json }) => ({ name: label, pbrMetallicRoughness: { metallicFactor: 0, roughnessFactor: 0.8, ...colour && { baseColorTexture: { index: 0 } } }, ...json })),
    pictures: [...colour ? [pictureOf(colourSize, placesOn(colourSize, corners, triangles.filter(({ part }) => hasAtlas(materials[part]))).map(colour))] : [], ...pictures],
    bare: materials.flatMap(({ furry }, i) => (furry ? [] : [i])),
    fur: (writer) => ({ ...state && { state: { version: 1, ...state } }, groom: { size: mapSize, bufferView: writer.view(packedPlanes(texels)), texCoord: 0 }, ...wornOf(glb, writer, fit), ...hair && { hair: longHair(writer, rig, (size, reach) => placesOn(size, corners, triangles, reach), hair(fit)) } }),
  });
  return { file, triangles: mesh.cells.length, fit };
}

