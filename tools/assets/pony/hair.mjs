// Mane, forelock and tail, and what of the body they stay out of.
import { falling, roomAt } from '../hair.mjs';
import { surfaceOf } from '../nets.mjs';
import { add, between, clamp, far, mixed, scaled, smooth } from '../vectors.mjs';
import { tailAt } from './rig.mjs';
import { headPlace, headTurn, inHead, ponyAt } from './shape.mjs';

const { abs, max, min, sin } = Math;
const surface = surfaceOf(ponyAt, { step: 0.01, most: 0.1 });
// The same numbers every time, evenly spread.
const spread = (i) => (i * 0.6180339887) % 1;

// --- mane: from the poll to the withers, falling to the right ---

const crestLine = [[0, 12.75, 5.55], [0, 12.4, 4.75], [0, 11.85, 4.0], [0, 11.1, 3.4], [0, 10.4, 2.95], [0, 10.05, 2.6]];
const alongCrest = (t) => {
  const at = clamp(t, 0, 0.9999) * (crestLine.length - 1), i = Math.floor(at);
  return between(crestLine[i], crestLine[i + 1], at - i);
};
const maneLength = (t) => 3.0 + 0.9 * sin(3.1 * t) - 1.0 * smooth(0.85, 1, t);
const maneGuides = () => Array.from({ length: 48 }, (_, i) => {
  const row = i % 3, t = (Math.floor(i / 3) + 0.5) / 16, x = [0.2, 0, -0.2][row];
  const root = surface.onSurface(add(alongCrest(t), [x, 0.05, 0]), 12), n = surface.normal(root);
  return falling({
    root, start: add(n, [-0.35 - 0.2 * row, 0.1, 0.1]), fall: [-0.14, -1, -0.06 + 0.1 * (spread(i) - 0.5)], nodes: 9, length: maneLength(t) * mixed(0.85, 1.08, spread(i + 3)), bend: 0.55, gap: (s) => 0.1 + 0.16 * min(1, 2.5 * s),
  }, ponyAt, surface);
});
const onMane = ({ position: p, normal: n }) => {
  let least = Infinity;
  for (let i = 0; i < 30; ++i) least = min(least, far(p, alongCrest(i / 29)));
  return n[1] < 0.1 && abs(p[0]) > 0.3 ? 0 : smooth(0.42, 0.26, max(abs(p[0]), 0.75 * least));
};

// --- forelock ---

const forelockGuides = () => Array.from({ length: 15 }, (_, i) => {
  const row = Math.floor(i / 5), x = ((i % 5) - 2) * 0.1, root = surface.onSurface(headPlace([x, 0.1, 0.02 + 0.13 * row]), 12), n = surface.normal(root);
  const side = x - 0.08;  // it parts beside the middle
  return falling({
    root, start: add(n, headTurn([side, 0.3, 0.35])), fall: headTurn([1.2 * side, -0.12, 1]), nodes: 8, length: 2.1 * mixed(0.6, 1.1, spread(i)), bend: 0.5, gap: (s) => 0.08 + 0.12 * min(1, 2.5 * s),
  }, ponyAt, surface);
});
const onForelock = ({ position: p }) => {
  const [x, v, u] = inHead(p);
  return v < -0.25 ? 0 : smooth(0.28, 0.16, abs(x)) * smooth(-0.2, -0.05, u) * smooth(0.42, 0.28, u);
};

// --- tail ---

const alongDock = (t) => {
  const at = clamp(t, 0, 0.9999) * 3, i = Math.floor(at);
  return between(tailAt[i], tailAt[i + 1], at - i);
};
const tailGuides = () => Array.from({ length: 30 }, (_, i) => {
  const ring = Math.floor(i / 5), t = 0.08 + (0.9 * ring) / 5, angle = ((i % 5) - 2) * 0.62, middle = alongDock(t);
  // Round the back of the dock, from one side to the other.
  const out = [sin(angle), 0.3 * (1 - t), -Math.cos(angle)], root = surface.onSurface(add(middle, scaled(out, 0.3)), 12);
  const length = root[1] - mixed(0.75, 1.5, spread(i)) + 0.35;
  return falling({
    root, start: add(scaled(out, 0.8), [0, -0.5, -0.3]), fall: (p) => [-0.06 * p[0], -1, p[1] > 5 ? 0.03 : 0.05], nodes: 14, length, bend: 0.45, gap: (s) => 0.06 + 0.42 * min(1, 3 * s) * (0.4 + 0.6 * spread(i + 7)),
  }, ponyAt, surface);
});
const onTail = ({ position: p }) => {
  let least = Infinity, best = 0;
  for (let i = 0; i < 20; ++i) { const d = far(p, alongDock(i / 19)); if (d < least) least = d, best = i / 19; }
  return p[2] < -4.9 && least < 0.6 ? smooth(0.02, 0.22, best) : 0;
};

// --- what hair stays out of ---

const thick = 0.1;  // of the coat that lies
function capsule(joint, a, b) {
  return { joint, a, b, radius: min(roomAt(ponyAt, a), roomAt(ponyAt, b), roomAt(ponyAt, between(a, b, 0.5))) + thick };
}
const bothSides = (joint, a, b) => ['L', 'R'].map((side) => {
  const at = ([x, y, z]) => [side === 'L' ? x : -x, y, z];
  return { ...capsule(joint, a, b), joint: joint.endsWith('*') ? joint.slice(0, -1) + side : joint, a: at(a), b: at(b) };
});
const bodies = () => [
  capsule('neck1', [0, 9.9, 3.0], [0, 10.9, 3.75]), capsule('neck1', [0, 9.3, 3.6], [0, 10.3, 4.2]), capsule('neck1', [0, 8.4, 3.6], [0, 9.9, 4.7]),
  capsule('neck', [0, 10.9, 3.75], [0, 11.75, 4.4]), capsule('neck', [0, 10.3, 4.2], [0, 11.4, 4.85]), capsule('neck', [0, 10.2, 4.9], [0, 11.2, 5.3]),
  ...bothSides('neck', [0.3, 11.6, 5.0], [0.35, 10.8, 4.7]),
  capsule('neck', [0, 11.75, 4.4], [0, 12.2, 5.1]),
  capsule('head', headPlace([0, -0.35, 0.15]), headPlace([0, -0.25, 1.0])), capsule('head', headPlace([0, -0.8, 0.6]), headPlace([0, -0.75, 1.6])), capsule('head', headPlace([0, -0.25, 1.0]), headPlace([0, -0.45, 2.2])),
  capsule('head', headPlace([0, -0.45, 2.2]), headPlace([0, -0.6, 3.6])), ...bothSides('head', headPlace([0.42, -0.35, 0.9]), headPlace([0.38, -0.4, 1.7])),
  capsule('chest', [0, 8.9, 1.2], [0, 9.1, 2.8]), capsule('chest', [0, 7.3, 1.2], [0, 7.4, 2.9]), ...bothSides('chest', [0.7, 8.2, 2.6], [0.75, 6.9, 3.7]), capsule('chest', [0, 6.9, 3.0], [0, 7.6, 3.9]),
  capsule('spine2', [0, 8.5, -0.9], [0, 8.55, 0.7]), ...bothSides('spine2', [0.8, 7.9, -0.7], [0.8, 7.9, 0.7]), ...bothSides('chest', [0.7, 8.4, 0.9], [0.7, 8.6, 2.1]),
  capsule('hips', [0, 7.8, -3.6], [0, 8.2, -2.4]), ...bothSides('hips', [0.75, 8.5, -3.6], [0.75, 8.0, -4.3]), ...bothSides('thigh*', [1.05, 7.6, -4.2], [1.15, 6.4, -4.3]), ...bothSides('thigh*', [1.0, 7.9, -4.5], [1.05, 7.0, -4.75]),
  ...bothSides('shin*', [1.3, 5.6, -3.8], [1.15, 4.3, -4.75]), ...bothSides('cannonH*', [1.1, 3.9, -5.05], [1.08, 1.4, -4.9]),
];

// --- all of it ---

const flaxen = { rootColor: '#7d5530', tipColor: '#e3c79b', variance: 0.45, gloss: 0.3, shininess: 45 };
export const hair = ({ size }) => ({
  bodies: bodies(),
  scalps: [
    { name: 'Mane', guides: maneGuides(), grow: (at) => [onMane(at), 0.6, 1, 1], values: { ...flaxen, wisps: 420, strands: 30, strandWidth: 0.0022, guideLength: size(2.4), nodes: 9, leastWidth: 0.02, mostWidth: 0.05, tipWidth: 0.4, depth: 0.5, lengthVariation: 0.3, frizz: 0.12, stray: 0.2, tipVariation: 0.45, magnet: 0.3, stiffness: 0.3, damping: 0.35 } },
    { name: 'Forelock', guides: forelockGuides(), grow: (at) => [onForelock(at), 0.5, 1, 1], values: { ...flaxen, wisps: 110, strands: 22, strandWidth: 0.0022, guideLength: size(2), nodes: 8, leastWidth: 0.012, mostWidth: 0.03, tipWidth: 0.35, lengthVariation: 0.5, frizz: 0.12, stray: 0.2, tipVariation: 0.45, magnet: 0.3, stiffness: 0.35, damping: 0.4 } },
    { name: 'Tail', guides: tailGuides(), grow: (at) => [onTail(at), 0.7, 1, 1], values: { ...flaxen, wisps: 300, strands: 32, strandWidth: 0.0024, guideLength: size(7), nodes: 14, leastWidth: 0.03, mostWidth: 0.072, tipWidth: 0.4, depth: 0.6, lengthVariation: 0.35, frizz: 0.1, stray: 0.15, tipVariation: 0.5, magnet: 0.35, stiffness: 0.25, damping: 0.3 } },
  ],
});
