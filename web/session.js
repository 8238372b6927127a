// What the parts of one WetFur share: its canvas and context, the program at work, what that shows, what was asked for, and
// how all of it is told. The lowest part: it knows none of the others.
import { Attachment } from './attachment.js';
import { forgetProgram } from './contexts.js';
import { optionDefaults, qualities } from './options.js';
import { Screen } from './screen.js';

const maxWarnings = 100;
const wetnessCheckMilliseconds = 200;

/**
 * @typedef {object} SessionEvents what the screen does
 * @property {(width: number, height: number, pixelRatio: number) => void} onResize
 * @property {(visible: boolean) => void} onVisible
 * @property {(atOnce?: boolean) => void} comeBack there is a context again: draw
 */
export class Session {
  /** @type {import('./furapp.js').FurApp | null} */
  app = null;
  /** @type {import('./editor.js').EditorPanel | null} */
  panel = null;
  /** Which program `app` is in: 'viewer', 'hair' (the viewer with long hair and all formats) or 'editor'. */
  program = 'viewer';
  /** Whether something here has needed more than the viewer's program: undo may lead back to it. */
  needsLarger = false;
  /** The model that is shown, or about to be. @type {import('./models.js').ModelSource | null} */
  source = null;
  /** Whether any has been. */
  shown = false;
  cameWith = null;  // groom and long hair of the file that is shown, water of a link; null: not known
  changesAtLoad = 0;  // what the program's `changes` was when it had come
  options = { ...optionDefaults };
  /** Settings that were asked for before the program was there. */
  wantedSettings = new Map();
  /** The newest, oldest first. */
  warnings = [];
  /** The part of `state` that loading makes. */
  phase = 'idle';

  #target;
  #toldChanges = 0;
  #lastCamera = '';
  #lastAction = '';
  #lastWetness = 0;
  #lastWetnessCheck = 0;

  /** @param {EventTarget} target gets the events @param {HTMLCanvasElement} canvas @param {SessionEvents} events */
  constructor(target, canvas, { onResize, onVisible, comeBack }) {
    this.#target = target;
    this.canvas = canvas;
    this.screen = new Screen(canvas, {
      onResize,
      onVisible,
      onRelease: () => this.context.onRelease(),
      onLost: () => this.context.onLost(),
      gpuBytes: () => this.app?.stats.gpuBytes ?? 0,
    });
    const session = this;
    this.context = new Attachment(this.screen, {
      get app() { return session.app; },
      get panel() { return session.panel; },
      get antialias() { return qualities[session.options.quality].antialias; },
      comeBack,
      emit: (type, detail) => this.emit(type, detail),
      stateChanged: () => this.tellState('loading'),
      warn: (message) => this.warn(message),
    });
  }

  get loaded() { return this.shown && this.source !== null; }
  /** Whether a person can do anything with it: then it takes the focus and pointers. */
  get interactive() { return this.options.cameraControls || (this.app?.tool ?? this.options.tool) !== 'none' || this.panel !== null; }
  get state() {
    if (this.phase !== 'ready') return this.phase;
    if (!this.screen.visible) return 'suspended';
    return this.context.mending ? 'lost' : this.screen.live ? 'ready' : 'suspended';
  }

  emit(type, detail) { this.#target.dispatchEvent(new CustomEvent(type, { detail })); }
  tellState(reason) { this.emit('state-change', { state: this.state, reason }); }
  setPhase(phase) {
    if (phase === this.phase) return;
    this.phase = phase;
    this.tellState('loading');
  }

  warn(message) {
    console.warn(`wet-fur: ${message}`);
    this.warnings.push(message);
    if (this.warnings.length > maxWarnings) this.warnings.shift();
    this.emit('warning', { message });
  }
  flushWarnings() { this.app?.takeWarnings().forEach((message) => this.warn(message)); }

  tellSettings() {
    this.#toldChanges = this.app?.changes;
    this.tellState('settings');
  }

  #tellAction() {
    const { action } = this.app;
    if (action === this.#lastAction) return;
    if (this.#lastAction) this.emit('action-end', { action: this.#lastAction });
    if (action) this.emit('action-start', { action });
    this.#lastAction = action;
  }

  /** What a person changed on the canvas or in the panel, and what time did; `last`: no frame follows. */
  tellChanges(last) {
    if (this.app.changes !== this.#toldChanges) this.tellSettings();
    const camera = JSON.stringify(this.app.camera);
    if (camera !== this.#lastCamera) {
      this.#lastCamera = camera;
      this.emit('camera-change', { orbit: this.app.camera });
    }
    this.#tellAction();
    const now = performance.now();
    if (!last && now - this.#lastWetnessCheck < wetnessCheckMilliseconds) return;
    this.#lastWetnessCheck = now;
    const wetness = this.app.meanWetness;
    if (wetness === this.#lastWetness) return;
    this.#lastWetness = wetness;
    this.emit('wetness-change', { wetness });
  }

  dispose() {
    this.context.dispose();
    this.panel?.dispose();
    this.panel = null;
    this.screen.close();
    this.app?.destroy();
    if (this.program === 'editor') forgetProgram(this.app.program);
    this.app = this.source = null;
    this.phase = 'disposed';
  }
}
