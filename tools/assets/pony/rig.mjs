// The pony's joints, and which part of the skin goes with which. Joints at x > 0 are those of its left side.
import { ear, eye, headPlace, jaw } from './shape.mjs';
import { sides, skeleton } from '../rig.mjs';
import { smooth } from '../vectors.mjs';

const eyeAt = headPlace(eye.at);
export const tailAt = [[0, 9.05, -4.9], [0, 8.45, -5.6], [0, 7.55, -5.8], [0, 6.9, -5.8]];

export const rig = skeleton([
  ['root', null, [0, 0, 0]], ['hips', 'root', [0, 8.3, -3.5]], ['spine1', 'hips', [0, 8.5, -1.9]], ['spine2', 'spine1', [0, 8.4, -0.3]], ['chest', 'spine2', [0, 8.3, 1.4]],
  ['neck1', 'chest', [0, 8.6, 3.0]], ['neck', 'neck1', [0, 10.5, 4.2]], ['head', 'neck', [0, 12.1, 5.5]], ['jaw', 'head', jaw.hinge],
  ...sides([
    ['ear', 'head', ear.base], ['eye', 'head', eyeAt], ['lidUpper', 'head', eyeAt], ['lidLower', 'head', eyeAt],
    ['upperArm', 'chest', [1.15, 7.0, 3.8]], ['foreArm', '+upperArm', [1.28, 5.5, 2.95]], ['cannonF', '+foreArm', [1.13, 2.95, 3.12]], ['hand', '+cannonF', [1.1, 1.2, 3.1]],
    ['thigh', 'hips', [1.05, 7.9, -3.6]], ['shin', '+thigh', [1.4, 5.75, -2.85]], ['cannonH', '+shin', [1.1, 3.8, -4.98]], ['foot', '+cannonH', [1.08, 1.25, -4.85]],
  ]),
  ['tail1', 'hips', tailAt[0]], ['tail2', 'tail1', tailAt[1]], ['tail3', 'tail2', tailAt[2]],
]);

// What hangs on a joint: a line and how far round it the skin is.
const line = (joint, from, to, radius, end) => ({ joint, from, to, radius, end });
const both = (rows) => ['L', 'R'].flatMap((side) => rows.map(([joint, from, to, radius, end]) => {
  const at = ([x, y, z]) => [side === 'L' ? x : -x, y, z];
  return { ...line(joint + side, at(from), at(to), radius, end), only: ([x]) => (side === 'L' ? x > -0.05 : x < 0.05) };
}));
const { place } = rig;
const left = (name) => place(`${name}L`);

export const bones = [
  line('hips', [0, 7.9, -4.6], [0, 7.7, -2.8], 2.0), line('spine1', [0, 7.4, -1.9], [0, 7.3, -0.9], 2.4), line('spine2', [0, 7.2, -0.2], [0, 7.2, 0.8], 2.4),
  line('chest', [0, 7.4, 1.6], [0, 7.6, 3.2], 2.1), line('neck1', [0, 8.4, 3.4], [0, 9.9, 4.2], 1.45, 1.3), line('neck', place('neck'), [0, 11.6, 5.1], 1.2, 1.0),
  { ...line('head', headPlace([0, -0.6, 0.4]), headPlace([0, -0.4, 3.8]), 0.95, 0.6), only: (p) => !jaw.onJaw(p) }, { ...line('jaw', jaw.hinge, headPlace([0, -1.3, 3.7]), 0.4), only: jaw.onJaw },
  line('tail1', [0, 8.9, -5.1], tailAt[1], 0.42), line('tail2', tailAt[1], tailAt[2], 0.34), line('tail3', tailAt[2], tailAt[3], 0.3),
  ...both([
    ['ear', ear.base, ear.tip, 0.36, 0.2],
    ['upperArm', [1.3, 7.3, 3.6], [1.4, 6.0, 3.3], 0.9, 0.85], ['foreArm', [1.3, 5.2, 3.0], left('cannonF'), 0.75, 0.42], ['cannonF', left('cannonF'), left('hand'), 0.42, 0.36], ['hand', left('hand'), [1.1, 0, 3.7], 0.4, 0.5],
    ['thigh', [1.2, 7.6, -3.7], [1.4, 6.1, -3.4], 1.25, 1.15], ['shin', [1.35, 5.4, -3.4], left('cannonH'), 0.85, 0.45], ['cannonH', left('cannonH'), left('foot'), 0.45, 0.36], ['foot', left('foot'), [1.08, 0, -4.2], 0.4, 0.5],
  ]),
];

/** How far the skin shares a joint: little at knees and fetlocks, far on the trunk. */
export const spread = ([x, y, z]) => {
  if (y > 9.5 && z > 5.5) return 0.22;
  const high = smooth(3.6, 6.6, y);
  return 0.2 + 0.6 * high - (y > 8 && z > 3 ? 0.3 * smooth(9, 12, y) : 0);
};
