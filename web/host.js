// One furry model on one canvas: what createWetFur() returns and <wet-fur> stands on. It makes the parts and is what others
// see of them. Calls go down this list, what happens comes up as events: loading and editing, applied options, frames, session.
import { elementMethods, elementQueries } from '#tables';
import { AppliedOptions } from './applied.js';
import { BrushRing } from './brushring.js';
import { Editing } from './editing.js';
import { asFurError, FurError } from './errors.js';
import { Frames } from './frames.js';
import { forEach } from './furapp.js';
import { Input } from './input.js';
import { pictureOfText } from './lettering.js';
import { breathe, Loading } from './loading.js';
import { acceptedFiles, readGiven, readModel, readPicture, sortFiles } from './models.js';
import { optionDefaults, settingsObject } from './options.js';
import { orbitText } from './orbit.js';
import { Session } from './session.js';

/** Behind the fur types, where pictures are told apart. */
const skin = 4;

/** What is told of no model, by kinds of results. */
const emptyOf = { Truth: false, Number: 0, Text: '', Hash: '', Lines: [] };

export class WetFur extends EventTarget {
  #session;
  #frames;
  #ring;
  #input;
  #applied;
  #loading;
  #editing;
  #src = '';
  #settings;

  /** @param {HTMLCanvasElement} canvas @param {object} options as WetFurOptions in types.d.ts */
  constructor(canvas, options = {}) {
    super();
    const session = this.#session = new Session(this, canvas, {
      onResize: (width, height, ratio) => this.#onResize(width, height, ratio),
      onVisible: (visible) => this.#onVisible(visible),
      comeBack: (atOnce) => this.#comeBack(atOnce),
    });
    const frames = this.#frames = new Frames(session, {
      onModelStep: () => this.#loading.bringModel(),
      onDrawn: () => this.#ring.refresh(),
      onCoat: (fraction) => this.#loading.progress('coat', fraction, 1),
    });
    const ring = this.#ring = new BrushRing(session);
    const input = this.#input = new Input(canvas, {
      get app() { return session.phase === 'ready' && session.interactive ? session.app : null; },
      get panel() { return session.panel; },
      get turns() { return session.options.cameraControls; },
      toBuffer: (event) => session.screen.toBuffer(event),
      wake: () => frames.wake(),
      stroke: (phase, detail) => session.emit(`stroke-${phase}`, detail),
      hover: (at, byKey = false) => ring.hover(at, byKey),
    });
    const applied = this.#applied = new AppliedOptions(session, { frames, input, ring, onEditor: (open) => this.#editing.open(open) });
    const loading = this.#loading = new Loading(session, {
      frames, applied, onShown: () => { if (session.options.editor && !session.panel) this.#editing.open(true); },
    });
    this.#editing = new Editing(session, { frames, loading, host: this, openDialog: () => this.#openDialog() });
    this.#settings = settingsObject({
      names: () => this.settingsTable?.map((field) => field.name) ?? [...session.wantedSettings.keys()],
      get: (name) => applied.getSetting(name),
      set: (name, value) => applied.setSetting(name, value),
    });
    for (const [name, value] of Object.entries(options)) if (name !== 'src') this.set(name, value);
    if (options.src) this.src = options.src;
  }

  get #app() { return this.#session.app; }

  // --- what it is doing ---

  get canvas() { return this.#session.canvas; }
  get loaded() { return this.#session.loaded; }
  get ready() { return this.#loading.ready; }
  get state() { return this.#session.state; }
  get interactive() { return this.#session.interactive; }
  get editorOpen() { return this.#session.panel !== null; }
  get settings() { return this.#settings; }
  get warnings() { return this.#session.warnings; }
  get stats() { return this.#app?.stats ?? null; }
  get settingsTable() { return this.#app?.settingsTable ?? null; }
  get presets() { return this.#app?.presets ?? null; }
  get modelName() { return this.#session.source?.name ?? ''; }
  /** Another number whenever the settings, the tool or what can be undone have changed. @internal */
  get changes() { return this.#app?.changes; }

  // --- options and settings ---

  /** An option of WetFurOptions or a settings field; before the model is there it is kept for it. */
  set(name, value) {
    if (name === 'src') this.src = value;
    else if (name in optionDefaults) this.#applied.setOption(name, value);
    else this.#applied.setSetting(name, value);
  }
  get(name) {
    if (name === 'src') return this.#src;
    return name in optionDefaults ? this.#applied.getOption(name) : this.#applied.getSetting(name);
  }

  /** What lies over the picture at its edges, in CSS pixels: the model is shown in the middle of the rest. */
  setPadding(padding) { this.#applied.setPadding(padding); }

  // --- loading and saving ---

  get src() { return this.#src; }
  set src(value) {
    this.#src = String(value ?? '');
    if (this.#src) this.#loading.loadSrc(this.#src).catch(() => {});  // `ready` and the error event carry it
  }

  /** Fetches `src` again: after an error, or because the file changed. */
  reload() { return this.#session.phase === 'loading' ? this.ready : this.#loading.loadSrc(this.#src); }

  /**
   * A File, Blob, ArrayBuffer or typed array with a model (src/scene/Formats.inc). Rejects with a FurError, and
   * then the old scene stays.
   */
  async loadModel(given, options) { await this.#loading.load(() => readModel(given, options)); }
  /**
   * The same with a type set (.fts) or a saved coat (.coat), for the fur type 1 to 4, by default the one that the
   * editor edits, else 1: its coat is drawn until a setting changes that grows another.
   * Waits for the model. Rejects with a FurError, and then the old coat stays.
   */
  async loadTypeSet(given, { name, type = (this.#session.panel?.coatType ?? 0) + 1 } = {}) { await this.#loading.loadTypeSet(given, name, type - 1); }
  /** A picture as the colour map of a fur type, 1 to 4, or of the 'skin', in the model's texture coordinates; null takes it away. */
  async setTypePicture(type, given) { await this.#loading.setTypePicture(type === 'skin' ? skin : type - 1, given); }

  /** The coat as .fts, the model with its fur coordinates as .fo, the whole scene as .glb: Uint8Arrays. */
  saveTypeSet(type = 1) { return this.#editing.inWorkshop((app) => app.saveTypeSet(type - 1)); }
  /** A type's whole coat under a name, by default its own, as .coat: for loadTypeSet(). */
  saveCoat({ name = '', type = 1 } = {}) { return this.#editing.inWorkshop((app) => app.saveCoat(name, type - 1)); }
  saveFo() { return this.#editing.inWorkshop((app) => app.saveFo()); }
  /** The strands of the selected scalp as .hair. */
  saveHair() { return this.#editing.inWorkshop((app) => app.saveHairFile()); }
  async save() {
    const tell = async (done) => {
      this.#loading.progress('save', done, 3);
      if (done < 3) await breathe();
    };
    try {
      await tell(1);
      return await this.#editing.inWorkshop(async (app) => {
        for (const what of app.lostBySaving) this.#session.warn(`save() leaves out ${what}`);
        await tell(2);
        return app.saveScene();
      });
    } finally {
      await tell(3);
    }
  }
  lostBySaving() { return this.#editing.inWorkshop((app) => app.lostBySaving); }

  /** All there is to keep of the scene, for openDocument() of another visit. @internal */
  get document() { return this.#loading.document; }
  /** Groom and long hair that the file brought, each false for none, and water that a link brought; null: not known. @internal */
  get cameWith() { return this.#session.cameWith; }
  /** What `changes` was when the model had come. @internal */
  get changesAtLoad() { return this.#session.changesAtLoad; }
  /** Groom, long hair and water as there, on the model that is shown; undo does not lead behind them. @internal */
  async takeParts({ groom, hair, water }) {
    if (groom) this.#app.restoreGroom(groom, false);
    if (hair) await this.#editing.takeHair(hair, false);
    if (water) {
      this.#app.water = water;
      this.#session.cameWith = { ...this.#session.cameWith, water };
    }
    this.#frames.afterChange();
  }
  /** Shows it; of a shipped model `source` need only name it as `src`. @internal */
  openDocument(document) { return this.#loading.openDocument(document); }

  /** The model as it came, dry, with the look that it brought or the default but for `settings`. Undo takes that back. */
  async reset(settings = {}) {
    if (this.loaded) await this.#loading.reset(settings);
  }

  #openDialog() {
    const input = Object.assign(document.createElement('input'), { type: 'file', accept: acceptedFiles, multiple: true });
    input.addEventListener('change', async () => {
      const { model, typeSet, hair, image, others } = sortFiles(input.files);
      try {
        if (image) await this.loadPicture(image);
        else if (model ?? others[0]) await this.loadModel(model ?? others[0], { files: others });
        if (typeSet) await this.loadTypeSet(typeSet);
        if (hair) await this.loadHair(hair);
      } catch {
        // The error event carries it.
      }
    });
    input.click();
  }

  // --- water ---

  /** At {u, v} of the atlas or {x, y} in CSS pixels of the canvas; whether it hit the model. */
  splash(at, { radius = this.settings.brushRadius, amount = this.settings.brushFlow } = {}) {
    if (!this.loaded) return false;
    const hit = 'u' in at
      ? (this.#app.splashAt(at.u, at.v, radius, amount), true)
      : this.#app.splashPixel(...this.#cssToBuffer(at), radius, amount);
    this.#frames.wake();
    return hit;
  }
  dry(seconds = Infinity) {
    if (!this.loaded) return;
    if (seconds === Infinity) this.#app.setWetness(0);
    else this.#app.dry(seconds);
    this.#frames.wake();
  }
  /** Letters as clumps of wet fur, round {x, y} in CSS pixels of the canvas (default: its middle), `size` high, turned by `angle` (radians, clockwise). */
  stamp(text, { x = this.canvas.clientWidth / 2, y = this.canvas.clientHeight / 2, size = 96, angle = 0, amount = 0.7 } = {}) {
    if (!this.loaded || !text) return;
    const picture = pictureOfText(text, size, angle);
    const [left, top] = this.#cssToBuffer({ x, y });
    const ratio = this.#session.screen.width / this.canvas.clientWidth;
    this.#app.stamp(picture, left, top, picture.width * ratio, amount);
    this.#frames.wake();
  }
  /** What was painted since the model came, as text for replay(). */
  get recordedStrokes() { return this.#app?.recordedStrokes ?? '[]'; }
  /** Paints it again, with the time that it took. `undoable` false: the scene begins with it. */
  replay(strokes, { undoable = true } = {}) {
    if (!this.loaded) return;
    this.#app.replay(strokes);
    if (!undoable) this.#app.restoreHistory(new Uint8Array());
    this.#frames.afterChange();
  }
  /** Where the water is and went, in square model radii of soaked fur. */
  get waterAccounts() { return this.#app?.waterAccounts ?? null; }
  /** The atlas coordinates under {x, y} in CSS pixels of the canvas, or null. */
  pick(at) { return this.loaded ? this.#app.pick(...this.#cssToBuffer(at)) : null; }
  /** Where the keys' cursor is: null beside the model, undefined while nobody uses it. @internal */
  get spotWetness() { return this.#ring.spotWetness; }
  /** @internal an SVG polygon over the canvas: the brush's footprint */
  set ring(polygon) { this.#ring.polygon = polygon; }

  #cssToBuffer({ x, y }) {
    const box = this.canvas.getBoundingClientRect();
    return this.#session.screen.toBuffer({ clientX: box.left + x, clientY: box.top + y });
  }

  // --- groom ---

  /** All over the model: the edits of app/tools/GroomEdits.inc. `color`: of markings, "#rrggbb", in place of the setting paintColor. */
  async groom(edit, value = 1, direction = [0, -1, 0], { color } = {}) {
    if (color !== undefined && !/^#[0-9a-f]{6}$/i.test(color)) throw new FurError('bad-file', `groom: the color "${color}" is not #rrggbb`);
    if (edit !== 'clear') return this.#editing.groomInWorkshop((app) => app.groomAll(edit, value, direction, color));
    if (!this.loaded) return;
    this.#app.clearGroom();
    this.#frames.afterChange();
  }
  /** What the model is made of: [{ name, triangles, furry }]. */
  get materials() { return this.loaded ? JSON.parse(this.#app.materials) : []; }
  /** Whether fur grows on one of several materials, by its number. */
  setFurry(material, furry) {
    this.#app?.setFurry(material, furry);
    this.#frames.afterChange();
  }
  /** The number of the material under CSS pixels of the canvas; -1 beside the model. */
  materialAt(at) {
    const [x, y] = this.#cssToBuffer(at);
    return this.loaded ? this.#app.materialAt(x, y) : -1;
  }
  /** Long hair: the edits of app/tools/HairEdits.inc. */
  async hair(edit, value = 1, direction = [0, 0, 0]) {
    await this.ready;
    return this.#editing.hairInWorkshop((app) => app.editHair(edit, value, direction));
  }
  /** Strands of a .hair file as guides. Rejects with a FurError, and then the hair stays as it was. */
  async loadHair(given, { name } = {}) {
    await this.ready;
    try {
      const { bytes, name: file } = await readGiven(given, name ?? given?.name ?? 'strands.hair');
      await this.#editing.hairInWorkshop((app) => app.loadHair(bytes, file));
    } catch (error) {
      throw this.#loading.failed(asFurError(error, error instanceof RangeError ? 'out-of-memory' : 'bad-file'));
    }
  }
  setHairValue(scalp, name, value) {
    this.#app?.setHairValue(scalp, name, String(value));
    this.#frames.afterChange();
  }
  get scalps() { return this.loaded ? JSON.parse(this.#app.scalps) : []; }
  /** A picture, and what it is of app/tools/PictureUses.inc; without that, the person is asked. Whether it was used. */
  async loadPicture(given, { as } = {}) {
    await this.ready;
    const name = given.name ?? '', image = await this.#decode(given);
    // One that "Save maps" wrote says what it is.
    const known = as ?? (/-map-(length|types|paint|mask|shape)( \(\d+\))?\.png$/.test(name) ? 'length' : null);
    const use = known ?? await (await import('./askpicture.js')).askPicture(name, this.canvas);
    if (!use) return false;
    if (use === 'skin' || use === 'typeColor') {
      await this.setTypePicture(use === 'skin' ? use : Number(this.settings.groomType), given);
      return true;
    }
    const hadWarned = [];
    await this.#editing.groomInWorkshop((app) => {
      app.usePicture(use, name, image);
      hadWarned.push(...app.takeWarnings());
    });
    for (const warning of hadWarned) this.#session.warn(warning);
    return true;
  }
  /** An image in the model's texture coordinates: black is bald. */
  async loadLengthMap(image) { await this.#loadGroomImage(0, image); }
  /** The same: red, green and blue are the presence of the fur types 2, 3 and 4. */
  async loadTypeMap(image) { await this.#loadGroomImage(1, image); }
  async #loadGroomImage(what, given) {
    await this.ready;
    const image = await this.#decode(given);
    await this.#editing.groomInWorkshop((app) => app.groomFromImage(what, given.name ?? '', image));
  }

  async #decode(given) {
    try {
      return (await readPicture(this.#app, given)).image;
    } catch (error) {
      throw this.#loading.failed(asFurError(error, 'bad-file'));
    }
  }

  // --- time, history, state, view ---

  play() { this.set('paused', false); }
  pause() { this.set('paused', true); }
  /** n steps of dt seconds and one frame, at once, whatever the page's own clock does. */
  step(dt, n = 1) {
    if (this.loaded) this.#frames.step(dt, n);
  }

  undo() { return this.#history('undo'); }
  redo() { return this.#history('redo'); }
  #history(way) {
    const done = this.loaded && this.#app[way]();
    if (done) {
      this.#loading.bringModel();
      this.#frames.afterChange();
    }
    return done;
  }

  /** Model name, settings that differ from the defaults, and camera, as JSON text. */
  getState() { return this.#app?.state ?? '{}'; }
  /** JSON text or the object it stands for; throws a FurError when it cannot be used. */
  setState(state) { this.#loading.setState(typeof state === 'string' ? state : JSON.stringify(state)); }

  getCameraOrbit() { return this.#app?.camera ?? null; }
  /** The same as text for the camera-orbit attribute and links. */
  get cameraOrbitText() { return this.#app ? orbitText(this.#app.camera) : ''; }

  /** A picture of its own size (default: as shown). */
  toBlob(options) { return this.#frames.toBlob(options); }

  // --- the editor ---

  openEditor() { return this.#editing.open(true); }
  closeEditor() { return this.#editing.open(false); }
  /** As the panel's own key: it asks where something would be left out. @internal */
  saveByPanel() {
    this.#session.panel?.key({ key: 's', ctrlKey: true }, true);
    this.#frames.wake();
  }

  // --- what the program does as it is told (web/Methods.inc) ---

  static {
    forEach(elementMethods, (name, result) => {
      this.prototype[name] = function method(...args) {
        if (!this.loaded) return emptyOf[result];
        const value = this.#app[name](...args);
        if (result !== 'Number') this.#frames.wake();
        return value;
      };
    });
    forEach(elementQueries, (name, result) => {
      Object.defineProperty(this.prototype, name, { get() { return this.loaded ? this.#app[name] : emptyOf[result]; } });
    });
  }

  // --- what the screen does ---

  #onResize(width, height, ratio) {
    const { app, context, options, screen } = this.#session;
    if (!app) return;
    context.resize(width, height, ratio);
    this.#applied.applyPadding();
    const draws = screen.live || options.paused;
    if (screen.visible && draws) this.#frames.drawNow();  // until then the old picture is stretched
    this.#frames.wake();
  }

  #onVisible(visible) {
    const { context, loaded, screen } = this.#session;
    if (!loaded) return;
    this.#frames.endRun();
    this.#session.emit('model-visibility', { visible });
    if (!visible) return;
    if (screen.live) this.#frames.wake();
    else context.seen();
  }

  #comeBack(atOnce) {
    const { context, loaded, options } = this.#session;
    if (atOnce || options.paused) this.#frames.drawNow();
    else if (loaded) context.draws();
    this.#frames.wake();
  }

  dispose() {
    if (this.#session.phase === 'disposed') return;
    for (const part of [this.#loading, this.#applied, this.#frames, this.#ring, this.#input, this.#session]) part.dispose();
  }
}
