// The joints of the otter, and its bones.
import { sides, skeleton } from '../rig.mjs';
import { ear, eye, jaw, tailLine } from './shape.mjs';

const tailAt = [[0, 1.42, -2.35], [0, 1.1, -3.05], [0, 0.76, -3.8], [0, 0.48, -4.6], [0, 0.29, -5.35], [0, 0.19, -6]];

export const rig = skeleton([
  ['root', null, [0, 0, 0]], ['hips', 'root', [0, 1.68, -1.55]], ['spine1', 'hips', [0, 1.8, -0.85]], ['spine2', 'spine1', [0, 1.79, -0.05]],
  ['chest', 'spine2', [0, 1.72, 0.75]], ['neck', 'chest', [0, 1.93, 1.6]], ['head', 'neck', [0, 2.63, 2.42]], ['jaw', 'head', jaw.hinge],
  ...sides([
    ['ear', 'head', [ear[0] - 0.1, ear[1] - 0.1, ear[2]]], ['eye', 'head', eye.at], ['lidUpper', 'head', eye.at], ['lidLower', 'head', eye.at],
    ['upperArm', 'chest', [0.52, 1.48, 1.15]], ['foreArm', '+upperArm', [0.66, 0.88, 0.9]], ['hand', '+foreArm', [0.7, 0.34, 1.1]],
    ['thigh', 'hips', [0.48, 1.45, -1.5]], ['shin', '+thigh', [0.68, 0.92, -1.12]], ['foot', '+shin', [0.72, 0.4, -1.6]],
  ]),
  ...tailAt.map((at, i) => [`tail${i + 1}`, i ? `tail${i}` : 'hips', at]),
]);

const bone = (joint, to, radius, end = radius, only = undefined) => ({ joint, from: rig.place(joint), to, radius, end, only });
const overFeet = (p) => p[1] > 0.65;
const mirror = ([x, y, z]) => [-x, y, z];

const limbs = [
  ['upperArm', 'foreArm', 0.36, 0.26, overFeet], ['foreArm', 'hand', 0.25, 0.2, (p) => p[1] > 0.24], ['hand', [0.74, 0.1, 1.7], 0.2, 0.2],
  ['thigh', 'shin', 0.46, 0.36, overFeet], ['shin', 'foot', 0.33, 0.22, (p) => p[1] > 0.26], ['foot', [0.76, 0.1, -0.7], 0.22, 0.2],
].flatMap(([name, to, radius, end, only = () => true]) => ['L', 'R'].map((side) => {
  const target = typeof to === 'string' ? rig.place(to + side) : side === 'L' ? to : mirror(to);
  return bone(name + side, target, radius, end, (p) => (side === 'L') === p[0] > 0 && only(p));
}));

export const bones = [
  bone('hips', rig.place('spine1'), 0.8, 0.8, overFeet), bone('spine1', rig.place('spine2'), 0.85, 0.85, overFeet), bone('spine2', rig.place('chest'), 0.82, 0.82, overFeet),
  bone('chest', rig.place('neck'), 0.8, 0.7, overFeet),
  bone('neck', rig.place('head'), 0.62, 0.55), bone('head', [0, 2.83, 3.36], 0.55, 0.4, (p) => !jaw.onJaw(p)), bone('jaw', [0, 2.45, 3.4], 0.3, 0.3, jaw.onJaw),
  ...['L', 'R'].map((side) => ({ joint: `ear${side}`, from: rig.place(`ear${side}`), to: [(side === 'L' ? 1 : -1) * (ear[0] + 0.05), ear[1] + 0.05, ear[2] + 0.02], radius: 0.07 })),
  ...limbs,
  ...tailAt.map((_, i) => bone(`tail${i + 1}`, i < 5 ? rig.place(`tail${i + 2}`) : tailLine.at(-1).slice(0, 3), 0.42 - 0.06 * i, 0.36 - 0.06 * i, (p) => p[2] < -2)),
];
