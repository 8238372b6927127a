// Who on the page holds a graphics context. A browser keeps few (Chromium 16, on phones 8) and then takes the one that
// drew longest ago, whoever looks at it: so screens out of view give theirs back before there are as many.

const limit = 8;
/** Those that came into use, or went out of view, longest ago first. */
const holders = new Set();

/** A WebGL2 context on a surface of its own, `gl.canvas`; null where there is none to have. */
export function newContext(width, height, options) {
  makeRoom(1);
  return globalThis.OffscreenCanvas ? new OffscreenCanvas(width, height).getContext('webgl2', options) : null;
}

export function hold(screen) {
  holders.delete(screen);
  holders.add(screen);
}

export function letGo(screen) { holders.delete(screen); }

/** Until `more` fit in, screens that nobody sees give theirs back. */
export function makeRoom(more) {
  for (const screen of holders) {
    if (holders.size + more <= limit) return;
    if (!screen.visible) screen.giveBack();
  }
}

/** Whether whoever takes one more may take it from another that is seen. */
export const crowded = () => holders.size >= limit;
