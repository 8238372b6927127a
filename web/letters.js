// Letters to be stamped, as a ghost over the picture: placed, sized and turned first.

const sizes = [24, 400];  // CSS pixels
const keySteps = { ArrowLeft: [-8, 0], ArrowRight: [8, 0], ArrowUp: [0, -8], ArrowDown: [0, 8] };
const keySizes = { '+': 1.1, '=': 1.1, '-': 1 / 1.1 };
const keyTurns = { '[': -0.1, ']': 0.1 };
const clickPixels = 5;
// Cells of the area across which room is looked for; by so much of the atlas the model goes on elsewhere from one to the next; sizes that are tried, down
// to 3 / sizesTried of the largest; the share of the largest that fits which is as good where it is nearer to the middle; of the font's size: what
// capitals are high, and what is to be free about them.
const roomCells = 48, jump = 0.1, sizesTried = 14, nearlyLargest = 0.75, capitals = 0.75, margin = 0.4;

/** By fingers alone, or also by mouse and keys. */
export const howToPlace = (fingers) => (fingers ? 'Drag the letters, size and turn them with two fingers. A tap stamps them.'
  : 'Drag the letters. Wheel, two fingers or + and − size them; shift and wheel, two fingers or [ and ] turn them. Click or Enter stamps.');

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

  /** First where they are all on one piece of the model: see roomForText(). */
  show(text, area, spotAt) {
    this.#ghost.textContent = text;
    this.#layer.setAttribute('aria-label', `Place ${text}`);
    this.#layer.hidden = false;
    this.#ghost.style.fontSize = '100px';
    this.#place = { ...roomForText(this.#ghost.offsetWidth / 100, area, spotAt), angle: 0 };
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

/**
 * Where letters so wide (sizes of the font) are largest, or nearly, and yet all on one piece of the model, and nearest to the middle of the area. A
 * piece ends where the spot jumps, as where a head stands before a back. Where no piece has room for letters half as large as the whole model has,
 * anywhere on the model; in the area's middle if there is no such place.
 * @param {number} wide @param {{left: number, top: number, width: number, height: number}} area CSS pixels
 * @param {(x: number, y: number) => {u: number, v: number} | null} spotAt where the model is there, in its atlas
 */
export function roomForText(wide, area, spotAt) {
  const cell = area.width / roomCells, down = Math.floor(area.height / cell);
  const spots = Array.from({ length: roomCells * down }, (_, i) =>
    spotAt(area.left + ((i % roomCells) + 0.5) * cell, area.top + (Math.floor(i / roomCells) + 0.5) * cell));
  const onModel = spots.map(Boolean), largest = Math.min(0.25 * area.height, (0.75 * Math.min(area.width, area.height)) / Math.max(wide, 1));
  // The best place in free cells, and the size that fits there somewhere, in steps.
  const roomIn = (free) => {
    const isFull = fullRectangles(free);
    let best = null, fits = 0;
    for (let step = sizesTried; step >= Math.max(3, nearlyLargest * fits); --step) {
      const size = (largest * step) / sizesTried, w = Math.ceil(((wide + margin) * size) / cell), h = Math.ceil(((capitals + margin) * size) / cell);
      const place = nearestRoom(isFull, down, w, h);
      if (!place) continue;
      fits ||= step;
      if (!best || place.away < best.away - 1) best = { away: place.away, x: area.left + place.x * cell, y: area.top + place.y * cell, size };
    }
    return { best, fits };
  };
  const anywhere = roomIn(onModel), onePiece = roomIn(onModel.map((on, i) => on && !jumps(spots, i)));
  const { best } = onePiece.fits > 0.5 * anywhere.fits ? onePiece : anywhere;
  return best ? { x: best.x, y: best.y, size: best.size } : { x: area.left + area.width / 2, y: area.top + area.height / 2, size: largest };
}

// Whether the model goes on elsewhere in the next cell, or in that below.
function jumps(spots, i) {
  const next = (i + 1) % roomCells ? spots[i + 1] : null;
  return [next, spots[i + roomCells]].some((other) => other && Math.hypot(other.u - spots[i].u, other.v - spots[i].v) > jump);
}

// Whether all cells of a rectangle are free: how many lie before each is counted once, so that any rectangle's are four look-ups.
function fullRectangles(free) {
  const stride = roomCells + 1, down = free.length / roomCells, sums = new Uint32Array(stride * (down + 1));
  for (let y = 0; y < down; ++y)
    for (let x = 0; x < roomCells; ++x)
      sums[(y + 1) * stride + x + 1] = free[y * roomCells + x] + sums[y * stride + x + 1] + sums[(y + 1) * stride + x] - sums[y * stride + x];
  return (x, y, w, h) => sums[(y + h) * stride + x + w] - sums[y * stride + x + w] - sums[(y + h) * stride + x] + sums[y * stride + x] === w * h;
}

// The middle of the full rectangle of w x h cells that is nearest to the middle of all, and how far it is `away` from there, squared; in cells.
function nearestRoom(isFull, down, w, h) {
  let best = null, nearest = Infinity;
  for (let y = 0; y + h <= down; ++y)
    for (let x = 0; x + w <= roomCells; ++x) {
      const away = (x + w / 2 - roomCells / 2) ** 2 + (y + h / 2 - down / 2) ** 2;
      if (away < nearest && isFull(x, y, w, h)) [nearest, best] = [away, { x: x + w / 2, y: y + h / 2, away }];
    }
  return best;
}
