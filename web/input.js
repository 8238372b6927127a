// Pointers, wheel and keys of one canvas. The page keeps its wheel, its touch scroll and its keys
// until the person turns to the canvas (a click, a tap, Tab).

const doubleTapMilliseconds = 320;
const doubleTapPixels = 24;
const tapPixels = 12;

/**
 * @typedef {object} InputTarget what the input acts on; `app` and `panel` may change between events
 * @property {import('./furapp.js').FurApp | null} app null while nothing can be touched
 * @property {import('./editor.js').EditorPanel | null} panel
 * @property {(event: {clientX: number, clientY: number}) => [number, number]} toBuffer
 * @property {() => void} wake something may have changed: draw soon
 * @property {(phase: 'start' | 'end', detail: object) => void} stroke
 * @property {(at: [number, number] | null, byKey?: boolean) => void} hover the brush is over that pixel
 */
export class Input {
  #canvas;
  #target;
  #stop = new AbortController();
  #down = new Set();
  #stroke = null;
  // A finger on an unfocused canvas: it may be about to scroll the page, only its tap counts.
  #waitingTouch = null;
  #lastTap = { time: -Infinity, x: 0, y: 0 };
  wheel = 'focus';
  #touchAction = null;

  /** @param {HTMLCanvasElement} canvas @param {InputTarget} target */
  constructor(canvas, target) {
    this.#canvas = canvas;
    this.#target = target;
    const { signal } = this.#stop;
    const on = (type, listener, options) => canvas.addEventListener(type, listener, { signal, ...options });
    on('pointerdown', (event) => this.#onDown(event));
    on('pointermove', (event) => this.#onMove(event));
    on('pointerup', (event) => this.#onUp(event, 'up'));
    on('pointercancel', (event) => this.#onUp(event, 'cancel'));
    on('pointerleave', () => target.hover(null));
    on('wheel', (event) => this.#onWheel(event), { passive: false });
    on('keydown', (event) => this.#onKey(event, true));
    on('keyup', (event) => this.#onKey(event, false));
    on('contextmenu', (event) => event.preventDefault());
    on('focus', () => this.#applyTouchAction());
    on('blur', () => {
      canvas.toggleAttribute('data-pointer-focus', false);
      this.#applyTouchAction();
    });
    this.#applyTouchAction();
  }

  /** A CSS touch-action that always holds; null: the page scrolls by touch until the canvas has the focus. */
  set touchAction(value) {
    this.#touchAction = value || null;
    this.#applyTouchAction();
  }

  dispose() { this.#stop.abort(); }

  get #focused() { return this.#canvas.getRootNode().activeElement === this.#canvas; }

  #applyTouchAction() {
    this.#canvas.style.touchAction = this.#touchAction ?? (this.#focused ? 'none' : 'pan-x pan-y pinch-zoom');
  }

  #send(phase, event) {
    const { app, panel } = this.#target;
    const [x, y] = this.#target.toBuffer(event);
    const used = panel?.pointer(phase, event, x, y) || app.pointer(phase, event, x, y);
    if (used || panel) this.#target.wake();
    return used;
  }

  #onDown(event) {
    const { app } = this.#target;
    if (!app) return;
    if (event.pointerType === 'touch' && !this.#touchAction && !this.#focused) {
      this.#waitingTouch = { id: event.pointerId, x: event.clientX, y: event.clientY };
      return;
    }
    this.#press(app, this.#target.panel, event);
  }

  #press(app, panel, event) {
    // Focus that came by pointer needs no ring, which browsers draw round what a script focuses.
    if (!this.#focused) this.#canvas.toggleAttribute('data-pointer-focus', true);
    this.#canvas.focus({ preventScroll: true });
    if (event.type === 'pointerdown') this.#canvas.setPointerCapture(event.pointerId);
    this.#down.add(event.pointerId);
    const [x, y] = this.#target.toBuffer(event);
    const hit = event.button === 0 && !panel?.wantsPointer ? app.pick(x, y) : null;
    this.#send('down', event);
    if (hit && !this.#stroke && app.tool !== 'none') {
      this.#stroke = { id: event.pointerId, tool: app.tool };
      this.#target.stroke('start', { tool: app.tool, ...hit });
    }
    event.preventDefault();  // no text selection, no mouse events made from touches
  }

  #onMove(event) {
    if (!this.#target.app) return;
    this.#target.hover(event.pointerType === 'touch' ? null : this.#target.toBuffer(event));
    if (!this.#down.has(event.pointerId) && event.pointerType !== 'mouse' && !this.#target.panel) return;
    // Between two frames a fast hand makes several: a stroke without corners needs them all.
    const between = this.#down.has(event.pointerId) ? event.getCoalescedEvents?.() ?? [] : [];
    for (const one of between.length > 1 ? between : [event]) this.#send('move', one);
  }

  #onUp(event, phase) {
    const { app, panel } = this.#target;
    if (!app) return;
    const waiting = this.#waitingTouch;
    if (waiting?.id === event.pointerId) {
      this.#waitingTouch = null;
      const stayed = Math.hypot(event.clientX - waiting.x, event.clientY - waiting.y) < tapPixels;
      if (phase === 'up' && stayed) this.#press(app, panel, event);
    }
    if (!this.#down.delete(event.pointerId)) return;
    this.#send(phase, event);
    if (this.#stroke?.id === event.pointerId) {
      this.#target.stroke('end', { tool: this.#stroke.tool });
      this.#stroke = null;
    } else if (phase === 'up' && this.#down.size === 0) {
      this.#onTap(event);
    }
  }

  /** Two taps beside the model bring the view back; on the model they are two droplets. */
  #onTap(event) {
    const { timeStamp: time, clientX: x, clientY: y } = event;
    const last = this.#lastTap;
    const near = Math.hypot(x - last.x, y - last.y) < doubleTapPixels;
    const twice = near && time - last.time < doubleTapMilliseconds && !this.#target.panel?.wantsPointer;
    this.#lastTap = twice ? { time: -Infinity, x, y } : { time, x, y };
    if (!twice) return;
    this.#target.app.resetCamera();
    this.#target.wake();
  }

  #onWheel(event) {
    const { app, panel } = this.#target;
    if (!app || this.wheel === 'page' || (this.wheel === 'focus' && !this.#focused)) return;
    const notches = event.deltaY / [100, 3, 1][event.deltaMode];
    const [x, y] = this.#target.toBuffer(event);
    event.preventDefault();
    if (panel?.wheel(notches, x, y) || app.wheel(notches, x, y)) this.#target.wake();
  }

  #onKey(event, down) {
    const { app, panel } = this.#target;
    if (!app || event.isComposing) return;
    this.#canvas.toggleAttribute('data-pointer-focus', false);
    if (panel?.key(event, down)) {
      event.preventDefault();
      this.#target.wake();
    } else if (down ? this.#onAppKey(app, event) : app.key(event, false)) {
      event.preventDefault();
      this.#target.wake();
    }
  }

  #onAppKey(app, event) {
    if (app.key(event)) {
      if (event.key === ' ' || event.key === 'Enter' || (event.key.startsWith('Arrow') && (event.shiftKey || !this.#target.turns)))
        this.#target.hover(app.cursor, true);
      return true;
    }
    if (event.key !== 'Home') return false;
    app.resetCamera();
    return true;
  }
}
