// The pony: { name, file(program) }.
import { animalFile } from '../animal.mjs';
import { factorOf } from '../paint.mjs';
import { colourOf, comb, eyePicture, groom, settings } from './coat.mjs';
import { hair } from './hair.mjs';
import { materials as names, ponyBodies } from './mesh.mjs';
import { animations } from './motion.mjs';
import { rig } from './rig.mjs';

const roughness = { eye: 0.08, nose: 0.55, mouth: 0.75, hooves: 0.62, lids: 0.45, innerEar: 0.8 };
const plain = { nose: '#241714', mouth: '#6b403b', innerEar: '#5a3d2e' };
const colourIn = (name) => (name in plain ? { baseColorFactor: factorOf(plain[name]) } : { baseColorTexture: name === 'eye' ? { index: 1, texCoord: 1 } : { index: 0 } });
const materials = names.map((name) => ({
  name, furry: name === 'fur', json: { pbrMetallicRoughness: { metallicFactor: 0, roughnessFactor: roughness[name] ?? 0.8, ...colourIn(name) }, ...(name === 'lids' && { doubleSided: true }) },
}));

export const pony = {
  name: 'pony',
  file: (program) => animalFile(program, {
    name: 'pony', rig, materials, bodies: ponyBodies(), colour: colourOf(names), groom, comb, hair, animations: animations(), state: { settings, camera: { yaw: -0.68, pitch: 0.09, distance: 2.85, target: [0, 0.02, 0] } }, pictures: [eyePicture()], colourSize: 768,
  }),
};
