// An app and the context it draws in: what it has there comes when there is something to draw, goes while nobody looks and others need
// the room, and may be taken by the browser. The scene is the app's and does not notice; what is in the context is made anew.
import { makeRoom } from './contexts.js';
import { FrameTimer } from './frametimer.js';

/** Whoever is scrolled past faster than this keeps the picture it has. */
const dwellMilliseconds = 100;
/** How soon a browser is asked again that had no context to give. */
const retryMilliseconds = 1000;

/**
 * @typedef {object} AttachmentHost `app` and `panel` may change while detached
 * @property {import('./furapp.js').FurApp | null} app
 * @property {import('./editor.js').EditorPanel | null} panel
 * @property {boolean} antialias
 * @property {(atOnce?: boolean) => void} comeBack draw again
 * @property {() => void} stateChanged
 * @property {(type: string, detail: object) => void} emit
 * @property {(message: string) => void} warn
 */
export class Attachment {
  #screen;
  #host;
  #comeBackTimer = 0;
  #taken = false;  // by the browser, and another has not come yet

  /** Measures what is drawn in this context. */
  timer = null;
  /** A new context, or one with another model, lacks the coat still: the canvas shows what was drawn last. */
  returning = false;
  /** A context was taken and another is being asked for. */
  mending = false;

  /** @param {import('./screen.js').Screen} screen @param {AttachmentHost} host */
  constructor(screen, host) {
    this.#screen = screen;
    this.#host = host;
  }

  /** True: the context is a new one. Throws webgl-unavailable. */
  open() { return this.#screen.open({ antialias: this.#host.antialias }); }

  /** In a context that has nothing of it yet. */
  attach(app) {
    app.attach(this.#screen);
    this.timer = new FrameTimer(this.#screen.gl);
    this.#host.panel?.attach();
    this.resize(this.#screen.width, this.#screen.height, this.#screen.pixelRatio, app);
    this.returning = true;
  }

  /** What is drawn, whatever the canvas on the page measures. */
  resize(width, height, ratio, app = this.#host.app) {
    this.#screen.drawn = { width, height };
    app.resize(width, height, ratio);
    this.#host.panel?.resize(width, height, ratio);
  }

  /** Whether there is a context to draw with, a new one if need be. */
  draws() {
    if (this.#screen.live) return true;
    try {
      if (this.open()) this.attach(this.#host.app);
    } catch (error) {
      if (!this.mending) this.#host.warn(error.message);
      this.#screen.giveBack();
      this.#setMending(true);
      this.#comeBackIn(retryMilliseconds);
      return false;
    }
    this.#setMending(false);
    if (this.#taken) this.#host.emit('context-restored', {});
    this.#taken = false;
    return true;
  }

  /** Somebody sees it, and it has no context. */
  seen() { this.#comeBackIn(dwellMilliseconds); }

  #comeBackIn(milliseconds) {
    clearTimeout(this.#comeBackTimer);
    this.#comeBackTimer = setTimeout(() => { if (this.#screen.visible) this.#host.comeBack(); }, milliseconds);
  }

  /** The context goes. */
  onRelease() {
    if (!this.timer) return;
    this.timer.dispose();
    this.timer = null;
    this.#host.panel?.detach(true);
    this.#host.app?.detach();
  }

  /** What was lacking in the context is there, and takes its room. */
  returned() {
    if (!this.returning) return;
    this.returning = false;
    queueMicrotask(makeRoom);  // once the picture is where it belongs
  }

  /** The browser took it. Another is asked for where somebody looks. */
  onLost() {
    if (!this.#host.app) return;
    this.#taken = true;
    const pending = this.returning;  // in the task in which another comes, or pages would take it from each other for ever
    const mend = this.#screen.visible;
    this.#setMending(mend);
    this.#host.emit('context-lost', {});
    if (mend) this.#host.comeBack(pending);
  }

  #setMending(mending) {
    if (mending === this.mending) return;
    this.mending = mending;
    this.#host.stateChanged();
  }

  dispose() { clearTimeout(this.#comeBackTimer); }
}
