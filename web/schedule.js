// Whose turn it is: figures of a page share its frames, and come to be shown one after another.

/** What all figures together may take of a frame; who does not fit in waits for the next. The first always fits. */
const frameMilliseconds = 12;

/**
 * @typedef {object} Asking
 * @property {HTMLCanvasElement} canvas
 * @property {(time: number) => void} work
 */
/** Those that ask for a frame, who has waited longest first. @type {Set<Asking>} */
const asking = new Set();
let request = 0;

/** Whether a person turns to it. */
const attended = ({ canvas }) => canvas.matches(':hover, :focus');

/** The work is called in one of the next frames. */
export function askFrame(one) {
  asking.add(one);
  request ||= requestAnimationFrame(onFrame);
}
export function cancelFrame(one) {
  asking.delete(one);
  if (asking.size > 0) return;
  cancelAnimationFrame(request);
  request = 0;
}
export const asksFrame = (one) => asking.has(one);

function onFrame(time) {
  request = 0;
  const all = [...asking], first = all.length > 1 ? all.findIndex(attended) : -1;
  if (first > 0) all.unshift(...all.splice(first, 1));
  const begun = performance.now();
  for (const one of all) {
    if (one !== all[0] && performance.now() - begun > frameMilliseconds) break;
    // Whoever asks again meanwhile asks for the next frame.
    if (asking.delete(one)) one.work(time);
  }
  if (asking.size > 0) request ||= requestAnimationFrame(onFrame);
}

/** How long a piece of work may take that goes on after a pause(). */
export const pieceSeconds = 0.016;
let channel = null;
const paused = [];

/** Between two pieces of work the page does what waits. Soon: timers would wait in turn. */
export function pause() {
  if (!channel) {
    channel = new MessageChannel();
    channel.port1.onmessage = () => paused.shift()();
  }
  return new Promise((resolve) => {
    paused.push(resolve);
    channel.port2.postMessage(null);
  });
}

/** Those that wait to be loaded, who came first first. @type {{ canvas: HTMLCanvasElement, go: () => void }[]} */
const waiting = [];
let loading = false;

function inWindow({ canvas }) {
  const { top, bottom, left, right } = canvas.getBoundingClientRect();
  return bottom > 0 && right > 0 && top < innerHeight && left < innerWidth;
}

function next() {
  loading = waiting.length > 0;
  if (!loading) return;
  const best = [attended, inWindow, () => true].map((is) => waiting.findIndex(is)).find((at) => at >= 0);
  waiting.splice(best, 1)[0].go();
}

/** Resolves when it is its turn to be loaded: one at a time, what is seen first. @returns {Promise<() => void>} to be called after */
export async function turnToLoad(canvas) {
  if (loading) await new Promise((go) => { waiting.push({ canvas, go }); });
  loading = true;
  let over = false;
  return () => {
    if (!over) next();
    over = true;
  };
}
