// The coat of the otter: colours, lengths, types, the way it lies, whiskers and brows.
import { hex, pictureOf } from '../paint.mjs';
import { blend, cross, leaning, mixed, smooth, unit } from '../vectors.mjs';
import { eyeColours, eyeOf, lidColour, onEye } from '../eyes.mjs';
import { edgesAt } from './parts.mjs';
import { ear, eye, nostril, overMouth } from './shape.mjs';

const { abs, exp, hypot, sin } = Math;
/** How far from a place on either side, in half axes. */
const away = (p, c, [rx, ry, rz] = [1, 1, 1]) => hypot((abs(p[0]) - c[0]) / rx, (p[1] - c[1]) / ry, (p[2] - c[2]) / rz);
const within = (p, c, r, inner = 0.6) => smooth(1, inner, away(p, c, r));

// Type 1: long glossy guard hairs over an undercoat; type 2: the plush of face and feet.
const plush = { density: 1, thickness: 0.24, lengthVariation: 0.15, clump: 0.2, lockSize: 0.15, curl: 0.05, taper: 0.5, furLength: 0.042, undercoat: 0.4, undercoatLength: 0.7,
  rootColor: '#7f7165', tipColor: '#b7a697', skinColor: '#6a5446', variance: 0.3, specular: 0.03, shininess: 40, stiffness: 0.9 };
/** Mist over a bank: light from its right, low, and a little from behind along its outline. */
const setting = { backgroundTop: '#8fa9a6', backgroundBottom: '#ece5d8', keyColor: '#fff0da', lightYaw: -0.9, lightPitch: 0.62, lightIntensity: 1, fillLight: 0.08, rimLight: 0.22, rimColor: '#ffdfb0', ambient: 0.48, skyColor: '#e2eef2', groundColor: '#f4e6d0' };
export const settings = {
  ...setting,
  furLength: 0.042, density: 1, thickness: 0.24, lengthVariation: 0.3, curl: 0.06, taper: 0.6, repeat: 10, clump: 0.35, lockSize: 0.25, undercoat: 0.8, undercoatLength: 0.5,
  rootColor: '#675748', tipColor: '#ab9884', skinColor: '#5a463a', variance: 0.4, specular: 0.06, shininess: 90, stiffness: 0.7, gravity: 0.1, clumpSize: 0.011, wetDarkening: 0.1,
  type2: 'own', ...Object.fromEntries(Object.entries(plush).map(([key, value]) => [`type2.${key}`, value])),
};

const dark = hex('#2e1b10'), brown = hex('#48301d'), flank = hex('#5f4229'), belly = hex('#8f7454'), cream = hex('#c6ad88'), lip = hex('#d8c6a6');

const frames = { 1: eyeOf(1, eye), [-1]: eyeOf(-1, eye) };

/** 1 on the head, 0 on the body. */
const onHead = (p) => smooth(1.7, 2.5, p[2] + 0.4 * (p[1] - 2));
const onLegs = (p) => smooth(1.25, 0.75, p[1]) * smooth(-2.35, -2, p[2]);
// Slow irregularities of about 0.3 dm.
const mottle = ([x, y, z]) => sin(9 * x + 2 * sin(7 * z)) * sin(8 * y + 1.7 * sin(6 * x + 3)) * sin(7 * z + 2.3 * sin(5 * y));

function furColour({ position: p, normal: n }) {
  const head = onHead(p), legs = onLegs(p);
  // Dark along the back, paler down the flanks, palest below.
  const level = n[1] + 0.12 * mottle(p);
  let colour = blend(belly, flank, smooth(-0.75, -0.2, level));
  colour = blend(colour, brown, smooth(-0.25, 0.35, level));
  colour = blend(colour, dark, 0.8 * smooth(0.4, 0.98, level));
  colour = blend(colour, brown, 0.9 * legs);
  colour = blend(colour, dark, 0.8 * smooth(0.45, 0.15, p[1]) * legs);
  colour = blend(colour, dark, 0.6 * smooth(-3.5, -6, p[2]));
  // Throat and breast, up to a line below eye and ear.
  const line = 2.76 + 0.06 * smooth(2.9, 3.4, p[2]) - 0.25 * smooth(2.5, 2, p[2]), throat = smooth(0.12, -0.1, p[1] - line + 0.03 * mottle(p)) * head;
  colour = blend(colour, cream, 0.9 * throat);
  colour = blend(colour, cream, 0.7 * smooth(0.7, 1.5, p[2]) * smooth(0.1, 0.7, n[2] - 0.3 * n[1]) * (1 - legs) * (1 - head));
  colour = blend(colour, lip, 0.85 * within(p, [0.2, 2.63, 3.46], [0.36, 0.22, 0.34]));
  colour = blend(colour, dark, 0.55 * within(p, [0, 3.02, 3.35], [0.17, 0.2, 0.45], 0.3));
  colour = blend(colour, dark, 0.85 * within(p, eye.at, [0.2, 0.18, 0.2], 0.7));
  return blend(colour, dark, 0.5 * within(p, ear, [0.22, 0.22, 0.22], 0.4));
}

function lidShown(place) {
  const at = onEye(frames[place.position[0] < 0 ? -1 : 1], place.position);
  return lidColour(furColour(place), at, edgesAt(at[0]));
}
/** Leather: dark, with fine grain. */
const noseColour = ({ position: [x, y, z] }) => blend(hex('#15100e'), hex('#2c2320'), 0.5 + 0.5 * sin(61 * x + 3 * sin(47 * y)) * sin(57 * y + 2 * sin(53 * z)) * sin(49 * z)).map((c) => c * (1 - 0.8 * nostril([x, y, z])));
const bare = { nose: noseColour, lids: lidShown };
export const colourOf = (materials) => (place) => (bare[materials[place.part]] ?? furColour)(place);

function furLength({ position: p }) {
  const head = onHead(p), legs = onLegs(p);
  let share = mixed(0.95, 0.36, head);
  share = mixed(mixed(share, 0.32, smooth(-3.2, -6, p[2])), 0.12, smooth(-5.7, -6.55, p[2]));
  share = mixed(share, 0.5, legs);
  share = mixed(share, 0.24, smooth(0.55, 0.25, p[1]) * legs);
  for (const [z, far] of [[1.42, 0.35], [-1.05, 0.45]]) share = mixed(share, 0.1, smooth(z, z + far, p[2]) * smooth(z + 1, z + far, p[2]) * legs);
  share = mixed(share, 0.2, within(p, [0, 2.78, 3.55], [0.55, 0.6, 0.75], 0.35));
  share = mixed(share, 0.14, within(p, ear, [0.28, 0.28, 0.28], 0.55));
  if (p[2] > 3.1) share *= mixed(0.45, 1, smooth(0.02, 0.12, abs(overMouth(p))));
  // Short on the lids, and round them.
  return share * mixed(0.35, 1, smooth(eye.radius * 1.2, eye.radius * 2.6, away(p, eye.at)));
}
const plushness = ({ position: p }) => Math.max(smooth(2, 3, p[2]) * smooth(1.9, 2.5, p[1]), smooth(0.8, 0.4, p[1]) * smooth(-2.35, -2, p[2]));
/** Length, and how much there is of the types 2 to 4. */
export const groom = (place) => [furLength(place), plushness(place), 0, 0];

// Where hair turns round a point of the skin: { at, reach, turn }.
const swirls = [{ at: [0.5, 1.3, 1.55], reach: 0.35, turn: 0.7 }, { at: [0.66, 0.9, 0.65], reach: 0.28, turn: 0.8 }];

// The way hair lies: from the nose back, down legs, along the tail.
function lie({ position: p, normal: n }) {
  const side = p[0] < 0 ? -1 : 1, head = onHead(p), legs = onLegs(p), paws = smooth(0.45, 0.25, p[1]) * legs;
  let way = [0, -0.25, -1];
  way = blend(way, [0, -0.35, -0.4], head * (1 - smooth(2.5, 2.9, p[2])));
  way = blend(way, [side * 0.15, -1, -0.45], legs);
  way = blend(way, [0, -0.2, 1], paws);
  // Off the nose and round the eyes.
  const face = smooth(2.6, 3.1, p[2]), from = [0, 2.85, 3.75];
  way = blend(way, unit(p.map((x, k) => x - from[k])), 0.85 * face);
  for (const { at, reach, turn } of swirls) {
    const q = [abs(p[0]) - at[0], p[1] - at[1], p[2] - at[2]], share = exp(-((hypot(...q) / reach) ** 2)), round = cross(n, [side * q[0], q[1], q[2]]);
    way = way.map((x, k) => x + side * turn * share * (round[k] / reach));
  }
  return unit(way);
}
/** How far it leans, and where to. */
export const comb = (place) => {
  const { position: p } = place;
  const lean = mixed(mixed(mixed(0.85, 1.1, smooth(-4.5, -6, p[2])), 0.72, onHead(p)), 0.6, within(p, [0, 2.78, 3.55], [0.5, 0.5, 0.6], 0.4));
  return leaning(lie(place), place.normal, lean);
};

export const eyePicture = () => {
  const iris = hex('#3b2213'), rim = hex('#0d0805');
  return pictureOf(64, eyeColours(64, (x, y) => blend(blend([0.01, 0.008, 0.006], blend(iris, hex('#5a3a20'), 0.7 * smooth(0.2, -0.7, y)), smooth(0.36, 0.44, hypot(x, y))), rim, smooth(0.56, 0.76, hypot(x, y)))));
};
