// How a model comes to be shown: fetched or read, put into the program with what was done on it, and brought back by undo.
import { forgetProgram, loseContextsOf } from './contexts.js';
import { asFurError, FurError } from './errors.js';
import { Documents } from './documents.js';
import { FurApp } from './furapp.js';
import { fetchModel, loadInto, prepare, provideModelImages, provideTypePictures, readColorMap, readGiven } from './models.js';
import { Progress } from './progress.js';
import { compileProgram, instantiateProgram, sharedProgram } from './runtime.js';
import { LoadingTurn, pause, pieceSeconds } from './schedule.js';

/** How soon a driver that compiles is asked again whether it is done. */
const driverMilliseconds = 4;
const wait = (milliseconds) => new Promise((resolve) => { setTimeout(resolve, milliseconds); });

/** Lets the browser show what changed before a long piece of work. */
export const breathe = () => new Promise((resolve) => {
  const timer = setTimeout(resolve, 60);
  requestAnimationFrame(() => setTimeout(() => {
    clearTimeout(timer);
    resolve();
  }));
});

/** Of what came with the model only that there was water of a link is known of a document. */
const cameWithOf = (document) => (document?.givenWater ? { water: true } : null);

export class Loading {
  #session;
  #frames;
  #applied;
  #onShown;
  #documents = new Documents();
  #turn = 0;
  #getSource = null;  // of the newest load()
  #failures = 0;  // of programs, by what is shown
  #abort = null;
  #told = new Progress();
  #starting = null;
  #wantedState = null;
  #hasOwnState = false;  // asked for beside the model: what a scene file brings gives way
  #ready;

  /**
   * @param {import('./session.js').Session} session
   * @param {{ frames: import('./frames.js').Frames, applied: import('./applied.js').AppliedOptions, onShown: () => void }} parts
   */
  constructor(session, { frames, applied, onShown }) {
    this.#session = session;
    this.#frames = frames;
    this.#applied = applied;
    this.#onShown = onShown;
    this.#newReady();
  }

  get ready() { return this.#ready.promise; }

  progress(stage, loaded, total) {
    this.#session.emit('progress', { stage, loaded, total, fraction: this.#told.fraction(stage, loaded, total) });
  }

  // --- from outside ---

  loadSrc(src) { return this.load((signal) => this.#fetch(src, signal)); }
  async #fetch(src, signal) {
    return { ...await fetchModel(src, (loaded, total) => this.progress('model', loaded, total), signal), src };
  }

  /** `type`: of the fur, 0 to 3. */
  async loadTypeSet(given, name, type = 0) {
    await this.ready;
    try {
      const typeSet = await readGiven(given, name ?? given?.name ?? 'coat.fts');
      await this.#inLarger(() => this.#session.app?.loadTypeSet(typeSet.bytes, typeSet.name, type));
      const { app } = this.#session;
      if (!app) return;  // disposed of meanwhile
      this.#session.needsLarger = true;
      const warning = await provideTypePictures(app, () => this.#session.app === app);
      if (warning) this.#session.warn(warning);
      this.#frames.afterChange();
    } catch (error) {
      throw this.failed(asFurError(error, error instanceof RangeError ? 'out-of-memory' : 'bad-file'));
    }
  }

  /** A picture (Blob, buffer) as a type's colour map, 0 to 3, or the skin's, 4; null takes it away. */
  async setTypePicture(type, given) {
    await this.ready;
    try {
      const picture = given && await readColorMap(this.#session.app, given);
      const { app } = this.#session;
      if (!app) return;  // disposed of meanwhile
      if (picture) app.setTypePicture(type, picture.bytes, picture.image);
      else app.setSetting(type < 4 ? `type${type + 1}.picture` : 'skin.picture', '');
      this.#session.flushWarnings();
      this.#frames.afterChange();
    } catch (error) {
      throw this.failed(asFurError(error, 'bad-file'));
    }
  }

  /** All there is to keep of the scene, for openDocument(). @returns {import('./documents.js').Document} */
  get document() {
    const { app, source, cameWith } = this.#session;
    return { source, ...cameWith?.water && { givenWater: true }, typeFiles: app.typeFiles, state: app.state, camera: app.camera, groom: app.groom, hair: app.hair, water: app.water };
  }
  openDocument(document) {
    const { source } = document;
    return this.load((signal) => (source.bytes || source.primitive ? source : this.#fetch(source.src, signal)), document);
  }

  async reset(settings) {
    this.#giveUp();
    await this.#show(this.#session.source, { state: JSON.stringify({ version: 1, settings }), brings: true });
  }

  /** Before there is a program it is kept for it. */
  setState(json) {
    const { app } = this.#session;
    if (!app) {
      this.#wantedState = json;
      return;
    }
    app.state = json;
    this.#frames.afterChange();
  }

  #giveUp() {
    this.#abort?.abort();
    return ++this.#turn;
  }

  /** @param {(signal: AbortSignal) => import('./models.js').ModelSource | Promise<import('./models.js').ModelSource>} getSource */
  async load(getSource, document) {
    const { loaded, phase } = this.#session;
    this.#getSource = getSource;
    if (phase === 'error' || phase === 'unsupported') this.#newReady();
    const turn = this.#giveUp();
    this.#abort = new AbortController();
    const isStale = () => turn !== this.#turn;
    this.#told = new Progress();
    const place = new LoadingTurn(this.#session.canvas);
    if (!loaded) this.#session.setPhase('loading');
    try {
      const pending = (async () => getSource(this.#abort.signal))();
      pending.catch(() => {});
      await this.#start();
      const source = await pending;
      await place.take();
      if (isStale()) return;
      this.progress('fur', 0, 1);
      await pause();
      if (isStale()) return;
      if (document?.hair?.byteLength && !this.#isLarger) await this.moveTo('hair', 'program');
      await this.#inLarger(() => this.#show(source, document));
    } catch (error) {
      if (isStale() && error.code !== 'program-failed') return;
      if (isStale()) throw error;  // #leaveFailed() tells it
      throw this.failed(asFurError(error, error instanceof RangeError ? 'out-of-memory' : 'bad-file'));
    } finally {
      place.end();
    }
  }

  // --- the program ---

  /** The context and the program, once. */
  async #start() {
    // A context takes long to come: the program is on its way meanwhile.
    compileProgram('viewer').catch(() => {});
    if (!this.#session.app) this.#session.context.open();
    this.#starting ??= sharedProgram('viewer', (loaded, total) => this.progress('program', loaded, total))
      .then(async (program) => {
        const app = new FurApp(program);
        await pause();
        this.adopt(app);
      })
      .finally(() => { this.#starting = this.#session.app ? this.#starting : null; });
    await this.#starting;
  }

  /**
   * The scene, if there is one, moves over to another program, on the same context; the editor's is an instance of its own. Whether
   * it has: it may be disposed of meanwhile. @param {'viewer' | 'hair' | 'editor'} which @param {string} part that progress is told of
   */
  async moveTo(which, part) {
    const session = this.#session;
    const program = await (which === 'editor' ? instantiateProgram : sharedProgram)(which, (loaded, total) => this.progress(part, loaded, total));
    const old = session.app;
    if (!old) return false;
    const document = session.source && { ...this.document, history: old.saveHistory() };
    session.panel?.dispose();
    session.panel = null;
    session.screen.giveBack();
    const app = new FurApp(program);
    this.adopt(app);
    if (document) this.putBack(app, document);
    old.destroy();
    if (session.program === 'editor') forgetProgram(old.program);
    session.program = which;
    session.needsLarger ||= which === 'hair' || Boolean(document?.hair?.byteLength);
    return true;
  }

  /** It takes the place of the one that is there. */
  adopt(app) {
    const { context, phase } = this.#session;
    try {
      if (phase === 'disposed') throw new FurError('wasm-load', 'disposed of while loading');
      context.open();
      context.attach(app);
    } catch (error) {
      app.destroy();
      throw error;
    }
    this.#session.app = app;
    app.onFailure(() => { if (this.#session.app === app) this.#leaveFailed(app); });
    this.#hasOwnState ||= Boolean(this.#wantedState);
    if (this.#wantedState) this.#takeWantedState(app);
    this.#applied.toProgram();
    this.#session.flushWarnings();
  }

  /**
   * The program has failed, and with it all that is in it. What is shown moves over to a fresh one, as it was; where it is what has
   * made the program fail, once.
   */
  async #leaveFailed(app) {
    const session = this.#session, { source } = session, turn = this.#giveUp();
    let document = null;
    try {
      document = source && app.program.salvage(() => ({ ...this.document, history: app.saveHistory() }));
    } catch {
      document = { source, state: '{}' };
      session.warn('what was done on the model is lost');
    }
    try {
      session.panel?.dispose();
    } catch {
      // The program has no more to say.
    }
    const wasHair = session.program === 'hair';
    session.app = session.source = session.panel = this.#starting = null;
    session.shown = false;
    session.program = 'viewer';
    await null;  // until all that were in it have left
    loseContextsOf(app.program);
    if (app.failed && (!document || ++this.#failures > 1)) return void this.failed(app.program.failure);
    session.setPhase('loading');
    if (!document) return void this.load(this.#getSource).catch(() => {});  // `ready` and the error event carry it
    const place = new LoadingTurn(session.canvas);
    await place.take();
    try {
      if (turn === this.#turn) await this.#start();
      if (turn === this.#turn && (wasHair || document.hair?.byteLength)) await this.moveTo('hair', 'program');
      if (turn !== this.#turn) return;
      this.putBack(session.app, document);
      await this.#present(source);
    } catch (error) {
      this.failed(asFurError(error, 'bad-file'));
    } finally {
      place.end();
    }
  }

  /** Before the model, so that undo does not lead behind it. */
  #takeWantedState(app) {
    try {
      app.state = this.#wantedState;
    } catch (error) {
      this.#session.warn(`state: ${error.message}`);
    }
    this.#wantedState = null;
  }

  // --- showing ---

  /** Does it; where the viewer's program cannot, as with long hair and formats that are not glTF, in the one that can. */
  async #inLarger(work) {
    try {
      await work();
    } catch (error) {
      if (error.code !== 'larger-program' || this.#isLarger || !await this.moveTo('hair', 'program')) throw error;
      await work();
    }
  }
  get #isLarger() { return this.#session.program !== 'viewer'; }

  /** In place of the one that is there, which undo brings back. */
  async #show(source, document) {
    const { app, loaded } = this.#session, turn = this.#turn;
    if (!await prepare(app, source, () => turn === this.#turn && this.#session.app === app)) return;
    this.#session.needsLarger ||= !source.primitive && !/\.gl(b|tf)$/i.test(source.name);
    const first = !loaded;
    const former = !first && { ...this.document, history: app.saveHistory(true) };
    this.#session.cameWith = cameWithOf(document);
    if (document) this.putBack(app, { ...document, source });
    else {
      loadInto(app, source, first && this.#hasOwnState);
      this.#session.cameWith = undefined;
    }
    if (first) this.#applied.settingsToModel();
    if (first && !document) this.#applied.waterToModel();
    // Undo begins with what is shown.
    if (document || first) app.restoreHistory(new Uint8Array());
    if (former) {
      this.#documents.follow(former);
      app.followModel();
    }
    if (first) this.#applied.cameraToModel();
    await this.#present(source);
  }

  /** In an app of this or another program. What cannot be read of it is left out with a warning. */
  putBack(app, { source, typeFiles, typeSet, state, camera, groom, hair, water, history, brings = false }) {
    const put = (what, work) => {
      try {
        work();
      } catch (error) {
        if (error.code === 'larger-program') throw error;
        this.#session.warn(`${what}: ${error.message}`);
      }
    };
    put('state', () => { app.state = state; });  // before the model, so that undo does not lead behind it
    if (!camera) app.resetCamera();
    loadInto(app, source, !brings);
    if (groom) put('groom', () => app.restoreGroom(groom, false));
    if (hair) put('hair', () => app.restoreHair(hair, false));
    if (typeFiles) put('coat', () => { app.typeFiles = typeFiles; });
    this.#session.needsLarger ||= typeFiles?.byteLength > 3e6;  // as much as the coat of a type set takes
    if (typeSet) put('coat', () => app.loadTypeSet(typeSet.bytes, typeSet.name));  // as it was kept before types had files of their own
    if (water) put('water', () => { app.water = water; });
    if (history) put('history', () => app.restoreHistory(history));
    if (camera) app.camera = camera;
  }

  /** Undo or redo may have come to the end of what was done on this model: then the other one comes. */
  bringModel() {
    const { app } = this.#session;
    const way = app?.takeModelStep();
    if (!way) return;
    const document = this.#documents.step(way, { ...this.document, history: app.saveHistory() });
    if (!document) return this.#session.warn('the other model is no longer kept: there was too much to keep');
    this.#giveUp();
    this.#session.cameWith = cameWithOf(document);
    this.putBack(app, document);
    this.#present(document.source);
    this.#frames.afterChange();
  }

  async #present(source) {
    const session = this.#session;
    session.source = source;
    const { app } = session, isShown = () => session.app === app && session.source === source;
    session.changesAtLoad = app.changes;
    session.context.returning = true;
    const warning = await this.provideImage();
    if (warning) session.warn(warning);
    // Those that nothing follows, or that are to come out the same everywhere, begin with the whole coat.
    const coarse = !session.options.paused && !session.options.fixedDt;
    for (let work; isShown() && (work = app.workOnPicture(pieceSeconds, coarse)) !== 1;) await (work === 2 ? pause() : wait(driverMilliseconds));
    if (!isShown()) return;  // disposed of meanwhile, or another came
    session.shown = true;
    session.flushWarnings();
    session.setPhase('ready');
    this.#frames.drawNow(coarse ? 0 : undefined);
    // Told apart when the picture is on its way.
    if (session.cameWith === undefined) session.cameWith = { groom: app.groomed && app.groom, hair: app.haired && app.hair };
    this.progress('fur', 1, 1);
    this.#ready.resolve();
    session.emit('load', { name: source.name, src: source.src ?? null });
    this.#frames.wake();
    this.#onShown();
  }

  /** The picture of the model that is shown, decoded, if it is shown still by then. Returns a warning or null. */
  async provideImage() {
    const { app, source } = this.#session, wanted = () => this.#session.app === app && this.#session.source === source;
    const warning = await provideModelImages(app, source, wanted);
    return (wanted() && await provideTypePictures(app, wanted)) || warning;
  }

  /** Tells of an error, and returns it. */
  failed(error) {
    const { loaded, panel } = this.#session;
    if (!loaded) {
      const hopeless = error.code === 'webgl-unavailable' || error.code === 'wasm-blocked';
      this.#session.setPhase(hopeless ? 'unsupported' : 'error');
      this.#ready.reject(error);
    }
    panel?.message(error.message, true);
    this.#session.emit('error', { code: error.code, message: error.message });
    return error;
  }

  #newReady() {
    const ready = {};
    ready.promise = new Promise((resolve, reject) => Object.assign(ready, { resolve, reject }));
    ready.promise.catch(() => {});  // nobody need ask for it
    this.#ready = ready;
  }

  dispose() { this.#giveUp(); }
}
