// A canvas as the program sees it: its WebGL2 context, its size in device pixels, whether anyone can see it.
import { FurError } from './errors.js';

const maxSide = 4096;

/**
 * @typedef {object} ScreenEvents
 * @property {(width: number, height: number, pixelRatio: number) => void} onResize drawing-buffer pixels
 * @property {(visible: boolean) => void} onVisible
 * @property {() => void} onLost
 * @property {() => void} onRestored
 */
export class Screen {
  #events;
  #observers = [];
  #stop = new AbortController();
  #inView = true;
  #wasVisible = null;
  #maxRatio = 2;
  #deviceSize = null;

  /** @param {HTMLCanvasElement} canvas @param {ScreenEvents} events */
  constructor(canvas, events) {
    this.canvas = canvas;
    this.#events = events;
    this.gl = null;
    this.width = this.height = 0;
    this.pixelRatio = 1;
  }

  /** Throws webgl-unavailable. */
  open({ antialias = true } = {}) {
    if (this.gl) return;
    this.gl = this.canvas.getContext('webgl2', {
      alpha: false, antialias, depth: true, stencil: false, powerPreference: 'high-performance',
    });
    if (!this.gl)
      throw new FurError('webgl-unavailable', 'This browser or its graphics driver offers no WebGL2, which drawing fur needs.');
    const { signal } = this.#stop;
    this.canvas.addEventListener('webglcontextlost', (event) => {
      event.preventDefault();
      this.#events.onLost();
    }, { signal });
    this.canvas.addEventListener('webglcontextrestored', () => this.#events.onRestored(), { signal });
    this.#watchSize();
    this.#watchVisibility(signal);
  }

  /** The context as `program` knows it. */
  register(program) {
    const { GL } = program.emscripten;
    this.handle = GL.registerContext(this.gl, { majorVersion: 2, minorVersion: 0 });
    GL.makeContextCurrent(this.handle);
  }
  makeCurrent(program) { program.emscripten.GL.makeContextCurrent(this.handle); }
  unregister(program) {
    if (!this.handle) return;
    program.emscripten.GL.deleteContext(this.handle);
    this.handle = 0;
  }

  get visible() { return this.#inView && document.visibilityState === 'visible'; }

  /** At most this many drawing-buffer pixels to a CSS pixel. */
  set maxPixelRatio(ratio) {
    this.#maxRatio = ratio;
    if (this.gl) this.measure();
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
    this.canvas.width = width;
    this.canvas.height = height;
    this.#events.onResize(width, height, pixelRatio);
  }

  close() {
    this.#stop.abort();
    this.#observers.forEach((observer) => observer.disconnect());
    this.gl?.getExtension('WEBGL_lose_context')?.loseContext();
    this.gl = null;
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
      this.#events.onVisible(this.visible);
    };
    const observer = new IntersectionObserver(([entry]) => {
      this.#inView = entry.isIntersecting;
      tell();
    });
    observer.observe(this.canvas);
    this.#observers.push(observer);
    document.addEventListener('visibilitychange', tell, { signal });
  }
}

/** The state that a fresh context has, for a program that takes a context over from another. */
export function resetContext(gl) {
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  gl.bindVertexArray(null);
  gl.useProgram(null);
  gl.bindBuffer(gl.ARRAY_BUFFER, null);
  gl.bindBuffer(gl.PIXEL_UNPACK_BUFFER, null);
  gl.bindBuffer(gl.UNIFORM_BUFFER, null);
  for (const unit of Array(16).keys()) {
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(gl.TEXTURE_2D, null);
    gl.bindTexture(gl.TEXTURE_2D_ARRAY, null);
    gl.bindSampler(unit, null);
  }
  gl.activeTexture(gl.TEXTURE0);
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 4);
  for (const name of ['UNPACK_ROW_LENGTH', 'UNPACK_SKIP_ROWS', 'UNPACK_SKIP_PIXELS', 'UNPACK_IMAGE_HEIGHT', 'UNPACK_SKIP_IMAGES'])
    gl.pixelStorei(gl[name], 0);
  for (const name of ['BLEND', 'CULL_FACE', 'DEPTH_TEST', 'POLYGON_OFFSET_FILL', 'SAMPLE_ALPHA_TO_COVERAGE', 'SCISSOR_TEST', 'STENCIL_TEST'])
    gl.disable(gl[name]);
  gl.colorMask(true, true, true, true);
  gl.depthMask(true);
  gl.depthFunc(gl.LESS);
}
