// When pictures are drawn and how well: the loop that runs while something moves, the better picture once nothing does, and
// pictures on demand. It asks the program what is to be drawn, and changes nothing of the scene but its time.
import { FurError } from './errors.js';
import { clampDt } from './options.js';
import { pictures } from './furapp.js';
import { askFrame, asksFrame, cancelFrame } from './schedule.js';

/** After so long without a change a picture is drawn better than moving ones are. */
const stillMilliseconds = 300, busyMilliseconds = 8;
/** What a frame may spend on a coat that grows: the page answers while it does. */
const coatSeconds = 0.014;
const maxFrameSeconds = 0.5;
/** A coat that takes longer is told of. */
const coatToldMilliseconds = 500;
const mostSamples = 64;

/** When any model on the page moved last, by performance.now(): pictures that stay leave it the graphics processor. */
let lastMoved = -Infinity;

/**
 * @typedef {object} FrameEvents
 * @property {() => void} onModelStep undo or redo may have asked for another model
 * @property {() => void} onDrawn
 * @property {(fraction: number) => void} onCoat how far the coat is that is growing
 */
export class Frames {
  #session;
  #events;
  #turn;
  #lastTime = null;
  #run = 0;  // frames that were painted one after another
  #stillTimer = 0;
  #lastPaint = 0;
  #coat = null;

  /** @param {import('./session.js').Session} session @param {FrameEvents} events */
  constructor(session, events) {
    this.#session = session;
    this.#events = events;
    this.#turn = { canvas: session.canvas, work: (time) => this.#onFrame(time) };
  }

  get #canRun() {
    const { phase, screen, options } = this.#session;
    return phase === 'ready' && screen.visible && !options.paused;
  }

  /** Something may have changed: draw soon. */
  wake() {
    this.#events.onModelStep();
    if (this.#canRun) askFrame(this.#turn);
  }

  /** What was asked of the program has changed something: told now, drawn soon. */
  afterChange() {
    this.#session.flushWarnings();
    this.#session.tellSettings();
    this.wake();
  }

  #onFrame(time) {
    const { app, panel, context, screen, options } = this.#session;
    if (!this.#canRun || !context.draws()) {
      this.endRun();
      return;
    }
    // Until the coat has grown again no time goes by.
    if (context.returning) {
      app.tick(0, coatSeconds);
      if (app.coatProgress < 1) return this.wake();
      app.invalidate();
    }
    clearTimeout(this.#stillTimer);
    const dt = this.#timeSince(time);
    const moved = app.tick(dt, options.fixedDt ? undefined : coatSeconds), panelMoved = panel?.update(dt);
    this.#events.onModelStep();
    // A panel that moves alone does not take away what the picture has become.
    const paints = moved || (panelMoved && !app.showAgain());
    // Steps of a given length are for pictures that come out the same everywhere.
    if (paints) this.#paint(options.fixedDt ? pictures.best : pictures.moving);
    else if (panelMoved) this.#afterDrawing();
    this.#run = paints ? this.#run + 1 : 0;
    if (paints) this.#lastPaint = time;
    if (paints || panelMoved) screen.show();
    else if (time - this.#lastPaint > stillMilliseconds) this.#improve();  // fur that dries changes now and then
    panel?.afterFrame();
    this.#tellCoat(time);
    this.#goOn();
  }

  /** Seconds that this frame advances; the program is told how long the one before took. */
  #timeSince(time) {
    const { app, context, options } = this.#session;
    const since = this.#lastTime === null ? 1 / 60 : (time - this.#lastTime) / 1000;
    // Only where drawing is all that the time went by with.
    if (this.#run > 1 && !options.fixedDt) {
      context.timer.update();
      app.frameShown(since * 1000, context.timer.milliseconds);
    }
    this.#lastTime = time;
    return options.fixedDt || Math.min(since, maxFrameSeconds);
  }

  #goOn() {
    const { app, panel } = this.#session;
    const goesOn = app.active || Boolean(panel?.active);
    this.#session.tellChanges(!goesOn);
    this.#session.flushWarnings();
    if (goesOn) return askFrame(this.#turn);
    this.endRun();
    this.#improveIn(stillMilliseconds);
  }

  /** No frame follows the last one at once. */
  endRun() {
    this.#lastTime = null;
    this.#run = 0;
  }

  /** What was drawn in a hurry is not left standing. */
  pauseNow() {
    cancelFrame(this.#turn);
    this.endRun();
    this.#improve();
  }

  /** The program, which gathers samples but for pictures that are to come out the same everywhere. */
  get #app() {
    const { app, options } = this.#session;
    app.setRefining(!options.paused && !options.fixedDt);
    return app;
  }

  #improve() {
    const { app, screen, state } = this.#session;
    clearTimeout(this.#stillTimer);
    if (asksFrame(this.#turn) || state !== 'ready' || !this.#app.improvable) return;
    // What waits for the graphics processor would wait in front of the next touch.
    if (screen.context?.busy) return this.#improveIn(busyMilliseconds);
    if (app.improve()) {
      this.#afterDrawing();
      screen.show();
    }
    screen.context.setFence();
    this.#improveIn(performance.now() - lastMoved < stillMilliseconds ? stillMilliseconds : 0);
  }
  #improveIn(milliseconds) {
    clearTimeout(this.#stillTimer);
    if (this.#app.improvable) this.#stillTimer = setTimeout(() => this.#improve(), milliseconds);
  }

  // Only of a coat that takes longer than a person would notice.
  #tellCoat(time) {
    const { coatProgress: fraction, coatRevision: revision } = this.#session.app;
    const done = fraction >= 1;
    if (!this.#coat || this.#coat.revision !== revision) {
      if (this.#coat?.told) this.#events.onCoat(1);
      this.#coat = { revision, since: time, told: false };
    }
    if (done) this.#coat.since = time;
    if (done || time - this.#coat.since < coatToldMilliseconds) return;
    this.#coat.told = true;
    this.#events.onCoat(fraction);
  }

  #paint(picture, samples = 1) {
    const { app, context } = this.#session;
    if (picture === pictures.moving) {
      lastMoved = performance.now();
      context.timer.begin();
    }
    app.draw(picture, samples);
    context.timer.end();
    context.returned();
    this.#afterDrawing();
  }
  #afterDrawing() {
    this.#session.panel?.draw();
    this.#events.onDrawn();
  }

  /** The picture of this moment, in this task; `coatBudget`: seconds that a coat which grows may take. */
  drawNow(coatBudget) {
    if (this.#drawMoment(1, coatBudget)) this.#session.screen.show();
  }
  /** The same for nobody to see; false: there is nothing to draw with. */
  #drawMoment(samples = 1, coatBudget = undefined) {
    const { app, panel, context, loaded } = this.#session;
    if (!loaded || !context.draws()) return false;
    app.invalidate();
    app.tick(0, coatBudget);
    panel?.update(0);
    this.#paint(pictures.best, samples);
    return true;
  }

  /** n steps of dt seconds and one frame, at once, whatever the page's own clock does. */
  step(dt, n) {
    for (let i = 0; i < n; ++i) this.#session.app.tick(clampDt(dt));
    this.drawNow();
    this.#session.tellChanges(true);
  }

  /** A picture of its own size (default: as shown), the mean of 1 to 64 samples. */
  async toBlob({ mimeType = 'image/png', quality, width, height, transparent, samples } = {}) {
    const { app, context, loaded, panel, screen } = this.#session;
    if (!loaded || !context.draws()) throw new FurError('webgl-unavailable', 'there is no picture to take yet');
    const count = Math.max(1, Math.min(mostSamples, Math.round(samples ?? this.#app.savedSamples) || 1));
    const shown = [screen.width, screen.height, screen.pixelRatio];
    const size = [width ?? shown[0], height ?? shown[1]].map((side) => Math.max(1, Math.min(4096, Math.round(side))));
    this.#session.panel = null;  // not in the picture, nor what it pushes aside
    app.saved = transparent ? 3 : 1;
    let blob;
    try {
      context.resize(...size, shown[2] * (size[1] / shown[1]));
      this.#drawMoment(count);
      // The browser copies the surface now; only the encoding comes later.
      blob = screen.gl.canvas.convertToBlob({ type: mimeType, quality });
    } finally {
      this.#session.panel = panel;
      app.saved = 0;
      context.resize(...shown);
      this.wake();
    }
    return blob.catch(() => { throw new FurError('out-of-memory', `no memory for a picture of ${size.join(' x ')}`); });
  }

  dispose() {
    cancelFrame(this.#turn);
    clearTimeout(this.#stillTimer);
  }
}
