// A canvas as the program sees it: its size in device pixels, whether anyone can see it, and the context that it shares with others.
// That draws on a surface of its own; the canvas is given each picture, and has it still when what drew it is gone.
import { contextFor, makeRoom, noteSeen } from './contexts.js';
import { FurError } from './errors.js';

const maxSide = 4096;
/** A picture that is shown for longer is made the canvas's own. */
const keepMilliseconds = 300;

/**
 * @typedef {object} ScreenEvents
 * @property {(width: number, height: number, pixelRatio: number) => void} onResize drawing-buffer pixels
 * @property {(visible: boolean) => void} onVisible
 * @property {() => void} onRelease the context goes: what was made in it is to be deleted
 * @property {() => void} onLost the browser took it
 * @property {() => number} gpuBytes that what was made in it takes
 */
export class Screen {
  #events;
  #observers = [];
  #stop = new AbortController();
  #inView = true;
  #wasVisible = null;
  #maxRatio = 2;
  #deviceSize = null;
  #page = null;
  #kept = true;
  #keepTimer = 0;

  /** @param {HTMLCanvasElement} canvas @param {ScreenEvents} events */
  constructor(canvas, events) {
    this.canvas = canvas;
    this.#events = events;
    /** @type {import('./contexts.js').SharedContext | null} */
    this.context = null;
    this.width = this.height = 0;
    this.pixelRatio = 1;
    /** What is drawn, whatever the canvas on the page measures. */
    this.drawn = { width: 1, height: 1 };
  }

  /** Whether there is a context that can draw: one that was taken is told of later. */
  get live() { return this.context !== null && !this.context.lost; }
  get gl() { return this.context?.gl ?? null; }
  get gpuBytes() { return this.#events.gpuBytes(); }

  /** Makes it live. True: nothing of it is in the context yet. Throws webgl-unavailable. */
  open({ antialias = true } = {}) {
    if (!this.live) this.context?.lose();
    if (this.live) return false;  // whoever was told has opened it
    this.#page ??= this.canvas.getContext('bitmaprenderer', { alpha: false });
    if (!this.#page) throw new FurError('webgl-unavailable', 'This canvas has another context already.');
    const context = contextFor(antialias);
    if (this.live) return false;  // likewise
    context.join(this);
    this.context = context;
    if (this.#observers.length > 0) return true;
    this.#watchSize();
    this.#watchVisibility(this.#stop.signal);
    return true;
  }

  tellLost() { this.#events.onLost(); }

  /** Until it is opened again the canvas shows what it was given last. */
  giveBack() {
    if (!this.context) return;
    this.keep();
    this.release();
  }

  /** Leaves the context. */
  release() {
    this.#events.onRelease();
    this.#kept = true;
    this.context.leave(this);
    this.context = null;
  }

  /** Before a picture is drawn: the surface, which others have used meanwhile, is as large as it. */
  fit() {
    const { canvas } = this.gl, { width, height } = this.drawn;
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
  }

  /** What was drawn goes to the canvas, unless the context went meanwhile. */
  show() {
    if (!this.live) return;
    const { canvas, width, height } = this;
    if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
    this.#page.transferFromImageBitmap(this.gl.canvas.transferToImageBitmap());
    this.#kept = false;
    clearTimeout(this.#keepTimer);
    this.#keepTimer = setTimeout(() => this.keep(), keepMilliseconds);
  }

  /** A picture that was shown is the context's still, and goes with it: the canvas takes a copy. */
  keep() {
    clearTimeout(this.#keepTimer);
    if (this.#kept || !this.live) return;
    this.#kept = true;
    const copy = new OffscreenCanvas(this.canvas.width, this.canvas.height);
    copy.getContext('2d', { alpha: false }).drawImage(this.canvas, 0, 0);
    this.#page.transferFromImageBitmap(copy.transferToImageBitmap());
  }

  get visible() { return this.#inView && document.visibilityState === 'visible'; }

  /** At most this many drawing-buffer pixels to a CSS pixel. */
  set maxPixelRatio(ratio) {
    this.#maxRatio = ratio;
    if (this.#observers.length > 0) this.measure();
  }

  /** The position of a pointer event, in drawing-buffer pixels. */
  toBuffer({ clientX, clientY }) {
    const box = this.canvas.getBoundingClientRect();
    return [
      (clientX - box.left) * (this.width / (box.width || 1)),
      (clientY - box.top) * (this.height / (box.height || 1)),
    ];
  }

  measure() {
    const deviceRatio = globalThis.devicePixelRatio || 1;
    const ratio = Math.min(deviceRatio, this.#maxRatio);
    const layout = [this.canvas.clientWidth * deviceRatio, this.canvas.clientHeight * deviceRatio];
    // The exact box, unless the ratio is emulated: then it still counts the pixels of the real screen.
    const isExact = this.#deviceSize?.every((side, i) => Math.abs(side - layout[i]) <= deviceRatio);
    const device = isExact ? this.#deviceSize : layout;
    const [width, height] = device.map((side) => Math.max(1, Math.min(maxSide, Math.round((side * ratio) / deviceRatio))));
    if (width === this.width && height === this.height && ratio === this.pixelRatio) return;
    this.resize(width, height, ratio);
  }

  resize(width, height, pixelRatio) {
    Object.assign(this, { width, height, pixelRatio });
    this.#events.onResize(width, height, pixelRatio);
  }

  close() {
    this.#stop.abort();
    this.#observers.forEach((observer) => observer.disconnect());
    this.giveBack();
    clearTimeout(this.#keepTimer);
  }

  #watchSize() {
    const observer = new ResizeObserver(([entry]) => {
      const box = entry.devicePixelContentBoxSize?.[0];
      this.#deviceSize = box ? [box.inlineSize, box.blockSize] : null;
      this.measure();
    });
    // In device pixels it also tells of a changed zoom; browsers without it take the plain box.
    try {
      observer.observe(this.canvas, { box: 'device-pixel-content-box' });
    } catch {
      observer.observe(this.canvas);
    }
    this.#observers.push(observer);
    this.measure();
  }

  #watchVisibility(signal) {
    const tell = () => {
      if (this.visible === this.#wasVisible) return;
      this.#wasVisible = this.visible;
      if (!this.visible && this.live) {
        this.keep();
        noteSeen(this);
        makeRoom();
      }
      this.#events.onVisible(this.visible);
    };
    const observer = new IntersectionObserver((entries) => {
      this.#inView = entries.at(-1).isIntersecting;
      tell();
    });
    observer.observe(this.canvas);
    this.#observers.push(observer);
    document.addEventListener('visibilitychange', tell, { signal });
  }
}
