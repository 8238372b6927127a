// What was done with water, packed for a link: recordedStrokes with fewer digits, in columns, deflated, as base64url.
// It comes from a stranger: what is unpacked is bounded, in size and in the time that painting it again takes.
import { deflated, inflated } from './packed.js';

const headNumbers = 7, spotNumbers = 5;
// Per unit: radius, flow, clump size, eye; step, triangle, two weights, pressure.
const headScale = [1e4, 1e4, 1e4, 1e3, 1e3, 1e3], spotScale = [1, 1, 1e3, 1e3, 100];
/** Pauses become as short: nobody waits for them when a link opens. Steps of 1/60 s. */
const longestPause = 60;
const mostSteps = 1800;
const mostText = 1024 * 1024;

/** Without what the last soaking, or drying off, has made undone. */
function sinceSoaked(strokes) {
  const last = strokes.findLastIndex(([what]) => what === 'soak');
  return strokes.slice(last + 1).some(([what]) => what === 'undo' || what === 'redo') ? strokes : strokes.slice(Math.max(last, 0));
}

/** @param {string} recorded recordedStrokes @returns {Promise<string | null>} null: they take too long, or the browser cannot */
export async function packStrokes(recorded) {
  if (!globalThis.CompressionStream) return null;
  let before, triangle = 0, steps = 0;
  const columns = sinceSoaked(JSON.parse(recorded)).map((stroke) => {
    const head = [stroke[0], ...headScale.map((scale, i) => Math.round(stroke[i + 1] * scale))];
    const out = [head, [], [], [], [], []];
    for (let at = headNumbers; at < stroke.length; at += spotNumbers) {
      const spot = spotScale.map((scale, i) => Math.round(stroke[at + i] * scale));
      const pause = Math.min(Math.max(spot[0] - (before ?? spot[0]), 0), longestPause);
      before = spot[0];
      steps += pause;
      spot[0] = pause;
      spot[1] -= triangle;
      triangle += spot[1];
      spot.forEach((number, i) => out[i + 1].push(number));
    }
    return out;
  });
  if (columns.length === 0 || steps > mostSteps) return null;
  return deflated(JSON.stringify(columns));
}

/** The way back, for replay(). Throws for what packStrokes() did not make. */
export async function unpackStrokes(text) {
  let step = 0, triangle = 0;
  const strokes = JSON.parse(await (await inflated(text, mostText)).text()).map(([head, ...columns]) => {
    const stroke = [head[0], ...headScale.map((scale, i) => head[i + 1] / scale)];
    columns[0].forEach((pause, at) => {
      step += Math.min(Math.max(pause, 0), longestPause);
      triangle += columns[1][at];
      stroke.push(step, triangle, ...[2, 3, 4].map((i) => columns[i][at] / spotScale[i]));
    });
    return stroke;
  });
  if (!(step <= mostSteps)) throw new RangeError('too long');
  return JSON.stringify(strokes);
}
