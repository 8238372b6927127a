// The brush's footprint on the model, where the pointer or the keys' cursor is.
export class BrushRing {
  #session;
  #at = null;  // in pixels of the drawing buffer
  #byKey = false;
  #task = 0;
  /** An SVG polygon over the canvas; null: nobody draws it. */
  polygon = null;

  /** @param {import('./session.js').Session} session */
  constructor(session) { this.#session = session; }

  /** The brush is over that pixel, null: over none. */
  hover(at, byKey) {
    this.#at = at;
    this.#byKey = byKey;
    if (byKey) this.#session.emit('cursor-move', { wetness: this.spotWetness });
    // A fast mouse tells more often than pictures are shown.
    this.#task ||= requestAnimationFrame(() => this.#show());
  }

  /** What it lies on, or how large it is, has changed. */
  refresh() { if (this.#at) this.#show(); }

  #show() {
    this.#task = 0;
    if (!this.polygon) return;
    const { app, interactive, loaded, panel, screen } = this.#session;
    const ring = this.#at && loaded && interactive && !panel ? app.brushRing(...this.#at) : null;
    this.polygon.setAttribute('points', ring?.join(' ') ?? '');
    if (ring) this.polygon.ownerSVGElement.setAttribute('viewBox', `0 0 ${screen.width} ${screen.height}`);
  }

  /** How wet it is where the keys' cursor is: null beside the model, undefined while nobody uses it. */
  get spotWetness() {
    const { app, loaded } = this.#session;
    if (!this.#byKey || !loaded) return undefined;
    const hit = app.pick(...app.cursor);
    return hit && app.wetnessAt(hit.u, hit.v);
  }

  dispose() { cancelAnimationFrame(this.#task); }
}
