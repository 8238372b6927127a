// The bodies of which the pony's mesh consists, with materials and weights.
import { materialsBy, sculpted, shut } from '../animal.mjs';
import { bones, rig, spread } from './rig.mjs';
import { eyeballOf, lidOf } from './eyes.mjs';
import { eye, fields, headPlace, inHead, jaw } from './shape.mjs';
import { boneWeights } from '../rig.mjs';
import { far, mixed, smooth } from '../vectors.mjs';

export const materials = ['fur', 'eye', 'nose', 'mouth', 'hooves', 'lids', 'innerEar'];
const numberOf = (name) => materials.indexOf(name);

/** How long edges are to be: finer about the eyes, the muzzle, the ears and at the legs. */
export function sizeAt(place) {
  const [x, y, z] = place, p = [Math.abs(x), y, z];
  let size = 0.32;
  if (y < 5.6) size = mixed(0.19, 0.32, smooth(3.6, 5.6, y));
  if (y < 1.5) size = mixed(0.15, 0.19, smooth(0.7, 1.5, y));
  if (z > 3 && y > 8) size = mixed(size, 0.22, smooth(8, 12, y + 0.5 * (z - 5)));
  if (z < -4.6 && y > 6) size = mixed(size, 0.2, smooth(-4.6, -5.4, z));
  if (z > 5.2 && y > 8) {
    const [, , u] = inHead(p);
    size = Math.min(size, 0.2, mixed(0.2, 0.1, smooth(2.6, 3.4, u)), mixed(0.07, 0.2, smooth(0.32, 0.85, far(p, headPlace(eye.at)))));
    if (y > 12.6) size = Math.min(size, 0.068);
  }
  return size;
}

function skin() {
  const mesh = sculpted({ at: jaw.open, box: [[-2.9, -0.3, -6.6], [2.9, 14.6, 10]], cell: 0.075, sizeAt, lines: Object.values(fields) });
  const bare = Object.entries(fields).map(([name, field]) => [numberOf(name), field]);
  return { ...shut(mesh, jaw), materialOf: materialsBy(mesh, (p) => bare.find(([, field]) => field(p) < 0)?.[0] ?? 0), weights: boneWeights(mesh, rig, bones, spread) };
}

const stiff = (body, material, joint) => ({ ...body, materialOf: () => numberOf(material), weights: body.positions.map(() => [[rig.joint(joint), 1]]) });

export const ponyBodies = () => [
  skin(),
  ...[['L', 1], ['R', -1]].flatMap(([name, side]) => [
    stiff(eyeballOf(side), 'eye', `eye${name}`), stiff(lidOf(side, 'upper'), 'lids', `lidUpper${name}`), stiff(lidOf(side, 'lower'), 'lids', `lidLower${name}`),
  ]),
];
