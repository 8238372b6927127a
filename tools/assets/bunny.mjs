// The bunny: a scanned surface, which comes from its package when the project is built, with eyes, lids and shorter fur on its head.
import { animalFile, withNormals } from './animal.mjs';
import { eyeball, eyeColours, eyeOf, lid } from './eyes.mjs';
import { hex, pictureOf } from './paint.mjs';
import { fitOf } from './program.mjs';
import { subdivided } from './subdivide.mjs';
import { add, between, blend, dot, far, leaning, mixed, scaled, smooth, sub, unit } from './vectors.mjs';

const { hypot, max } = Math;

// All places are in the unit sphere. Its head looks aside.
const front = [-0.56, 0, 0.83], right = [0.83, 0, 0.56];
const radius = 0.05, sides = [{ side: 1, near: [-0.725, 0.3, 0.125] }, { side: -1, near: [-0.4, 0.3, 0.34] }];

/** The nearest vertex, and the normal of what lies about it. */
function skinAt({ positions, normals }, near) {
  let at = 0, way = [0, 0, 0];
  positions.forEach((p, v) => (far(p, near) < far(positions[at], near) ? (at = v) : 0));
  positions.forEach((p, v) => (far(p, positions[at]) < 0.08 ? (way = add(way, normals[v])) : 0));
  return { at: positions[at], normal: unit(way) };
}

function eyesOf(body) {
  return sides.map(({ near }) => {
    const { at, normal } = skinAt(body, near), out = unit(add(normal, scaled(front, 0.25)));
    return eyeOf(1, { at: sub(at, scaled(normal, 0.45 * radius)), radius, gaze: out, nose: unit(add(front, [0, -0.5, 0])) });
  });
}

const open = (t) => max(0, 1 - (t / 62) ** 2);
const lids = [{ sign: 1, edge: (t) => -4 + 46 * open(t), outer: 1.12 }, { sign: -1, edge: (t) => -4 - 36 * open(t), outer: 1.1 }];

const eyePicture = () => pictureOf(64, eyeColours(64, (x, y) => {
  const iris = blend(hex('#4a2a16'), hex('#7a4a26'), 0.6 * smooth(0.2, -0.7, y)), pupil = smooth(0.42, 0.5, hypot(x, y)), rim = smooth(0.6, 0.8, hypot(x, y));
  return blend(blend([0.01, 0.01, 0.01], iris, pupil), hex('#120a06'), rim);
}));

const onEars = (p) => smooth(0.33, 0.5, p[1]) * smooth(0.34, 0.2, dot(p, front)) * smooth(0.3, 0.1, p[0]);
/** Short on the muzzle, shorter round the eyes and more so before them, none on the skin below them. */
const lengthAt = (eyes) => ({ position: p }) => {
  const ahead = dot(p, front), head = smooth(0, 0.4, ahead) * smooth(-0.1, 0.1, p[1]) * smooth(-0.05, -0.3, p[0]);
  let share = mixed(1, mixed(0.62, 0.4, smooth(0.55, 0.76, ahead)), head);
  share = mixed(share, 0.3, onEars(p));
  for (const { at } of eyes) share *= smooth(1.15 * radius, mixed(3.4, 5, smooth(-1, 1, dot(sub(p, at), front) / radius)) * radius, far(p, at)) ** 0.9;
  return share;
};

const nose = [-0.62, 0.1, 0.5], crown = [-0.3, 0.35, 0.15];
/** Hair lies from the nose over the head, along the ears, and from there back and down. */
function wayAt({ position: p }) {
  const head = smooth(-0.05, 0.3, dot(p, front) + 0.35 * p[1]) * smooth(0, 0.15, p[1]) * smooth(-0.05, -0.3, p[0]);
  const body = unit([0.8, -0.5 - 0.6 * smooth(-0.2, -0.6, p[1]), -0.25]);
  const way = between(body, unit(sub(p, nose)), head);
  return unit(between(way, unit(sub(p, crown)), onEars(p)));
}
/** How far it leans, and where to; upright where it would have to stand against its way. */
const combAt = (place) => leaning(wayAt(place), place.normal, 0.95, 0.3);

/** Ears, which are thin, and what is round the eyes have shorter edges. */
const isFine = (p) => onEars(p) > 0.1 || sides.some(({ near }) => far(p, near) < 2.6 * radius);

const glossy = (roughness, texture) => ({ pbrMetallicRoughness: { metallicFactor: 0, roughnessFactor: roughness, ...texture } });

const of = (number) => () => number;
/** The bytes of its file; `mesh`: { positions, cells } of the package; `program`: wet-fur-make-assets. */
export function bunnyFile(program, mesh) {
  const fit = fitOf(mesh.positions), body = withNormals(subdivided({ positions: mesh.positions.map(fit.of), cells: mesh.cells }, isFine)), eyes = eyesOf(body);
  return animalFile(program, {
    name: 'bunny', comb: combAt, groom: (place) => [lengthAt(eyes)(place), 0, 0, 0], pictures: [eyePicture()],
    materials: [{ name: 'fur', furry: true }, { name: 'eye', json: glossy(0.12, { baseColorTexture: { index: 0, texCoord: 1 } }) }, { name: 'lids', json: glossy(0.7, { baseColorFactor: [0.045, 0.026, 0.018, 1] }) }],
    bodies: [{ ...body, materialOf: of(0) }, ...eyes.flatMap((eye) => [{ ...eyeball(eye, { rings: 9, segments: 14 }), materialOf: of(1) }, ...lids.map((one) => ({ ...lid(eye, { ...one, columns: 10, rows: 5 }), materialOf: of(2) }))])],
  }).file;
}
