// Animations as functions of time. A pose is { turn: { joint: [x, y, z] }, move: { joint: [x, y, z] } }: degrees about the animal's left
// (nose down), up (to its left) and front (left side up), in the order roll, pitch, yaw; ways from where joints are at rest.
import { add, dot, scaled, sub } from './vectors.mjs';

const { PI, acos, atan2, cos, hypot, max, min, sin } = Math;
const radians = PI / 180;

// --- quaternions [x, y, z, w] ---

export const product = ([ax, ay, az, aw], [bx, by, bz, bw]) => [
  aw * bx + ax * bw + ay * bz - az * by, aw * by - ax * bz + ay * bw + az * bx, aw * bz + ax * by - ay * bx + az * bw, aw * bw - ax * bx - ay * by - az * bz,
];
const about = (axis, degrees) => {
  const half = 0.5 * degrees * radians, out = [0, 0, 0, cos(half)];
  out[axis] = sin(half);
  return out;
};
export const quaternion = ([x = 0, y = 0, z = 0] = []) => product(product(about(1, y), about(0, x)), about(2, z));
export const rotated = (q, [x, y, z]) => product(product(q, [x, y, z, 0]), [-q[0], -q[1], -q[2], q[3]]).slice(0, 3);

// --- poses ---

/** Where joints are: { at, q } each, in the space of the model. */
export function placed({ joints }, { turn = {}, move = {} }) {
  const out = [];
  for (const { name, parent, offset } of joints) {
    const way = add(offset, move[name] ?? [0, 0, 0]), q = quaternion(turn[name]), from = out[parent];
    out.push(from ? { at: add(from.at, rotated(from.q, way)), q: product(from.q, q) } : { at: way, q });
  }
  return out;
}

/** Adds up turns and ways. */
export function together(...poses) {
  const out = { turn: {}, move: {} };
  for (const pose of poses) for (const kind of ['turn', 'move'])
    for (const [name, value] of Object.entries(pose[kind] ?? {})) out[kind][name] = add(out[kind][name] ?? [0, 0, 0], value);
  return out;
}
export const poseTimes = (pose, share) => Object.fromEntries(Object.entries(pose).map(([kind, all]) =>
  [kind, Object.fromEntries(Object.entries(all).map(([name, value]) => [name, scaled(value, share)]))]));
export const poseBetween = (a, b, t) => together(poseTimes(a, 1 - t), poseTimes(b, t));

/**
 * The pose with a leg turned so that its last joint comes to `target` (in the space of the model), or as near as it can. `leg`: its three
 * joints; `bend`: 1 where its middle joint bends to the front, -1 to the back; `pitch`: of the last one, in the space of the model.
 */
export function planted(rig, pose, leg, target, { bend = 1, pitch = 0 } = {}) {
  const [upper, , foot] = leg.map((name) => rig.joint(name)), reach = hypot(...rig.joints[foot].offset) + hypot(...rig.joints[rig.joint(leg[1])].offset);
  let out = pose, goal = target, roll = 0;
  // The leg swings sideways first, then works in its own plane: what that misses is aimed for again.
  for (let round = 0; round < 5; ++round) {
    out = swung(rig, out, leg, goal, bend, pitch, roll);
    const all = placed(rig, out), q = all[rig.joints[upper].parent].q;
    const miss = sub(target, all[foot].at), own = rotated([-q[0], -q[1], -q[2], q[3]], miss);
    roll += atan2(own[0], reach) / radians;
    goal = add(goal, scaled(miss, 0.7));
  }
  return out;
}

// In the plane of the leg, which is turned by `roll` about the front.
function swung(rig, pose, leg, goal, bend, pitch, roll) {
  const [upper, lower, foot] = leg.map((name) => rig.joint(name)), { joints } = rig;
  const all = placed(rig, pose), from = all[joints[upper].parent].q, back = [-from[0], -from[1], -from[2], from[3]];
  const way = rotated(back, sub(goal, all[upper].at)), u = joints[lower].offset, v = joints[foot].offset;
  const angle = (w) => atan2(w[2], w[1]), lengthOf = (w) => hypot(w[1], w[2]);
  const a = lengthOf(u), b = lengthOf(v), d = min(max(lengthOf(way), Math.abs(a - b) * 1.02 + 1e-6), (a + b) * 0.998);
  const open = acos(max(-1, min(1, (a * a + d * d - b * b) / (2 * a * d))));
  // A leg hangs down, at an angle of 180 degrees: to its front angles are smaller.
  const first = angle(way) - bend * open, knee = [0, a * cos(first), a * sin(first)], end = scaled([0, way[1], way[2]], d / lengthOf(way));
  const near = (degrees) => ((degrees % 360) + 540) % 360 - 180;
  const hip = near((first - angle(u)) / radians), bent = near((angle(sub(end, knee)) - angle(v)) / radians - hip);
  const upwards = rotated(from, [0, 1, 0]), pitchOfParent = atan2(upwards[2], upwards[1]) / radians;
  return { ...pose, turn: { ...pose.turn, [leg[0]]: [hip, 0, roll], [leg[1]]: [bent, 0, 0], [leg[2]]: [near(pitch - hip - bent - pitchOfParent), 0, -roll] } };
}

/** The pose with a tail that comes down to the ground and lies on it: `heights` of its joints and of its tip there; `most`: degrees a joint. */
export function laidDown(rig, pose, tail, tip, heights, most = 40) {
  let out = pose;
  const ends = [...tail.slice(1).map((name) => rig.joints[rig.joint(name)].offset), tip];
  tail.forEach((name, i) => {
    const { at, q } = placed(rig, out)[rig.joint(name)], way = rotated(q, ends[i]), size = hypot(...way);
    const wanted = -Math.asin(max(-0.95, min(0.95, (heights[i] - at[1]) / size))), is = -Math.asin(way[1] / size);
    const [x, y, z] = out.turn?.[name] ?? [0, 0, 0];
    out = { ...out, turn: { ...out.turn, [name]: [x + max(-most, min(most, (is - wanted) / radians)), y, z] } };
  });
  return out;
}

// --- time ---

/** From 0 at `begin` to 1 at `end`, without a jerk. */
export const ease = (begin, end, t) => {
  const s = max(0, min(1, (t - begin) / (end - begin)));
  return s * s * s * (s * (6 * s - 15) + 10);
};
/** Up within `rise`, there until `hold` before the end, and back: 0..1..0. */
export const swell = (t, seconds, rise, fall = rise) => ease(0, rise, t) * (1 - ease(seconds - fall, seconds, t));


// How far from the line between keys i and k the values are, in units of what is seen.
function worst(rows, times, i, k) {
  let at = -1, most = 1;
  for (let m = i + 1; m < k; ++m) {
    const t = (times[m] - times[i]) / (times[k] - times[i]);
    let off = 0;
    for (const { values, tolerance } of rows)
      for (let c = 0; c < values[m].length; ++c) off = max(off, Math.abs(values[m][c] - (values[i][c] + t * (values[k][c] - values[i][c]))) / tolerance);
    if (off > most) most = off, at = m;
  }
  return at;
}

// Douglas and Peucker 1973, for all rows at once: the numbers of the samples that stay.
function thinned(rows, times) {
  const kept = new Set([0, times.length - 1]), open = [[0, times.length - 1]];
  while (open.length) {
    const [i, k] = open.pop(), at = worst(rows, times, i, k);
    if (at < 0) continue;
    kept.add(at);
    open.push([i, at], [at, k]);
  }
  return [...kept].sort((a, b) => a - b);
}

/**
 * { name, times, tracks: [{ joint, path, values }] }: `at(seconds)` sampled, of the samples those without which it would look otherwise.
 * `loop`: its end is its beginning; `rate`: samples a second; `degrees`, `way`: by how much joints may be off.
 */
export function animation({ joint, joints }, name, seconds, at, { loop = false, degrees = 0.5, way = 0.006, rate = 30 } = {}) {
  const count = Math.ceil(seconds * rate), times = Array.from({ length: count + 1 }, (_, i) => (seconds * i) / count);
  const poses = times.map((t, i) => at(loop && i === count ? 0 : t)), rows = [];
  const used = (kind) => [...new Set(poses.flatMap((pose) => Object.keys(pose[kind] ?? {})))];
  for (const of of used('turn')) {
    const values = [];
    for (const pose of poses) {
      const q = quaternion(pose.turn?.[of]);
      values.push(values.length && dot(q, values.at(-1)) + q[3] * values.at(-1)[3] < 0 ? q.map((x) => -x) : q);
    }
    rows.push({ joint: joint(of), path: 'rotation', values, tolerance: 0.5 * degrees * radians, rest: [0, 0, 0, 1] });
  }
  for (const of of used('move')) {
    const rest = joints[joint(of)].offset;
    rows.push({ joint: joint(of), path: 'translation', values: poses.map((pose) => add(rest, pose.move?.[of] ?? [0, 0, 0])), tolerance: way, rest });
  }
  const still = ({ values, rest }) => values.every((value) => value.every((x, c) => Math.abs(x - rest[c]) < 1e-5));
  const moving = rows.filter((row) => !still(row)), kept = thinned(moving, times);
  return { name, times: kept.map((i) => times[i]), tracks: moving.map(({ joint: j, path, values }) => ({ joint: j, path, values: kept.map((i) => values[i]) })) };
}
