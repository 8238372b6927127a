// What was asked for by options and settings, and how it comes to the program: at once, or when that is there.
import { choices, optionValue, qualities } from './options.js';
import { parseFov, parseOrbit, parseTarget } from './orbit.js';

/** Options that a new program is told of before it has a model. */
const forProgram = ['tool', 'cameraControls', 'motion', 'autoRotate', 'fieldOfView'];
/** Those that need a model first. */
const forModel = ['cameraOrbit', 'cameraTarget'];

export class AppliedOptions {
  #session;
  #frames;
  #input;
  #ring;
  #onEditor;
  #padding = [0, 0, 0, 0];
  #reducedMotion = matchMedia('(prefers-reduced-motion: reduce)');
  #onMotion = () => this.#applyMotion();
  #stop = new AbortController();

  /**
   * @param {import('./session.js').Session} session
   * @param {{ frames: import('./frames.js').Frames, input: import('./input.js').Input, ring: import('./brushring.js').BrushRing, onEditor: (open: boolean) => void }} parts
   */
  constructor(session, { frames, input, ring, onEditor }) {
    this.#session = session;
    this.#frames = frames;
    this.#input = input;
    this.#ring = ring;
    this.#onEditor = onEditor;
  }

  dispose() { this.#stop.abort(); }

  // --- options ---

  setOption(name, value) {
    const usable = optionValue(name, value);
    if (usable === undefined) {
      this.#session.warn(`${name}: "${value}" is not one of ${choices[name].join(', ')}`);
      return;
    }
    this.#session.options[name] = usable;
    this.#apply(name);
  }

  getOption(name) {
    const { app, options } = this.#session;
    // The editor's panel sets them, too.
    return (name === 'tool' || name === 'preset') && app ? app[name] : options[name];
  }

  #apply(name) {
    const { app, canvas, interactive, options, source } = this.#session;
    const value = options[name];
    canvas.tabIndex = interactive ? 0 : -1;
    if (name === 'wheel') this.#input.wheel = value;
    if (name === 'touchAction') this.#input.touchAction = value;
    if (name === 'quality') this.#applyQuality(value);
    if (name === 'frameBudget' && app) app.setFrameBudget(value);
    if (name === 'motion') this.#applyMotion();
    if (name === 'background' && value)
      for (const field of ['backgroundTop', 'backgroundBottom']) this.setSetting(field, value);
    if (!app) return;
    if (name === 'paused' && value) this.#frames.pauseNow();
    if (name === 'tool') {
      app.tool = value;
      this.#ring.refresh();
    }
    if (name === 'preset' && value) {
      this.#applyPreset();
      this.#frames.afterChange();
    }
    if (name === 'wetness' && source) this.waterToModel();
    if (name === 'cameraControls') app.setCameraControls(value);
    if (name === 'autoRotate') app.setAutoRotate(value);
    if (name === 'cameraOrbit' && value) this.#applyOrbit(value);
    const { cameraTarget } = options;  // an orbit without one keeps it
    if (forModel.includes(name) && cameraTarget) this.#applyTarget(cameraTarget);
    if (name === 'fieldOfView') this.#applyFov(value);
    if (name === 'editor' && source) this.#onEditor(value);
    this.#frames.wake();
  }

  #applyQuality(name) {
    const { app, screen, wantedSettings } = this.#session;
    const { maxPixelRatio, layers, governed } = qualities[name];
    screen.maxPixelRatio = maxPixelRatio;
    if (app) app.governed = governed;
    if (layers && !wantedSettings.has('layers')) this.setSetting('layers', layers);
  }

  /** Once, on what the first model brought: what is set later stays over it. */
  #applyPreset(isThere = this.#session.loaded) {
    const { app, options } = this.#session;
    if (options.preset) app.preset = options.preset;
    if (isThere) options.preset = '';
  }

  #applyMotion() {
    const { app, options } = this.#session;
    if (!app) return;
    app.setReducedMotion(options.motion === 'reduced' || (options.motion === 'auto' && this.#reducedMotion.matches));
    this.#frames.wake();
  }

  #applyOrbit(value) {
    const { app } = this.#session;
    const orbit = typeof value === 'string' ? parseOrbit(value) : { target: [0, 0, 0], ...value };
    if (orbit) app.camera = orbit;
    else this.#session.warn(`camera-orbit: "${value}" is not "yaw pitch distance"`);
    this.#frames.wake();
  }

  #applyTarget(value) {
    const { app } = this.#session;
    const target = parseTarget(value);
    if (target) app.camera = { ...app.camera, target };
    else this.#session.warn(`camera-target: "${value}" is not "x y z"`);
  }

  #applyFov(value) {
    const radians = parseFov(value);
    if (Number.isFinite(radians)) this.#session.app.setFieldOfView(radians);
    else this.#session.warn(`field-of-view: "${value}" is not "auto" or degrees`);
  }

  // --- padding ---

  setPadding({ left = 0, top = 0, right = 0, bottom = 0 }) {
    const padding = [left, top, right, bottom];
    if (padding.every((side, i) => side === this.#padding[i])) return;
    this.#padding = padding;
    this.applyPadding(false);
    this.#frames.wake();
  }
  applyPadding(atOnce = true) {
    const { app, canvas, loaded } = this.#session;
    const [width, height] = [canvas.clientWidth || 1, canvas.clientHeight || 1];
    app?.setPadding(this.#padding.map((side, i) => side / (i % 2 ? height : width)), atOnce || !loaded);
  }

  // --- settings ---

  setSetting(name, value) {
    const { app, loaded, wantedSettings } = this.#session;
    // The file of the first model brings settings of its own.
    if (!loaded) wantedSettings.set(name, value);
    if (!app) return;
    app.setSetting(name, value);
    this.#frames.afterChange();
  }

  getSetting(name) {
    const { app, wantedSettings } = this.#session;
    return app ? app.getSetting(name) : wantedSettings.get(name);
  }

  // --- what was asked for before there was a program, and before there was a model ---

  toProgram() {
    // Not before: the document holds whoever listens, and an element that was removed stands ready without a program.
    this.#reducedMotion.addEventListener('change', this.#onMotion, { signal: this.#stop.signal });
    const { app, options, wantedSettings } = this.#session;
    app.governed = qualities[options.quality].governed;
    app.setFrameBudget(options.frameBudget);
    this.#applyPreset();
    for (const [name, value] of wantedSettings) app.setSetting(name, value);
    for (const name of forProgram) this.#apply(name);
    this.applyPadding();
  }

  /** Over what it brought. */
  settingsToModel() {
    const { app, wantedSettings } = this.#session;
    this.#session.flushWarnings();
    this.#applyPreset(true);
    for (const [name, value] of wantedSettings) app.setSetting(name, value);
    app.takeWarnings();  // of values that were refused, and told, when they were set first
    app.settingsCameWithModel();
  }
  waterToModel() {
    const { app, options } = this.#session;
    if (options.wetness !== '') app.setWetness(options.wetness);
  }
  cameraToModel() {
    for (const name of forModel) this.#apply(name);
  }
}
