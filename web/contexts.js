// The page's graphics contexts. A browser keeps few (Chromium 16, on phones 8): all figures share two, one with smooth edges and one
// without, each made when the first of them needs it. Each figure has its own objects in one of them, but for what all share; those
// that nobody sees give theirs back, the one seen longest ago first, where all together hold more than the budget.
import { FurError } from './errors.js';

let budget = 256 * 2 ** 20;
/** A context without figures is kept for so long: the next one finds its shaders compiled. */
const idleMilliseconds = 5000;

/** @type {Map<boolean, SharedContext>} by whether edges are smooth */
const contexts = new Map();
/** Screens with objects in a context, the one seen longest ago first. @type {Set<import('./screen.js').Screen>} */
const holders = new Set();

/** Bytes that figures out of view may hold beside those in view. */
export function setBudget(bytes) {
  budget = bytes;
  makeRoom();
}

export function makeRoom() {
  let bytes = 0;
  for (const screen of holders) bytes += screen.gpuBytes;
  for (const screen of holders) {
    if (bytes <= budget) return;
    if (screen.visible) continue;
    bytes -= screen.gpuBytes;
    screen.giveBack();
  }
}

export class SharedContext {
  #inPrograms = new Map();  // the context as each program knows it
  #screens = new Set();
  #fence = null;
  #idleTimer = 0;
  #antialias;

  constructor(gl, antialias) {
    this.gl = gl;
    this.#antialias = antialias;
    gl.canvas.addEventListener('webglcontextlost', () => this.lose());
  }

  get lost() { return this.gl.isContextLost(); }

  join(screen) {
    clearTimeout(this.#idleTimer);
    this.#screens.add(screen);
    holders.add(screen);
  }
  leave(screen) {
    this.#screens.delete(screen);
    holders.delete(screen);
    clearTimeout(this.#idleTimer);
    if (this.#screens.size === 0) this.#idleTimer = setTimeout(() => this.#end(), idleMilliseconds);
  }

  /** The program's calls go to this context from now on. */
  use(program) {
    if (program.context === this) return;
    const { GL } = program.emscripten;
    const known = this.#inPrograms.get(program) ?? { handle: GL.registerContext(this.gl, { majorVersion: 2, minorVersion: 0 }), pointer: 0 };
    GL.makeContextCurrent(known.handle);
    program.context = this;
    if (!known.pointer) {
      this.#inPrograms.set(program, known);
      this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, null);  // another program may have drawn last
      known.pointer = program.callOrThrow('fur_createContext', this.gl.getExtension('KHR_parallel_shader_compile') ? 1 : 0);
    }
    program.call('fur_useContext', known.pointer);
  }
  /** What apps in the program are attached with. */
  pointerIn(program) {
    this.use(program);
    return this.#inPrograms.get(program).pointer;
  }
  isIn(program) { return this.#inPrograms.has(program); }
  /** The program has no more to draw. */
  forget(program) {
    const known = this.#inPrograms.get(program);
    if (!known) return;
    if (!program.failure) {
      this.use(program);
      program.call('fur_destroyContext', known.pointer);
    }
    program.emscripten.GL.deleteContext(known.handle);
    program.context = null;
    this.#inPrograms.delete(program);
  }

  /** The browser has taken it: whoever drew in it is told, and gets another. */
  lose() {
    if (contexts.get(this.#antialias) !== this) return;
    const screens = [...this.#screens];
    for (const screen of screens) screen.release();
    this.#end();
    for (const screen of screens) screen.tellLost();
  }

  #end() {
    clearTimeout(this.#idleTimer);
    if (contexts.get(this.#antialias) === this) contexts.delete(this.#antialias);
    for (const program of [...this.#inPrograms.keys()]) this.forget(program);
    this.gl.getExtension('WEBGL_lose_context')?.loseContext();
  }

  /** `busy` until all that was asked of the graphics processor so far is done. */
  setFence() {
    if (this.#fence) this.gl.deleteSync(this.#fence);
    this.#fence = this.gl.fenceSync(this.gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    this.gl.flush();
  }
  get busy() {
    if (!this.#fence || this.lost) return false;
    if (this.gl.clientWaitSync(this.#fence, 0, 0) === this.gl.TIMEOUT_EXPIRED) return true;
    this.gl.deleteSync(this.#fence);
    this.#fence = null;
    return false;
  }
}

const newContext = (options) => (globalThis.OffscreenCanvas ? new OffscreenCanvas(1, 1).getContext('webgl2', options) : null);

/** The one with or without smooth edges. Throws webgl-unavailable. */
export function contextFor(antialias) {
  const had = contexts.get(antialias);
  if (had && !had.lost) return had;
  had?.lose();
  if (contexts.has(antialias)) return contexts.get(antialias);  // whoever was told has made it
  const gl = newContext({ antialias, powerPreference: 'high-performance' });
  if (!gl) throw new FurError('webgl-unavailable', 'This browser or its graphics driver offers no WebGL2, which drawing fur needs.');
  const context = new SharedContext(gl, antialias);
  contexts.set(antialias, context);
  return context;
}

/** The program is gone, and with it what it had in any of them. */
export function forgetProgram(program) {
  for (const context of contexts.values()) context.forget(program);
}

/** The program has failed: what it made cannot be told from what others have made, so all begin anew. */
export function loseContextsOf(program) {
  for (const context of [...contexts.values()]) if (context.isIn(program)) context.lose();
}

/** The screen was seen last of all. */
export function noteSeen(screen) {
  if (holders.delete(screen)) holders.add(screen);
}

/** Whether there is WebGL2. */
export function offersContext() {
  const gl = contexts.size > 0 ? null : newContext({});
  gl?.getExtension('WEBGL_lose_context')?.loseContext();
  return contexts.size > 0 || gl !== null;
}
