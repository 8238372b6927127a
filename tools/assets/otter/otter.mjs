// The otter: { name, file(program) }.
import { animalFile, materialsBy, sculpted, shut } from '../animal.mjs';
import { factorOf } from '../paint.mjs';
import { boneWeights } from '../rig.mjs';
import { squared } from '../vectors.mjs';
import { colourOf, comb, eyePicture, groom, settings } from './coat.mjs';
import { motions } from './motions.mjs';
import { parts } from './parts.mjs';
import { bones, rig } from './rig.mjs';
import { box, earField, jaw, noseField, padField, sizeAt } from './shape.mjs';
import { whiskers } from './whiskers.mjs';

const glossy = (roughness, colour = { baseColorTexture: { index: 0 } }) => ({ pbrMetallicRoughness: { metallicFactor: 0, roughnessFactor: roughness, ...colour } });
const plain = (roughness, colour) => glossy(roughness, { baseColorFactor: factorOf(colour) });
const materials = [
  { name: 'fur', furry: true }, { name: 'eye', json: glossy(0.12, { baseColorTexture: { index: 1, texCoord: 1 } }) },
  { name: 'nose', json: glossy(0.45) }, { name: 'mouth', json: plain(0.4, '#6b3a36') }, { name: 'claws', json: plain(0.35, '#4a3a2e') }, { name: 'pads', json: plain(0.7, '#33251f') },
  { name: 'lids', json: glossy(0.9) }, { name: 'innerEar', json: plain(1, '#140b07') },
];
const names = materials.map(({ name }) => name), numberOf = (name) => names.indexOf(name);

/** A part goes with its joint, or with the skin in which it stands. */
function weightsOf({ joint, root }, { positions, weights }) {
  if (joint) return [[rig.joint(joint), 1]];
  let nearest = 0;
  positions.forEach((p, v) => (squared(p, root) < squared(positions[nearest], root) ? (nearest = v) : 0));
  return weights[nearest];
}

/** The body alone, which takes most of the time. It is sculpted with its mouth open, and then shut. */
export function body() {
  const mesh = sculpted({ at: jaw.open, box, cell: 0.045, sizeAt, lines: [noseField, jaw.mouth, earField, padField], rounds: 3 });
  const material = (p) => (noseField(p) < 0 ? 'nose' : earField(p) < 0 ? 'innerEar' : jaw.mouth(p) < 0 ? 'mouth' : padField(p) < 0 ? 'pads' : 'fur');
  const width = (p) => (p[2] > 3.1 ? 0.12 : p[1] < 0.6 && p[2] > -2.2 ? 0.12 : p[2] < -2.4 ? 0.3 : 0.4);
  return { ...shut(mesh, jaw), weights: boneWeights(mesh, rig, bones, width), materialOf: materialsBy(mesh, (p) => numberOf(material(p))) };
}

export const otter = {
  name: 'otter',
  file: (program, sculptedBody = body()) => animalFile(program, {
    name: 'otter', rig, materials, colour: colourOf(names), groom, comb, steps: whiskers, animations: motions(), state: { settings, camera: { yaw: -0.7, pitch: 0.12, distance: 2.75, target: [0, -0.02, 0.12] } }, pictures: [eyePicture()],
    bodies: [sculptedBody, ...parts().map((part) => ({ ...part, materialOf: () => numberOf(part.material), weights: new Array(part.positions.length).fill(weightsOf(part, sculptedBody)) }))],
  }),
};
