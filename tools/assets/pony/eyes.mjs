// The pony's eyes, and the edges of their lids.
import { eyeball, eyeOf, lid } from '../eyes.mjs';
import { eye as inHead, headPlace, headSize, headTurn } from './shape.mjs';

const { max } = Math;

export const eye = { at: headPlace(inHead.at), radius: inHead.radius * headSize, gaze: headTurn(inHead.gaze), nose: headTurn([0, 0, 1]) };
export const frames = { 1: eyeOf(1, eye), [-1]: eyeOf(-1, eye) };

const open = (t) => max(0, 1 - (t / 56) ** 2);
/** Degrees above the gaze, at so many from the nose to the outer corner. */
export const edges = { upper: (t) => -4 + 34 * open(t - 4) ** 0.8, lower: (t) => -4 - 22 * open(t + 4) ** 0.9 };

export const eyeballOf = (side) => eyeball(frames[side]);
export const lidOf = (side, which) => lid(frames[side], { sign: which === 'upper' ? 1 : -1, edge: edges[which], outer: which === 'upper' ? 1.115 : 1.09 });
