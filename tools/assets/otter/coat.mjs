// The coat of the otter: colours, lengths, types, the way it lies, whiskers and brows.
import { hex, pictureOf } from '../paint.mjs';
import { across, clamp, length, mixed, scaled, smooth, unit } from '../vectors.mjs';
import { ear, eye } from './shape.mjs';

const { abs, hypot } = Math;
const blend = (a, b, t) => a.map((x, k) => mixed(x, b[k], clamp(t)));
const away = (p, c, [rx, ry, rz] = [1, 1, 1]) => hypot((abs(p[0]) - c[0]) / rx, (p[1] - c[1]) / ry, (p[2] - c[2]) / rz);

export const settings = {
  furLength: 0.05, density: 1, thickness: 0.25, lengthVariation: 0.25, curl: 0.06, taper: 0.6, repeat: 7, undercoat: 0.8, undercoatLength: 0.5,
  rootColor: '#8a7a6c', tipColor: '#ffffff', skinColor: '#5a463a', variance: 0.3, specular: 0.5, shininess: 80, stiffness: 0.7,
};

const brown = hex('#6f4a2c'), dark = hex('#4e311c'), pale = hex('#c9ad8a'), cream = hex('#dcc7a6');

// 1 on the back, 0 on the belly.
const backness = ({ position: p, normal: n }) => smooth(-0.55, 0.5, n[1]);
const onHead = (p) => smooth(1.9, 2.6, p[2] + 0.35 * (p[1] - 2));

function furColour(place) {
  const { position: p } = place, back = backness(place);
  let colour = blend(pale, brown, back);
  colour = blend(colour, dark, 0.7 * smooth(0.6, 1, place.normal[1]));
  // The throat up to the cheeks, and the muzzle.
  const head = onHead(p), throat = head * smooth(3, 2.72, p[1] - 0.1 * (p[2] - 3));
  colour = blend(colour, cream, throat);
  colour = blend(colour, cream, 0.75 * smooth(0.42, 0.22, away(p, [0.16, 2.8, 3.55])));
  return colour;
}

const bareColours = { eye: hex('#20130c'), nose: hex('#1c1614'), mouth: hex('#5a3030'), claws: hex('#4a3a2e'), pads: hex('#3a2b26'), lids: hex('#2a1c15'), innerEar: hex('#5a4034') };
export const colourOf = (materials) => (place) => (materials[place.part] === 'fur' ? furColour(place) : bareColours[materials[place.part]]);

function furLength({ position: p }) {
  const head = onHead(p);
  let share = mixed(0.85, 0.34, head);
  share = mixed(share, 0.16, smooth(0.75, 0.3, away(p, [0, 2.9, 3.6])));
  share = mixed(share, 0.3, smooth(0.7, 0.25, p[1]) * smooth(-2.6, -2, p[2]));
  share *= smooth(eye.radius * 1.15, eye.radius * 2.2, away(p, eye.at));
  return share;
}
export const groom = (place) => [furLength(place), 0, 0, 0];

const lie = ({ position: p }) => {
  const side = Math.sign(p[0]) || 1;
  let way = [0, -0.15, -1];
  if (p[1] < 1.2 && p[2] > -2.4) way = [0, mixed(-0.15, -1, smooth(1.2, 0.7, p[1])), mixed(-1, 0.1, smooth(1.2, 0.7, p[1]))];
  if (p[2] > 3) way = [side * 0.5, -0.05, -1];
  return unit(way);
};
export const comb = (place) => {
  const flat = across(lie(place), place.normal), size = length(flat);
  return size < 1e-3 ? [0, 0, 0] : scaled(flat, (1 / size) * 1.05 * smooth(0, 0.3, size));
};

export const eyePicture = () => {
  const size = 64, iris = hex('#3b2416'), rim = hex('#120b07');
  return pictureOf(size, Array.from({ length: size * size }, (_, i) => {
    const r = 2 * hypot((i % size + 0.5) / size - 0.5, (Math.floor(i / size) + 0.5) / size - 0.5);
    return blend(blend([0.01, 0.008, 0.006], iris, smooth(0.34, 0.42, r)), rim, smooth(0.5, 0.78, r));
  }));
};
