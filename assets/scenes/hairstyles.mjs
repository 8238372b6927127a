// The head with three hair styles, made by the edits that programs have for long hair (src/app/tools/HairEdits.inc). Written in
// decimetres as the head is; models are in bounding radii.
import { browAt, headMesh, lidAt, skinNear } from './head.mjs';

let made;
/** Made once, when it is first asked for. */
const head = () => (made ??= headMesh());
const numbers = (list) => list.map((x) => Number(x.toFixed(4)));
const place = (p) => numbers(head().fit(p));
const size = (length) => numbers([length / head().radius])[0];
const both = (list) => [1, -1].flatMap((side) => list.map(([x, ...rest]) => [side * x, ...rest]));

const edit = (name, value, p) => [name, value, ...(p ?? [])].join(',');
const ballOf = (name) => ([x, y, z, radius]) => edit(name, size(radius), place([x, y, z]));

// --- the face ---

const shares = (count) => Array.from({ length: count }, (_, i) => (i + 0.5) / count);
const dab = (color, strength, [x, y, z, radius]) => `dab ${color} ${strength} ${size(radius)} ${place([x, y, z]).join(' ')}`;
const whisker = (color, length, width, { at }, way) => `whisker ${color} ${size(length)} ${size(width)} ${place(at).join(' ')} ${numbers(way).join(' ')}`;

/** Three rows of hairs that lie outwards, and upwards near the nose. */
const brow = (side, color) => shares(90).map((t, i) => {
  const root = browAt(side, t), up = ((i * 7) % 5 - 2) * 0.011 * (1 - 0.5 * t);
  const way = [side * (0.5 + 0.7 * t), 0.75 - 1.1 * t, 0].map((x, k) => x + 0.35 * root.normal[k]);
  return whisker(color, 0.1, 0.008, { at: [root.at[0], root.at[1] + up, root.at[2]] }, way);
});
const lashes = (side) => shares(34).map((s) => {
  const t = 1.8 * s - 0.9, root = lidAt(side, t);
  return whisker('#2a1c16', 0.09 + 0.035 * s, 0.008, root, [side * 0.5 * t, -0.75, 0.8]);
});
const lips = [0, 0.05, 0.1, 0.15, 0.2].flatMap((x) => both([[x, -0.58 - 0.9 * x * x, 0.86 - 2.2 * x * x, 0.1 - 0.2 * x], [x, -0.7 + 0.9 * x * x, 0.85 - 2.2 * x * x, 0.11 - 0.2 * x]]));
const face = (browColor) => [
  ...lips.map((at) => dab('#a8483f', 0.3, at)), ...both([[0.4, -0.32, 0.68, 0.3]]).map((at) => dab('#d98a76', 0.3, at)),
  ...[1, -1].flatMap((side) => [...brow(side, browColor), ...lashes(side)]),
];

// --- what all styles have ---

const grows = [[0, 0.5, -0.34, 1.03], [0, 0.98, 0.08, 0.63], [0, -0.2, -0.62, 0.46]], bare = both([[0.76, -0.1, -0.04, 0.27]]);
const scalp = (name, values, where = [...grows.map(ballOf('paint')), ...bare.map(ballOf('erase'))]) =>
  ['addScalp', `name=${name}`, ...Object.entries(values).map(([key, value]) => `${key}=${value}`), ...where];

const bodies = [
  [0, 0.42, 0.08, 0.72], [0, 0.4, -0.28, 0.73], [0, -0.2, 0.3, 0.54],
  [0, 0.36, 0.36, 0.5], [0, -0.12, 0.8, 0.14], [0, -0.3, 0.9, 0.16], [0, -0.62, 0.62, 0.26], [0, -0.9, 0.6, 0.2], ...both([[0.3, 0.16, 0.56, 0.22], [0.36, -0.28, 0.46, 0.28], [0.3, -0.62, 0.3, 0.26]]),
  [0, -0.55, -0.18, 0.46], [0, -0.85, -0.22, 0.46], [0, -1.15, -0.26, 0.47], [0, -1.45, -0.3, 0.48], [0, -1.9, -0.2, 0.56],
  ...both([[0.35, -1.63, -0.36, 0.36], [0.62, -1.73, -0.37, 0.34], [0.88, -1.85, -0.37, 0.33], [1.08, -1.95, -0.35, 0.32], [0.45, -1.9, -0.1, 0.4]]),
].map(ballOf('addSphere'));

const settings = {
  density: 0, furLength: 0, skinColor: '#d9a58a', specular: 0.06, ambient: 0.6, fillLight: 0.35, lightYaw: -0.6, lightPitch: 0.85, backgroundTop: '#7d8b99',
  backgroundBottom: '#d9d5cf',
};
const style = (name, browColor, camera, steps, more = {}) => ({ name, mesh: head, settings: { ...settings, ...more }, camera: { target: [0, 0.1, 0], ...camera }, steps: () => [...face(browColor), ...bodies, ...steps()] });

// --- the styles ---

const short = style('hair-short', '#4a3222', { yaw: 0.5, pitch: 0.1, distance: 2.9 }, () => [
  ...scalp('short', { guideLength: size(0.55), nodes: 7, wisps: 1900, strands: 24, strandWidth: 0.002, leastWidth: 0.02, mostWidth: 0.038, tipWidth: 0.6,
    rootColor: '#2e1d12', tipColor: '#6b452a', variance: 0.35, lengthVariation: 0.35, magnet: 0.35, stiffness: 0.6 }),
  'shade #2e1d12 0.8', 'plant,300', 'hang,0.6,0.08,-0.7,0.5',
]);

const shoulder = style('hair-shoulder', '#8a6a45', { yaw: 0.45, pitch: 0.1, distance: 3.1 }, () => [
  ...scalp('shoulder', { guideLength: size(3.3), nodes: 16, wisps: 1800, strands: 32, strandWidth: 0.002, leastWidth: 0.025, mostWidth: 0.045, tipWidth: 0.7,
    rootColor: '#5f4226', tipColor: '#c29a62', variance: 0.4, lengthVariation: 0.12, magnet: 0.3 }),
  'shade #6b4a2b 0.8', 'plant,320', edit('part', 0.95, place([0.12, 1, 0])), 'hang,0.7,0,-1,-0.6', 'hang,0.6', edit('cut', 6, place([0, -1.4 - 6 * head().radius, 0])),
]);

const pony = style('hair-pony', '#1f1712', { yaw: 2.3, pitch: 0.15, distance: 3.1 }, () => {
  const looks = { strandWidth: 0.0014, rootColor: '#17110d', tipColor: '#3a281c', variance: 0.3 };
  const { at, normal } = skinNear([0, 0.74, -1]), tie = at.map((x, i) => x + 0.08 * normal[i]), atTie = (name, radius) => ballOf(name)([...at, radius]);
  const wider = [...grows.map(([x, y, z, radius]) => ballOf('paint')([x, y, z, radius + 0.12])), ...bare.map(ballOf('erase'))];  // thin at its border
  return [
    ...scalp('pulled back', { ...looks, guideLength: 0.3, nodes: 10, wisps: 4000, strands: 14, leastWidth: 0.002, mostWidth: 0.012, leastLength: 0.2, tipWidth: 0.7,
      magnet: 0.1, lengthVariation: 0, stray: 0.05, frizz: 0.05 }, wider),
    `soften ${size(0.35)}`, 'shade #17110d 0.85', 'plant,300', edit('gather', 1, place(tie)), 'holdAll',
    ...scalp('tail', { ...looks, guideLength: size(2.4), nodes: 16, wisps: 420, strands: 32, leastWidth: 0.03, mostWidth: 0.05, depth: 1, tipWidth: 0.5, magnet: 0.4,
      lengthVariation: 0.35, tipVariation: 0.6 }, [atTie('paint', 0.13)]),
    'plant,40', 'hang,0.6', 'bundle,1',
    ...scalp('band', { guideLength: size(0.2), nodes: 4, wisps: 120, strands: 32, strandWidth: 0.003, leastWidth: 0.04, mostWidth: 0.04, depth: 1, tipWidth: 1, curl: 0.4, curls: 1,
      lengthVariation: 0.1, stray: 0, rootColor: '#5a1522', tipColor: '#8a2436', gloss: 0.1 }, [atTie('paint', 0.19), atTie('erase', 0.12)]),
    'plant,24', 'bundle,1', 'holdAll',
  ];
}, { hairVolume: 0.2 });

export const hairstyles = [short, shoulder, pony];
