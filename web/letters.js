// Letters to be stamped, as a ghost over the picture: placed, sized and turned first.

const sizes = [24, 400];  // CSS pixels
const keySteps = { ArrowLeft: [-8, 0], ArrowRight: [8, 0], ArrowUp: [0, -8], ArrowDown: [0, 8] };
const keySizes = { '+': 1.1, '=': 1.1, '-': 1 / 1.1 };
const keyTurns = { '[': -0.1, ']': 0.1 };
const clickPixels = 5;

export const howToPlace = 'Drag the letters. Wheel, two fingers or + and − size them; shift and wheel, two fingers or [ and ] turn them. Click or Enter stamps, Escape leaves.';

export class Letters {
  #layer;  // over the whole picture, so that a second finger finds room
  #ghost;
  #stamp;
  #left;
  #pointers = new Map();
  #travelled = 0;
  #place = { x: 0, y: 0, size: 96, angle: 0 };

  /** `stamp(text, {x, y, size, angle})` in CSS pixels of the window and radians; `left()` when the ghost goes. */
  constructor(layer, stamp, left) {
    this.#layer = layer;
    this.#ghost = layer.firstElementChild;
    this.#stamp = stamp;
    this.#left = left;
    const on = (type, listener, options) => layer.addEventListener(type, listener, options);
    on('pointerdown', (event) => this.#onDown(event));
    on('pointermove', (event) => this.#onMove(event));
    on('pointerup', (event) => this.#onUp(event));
    on('pointercancel', (event) => this.#pointers.delete(event.pointerId));
    on('wheel', (event) => this.#onWheel(event), { passive: false });
    on('keydown', (event) => this.#onKey(event));
  }

  get shown() { return !this.#layer.hidden; }

  show(text, { x, y, size }) {
    this.#place = { x, y, size, angle: 0 };
    this.#ghost.textContent = text;
    this.#layer.setAttribute('aria-label', `Place ${text}`);
    this.#layer.hidden = false;
    this.#draw();
    this.#layer.focus();
  }

  hide() {
    if (!this.shown) return false;
    this.#layer.hidden = true;
    this.#pointers.clear();
    this.#left();
    return true;
  }

  #draw() {
    const { x, y, size, angle } = this.#place;
    Object.assign(this.#ghost.style, { left: `${x}px`, top: `${y}px`, fontSize: `${size}px`, rotate: `${angle}rad` });
  }

  #change({ dx = 0, dy = 0, factor = 1, turn = 0 }) {
    const { x, y, size, angle } = this.#place;
    this.#place = {
      x: Math.min(innerWidth, Math.max(0, x + dx)), y: Math.min(innerHeight, Math.max(0, y + dy)),
      size: Math.min(sizes[1], Math.max(sizes[0], size * factor)), angle: angle + turn,
    };
    this.#draw();
  }

  #finish() {
    const text = this.#ghost.textContent;
    this.hide();
    this.#stamp(text, this.#place);
  }

  // Where the fingers are: their middle, and from one to the other.
  #hand() {
    const [a, b = a] = this.#pointers.values();
    return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, span: Math.hypot(b.x - a.x, b.y - a.y), angle: Math.atan2(b.y - a.y, b.x - a.x) };
  }

  #onDown(event) {
    if (event.button !== 0 || this.#pointers.size === 2) return;
    if (this.#pointers.size === 0) this.#travelled = 0;
    else this.#travelled = Infinity;  // two fingers do not click
    this.#pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    this.#layer.setPointerCapture(event.pointerId);
  }

  #onMove(event) {
    if (!this.#pointers.has(event.pointerId)) return;
    const before = this.#hand();
    this.#pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    const now = this.#hand();
    this.#travelled += Math.hypot(now.x - before.x, now.y - before.y);
    const two = before.span > 1 && now.span > 1;
    this.#change({
      dx: now.x - before.x, dy: now.y - before.y, factor: two ? now.span / before.span : 1, turn: two ? now.angle - before.angle : 0,
    });
  }

  #onUp(event) {
    if (this.#pointers.delete(event.pointerId) && this.#pointers.size === 0 && this.#travelled < clickPixels) this.#finish();
  }

  #onWheel(event) {
    event.preventDefault();
    const notches = (event.deltaY || event.deltaX) / [100, 3, 1][event.deltaMode];  // with shift some browsers scroll sideways
    this.#change(event.shiftKey ? { turn: 0.1 * notches } : { factor: 1.1 ** -notches });
  }

  #onKey(event) {
    const step = keySteps[event.key];
    if (event.key === 'Enter' || event.key === ' ') this.#finish();
    else if (event.key === 'Escape') this.hide();
    else if (step) this.#change({ dx: step[0], dy: step[1] });
    else if (keySizes[event.key]) this.#change({ factor: keySizes[event.key] });
    else if (keyTurns[event.key]) this.#change({ turn: keyTurns[event.key] });
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
}
