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

/** Figures that are to be loaded, who came first first. @type {LoadingTurn[]} */
const coming = [];
/** @type {LoadingTurn | null} */
let holder = null;
let decision = 0;  // a timer
/** Milliseconds: those that have come together are compared; who is held back asks again so soon, as the page may have been scrolled. */
const together = 4, again = 100;

const topOf = ({ canvas }) => canvas.getBoundingClientRect().top;
function inWindow({ canvas }) {
  const { top, bottom, left, right } = canvas.getBoundingClientRect();
  return bottom > 0 && right > 0 && top < innerHeight && left < innerWidth;
}

function decideIn(milliseconds) {
  clearTimeout(decision);
  decision = setTimeout(decide, milliseconds);
}

/** First the one that a person turns to, then what the window shows, from its top down, then the others. */
function decide() {
  if (holder) return;
  const ready = coming.filter(({ go }) => go), shown = ready.filter(inWindow).sort((a, b) => topOf(a) - topOf(b));
  const best = ready.find(attended) ?? shown[0] ?? (coming.some(inWindow) ? null : ready[0]);
  if (best) (holder = best).go();
  else if (ready.length > 0) decideIn(again);
}

/**
 * Figures come to be shown one after another. A turn is made as soon as a figure is to be loaded, so that what the window does not show
 * waits for what it shows, whose file is on its way.
 */
export class LoadingTurn {
  constructor(canvas) {
    this.canvas = canvas;
    this.go = null;  // once it is ready
    coming.push(this);
  }

  /** Resolves when it is its turn. */
  take() {
    return new Promise((go) => {
      this.go = go;
      if (coming.length > 1) decideIn(together);
      else decide();
    });
  }

  /** In any case, taken or not. */
  end() {
    const at = coming.indexOf(this);
    if (at < 0) return;
    coming.splice(at, 1);
    if (holder === this) holder = null;
    decide();
  }
}
