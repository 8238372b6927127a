// What the otter does. Whole-body animations begin and end on all fours, sitting up or on its back; layers begin and end at rest.
import { animation, ease, laidDown, placed, planted, poseTimes, rotated, swell, together } from '../motion.mjs';
import { lidTurns } from '../eyes.mjs';
import { add, mixed } from '../vectors.mjs';
import { rig } from './rig.mjs';
import { eye, tailLine } from './shape.mjs';

const { PI, cos, max, sin } = Math;
const wave = (t, seconds, phase = 0) => sin(2 * PI * (t / seconds + phase));
const tail = [1, 2, 3, 4, 5, 6].map((i) => `tail${i}`), spine = ['hips', 'spine1', 'spine2', 'chest', 'neck', 'head'];
const legs = { foreL: ['upperArmL', 'foreArmL', 'handL'], foreR: ['upperArmR', 'foreArmR', 'handR'], hindL: ['thighL', 'shinL', 'footL'], hindR: ['thighR', 'shinR', 'footR'] };
const bends = { fore: -1, hind: 1 };
const atRest = (leg) => rig.place(legs[leg][2]);
const turns = (names, at) => ({ turn: Object.fromEntries(names.map((name, i) => [name, at(i)])) });

/** All feet where they stand, or off from there by `off(leg)`: { way, pitch }. */
function onFeet(pose, off = () => ({})) {
  return Object.keys(legs).reduce((out, leg) => {
    const { way = [0, 0, 0], pitch = 0 } = off(leg);
    return planted(rig, out, legs[leg], add(atRest(leg), way), { bend: bends[leg.slice(0, 4)], pitch });
  }, pose);
}
const tailEnd = tailLine.at(-1).slice(0, 3).map((x, k) => x - rig.place('tail6')[k]);
const tailDown = (pose, heights = [0.86, 0.5, 0.3, 0.19, 0.13, 0.1], most = 40) => laidDown(rig, pose, tail, tailEnd, heights, most);
const tailCurve = (degrees, t = 0, seconds = 6) => turns(tail, (i) => [0, degrees * (0.6 + 0.14 * i) + 2.5 * wave(t, seconds, -0.08 * i), 0]);

// --- on all fours ---

function stand(t) {
  const shift = wave(t, 6), look = wave(t, 6, 0.1), nod = wave(t, 3);
  return onFeet(tailDown(together(
    { move: { root: [0.05 * shift, 0.012 * nod - 0.02, 0] }, turn: { hips: [0, -1.5 * shift, -1.8 * shift], spine2: [0, 2 * shift, 2.4 * shift], neck: [0.8 * nod, 4 * look, 0], head: [1.2 * nod, 6 * look, -2 * look] } },
    tailCurve(9, t),
  )));
}

// Left hind, left fore, right hind, right fore: a walk's order.
const beat = { hindL: 0, foreL: 0.27, hindR: 0.5, foreR: 0.77 };
const kStride = 0.62, kStance = 0.62;
function step(leg, share) {
  const phase = (share + 1 - beat[leg]) % 1;
  if (phase < kStance) return { way: [0, 0, kStride * (0.5 - phase / kStance)] };
  const swing = (phase - kStance) / (1 - kStance), lift = sin(PI * swing);
  return { way: [0, (leg.startsWith('hind') ? 0.2 : 0.26) * lift, kStride * (-0.5 + ease(0, 1, swing))], pitch: 34 * lift * (1 - swing) - 8 * lift * swing };
}
function walk(t) {
  const s = t / kWalk, sway = wave(s, 1, 0.05), bob = wave(s, 0.5, 0.1);
  const body = together(
    { move: { root: [0.05 * sway, 0.035 * bob - 0.1, 0] }, turn: { hips: [1 * bob, 7 * sway, 4 * sway], spine1: [-1 * bob, -5 * sway, -3 * sway], spine2: [0, -7 * sway, -3 * sway], chest: [1.5 * bob, -2 * sway, 0], neck: [4 - 1.5 * bob, 4 * sway, 2 * sway], head: [-3 + bob, 3 * sway, 0] } },
    turns(tail, (i) => [0, (5 + 2 * i) * wave(s, 1, 0.2 - 0.09 * i), 0]),
  );
  return onFeet(tailDown(body), (leg) => step(leg, s));
}
const kWalk = 0.9;

/** The mouth open by so many degrees. */
const gape = (degrees) => ({ turn: { jaw: [degrees, 0, 0] } });

const kYawn = 3;
function yawn(t) {
  const wide = ease(0.1, 1.3, t) * (1 - ease(1.9, 2.5, t)), back = ease(0, 1.2, t) * (1 - ease(1.9, 2.8, t)), smack = swell(t - 2.3, 0.6, 0.2) * (t > 2.3 ? 1 : 0);
  return together(stand(0), gape(32 * wide + 6 * smack), shut(ease(0.4, 1.1, t) * (1 - ease(2.1, 2.8, t))), {
    turn: { neck: [-5 * back, 0, 0], head: [-15 * back, 0, 3 * back], earL: [-14 * wide, 20 * wide, 0], earR: [-14 * wide, -20 * wide, 0], chest: [-1.5 * back, 0, 0], upperArmL: [1.5 * back, 0, 0], upperArmR: [1.5 * back, 0, 0] },
  });
}

const kShake = 1.6, kBeats = 5.6;
function shake(t) {
  const much = swell(t, kShake, 0.16, 0.45), total = (place, most) => most * much * sin(2 * PI * (kBeats * t - 0.62 * place));
  // How far each is turned in all, from the head (0) to the tip of the tail; a joint adds what its parent has not.
  const places = { hips: [0.62, 20], spine1: [0.52, 23], spine2: [0.42, 26], chest: [0.3, 30], neck: [0.14, 33], head: [0, 35] }, turn = {};
  let before = 0;
  for (const name of spine) {
    const here = total(...places[name]);
    turn[name] = [{ neck: 14, head: 6, hips: -2 }[name] * much || 0, 0, here - before];
    before = here;
  }
  before = total(...places.hips);
  tail.forEach((name, i) => {
    const here = total(0.72 + 0.12 * i, 24 + 2 * i);
    turn[name] = [4 * much, 5 * much * sin(2 * PI * (kBeats * t - 0.8 - 0.12 * i)), here - before];
    before = here;
  });
  for (const side of ['L', 'R']) turn[`ear${side}`] = [0, 0, total(-0.12, 30)];
  const body = together({ move: { root: [0, -0.12 * much, 0] }, turn }, gape(7 * much), shut(ease(0.05, 0.2, t) * (1 - ease(1.2, 1.45, t))), poseTimes(stand(0), 1));
  return onFeet(body);
}

// --- sitting up ---

const sitting = (() => {
  const body = { move: { root: [0, -0.42, -0.25] }, turn: { hips: [-63, 0, 0], spine1: [-4, 0, 0], spine2: [6, 0, 0], chest: [10, 0, 0], neck: [22, 0, 0], head: [24, 0, 0] } };
  return ['hindL', 'hindR'].reduce((pose, leg) => planted(rig, pose, legs[leg], add(atRest(leg), [leg === 'hindL' ? 0.12 : -0.12, -0.06, 0.05]), { bend: 1 }), tailDown(together(body, tailCurve(8)), [0.34, 0.28, 0.22, 0.17, 0.13, 0.1], 80));
})();
const armsDown = turns(['upperArmL', 'upperArmR'], (i) => [38, 0, i ? 6 : -6]);
const handsDown = { turn: { foreArmL: [-78, 0, 0], foreArmR: [-78, 0, 0], handL: [62, 0, 0], handR: [62, 0, 0] } };
function sit(t) {
  const look = wave(t, 5), calm = wave(t, 2.5);
  return together(sitting, armsDown, handsDown, { turn: { spine2: [0.8 * calm, 0, 0], neck: [0, 5 * look, 0], head: [1.5 * calm, 9 * look, -2 * look], handL: [4 * calm, 0, 0], handR: [-4 * calm, 0, 0] } },
    turns(tail, (i) => [0, 2 * wave(t, 5, -0.1 * i), 0]));
}

const kGroom = 3.6;
function groom(t) {
  const much = swell(t, kGroom, 0.5), rub = sin(2 * PI * 2.2 * (t - 0.45)), tilt = sin(2 * PI * 0.55 * (t - 0.45));
  const body = together(sit(0), poseTimes({ turn: { chest: [6, 0, 0], neck: [8, 0, 0], head: [10 + 5 * rub, 6 * tilt, 9 * tilt] } }, much), gape((4 + 4 * sin(2 * PI * 2.2 * (t - 0.3))) * much), shut(0.9 * much));
  const all = placed(rig, body), head = all[rig.joint('head')];
  const rubbing = ['L', 'R'].reduce((pose, side, i) => {
    const own = sin(2 * PI * 2.2 * (t - 0.45) + (i ? 0.5 : 0)), out = i ? -1 : 1;
    const target = add(head.at, rotated(head.q, [out * (0.42 - 0.06 * own), -0.02 + 0.17 * own, 0.86 - 0.2 * own]));
    return planted(rig, pose, legs[`fore${side}`], target, { bend: -1, pitch: -70 });
  }, body);
  const arms = ['L', 'R'].flatMap((side) => legs[`fore${side}`]), down = sit(0).turn;
  return { ...body, turn: { ...body.turn, ...Object.fromEntries(arms.map((name) => [name, (down[name] ?? [0, 0, 0]).map((x, k) => mixed(x, rubbing.turn[name][k], much))])) } };
}

// --- on its back, in water ---

const kSwim = 4;
function swim(t) {
  const rock = wave(t, kSwim), kick = (phase) => max(-0.3, wave(t, kSwim / 4, phase)), bob = wave(t, kSwim / 2);
  return together(
    { move: { root: [0, 2.75 + 0.04 * bob, 0] }, turn: { root: [0, 0, 180 + 5 * rock] } },
    { turn: { hips: [-4, 0, 0], spine1: [4, 0, -1.5 * rock], spine2: [4, 0, -1.5 * rock], chest: [6, 0, 0], neck: [20, 3 * rock, 0], head: [20, 6 * rock, -3 * rock] } },
    { turn: { upperArmL: [-30, 0, -16], upperArmR: [-30, 0, 16], foreArmL: [-62, 0, -10], foreArmR: [-62, 0, 10], handL: [34 + 5 * bob, 0, -8], handR: [34 - 5 * bob, 0, 8] } },
    { turn: { thighL: [58 + 16 * kick(0), 0, 6], thighR: [58 + 16 * kick(0.5), 0, -6], shinL: [-14 - 14 * kick(0.1), 0, 0], shinR: [-14 - 14 * kick(0.6), 0, 0], footL: [46 + 24 * kick(-0.15), 0, 0], footR: [46 + 24 * kick(0.35), 0, 0] } },
    turns(tail, (i) => [[16, 4, 0, -2, -2, -2][i] + 3 * wave(t, kSwim / 2, -0.1 * i), (3 + 1.6 * i) * wave(t, kSwim, -0.1 * i), 0]),
  );
}

// --- layers ---

/** 1: shut. */
const shut = (share) => lidTurns(eye, 56 * share, 13 * share);
const lean = (side) => (t) => poseTimes(together(
  { move: { root: [side * 0.14, -0.03, 0] }, turn: { hips: [0, 0, -side * 3], spine1: [0, side * 2, -side * 3], chest: [0, side * 4, -side * 3], neck: [3, side * 6, -side * 9], head: [-3, -side * 4, -side * 16] } },
  { turn: { thighL: [0, 0, -side * 4], thighR: [0, 0, -side * 4], upperArmL: [0, 0, side * 5], upperArmR: [0, 0, side * 5], earL: [0, side * 8, 0], earR: [0, side * 8, 0] } },
), swell(t, 2, 0.45, 0.7));
const flick = (side) => (t) => ({ turn: { [`ear${side}`]: [-22, side === 'L' ? 34 : -34, 0].map((x) => x * swell(t, 0.4, 0.09, 0.3) * (0.7 + 0.3 * cos(2 * PI * 9 * t))) } });
const kBreath = 3.4;
const breathe = (t) => {
  const full = 0.5 - 0.5 * cos((2 * PI * t) / kBreath);
  return { move: { spine1: [0, 0.022 * full, 0], chest: [0, -0.008 * full, 0.01 * full], neck: [0, -0.004 * full, 0], upperArmL: [0.012 * full, -0.01 * full, 0], upperArmR: [-0.012 * full, -0.01 * full, 0] }, turn: { chest: [-0.7 * full, 0, 0], neck: [0.7 * full, 0, 0] } };
};
const sway = (t) => turns(tail, (i) => [0, (2 + 1.6 * i) * wave(t, 3, -0.11 * i) - (2 + 1.6 * i) * wave(0, 3, -0.11 * i), 0]);

/** As motion.mjs makes them; the first is what plays by itself. */
export const motions = () => [
  animation(rig, 'stand', 6, stand, { loop: true, rate: 15 }), animation(rig, 'sit', 5, sit, { loop: true, rate: 15 }), animation(rig, 'groom', kGroom, groom), animation(rig, 'yawn', kYawn, yawn),
  animation(rig, 'shake', kShake, shake, { rate: 60, degrees: 1.2 }), animation(rig, 'walk', kWalk, walk, { loop: true }), animation(rig, 'swim', kSwim, swim, { loop: true, rate: 20 }),
  animation(rig, 'breathe', kBreath, breathe, { loop: true, degrees: 0.2, way: 0.003 }), animation(rig, 'blink', 0.3, (t) => shut(swell(t, 0.3, 0.1, 0.16)), { degrees: 3 }),
  animation(rig, 'squint', 1.4, (t) => shut(0.55 * swell(t, 1.4, 0.2, 0.35))),
  animation(rig, 'earFlickL', 0.4, flick('L'), { rate: 60 }), animation(rig, 'earFlickR', 0.4, flick('R'), { rate: 60 }), animation(rig, 'tailSway', 3, sway, { loop: true, rate: 20 }),
  animation(rig, 'leanL', 2, lean(1)), animation(rig, 'leanR', 2, lean(-1)),
];
