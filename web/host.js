// One furry model on one canvas: what createWetFur() returns and <wet-fur> stands on.
// Longer than most files here: it is the one place where loading, frames, contexts that come and go and the
// change of programs meet, and each must know what the others have left undone.
import { Attachment } from './attachment.js';
import { asFurError, FurError } from './errors.js';
import { Documents } from './documents.js';
import { FurApp, pictures } from './furapp.js';
import { Input } from './input.js';
import { acceptedFiles, decodeImage, fetchModel, loadInto, provideModelImage, readGiven, readModel, sortFiles } from './models.js';
import { clampDt, choices, optionDefaults, optionValue, qualities, settingsObject } from './options.js';
import { orbitText, parseFov, parseOrbit, parseTarget } from './orbit.js';
import { Progress } from './progress.js';
import { compileProgram, instantiateProgram } from './runtime.js';
import { Screen } from './screen.js';

/** After so long without a change a picture is drawn better than moving ones are. */
const stillMilliseconds = 300, busyMilliseconds = 8;
/** What a frame may spend on a coat that grows: the page answers while it does. */
const coatSeconds = 0.014;
const maxFrameSeconds = 0.1;
const maxWarnings = 100;
const wetnessCheckMilliseconds = 200;

/** Lets the browser show what changed before a long piece of work. */
const breathe = () => new Promise((resolve) => {
  const timer = setTimeout(resolve, 60);
  requestAnimationFrame(() => setTimeout(() => {
    clearTimeout(timer);
    resolve();
  }));
});

/** The text as a picture of one byte a pixel, turned by `angle`. */
function letters(text, size, angle) {
  const context = new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true });
  const font = `bold ${Math.round(size)}px sans-serif`;
  context.font = font;
  const long = Math.min(Math.ceil(context.measureText(text).width) + 2, 4096), high = Math.ceil(1.3 * size);
  const [cos, sin] = [Math.abs(Math.cos(angle)), Math.abs(Math.sin(angle))];
  const width = Math.round(long * cos + high * sin), height = Math.round(long * sin + high * cos);
  Object.assign(context.canvas, { width, height });
  Object.assign(context, { font, textAlign: 'center', textBaseline: 'middle' });
  context.translate(width / 2, height / 2);
  context.rotate(angle);
  context.fillText(text, 0, 0, long);
  const { data } = context.getImageData(0, 0, width, height);
  return { coverage: Uint8Array.from({ length: width * height }, (_, i) => data[4 * i + 3]), width, height };
}

export class WetFur extends EventTarget {
  #canvas;
  #screen;
  #context;
  #input;
  #app = null;
  #panel = null;
  #program = 'viewer';
  #source = null;
  #typeSet = null;
  #documents = new Documents();
  #state = 'idle';
  #options = { ...optionDefaults };
  #wantedSettings = new Map();
  #src = '';
  #turn = 0;
  #loading = new Progress();
  #starting = null;
  #wantedState = null;
  #hasOwnLook = false;  // asked for beside the model: what a scene file brings gives way
  #switching = Promise.resolve();
  #abort = null;
  #ready;
  #frame = 0;
  #lastTime = null;
  #run = 0;  // frames that were painted one after another
  #stillTimer = 0;
  #lastPaint = 0;
  #toldChanges = 0;
  #lastCamera = '';
  #lastWetness = 0;
  #lastWetnessCheck = 0;
  #reducedMotion = matchMedia('(prefers-reduced-motion: reduce)');
  #stop = new AbortController();

  #hover = null;  // where the brush is, in pixels of the drawing buffer
  #byKey = false;
  #ringTask = 0;
  /** @internal an SVG polygon over the canvas: the brush's footprint */
  ring = null;

  /** The newest warnings, oldest first. */
  warnings = [];

  /** @param {HTMLCanvasElement} canvas @param {object} options as WetFurOptions in types.d.ts */
  constructor(canvas, options = {}) {
    super();
    this.#canvas = canvas;
    this.#screen = new Screen(canvas, {
      onResize: (width, height, ratio) => this.#onResize(width, height, ratio),
      onVisible: (visible) => this.#onVisible(visible),
      onRelease: () => this.#context.onRelease(),
      onLost: () => this.#context.onLost(),
    });
    const host = this;
    this.#context = new Attachment(this.#screen, {
      get app() { return host.#app; },
      get panel() { return host.#panel; },
      get antialias() { return qualities[host.#options.quality].antialias; },
      comeBack: (atOnce) => this.#comeBack(atOnce),
      emit: (type, detail) => this.#emit(type, detail),
      stateChanged: () => this.#emit('state-change', { state: this.state, reason: 'loading' }),
      warn: (message) => this.#warn(message),
    });
    this.#input = new Input(canvas, {
      get app() { return host.#state === 'ready' && host.interactive ? host.#app : null; },
      get panel() { return host.#panel; },
      toBuffer: (event) => this.#screen.toBuffer(event),
      wake: () => this.#wake(),
      stroke: (phase, detail) => this.#emit(`stroke-${phase}`, detail),
      get turns() { return host.#options.cameraControls; },
      hover: (at, byKey = false) => this.#onHover(at, byKey),
    });
    this.settings = settingsObject({
      names: () => this.settingsTable?.map((field) => field.name) ?? [...this.#wantedSettings.keys()],
      get: (name) => this.#getSetting(name),
      set: (name, value) => this.#setSetting(name, value),
    });
    this.#reducedMotion.addEventListener('change', () => this.#applyMotion(), { signal: this.#stop.signal });
    this.#newReady();
    for (const [name, value] of Object.entries(options)) if (name !== 'src') this.set(name, value);
    if (options.src) this.src = options.src;
  }

  // --- what it is doing ---

  get canvas() { return this.#canvas; }
  get loaded() { return this.#source !== null; }
  get ready() { return this.#ready.promise; }
  get state() {
    if (this.#state !== 'ready') return this.#state;
    if (!this.#screen.visible) return 'suspended';
    return this.#context.mending ? 'lost' : this.#screen.live ? 'ready' : 'suspended';
  }
  get stats() { return this.#app?.stats ?? null; }
  get settingsTable() { return this.#app?.settingsTable ?? null; }
  get presets() { return this.#app?.presets ?? null; }
  get modelName() { return this.#source?.name ?? ''; }
  get animations() { return this.#app?.animations ?? []; }
  get meanWetness() { return this.#app?.meanWetness ?? 0; }
  get wetnessHash() { return this.#app?.wetnessHash ?? ''; }
  get canUndo() { return this.#app?.canUndo ?? false; }
  /** Another number whenever the settings, the tool or what can be undone have changed. @internal */
  get changes() { return this.#app?.changes; }
  /** Whether the coat comes from a type set. @internal */
  get coatGiven() { return this.#app?.coatGiven ?? false; }
  get canRedo() { return this.#app?.canRedo ?? false; }
  /** Whether a person can do anything with it: then it takes the focus and pointers. */
  get interactive() { return this.#options.cameraControls || this.get('tool') !== 'none' || this.#panel !== null; }
  get editorOpen() { return this.#panel !== null; }

  // --- options and settings ---

  /** An option of WetFurOptions or a settings field; before the model is there it is kept for it. */
  set(name, value) {
    if (name === 'src') this.src = value;
    else if (name in optionDefaults) this.#setOption(name, value);
    else this.#setSetting(name, value);
  }
  get(name) {
    if (name === 'src') return this.#src;
    if ((name === 'tool' || name === 'preset') && this.#app) return this.#app[name];  // the editor's panel sets them too
    return name in optionDefaults ? this.#options[name] : this.#getSetting(name);
  }

  #setOption(name, value) {
    const usable = optionValue(name, value);
    if (usable === undefined) {
      this.#warn(`${name}: "${value}" is not one of ${choices[name].join(', ')}`);
      return;
    }
    this.#options[name] = usable;
    this.#applyOption(name);
  }

  #applyOption(name) {
    const value = this.#options[name];
    this.#canvas.tabIndex = this.interactive ? 0 : -1;
    if (name === 'wheel') this.#input.wheel = value;
    if (name === 'touchAction') this.#input.touchAction = value;
    if (name === 'quality') this.#applyQuality(value);
    if (name === 'frameBudget' && this.#app) this.#app.frameBudget = value;
    if (name === 'motion') this.#applyMotion();
    if (name === 'background' && value)
      for (const field of ['backgroundTop', 'backgroundBottom']) this.#setSetting(field, value);
    if (!this.#app) return;
    if (name === 'paused' && value) this.#pauseNow();
    if (name === 'tool') {
      this.#app.tool = value;
      if (this.#hover) this.#showRing();
    }
    if (name === 'preset' && value) {
      this.#applyPreset(this.#app);
      this.#afterChange();
    }
    if (name === 'cameraControls' || name === 'autoRotate') this.#app[name] = value;
    if (name === 'cameraOrbit' && value) this.#applyOrbit(value);
    const { cameraTarget } = this.#options;  // an orbit without one keeps it
    if (/^camera[OT]/.test(name) && cameraTarget) this.#applyTarget(cameraTarget);
    if (name === 'fieldOfView') this.#applyFov(value);
    if (name === 'editor' && this.#source) this.#switchEditor(value);
    this.#wake();
  }

  #applyQuality(name) {
    const { maxPixelRatio, layers, governed } = qualities[name];
    this.#screen.maxPixelRatio = maxPixelRatio;
    if (this.#app) this.#app.governed = governed;
    if (layers && !this.#wantedSettings.has('layers')) this.#setSetting('layers', layers);
  }

  /** Once: what is set later stays over it. */
  #applyPreset(app) {
    const name = this.#options.preset;
    this.#options.preset = '';
    if (name) app.preset = name;
  }

  #applyMotion() {
    if (!this.#app) return;
    const { motion } = this.#options;
    this.#app.reducedMotion = motion === 'reduced' || (motion === 'auto' && this.#reducedMotion.matches);
    this.#wake();
  }

  #applyOrbit(value) {
    const orbit = typeof value === 'string' ? parseOrbit(value) : { target: [0, 0, 0], ...value };
    if (orbit) this.#app.camera = orbit;
    else this.#warn(`camera-orbit: "${value}" is not "yaw pitch distance"`);
    this.#wake();
  }

  #applyTarget(value) {
    const target = parseTarget(value);
    if (target) this.#app.camera = { ...this.#app.camera, target };
    else this.#warn(`camera-target: "${value}" is not "x y z"`);
  }

  #applyFov(value) {
    const radians = parseFov(value);
    if (Number.isFinite(radians)) this.#app.fieldOfView = radians;
    else this.#warn(`field-of-view: "${value}" is not "auto" or degrees`);
  }

  #padding = [0, 0, 0, 0];
  /** What lies over the picture at its edges, in CSS pixels: the model is shown in the middle of the rest. */
  setPadding({ left = 0, top = 0, right = 0, bottom = 0 }) {
    const padding = [left, top, right, bottom];
    if (padding.every((side, i) => side === this.#padding[i])) return;
    this.#padding = padding;
    this.#applyPadding(false);
    this.#wake();
  }
  #applyPadding(atOnce = true) {
    const [width, height] = [this.#canvas.clientWidth || 1, this.#canvas.clientHeight || 1];
    this.#app?.setPadding(this.#padding.map((side, i) => side / (i % 2 ? height : width)), atOnce || !this.loaded);
  }

  #setSetting(name, value) {
    if (!this.#app) {
      this.#wantedSettings.set(name, value);
      return;
    }
    this.#app.setSetting(name, value);
    this.#afterChange();
  }

  #getSetting(name) {
    return this.#app ? this.#app.getSetting(name) : this.#wantedSettings.get(name);
  }

  // --- loading ---

  get src() { return this.#src; }
  set src(value) {
    this.#src = String(value ?? '');
    if (this.#src) this.#loadSrc().catch(() => {});  // `ready` and the error event carry it
  }

  /** Fetches `src` again: after an error, or because the file changed. */
  reload() {
    return this.#state === 'loading' ? this.ready : this.#loadSrc();
  }

  /**
   * A File, Blob, ArrayBuffer or typed array with a .glb, .gltf, .obj or .fo. Rejects with a FurError, and
   * then the old scene stays.
   */
  async loadModel(given, options) {
    await this.#load(() => readModel(given, options));
  }

  /**
   * The same with a type set (.fts): its coat is drawn until a setting changes that grows another. Waits for
   * the model. Rejects with a FurError, and then the old coat stays.
   */
  async loadTypeSet(given, { name } = {}) {
    await this.ready;
    try {
      const typeSet = await readGiven(given, name ?? given?.name ?? 'coat.fts');
      if (!this.#app) return;  // disposed of meanwhile
      this.#showTypeSet(typeSet);
      this.#afterChange();
    } catch (error) {
      throw this.#failed(asFurError(error, error instanceof RangeError ? 'out-of-memory' : 'bad-file'));
    }
  }

  #showTypeSet({ name, bytes }) {
    this.#app.loadTypeSet(bytes, name);
    this.#typeSet = { name, bytes };
  }

  /** The coat as .fts, the model with its fur coordinates as .fo, the whole scene as .glb: Uint8Arrays. */
  saveTypeSet() { return this.#inWorkshop((app) => app.saveTypeSet()); }
  saveFo() { return this.#inWorkshop((app) => app.saveFo()); }
  save() {
    return this.#inWorkshop((app) => {
      for (const what of app.lostBySaving) this.#warn(`save() leaves out ${what}`);
      return app.saveScene();
    });
  }
  lostBySaving() { return this.#inWorkshop((app) => app.lostBySaving); }

  #loadSrc() {
    const src = this.#src;
    return this.#load((signal) => this.#fetch(src, signal));
  }
  async #fetch(src, signal) {
    return { ...await fetchModel(src, (loaded, total) => this.#progress('model', loaded, total), signal), src };
  }

  /**
   * All there is to keep of the scene, for openDocument() of another visit.
   * @internal @returns {import('./documents.js').Document}
   */
  get document() {
    const app = this.#app;
    return { source: this.#source, typeSet: app.coatGiven ? this.#typeSet : null, state: app.state, camera: app.camera, groom: app.groom, water: app.water };
  }
  /** Shows it; of a shipped model `source` need only name it as `src`. @internal */
  openDocument(document) {
    const { source } = document;
    return this.#load((signal) => (source.bytes || source.primitive ? source : this.#fetch(source.src, signal)), document);
  }

  /** The model as it came, dry, with the look that it brought or the default but for `settings`. Undo takes that back. */
  async reset(settings = {}) {
    if (!this.loaded) return;
    this.#giveUpLoading();
    await this.#show(this.#source, { state: JSON.stringify({ version: 1, settings }), brings: true });
  }

  #giveUpLoading() {
    this.#abort?.abort();
    return ++this.#turn;
  }

  async #load(getSource, document) {
    if (this.#state === 'error' || this.#state === 'unsupported') this.#newReady();
    const turn = this.#giveUpLoading();
    this.#abort = new AbortController();
    const isStale = () => turn !== this.#turn;
    this.#loading = new Progress();
    if (!this.loaded) this.#setState('loading');
    try {
      const pending = (async () => getSource(this.#abort.signal))();
      pending.catch(() => {});
      await this.#start();
      const source = await pending;
      if (isStale()) return;
      this.#progress('fur', 0, 1);
      await breathe();
      if (isStale()) return;
      await this.#show(source, document);
    } catch (error) {
      if (isStale()) return;
      throw this.#failed(asFurError(error, error instanceof RangeError ? 'out-of-memory' : 'bad-file'));
    }
  }

  /** The context and the program, once. */
  async #start() {
    // A context takes long to come: the program is on its way meanwhile.
    compileProgram('viewer').catch(() => {});
    if (!this.#app) this.#context.open();
    this.#starting ??= instantiateProgram('viewer', (loaded, total) => this.#progress('program', loaded, total))
      .then((program) => this.#adopt(new FurApp(program)))
      .finally(() => { this.#starting = this.#app ? this.#starting : null; });
    await this.#starting;
  }

  #adopt(app) {
    if (this.#state === 'disposed') throw new FurError('wasm-load', 'disposed of while loading');
    this.#context.open();
    this.#context.attach(app);
    this.#app = app;
    app.governed = qualities[this.#options.quality].governed;
    app.frameBudget = this.#options.frameBudget;
    this.#hasOwnLook ||= Boolean(this.#wantedState || this.#options.preset);
    if (this.#wantedState) this.#takeWantedState(app);
    this.#applyPreset(app);
    for (const [name, value] of this.#wantedSettings) app.setSetting(name, value);
    for (const name of ['tool', 'cameraControls', 'motion', 'autoRotate', 'fieldOfView']) this.#applyOption(name);
    this.#applyPadding();
    this.#flushWarnings();
  }

  /** Before the model, so that undo does not lead behind it. */
  #takeWantedState(app) {
    try {
      app.state = this.#wantedState;
    } catch (error) {
      this.#warn(`state: ${error.message}`);
    }
    this.#wantedState = null;
  }

  /** In place of the one that is there, which undo brings back. */
  async #show(source, document) {
    const app = this.#app;
    const first = !this.loaded;
    const former = !first && { ...this.document, history: app.saveHistory(true) };
    if (document) this.#putBack(app, { ...document, source });
    else loadInto(app, source, first && this.#hasOwnLook);
    if (first) for (const [name, value] of this.#wantedSettings) app.setSetting(name, value);
    if (document) app.restoreHistory(new Uint8Array());
    if (former) {
      this.#documents.follow(former);
      app.followModel();
    }
    if (first) for (const name of ['cameraOrbit', 'cameraTarget']) this.#applyOption(name);
    await this.#present(source);
  }

  /** In an app of this or another program. What cannot be read of it is left out with a warning. */
  #putBack(app, { source, typeSet, state, camera, groom, water, history, brings = false }) {
    const put = (what, work) => {
      try {
        work();
      } catch (error) {
        this.#warn(`${what}: ${error.message}`);
      }
    };
    // Any setting that grows another coat lets go of one from a file.
    if (app.coatGiven) app.setSetting('seed', app.getSetting('seed') + 1);
    put('state', () => { app.state = state; });  // before the model, so that undo does not lead behind it
    if (!camera) app.resetCamera();
    loadInto(app, source, !brings);
    if (groom) put('groom', () => app.restoreGroom(groom, false));
    if (typeSet) put('coat', () => app.loadTypeSet(typeSet.bytes, typeSet.name));
    if (water) put('water', () => { app.water = water; });
    if (history) put('history', () => app.restoreHistory(history));
    if (camera) app.camera = camera;
    if (typeSet && app === this.#app) this.#typeSet = typeSet;
  }

  /** Undo or redo has come to the end of what was done on this model. */
  #bringModel() {
    const way = this.#app?.takeModelStep();
    if (!way) return;
    const document = this.#documents.step(way, { ...this.document, history: this.#app.saveHistory() });
    if (!document) return this.#warn('the other model is no longer kept: there was too much to keep');
    this.#giveUpLoading();
    this.#putBack(this.#app, document);
    this.#present(document.source);
    this.#afterChange();
  }

  async #present(source) {
    const app = this.#app;
    this.#source = source;
    const warning = await provideModelImage(app, source, () => this.#app === app && this.#source === source);
    if (warning) this.#warn(warning);
    if (!this.#app || this.#source !== source) return;  // disposed of meanwhile, or another came
    this.#flushWarnings();
    this.#setState('ready');
    this.#drawNow();
    this.#progress('fur', 1, 1);
    this.#ready.resolve();
    this.#emit('load', { name: source.name, src: source.src ?? null });
    this.#wake();
    if (this.#options.editor && !this.#panel) this.#switchEditor(true);
  }

  #failed(error) {
    if (!this.loaded) {
      const hopeless = error.code === 'webgl-unavailable' || error.code === 'wasm-blocked';
      this.#setState(hopeless ? 'unsupported' : 'error');
      this.#ready.reject(error);
    }
    this.#panel?.message(error.message, true);
    this.#emit('error', { code: error.code, message: error.message });
    return error;
  }

  #newReady() {
    const ready = {};
    ready.promise = new Promise((resolve, reject) => Object.assign(ready, { resolve, reject }));
    ready.promise.catch(() => {});  // nobody need ask for it
    this.#ready = ready;
  }

  #progress(stage, loaded, total) {
    this.#emit('progress', { stage, loaded, total, fraction: this.#loading.fraction(stage, loaded, total) });
  }

  // --- water ---

  /** At {u, v} of the atlas or {x, y} in CSS pixels of the canvas; whether it hit the model. */
  splash(at, { radius = this.settings.brushRadius, amount = this.settings.brushFlow } = {}) {
    if (!this.loaded) return false;
    const hit = 'u' in at
      ? (this.#app.splashAt(at.u, at.v, radius, amount), true)
      : this.#app.splashPixel(...this.#cssToBuffer(at), radius, amount);
    this.#wake();
    return hit;
  }
  dry(seconds = Infinity) {
    if (!this.loaded) return;
    if (seconds === Infinity) this.#app.setWetness(0);
    else this.#app.dry(seconds);
    this.#wake();
  }
  setWetness(amount) {
    if (!this.loaded) return;
    this.#app.setWetness(amount);
    this.#wake();
  }
  /** The model shakes its water off. */
  shake() {
    if (!this.loaded) return;
    this.#app.shake();
    this.#wake();
  }
  /** Letters as clumps of wet fur, round {x, y} in CSS pixels of the canvas (default: its middle), `size` high, turned by `angle` (radians, clockwise). */
  stamp(text, { x = this.#canvas.clientWidth / 2, y = this.#canvas.clientHeight / 2, size = 96, angle = 0, amount = 0.5 } = {}) {
    if (!this.loaded || !text) return;
    const picture = letters(text, size, angle);
    const [left, top] = this.#cssToBuffer({ x, y });
    const ratio = this.#screen.width / this.#canvas.clientWidth;
    this.#app.stamp(picture, left, top, picture.width * ratio, amount);
    this.#wake();
  }
  /** What was painted since the model came, as text for replay(). */
  get recordedStrokes() { return this.#app?.recordedStrokes ?? '[]'; }
  /** Paints it again, with the time that it took. `undoable` false: the scene begins with it. */
  replay(strokes, { undoable = true } = {}) {
    if (!this.loaded) return;
    this.#app.replay(strokes);
    if (!undoable) this.#app.restoreHistory(new Uint8Array());
    this.#afterChange();
  }
  /** Where the water is and went, in square model radii of soaked fur. */
  get waterAccounts() { return this.#app?.waterAccounts ?? null; }
  wetnessAt(u, v) { return this.#app?.wetnessAt(u, v) ?? 0; }
  /** The atlas coordinates under {x, y} in CSS pixels of the canvas, or null. */
  pick(at) { return this.loaded ? this.#app.pick(...this.#cssToBuffer(at)) : null; }

  /** Where the keys' cursor is: null beside the model, undefined while nobody uses it. */
  get spotWetness() {
    if (!this.#byKey || !this.loaded) return undefined;
    const hit = this.#app.pick(...this.#app.cursor);
    return hit && this.#app.wetnessAt(hit.u, hit.v);
  }

  #onHover(at, byKey) {
    this.#hover = at;
    this.#byKey = byKey;
    if (byKey) this.#emit('cursor-move', { wetness: this.spotWetness });
    // A fast mouse tells more often than pictures are shown.
    this.#ringTask ||= requestAnimationFrame(() => this.#showRing());
  }

  #showRing() {
    this.#ringTask = 0;
    if (!this.ring) return;
    const ring = this.#hover && this.loaded && this.interactive && !this.#panel ? this.#app.brushRing(...this.#hover) : null;
    this.ring.setAttribute('points', ring?.join(' ') ?? '');
    if (ring) this.ring.ownerSVGElement.setAttribute('viewBox', `0 0 ${this.#screen.width} ${this.#screen.height}`);
  }

  // --- groom ---

  /** Whether any fur is shorter, of another type or combed. */
  get groomed() { return this.#app?.groomed ?? false; }
  /** One of 'clear', 'length', 'invert', 'vary', 'type', 'comb', 'raise' and 'size', all over the model. */
  async groom(edit, value = 1, direction = [0, -1, 0]) {
    if (edit !== 'clear') return this.#groomInWorkshop((app) => app.groomAll(edit, value, direction));
    if (!this.loaded) return;
    this.#app.clearGroom();
    this.#afterChange();
  }
  /** An image in the model's texture coordinates: black is bald. */
  async loadLengthMap(image) { await this.#loadGroomImage(0, 'length', image); }
  /** The same: red, green and blue are the presence of the fur types 2, 3 and 4. */
  async loadTypeMap(image) { await this.#loadGroomImage(1, 'type', image); }
  async #loadGroomImage(what, name, given) {
    await this.ready;
    const image = await decodeImage(given instanceof Blob ? given : new Blob([given])).catch((error) => {
      throw this.#failed(new FurError('bad-file', `the ${name} map could not be read (${error.message})`));
    });
    await this.#groomInWorkshop((app) => app.groomFromImage(what, given.name ?? '', image));
  }
  async #groomInWorkshop(work) {
    await this.#inWorkshop((app) => {
      work(app);
      if (app !== this.#app) this.#app.restoreGroom(app.groom, true);
    });
    this.#afterChange();
  }

  /** Work that the viewer's program leaves to the editor's: on a copy of the scene, without a picture. */
  async #inWorkshop(work) {
    if (!this.loaded) throw new FurError('bad-file', 'there is no model yet');
    if (this.#program === 'editor') return work(this.#app);
    const app = new FurApp(await instantiateProgram('editor', (loaded, total) => this.#progress('editor', loaded, total)));
    try {
      this.#putBack(app, this.document);
      return work(app);
    } finally {
      app.destroy();
    }
  }

  #cssToBuffer({ x, y }) {
    const box = this.#canvas.getBoundingClientRect();
    return this.#screen.toBuffer({ clientX: box.left + x, clientY: box.top + y });
  }

  // --- time ---

  play() { this.set('paused', false); }
  pause() { this.set('paused', true); }

  /** n steps of dt seconds and one frame, at once, whatever the page's own clock does. */
  step(dt, n = 1) {
    if (!this.loaded) return;
    for (let i = 0; i < n; ++i) this.#app.tick(clampDt(dt));
    this.#drawNow();
    this.#tellChanges(true);
  }

  #canRun() { return this.#state === 'ready' && this.#screen.visible && !this.#options.paused; }

  #wake() {
    this.#bringModel();
    if (!this.#frame && this.#canRun()) this.#frame = requestAnimationFrame((time) => this.#onFrame(time));
  }

  #onFrame(time) {
    this.#frame = 0;
    if (!this.#canRun() || !this.#context.draws()) {
      this.#endRun();
      return;
    }
    // Until the coat has grown again no time goes by.
    if (this.#context.returning) {
      this.#app.tick(0, coatSeconds);
      if (this.#app.coatProgress < 1) return this.#wake();
      this.#app.invalidate();
    }
    clearTimeout(this.#stillTimer);
    const since = this.#lastTime === null ? 1 / 60 : (time - this.#lastTime) / 1000;
    // Only where drawing is all that the time went by with.
    if (this.#run > 1 && !this.#options.fixedDt) {
      this.#context.timer.update();
      this.#app.frameShown(since * 1000, this.#context.timer.milliseconds);
    }
    this.#lastTime = time;
    const dt = this.#options.fixedDt || Math.min(since, maxFrameSeconds);
    const changed = [this.#app.tick(dt, this.#options.fixedDt ? undefined : coatSeconds), this.#panel?.update(dt)];
    this.#bringModel();
    const paints = changed.some(Boolean);
    // Steps of a given length are for pictures that come out the same everywhere.
    if (paints) {
      this.#paint(this.#options.fixedDt ? pictures.best : pictures.moving);
      this.#screen.show();
    }
    this.#run = paints ? this.#run + 1 : 0;
    if (paints) this.#lastPaint = time;
    else if (time - this.#lastPaint > stillMilliseconds) this.#improve();  // fur that dries changes now and then
    this.#panel?.afterFrame();
    this.#tellCoat(time);
    const goesOn = this.#app.active || Boolean(this.#panel?.active);
    this.#tellChanges(!goesOn);
    this.#flushWarnings();
    if (goesOn && !this.#frame) this.#frame = requestAnimationFrame((next) => this.#onFrame(next));
    if (goesOn) return;
    this.#endRun();
    this.#improveIn(stillMilliseconds);
  }

  /** What was drawn in a hurry is not left standing. */
  #pauseNow() {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#endRun();
    this.#improve();
  }

  #endRun() {
    this.#lastTime = null;
    this.#run = 0;
  }

  #improve() {
    clearTimeout(this.#stillTimer);
    if (this.#frame || this.state !== 'ready' || !this.#app.improvable) return;
    // What waits for the graphics processor would wait in front of the next touch.
    if (this.#screen.busy) return this.#improveIn(busyMilliseconds);
    if (this.#app.improve()) {
      this.#afterDrawing();
      this.#screen.show();
    }
    this.#screen.setFence();
    this.#improveIn(0);
  }
  #improveIn(milliseconds) {
    clearTimeout(this.#stillTimer);
    if (this.#app.improvable) this.#stillTimer = setTimeout(() => this.#improve(), milliseconds);
  }

  // Only of a coat that takes longer than a person would notice.
  #coat = null;
  #tellCoat(time) {
    const fraction = this.#app.coatProgress, revision = this.#app.coatRevision;
    const done = fraction >= 1;
    if (!this.#coat || this.#coat.revision !== revision) {
      if (this.#coat?.told) this.#progress('coat', 1, 1);
      this.#coat = { revision, since: time, told: false };
    }
    if (done) this.#coat.since = time;
    if (done || time - this.#coat.since < 500) return;
    this.#coat.told = true;
    this.#progress('coat', fraction, 1);
  }

  #paint(picture) {
    this.#context.returning = false;
    if (picture === pictures.moving) this.#context.timer.begin();
    this.#app.draw(picture);
    this.#context.timer.end();
    this.#afterDrawing();
  }
  #afterDrawing() {
    this.#panel?.draw();
    if (this.#hover) this.#showRing();
  }

  /** The picture of this moment, in this task. */
  #drawNow() {
    if (!this.#drawMoment()) return;
    this.#screen.show();
  }
  /** The same for nobody to see; false: there is nothing to draw with. */
  #drawMoment() {
    if (!this.loaded || !this.#context.draws()) return false;
    this.#app.invalidate();
    this.#app.tick(0);
    this.#panel?.update(0);
    this.#paint(pictures.best);
    return true;
  }

  // --- history, state, view ---

  undo() { return this.#history('undo'); }
  redo() { return this.#history('redo'); }
  #history(way) {
    const done = this.loaded && this.#app[way]();
    if (done) {
      this.#bringModel();
      this.#afterChange();
    }
    return done;
  }

  /** Model name, settings that differ from the defaults, and camera, as JSON text. */
  getState() { return this.#app?.state ?? '{}'; }
  /** JSON text or the object it stands for; throws a FurError when it cannot be used. */
  setState(state) {
    const json = typeof state === 'string' ? state : JSON.stringify(state);
    if (!this.#app) {
      this.#wantedState = json;
      return;
    }
    this.#app.state = json;
    this.#afterChange();
  }

  getCameraOrbit() { return this.#app?.camera ?? null; }
  /** The same as text for the camera-orbit attribute and links. */
  get cameraOrbitText() { return this.#app ? orbitText(this.#app.camera) : ''; }
  resetCamera() {
    this.#app?.resetCamera();
    this.#wake();
  }

  /** A picture of its own size (default: as shown). */
  async toBlob({ mimeType = 'image/png', quality, width, height, transparent } = {}) {
    if (!this.loaded || !this.#context.draws()) throw new FurError('webgl-unavailable', 'there is no picture to take yet');
    const shown = [this.#screen.width, this.#screen.height, this.#screen.pixelRatio];
    const size = [width ?? shown[0], height ?? shown[1]].map((side) => Math.max(1, Math.min(4096, Math.round(side))));
    const panel = this.#panel;
    this.#panel = null;  // not in the picture, nor what it pushes aside
    this.#app.saved = transparent ? 3 : 1;
    let blob;
    try {
      this.#context.resize(...size, shown[2] * (size[1] / shown[1]));
      this.#drawMoment();
      // The browser copies the surface now; only the encoding comes later.
      blob = this.#screen.gl.canvas.convertToBlob({ type: mimeType, quality });
    } finally {
      this.#panel = panel;
      this.#app.saved = 0;
      this.#context.resize(...shown);
      this.#wake();
    }
    return blob.catch(() => { throw new FurError('out-of-memory', `no memory for a picture of ${size.join(' x ')}`); });
  }

  // --- the editor ---

  openEditor() { return this.#switchEditor(true); }
  closeEditor() { return this.#switchEditor(false); }
  /** As the panel's own key: it asks where something would be left out. @internal */
  saveByPanel() {
    this.#panel?.key({ key: 's', ctrlKey: true }, true);
    this.#wake();
  }

  #switchEditor(open) {
    this.#options.editor = open;
    this.#switching = this.#switching.then(() => this.#moveTo(open ? 'editor' : 'viewer'))
      .catch((error) => {
        this.#options.editor = this.#panel !== null;
        const known = asFurError(error, 'wasm-load');
        this.#emit('error', { code: known.code, message: known.message });
      });
    return this.#switching;
  }

  /** The scene moves over to the other program, in a module instance of its own on the same context. */
  async #moveTo(which) {
    if (which === this.#program || !this.loaded) return;
    const program = await instantiateProgram(which, (loaded, total) => this.#progress('editor', loaded, total));
    const { EditorPanel } = which === 'editor' ? await import('./editor.js') : {};
    if (!this.#app) return;
    const old = this.#app;
    const { tool } = old;
    const document = { ...this.document, history: old.saveHistory() };
    this.#panel?.dispose();
    this.#panel = null;
    this.#screen.giveBack();
    const app = new FurApp(program);
    this.#adopt(app);
    this.#putBack(app, document);
    app.tool = tool;
    old.destroy();
    this.#program = which;
    if (EditorPanel) {
      this.#panel = new EditorPanel(app, this.#canvas, {
        fur: this,
        wake: () => this.#wake(),
        openDialog: () => this.#openDialog(),
      });
      this.#panel.resize(this.#screen.width, this.#screen.height, this.#screen.pixelRatio);
    }
    this.#drawNow();
    const { source } = document;
    await provideModelImage(app, source, () => this.#app === app && this.#source === source);
    this.#drawNow();
    this.#wake();
    this.#emit('state-change', { state: this.state, reason: 'editor' });
  }

  #openDialog() {
    const input = Object.assign(document.createElement('input'), { type: 'file', accept: acceptedFiles, multiple: true });
    input.addEventListener('change', async () => {
      const { model, typeSet, image, others } = sortFiles(input.files);
      try {
        if (image) await this.loadLengthMap(image);
        else if (model ?? others[0]) await this.loadModel(model ?? others[0], { files: others });
        if (typeSet) await this.loadTypeSet(typeSet);
      } catch {
        // The error event carries it.
      }
    });
    input.click();
  }

  // --- what the screen does ---

  #onResize(width, height, ratio) {
    if (!this.#app) return;
    this.#context.resize(width, height, ratio);
    this.#applyPadding();
    const draws = this.#screen.live || this.#options.paused;
    if (this.#screen.visible && draws) this.#drawNow();  // until then the old picture is stretched
    this.#wake();
  }

  #onVisible(visible) {
    if (!this.loaded) return;
    this.#endRun();
    this.#emit('model-visibility', { visible });
    if (!visible) return;
    if (this.#screen.live) this.#wake();
    else this.#context.seen();
  }

  #comeBack(atOnce) {
    if (atOnce || this.#options.paused) this.#drawNow();
    else if (this.loaded) this.#context.draws();
    this.#wake();
  }

  // --- telling ---

  #emit(type, detail) { this.dispatchEvent(new CustomEvent(type, { detail })); }

  #setState(state) {
    if (state === this.#state) return;
    this.#state = state;
    this.#emit('state-change', { state: this.state, reason: 'loading' });
  }

  #afterChange() {
    this.#flushWarnings();
    this.#tellSettings();
    this.#wake();
  }

  #tellSettings() {
    this.#toldChanges = this.#app?.changes;
    this.#emit('state-change', { state: this.state, reason: 'settings' });
  }

  #warn(message) {
    console.warn(`wet-fur: ${message}`);
    this.warnings.push(message);
    if (this.warnings.length > maxWarnings) this.warnings.shift();
    this.#emit('warning', { message });
  }

  #flushWarnings() { this.#app?.takeWarnings().forEach((message) => this.#warn(message)); }

  #tellChanges(last) {
    // What a person changed on the canvas or in the panel.
    if (this.#app.changes !== this.#toldChanges) this.#tellSettings();
    const camera = JSON.stringify(this.#app.camera);
    if (camera !== this.#lastCamera) {
      this.#lastCamera = camera;
      this.#emit('camera-change', { orbit: this.#app.camera });
    }
    const now = performance.now();
    if (!last && now - this.#lastWetnessCheck < wetnessCheckMilliseconds) return;
    this.#lastWetnessCheck = now;
    const wetness = this.#app.meanWetness;
    if (wetness === this.#lastWetness) return;
    this.#lastWetness = wetness;
    this.#emit('wetness-change', { wetness });
  }

  dispose() {
    if (this.#state === 'disposed') return;
    ++this.#turn;
    this.#abort?.abort();
    this.#stop.abort();
    cancelAnimationFrame(this.#frame);
    cancelAnimationFrame(this.#ringTask);
    clearTimeout(this.#stillTimer);
    this.#context.dispose();
    this.#input.dispose();
    this.#panel?.dispose();
    this.#panel = null;
    this.#screen.close();
    this.#app?.destroy();
    this.#app = this.#panel = this.#source = null;
    this.#state = 'disposed';
  }
}
