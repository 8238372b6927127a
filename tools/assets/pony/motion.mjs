// The pony's animations. Whole-body ones, and layers that are added to them: those begin and end at rest.
import { animation, ease, placed, planted, swell, together } from '../motion.mjs';
import { lidTurns } from '../eyes.mjs';
import { eye } from './eyes.mjs';
import { rig } from './rig.mjs';

const { PI, cos, max, min, sin } = Math;
const turns = (t) => 2 * PI * t, fraction = (x) => x - Math.floor(x);
const { place } = rig;

// --- legs ---

const legs = ['LF', 'RF', 'LH', 'RH'].map((name) => {
  const side = name[0], isFore = name[1] === 'F';
  const chain = (isFore ? ['foreArm', 'cannonF', 'hand'] : ['shin', 'cannonH', 'foot']).map((joint) => joint + side);
  return { name, isFore, chain, upper: (isFore ? 'upperArm' : 'thigh') + side, at: place(chain[2]), bend: isFore ? 1 : -1 };
});

/**
 * A foreleg that carries is straight: the upper arm turns so that elbow and fetlock are as far apart as that takes. `load`: how much it carries,
 * `swing`: where it would be otherwise, degrees.
 */
function armOf(pose, { chain, upper }, target, load, swing) {
  const length = straight(chain), [fore] = chain.map((name) => rig.joint(name));
  const off = (angle) => {
    const { at } = placed(rig, together(pose, { turn: { [upper]: [angle, 0, 0] } }))[fore];
    return Math.hypot(at[1] - target[1], at[2] - target[2]) - length;
  };
  // Farther back the elbow is higher.
  let low = swing - 40, high = swing + 32;
  if (load <= 0) return swing;
  for (let i = 0; i < 16; ++i) off((low + high) / 2) < 0 ? (low = (low + high) / 2) : (high = (low + high) / 2);
  return swing + load * ((low + high) / 2 - swing);
}
const straight = (chain) => {
  const [a, b, c] = chain.map(place);
  return 0.9975 * (Math.hypot(a[1] - b[1], a[2] - b[2]) + Math.hypot(b[1] - c[1], b[2] - c[2]));
};

/** With each foot { forward, up, pitch in degrees, load } from where it stands at rest; `roll`: of the upper joints, degrees. */
function standing(pose, feet = {}, roll = 0) {
  for (const leg of legs) {
    const { name, isFore, chain, upper, at, bend } = leg, { forward, up, pitch, load } = feet[name] ?? { forward: 0, up: 0, pitch: 0, load: 1 };
    const target = [at[0], at[1] + up, at[2] + forward];
    // The shoulder and the hip follow by so much of the way.
    const swing = isFore ? armOf(pose, leg, target, load, -9 * forward - 10 * max(0, up)) : -10 * forward - 12 * max(0, up);
    pose = planted(rig, together(pose, { turn: { [upper]: [swing, 0, roll] } }), chain, target, { bend, pitch });
  }
  return pose;
}

/** A foot in a gait: at `s` 0 it lands, at `duty` it leaves the ground. */
function step(s, duty, reach, lift, isFore) {
  if (s < duty) {
    const t = s / duty, off = max(0, (t - 0.72) / 0.28);
    return { forward: reach * (1 - 2 * t), up: 0.28 * off * off * min(1, reach), pitch: 24 * off * off, load: 1 };
  }
  const t = (s - duty) / (1 - duty), rise = sin(PI * t ** 0.8);
  return {
    forward: reach * (2 * ease(-0.1, 1.04, t) - 1), up: lift * rise + 0.28 * (1 - t) ** 2 * min(1, reach),
    pitch: 24 * (1 - t) ** 2 + (isFore ? 95 : 75) * lift * sin(PI * t) * (1 - t) - 8 * t * sin(PI * t), load: 1 - ease(0, 0.3, t) + ease(0.75, 1, t),
  };
}

// --- whole body ---

function stand(t, seconds) {
  const s = turns(t / seconds), shift = 0.07 * sin(s);
  const pose = {
    move: { root: [shift, 0.02 * cos(2 * s) - 0.02, 0] },
    turn: { hips: [0, 0, 0.9 * sin(s)], chest: [0, 0, -0.9 * sin(s)], neck1: [1.5 * sin(s + 1), 2 * sin(s + 0.7), 0], neck: [1.2 * sin(2 * s), 1.5 * sin(s), 0], head: [-1.6 * sin(s + 0.6), 1.5 * sin(s + 2), 1.2 * sin(s)],
      earL: [0, 5 * sin(2 * s + 1), 0], earR: [0, 5 * sin(3 * s), 0] },
  };
  return standing(pose, {}, (-shift / 7) * (180 / PI));
}

function toss(t, seconds) {
  const dip = ease(0, 0.35, t) * (1 - ease(0.35, 0.75, t)), up = ease(0.35, 0.75, t) * (1 - ease(1.3, seconds - 0.1, t)), shake = swell(t, seconds, 0.6, 0.7) * sin(turns(2.2 * t));
  const pose = {
    move: { root: [0, -0.1 * dip + 0.03 * up, 0.08 * up] },
    turn: { neck1: [16 * dip - 15 * up, 2 * shake, 0], neck: [14 * dip - 14 * up, 7 * shake, 0], head: [10 * dip - 12 * up, 9 * shake, 9 * shake], jaw: [13 * up * (0.7 + 0.3 * cos(turns(3 * t))), 0, 0], earL: [-8 * up, 0, 14 * up], earR: [-8 * up, 0, -14 * up], chest: [1.5 * dip - 1.5 * up, 0, 0], tail1: [10 * up, 6 * shake, 0] },
  };
  return standing(pose);
}

/** Each hind leg is followed by the foreleg of its side: four beats. */
function walk(t, seconds) {
  const s = t / seconds, phase = { LH: 0, LF: 0.25, RH: 0.5, RF: 0.75 }, feet = {};
  for (const { name, isFore } of legs) feet[name] = step(fraction(s - phase[name]), 0.62, 1.15, isFore ? 0.55 : 0.45, isFore);
  const a = turns(s), b = turns(2 * s);
  return standing({
    move: { root: [0.06 * sin(a - 0.8), -0.08 + 0.05 * cos(b), 0] },
    turn: { hips: [0.8 * sin(b), 1.6 * sin(a), 1.6 * cos(a)], spine1: [0, -1.2 * sin(a), -1 * cos(a)], spine2: [0, -1.2 * sin(a), -0.6 * cos(a)], chest: [-0.6 * sin(b + 0.6), 0.8 * sin(a), 0], neck1: [2.6 * sin(b + 0.4), 0, 0], neck: [2 * sin(b + 0.1), 0.8 * sin(a), 0], head: [-2.4 * sin(b - 0.3), 0, 0], tail1: [0, 5 * sin(a + 0.5), 0], tail2: [0, 5 * sin(a - 0.3), 0] },
  }, feet);
}

/** The right hind leg, then the left one with the right foreleg, then the leading left foreleg; then none is on the ground. */
function canter(t, seconds) {
  const s = t / seconds, phase = { RH: 0, LH: 0.2, RF: 0.23, LF: 0.44 }, feet = {};
  for (const { name, isFore } of legs) feet[name] = step(fraction(s - phase[name]), 0.33, name === 'LF' ? 1.5 : 1.35, isFore ? 0.95 : 0.7, isFore);
  const a = turns(s), pitch = -5.5 * cos(a + 0.35), rise = 0.28 * sin(a - 2.1);
  // About the middle of the body, not about the ground.
  const radians = (pitch * PI) / 180, high = 7.4;
  return standing({
    move: { root: [0, -0.15 + rise + high * (1 - cos(radians)), -high * sin(radians)] },
    turn: { root: [pitch, 0, 0], hips: [2.5 * sin(a), 0, 0], spine1: [-2 * sin(a), 0, 0], spine2: [-2 * sin(a + 0.2), 0, 0], neck1: [5 - 4 * cos(a + 0.8), 0, 0], neck: [2 - 3.5 * cos(a + 0.5), 0, 0], head: [-3 + 4.5 * cos(a + 0.2), 0, 0], jaw: [3 - 3 * cos(a), 0, 0], tail1: [16 + 8 * sin(a), 0, 0], tail2: [-4 + 8 * sin(a - 0.8), 0, 0], tail3: [6 * sin(a - 1.6), 0, 0], earL: [-6, 0, 3], earR: [-6, 0, -3] },
  }, feet);
}

/** From the head to the tail, as a wave. */
function shake(t, seconds) {
  const wave = (delay, amount, rate = 4.6) => amount * swell(t - delay, seconds - 0.45, 0.35, 0.5) * sin(turns(rate * (t - delay)));
  const low = swell(t, seconds, 0.4, 0.5);
  return standing({
    move: { root: [wave(0.15, 0.05), -0.22 * low, 0] },
    turn: {
      head: [6 * low, wave(0, 6), wave(0, 20)], jaw: [6 * low + wave(0.05, 4), 0, 0], neck: [8 * low, wave(0.05, 5), wave(0.04, 9)], neck1: [9 * low, wave(0.1, 3), wave(0.08, 5)], chest: [0, 0, wave(0.14, 3.4)], spine2: [0, 0, wave(0.18, -1)], spine1: [0, 0, wave(0.24, 1.5)],
      hips: [0, 0, wave(0.3, 3)], tail1: [0, wave(0.36, 9), 0], tail2: [0, wave(0.42, 12), 0], tail3: [0, wave(0.45, 12), 0], earL: [0, wave(0.02, 25), 14 * low], earR: [0, wave(0.02, 25), -14 * low],
    },
  }, Object.fromEntries(legs.map(({ name, isFore }) => [name, { forward: 0.12 * low * (isFore ? 1 : -1), up: 0, pitch: 0, load: 1 }])));
}

// --- layers ---

const breathe = (t, seconds) => {
  const s = 0.5 - 0.5 * cos(turns(t / seconds));
  return { move: { spine2: [0, 0.035 * s, 0], chest: [0, -0.035 * s, 0.01 * s] }, turn: { neck1: [-0.5 * s, 0, 0], head: [0.4 * s, 0, 0] } };
};

const flick = (ear, side) => (t, seconds) => {
  const back = swell(t, seconds, 0.12, 0.3), tremble = back * sin(turns(6 * t));
  return { turn: { [ear]: [-10 * back + 5 * tremble, side * (38 * back + 12 * tremble), side * -12 * back] } };
};

function tailSway(t, seconds) {
  const a = turns(t / seconds), b = turns((2 * t) / seconds);
  return { turn: { tail1: [1.5 * (1 - cos(a)), 7 * sin(a), 0], tail2: [0, 6 * (sin(a - 0.7) + sin(0.7)) * (0.5 - 0.5 * cos(a)), 0], tail3: [0, 4 * sin(b) * (0.5 - 0.5 * cos(a)), 0] } };
}

/** Towards whoever strokes it: 1 left, -1 right. Feet stay where they are. */
const lean = (side) => (t, seconds) => {
  const s = swell(t, seconds, 0.7), roll = (-0.3 / 7) * (180 / PI) * s * side;
  const upper = Object.fromEntries(legs.map(({ upper: joint }) => [joint, [0, 0, roll]]));
  return { move: { root: [0.3 * side * s, 0, 0] }, turn: { ...upper, neck1: [2 * s, 4 * side * s, 0], neck: [3 * s, 6 * side * s, 0], head: [2 * s, 5 * side * s, 7 * side * s] } };
};

export const animations = () => {
  const of = (name, seconds, at, options) => animation(rig, name, seconds, (t) => at(t, seconds), options), loop = { loop: true };
  return [
    of('stand', 8, stand, loop), of('toss', 2.4, toss), of('walk', 1.3, walk, loop), of('canter', 0.62, canter, loop), of('shake', 2.4, shake),
    of('breathe', 3.6, breathe, loop), of('blink', 0.34, (t, seconds) => { const s = swell(t, seconds, 0.12, 0.2); return lidTurns(eye, 50 * s, 6 * s); }), of('squint', 1.6, (t, seconds) => { const s = swell(t, seconds, 0.25, 0.5); return lidTurns(eye, 24 * s, 8 * s); }),
    of('earFlickL', 0.7, flick('earL', 1)), of('earFlickR', 0.7, flick('earR', -1)), of('tailSway', 4.2, tailSway, loop), of('leanL', 3, lean(1)), of('leanR', 3, lean(-1)),
  ];
};
