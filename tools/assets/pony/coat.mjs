// The pony's coat: a chestnut with a flaxen mane, darker legs, a pale muzzle and a blaze. Colours, lengths, types and how the hair lies.
import { hex, pictureOf } from '../paint.mjs';
import { across, blend, clamp, cross, far, leaning, length, mixed, scaled, smooth, sub, unit } from '../vectors.mjs';
import { eyeColours, lidColour, onEye } from '../eyes.mjs';
import { edges, frames } from './eyes.mjs';
import { eye, fields, fromLips, headPlace, headTurn, inHead } from './shape.mjs';

const { abs, exp, hypot, sign, sin } = Math;

// Lengths are in bounding radii, about 9 decimetres.
export const settings = {
  furLength: 0.042, density: 1, thickness: 0.35, lengthVariation: 0.25, curl: 0.06, taper: 0.6, repeat: 10, clump: 0.3, lockSize: 0.15, undercoat: 0.4, undercoatLength: 0.6, gravity: 0.1, stiffness: 0.8,
  rootColor: '#74665c', tipColor: '#acacac', skinColor: '#9c8e84', variance: 0.4, specular: 0.07, shininess: 80, occlusion: 0.3, strandShadow: 0.3,
  wetDarkening: 0.1, layers: 40, clumpSize: 0.018,
  // Feathers.
  type2: 'own', 'type2.name': 'Feathers', 'type2.furLength': 0.085, 'type2.density': 0.9, 'type2.thickness': 0.3, 'type2.lengthVariation': 0.45, 'type2.curl': 0.15, 'type2.taper': 0.8, 'type2.undercoat': 0,
  'type2.wave': 0.25, 'type2.clump': 0.35, 'type2.lockSize': 0.3, 'type2.tipBreak': 0.4, 'type2.rootColor': '#74665c', 'type2.tipColor': '#b0b0b0', 'type2.skinColor': '#9c8e84', 'type2.occlusion': 0.3, 'type2.strandShadow': 0.3, 'type2.variance': 0.4,
  'type2.specular': 0.05, 'type2.shininess': 70, 'type2.gravity': 0.6, 'type2.stiffness': 0.3,
};

// --- colour ---

const red = hex('#843810'), dark = hex('#552108'), light = hex('#a9622c'), liver = hex('#341a0d'), mealy = hex('#c49a70'), white = hex('#fff0d6'), feather = hex('#8a6240'), shade = hex('#2c1a14');

// A slow unevenness, so that no area is of one colour.
const mottle = ([x, y, z]) => 0.5 + 0.25 * sin(1.9 * x + 1.3 * sin(1.1 * z)) * sin(1.7 * y + 0.6) + 0.25 * sin(2.3 * z + 1.2 * y + sin(2.1 * x));
// A number in 0..1 for each cell of a grid.
const chance = (x, y, z, n) => { const v = sin(12.9898 * x + 78.233 * y + 37.719 * z + 11.13 * n) * 43758.5453; return v - Math.floor(v); };
/** Dapples: how near the middle of one a place is, 0..1 (cells after Worley 1996). */
function dapple(p) {
  const q = scaled(p, 1 / 0.62), cell = q.map(Math.floor);
  let least = 9;
  for (let i = -1; i <= 1; ++i) for (let j = -1; j <= 1; ++j) for (let k = -1; k <= 1; ++k) {
    const [x, y, z] = [cell[0] + i, cell[1] + j, cell[2] + k];
    least = Math.min(least, far(q, [0, 1, 2].map((n) => [x, y, z][n] + chance(x, y, z, n))));
  }
  return smooth(0.62, 0.2, least);
}
/** Where they show: on barrel and croup. */
const dappled = ([, y, z]) => smooth(5.2, 6.6, y) * smooth(2.6, 1, z) * smooth(-5.2, -4.2, z) * smooth(10, 9.4, y);

/** Of the lower legs: 0 above, 1 at the fetlocks. */
const onLeg = ([, y]) => smooth(4.6, 2.6, y);

/** The blaze from the forehead to the nose: how white it is there. */
function blaze([x, v, u]) {
  if (v < -0.75) return 0;
  const width = 0.17 + 0.13 * exp(-(((u - 1.15) / 0.38) ** 2)) + 0.07 * smooth(2.9, 3.4, u) - 0.06 * exp(-(((u - 2.1) / 0.5) ** 2));
  const middle = 0.04 * sin(2.2 * u), ends = smooth(0.55, 0.85, u) * smooth(3.75, 3.5, u);
  return ends * smooth(width + 0.03, width - 0.03, abs(x - middle) + 0.025 * sin(9 * u + 4 * x));
}

function furColour({ position: p, normal: n }) {
  let colour = blend(red, dark, 0.6 * smooth(0.3, 1, n[1]) * smooth(5, 9, p[1]));
  colour = blend(colour, light, 0.65 * smooth(0, -0.8, n[1]) * smooth(3.8, 5, p[1]));                // belly
  colour = blend(colour, light, 0.45 * exp(-((hypot(p[2] + 2.9, 1.2 * (p[1] - 5.9)) / 0.9) ** 2)));  // flanks
  colour = blend(colour, blend(dark, light, mottle(p)), 0.22);
  const dapples = dappled(p);
  if (dapples > 0) colour = blend(colour, light, 0.34 * dapples * dapple(p));
  colour = blend(colour, liver, 0.92 * onLeg(p));
  colour = blend(colour, feather, 0.75 * featherAt({ position: p, normal: n }));
  if (p[2] < 5.2 || p[1] < 8.4) return colour;
  const h = inHead(p), muzzle = smooth(2.75, 3.5, h[2] + 0.25 * (h[1] + 0.5)), eyeFar = far([abs(h[0]), h[1], h[2]], eye.at);
  colour = blend(colour, mealy, 0.8 * muzzle);
  colour = blend(colour, shade, 0.75 * smooth(0.12, 0.02, fields.nose(p)) + 0.5 * smooth(0.09, 0.04, fromLips(p)));
  colour = blend(colour, mealy, 0.1 * smooth(0.62, 0.42, eyeFar));
  colour = blend(colour, shade, 0.5 * smooth(0.44, 0.33, eyeFar));
  if (p[1] > 12.7) colour = blend(colour, dark, 0.5 * smooth(13.2, 13.9, p[1]));                     // tips of the ears
  return blend(colour, white, blaze(h));
}

function lidShown(place) {
  const at = onEye(frames[sign(place.position[0]) || 1], place.position);
  return lidColour(furColour(place), at, [edges.upper(at[0]), edges.lower(at[0])]);
}

/** A brown iris about a pupil that lies, as grazers have it. */
export const eyePicture = () => {
  const iris = hex('#27130a'), rim = hex('#160a05'), pupil = hex('#050303');
  return pictureOf(64, eyeColours(64, (x, y) => blend(blend(blend(iris, hex('#4a2812'), smooth(0.2, -0.6, y)), rim, smooth(0.5, 0.7, hypot(x, y))), pupil, smooth(1.1, 0.85, hypot(x / 0.41, y / 0.22)))));
};

function hoofColour({ position: [x, y, z] }) {
  return blend(blend(hex('#2c2622'), hex('#40362e'), 0.5 + 0.5 * sin(26 * y + 0.7 * sin(5 * (x + z)))), hex('#6a5c4e'), 0.35 * smooth(0.6, 0.75, y) + 0.25 * smooth(0.12, 0, y));
}

const bare = { hooves: hoofColour, lids: lidShown };
export const colourOf = (materials) => (place) => (bare[materials[place.part]] ?? furColour)(place);

// --- lengths and types ---

/** Where feathers grow: behind the fetlocks and up the tendons, over the hooves all round. */
function featherAt({ position: [, y, z], normal: n }) {
  const behind = smooth(0.35, -0.5, n[2]), low = smooth(0.45, 0.62, y);
  return low * Math.max(behind * smooth(2.7, 1.6, y), smooth(1.05, 0.75, y));
}

/** Where mane and tail lie on it: short fur, which does not stick out between them. */
const underHair = (p) => Math.max(smooth(0.9, 0.5, abs(p[0])) * smooth(-4.9, -5.2, p[2]) * smooth(4.5, 6, p[1]), smooth(1.1, 0.7, far(p, headPlace([0, 0, 0.1]))) * smooth(0.7, 0.4, abs(p[0])));

function furLength(place) {
  const { position: p } = place;
  let share = 0.95 + 0.35 * smooth(0.2, -0.9, place.normal[1]) * smooth(4, 5, p[1]);
  share *= mixed(1, 0.75, onLeg(p)) * mixed(1, 0.75, smooth(10, 12, p[1]));
  const feather = featherAt(place);
  if (feather > 0) share = mixed(share, (0.5 + 0.5 * smooth(0.2, -0.5, place.normal[2])) * (0.6 + 0.4 * smooth(2.6, 1.6, p[1])), smooth(0.1, 0.5, feather));
  share *= 1 - 0.5 * underHair(p);
  if (p[2] < 5.2 || p[1] < 8.4) return clamp(share * 0.76);
  const h = inHead(p), eyeFar = far([abs(h[0]), h[1], h[2]], eye.at);
  share *= mixed(1, 0.32, smooth(2.4, 3.5, h[2])) * mixed(0.16, 1, smooth(0.35, 0.55, eyeFar)) * mixed(0.45, 1, smooth(0.04, 0.22, fromLips(p)));  // short round the eyes and on the lips
  share *= mixed(1, 0.5, smooth(12.7, 13.3, p[1]));
  return clamp(share * 0.76);
}
export const groom = (place) => [furLength(place), featherAt(place), 0, 0];

// --- how the hair lies ---

/** Whorls, from which hair goes to all sides, winding: place, reach, turn in radians. */
const whorls = [
  { at: headPlace([0, 0.2, 1.05]), reach: 0.9, wind: 0.5 },
  { at: [1.9, 6.3, -2.5], reach: 1.3, wind: 0.7, mirrored: true },
];

function lie({ position: p, normal: n }) {
  const side = sign(p[0]) || 1, q = [abs(p[0]), p[1], p[2]], h = inHead(p);
  const trunk = [0, -0.35 - 0.5 * smooth(7.5, 5.2, p[1]), -1], leg = [0, -1, -0.12];
  let way = unit(trunk).map((x, k) => mixed(x, leg[k], Math.max(smooth(6, 4.6, p[1]), smooth(-4.2, -5.2, p[2]))));
  const neck = unit([0, -0.75, -0.65]);
  way = way.map((x, k) => mixed(x, neck[k], smooth(2.2, 3.6, p[2]) * smooth(6.2, 8, p[1])));
  if (p[1] < 2) way = way.map((x, k) => mixed(x, [0, -1, p[2] > 0 ? -0.35 : -0.4][k], smooth(2, 1.4, p[1]) * smooth(0.4, -0.3, n[2])));
  if (p[2] > 5.2 && p[1] > 8.4) {
    // From the whorl on the forehead down the nose, over the cheeks and up to the poll.
    const from = sub(p, whorls[0].at), face = unit([from[0] * 0.8, from[1], from[2]]), down = headTurn([side * 0.15, -0.35, 1]);
    const head = face.map((x, k) => mixed(x, k === 0 ? down[0] : down[k], smooth(1.4, 2.3, h[2])));
    const cheek = headTurn([side * 0.1, -0.9, 0.1]);
    const mixedHead = head.map((x, k) => mixed(x, cheek[k], 0.6 * smooth(-0.5, -1, h[1]) * smooth(2.2, 1.4, h[2])));
    way = way.map((x, k) => mixed(x, mixedHead[k], smooth(-0.1, 0.5, h[2])));
    if (p[1] > 12.7) way = [side * 0.2, 1, 0.05];
  }
  for (const { at, reach, wind, mirrored } of whorls) {
    const off = across(sub(mirrored ? q : p, at), mirrored ? [side * n[0], n[1], n[2]] : n), r = length(off), share = exp(-((r / (0.55 * reach)) ** 2));
    if (share < 0.01 || r < 1e-3) continue;
    const out = scaled(off, 1 / r), turn = scaled(cross(mirrored ? [side * n[0], n[1], n[2]] : n, out), wind), round = [out[0] + turn[0], out[1] + turn[1], out[2] + turn[2]];
    const real = mirrored ? [side * round[0], round[1], round[2]] : round;
    way = unit(way).map((x, k) => mixed(x, unit(real)[k], share));
  }
  return unit(way);
}

/** A lean along the skin, radians. */
export const comb = (place) => leaning(lie(place), place.normal, mixed(1.08, 1.14, featherAt(place)));
