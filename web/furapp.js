// app/App.h as JavaScript methods: one handle in one Program. Positions are pixels of the drawing buffer.
// What crosses as it is (web/Methods.inc) becomes methods and getters at the end of the class.
import { methods, queries } from '#tables';
import { readableField } from './field.js';

const ringCorners = 64;  // App::kRingCorners
export const phases = ['down', 'move', 'up', 'cancel'];
export const pointerKinds = ['mouse', 'touch', 'pen'];
export const pictures = { best: 0, moving: 1, still: 2 };
const statNames = [
  'vertices', 'triangles', 'strands', 'layers', 'finEdges', 'cpuBytes', 'gpuBytes', 'uploadedBytes', 'framesDrawn',
  'level', 'pixels', 'frameTime',
];

const accountNames = ['held', 'film', 'drops', 'hair', 'dripped', 'evaporated', 'removed', 'painted', 'rained'];

/** Bit 0 shift, 1 control (or the command key), 2 alt. */
export const modifiersOf = (event) =>
  (event.shiftKey ? 1 : 0) | (event.ctrlKey || event.metaKey ? 2 : 0) | (event.altKey ? 4 : 0);

/** Calls back with each name and the kind of its result. */
export function forEach(names, work) {
  for (const [result, some] of Object.entries(names)) for (const name of some) work(name, result);
}

export class FurApp {
  constructor(program) {
    this.program = program;
    this.handle = program.callOrThrow('fur_create');
    program.tables ??= {
      presets: Object.freeze(JSON.parse(program.text(program.call('fur_presetTable')))),
      settingsTable: Object.freeze(JSON.parse(program.text(program.call('fur_settingsTable'))).map(readableField)),
    };
    Object.assign(this, program.tables);
  }

  #screen = null;  // where it draws
  /** Whether the program failed at what it was to do for this one. */
  failed = false;

  // Any call may reach the context, and others may have drawn in another meanwhile.
  #through(way, name, args) {
    const failedBefore = this.program.failure !== null;
    try {
      this.#screen?.context.use(this.program);
      return this.program[way](name, this.handle, ...args);
    } finally {
      this.failed ||= !failedBefore && this.program.failure !== null;
    }
  }
  #call(name, ...args) { return this.#through('call', name, args); }
  #callOrThrow(name, ...args) { return this.#through('callOrThrow', name, args); }
  #text(name, ...args) { return this.program.text(this.#call(name, ...args)); }

  /** @param {import('./screen.js').Screen} screen in whose context it has nothing yet */
  attach(screen) {
    this.#callOrThrow('fur_attach', screen.context.pointerIn(this.program));
    this.#screen = screen;
  }
  /** Deletes what it made in the context, which may have been lost. */
  detach() {
    if (this.#screen && !this.program.failure) this.#call('fur_detach', 0);
    this.#screen = null;
  }
  /** Calls back when the program fails, at whatever it does for anyone. */
  onFailure(work) {
    this.#onFailure = work;
    this.program.onFailure.add(work);
  }
  #onFailure = null;
  destroy() {
    this.program.onFailure.delete(this.#onFailure);
    if (!this.program.failure) this.#call('fur_destroy');
    this.handle = 0;
  }
  /**
   * @param {Map<string, Uint8Array>} files what came along, by the name that the model uses
   * @param {boolean} keepState not the settings that a saved scene brings
   */
  loadModel(bytes, name, files, keepState = false) {
    this.#stage(files);
    this.#callOrThrow('fur_loadModel', bytes, bytes.byteLength, name, keepState ? 1 : 0);
  }
  #stage(files) {
    this.program.call('fur_clearStagedFiles');
    for (const [fileName, content] of files)
      this.program.callOrThrow('fur_stageFile', fileName, content, content.byteLength);
  }
  /** The same in pieces: workOnComing() until it returns true, and showComing(). */
  beginModel(bytes, name, files) {
    this.#stage(files);
    this.#callOrThrow('fur_beginModel', bytes, bytes.byteLength, name);
  }
  /** About so many seconds of work; whether that was all. */
  workOnComing(seconds) { return this.#callOrThrow('fur_workOnComing', seconds) === 1; }
  /**
   * The same of what the next picture needs: 1 that was all, 2 it goes on, 3 it waits for the driver. `coarse`: with a coat of fewer
   * layers, where none is shown yet; the whole one follows by tick().
   */
  workOnPicture(seconds, coarse) { return this.#callOrThrow('fur_workOnPicture', seconds, coarse ? 1 : 0); }
  /** What was made of the model, as bytes that spare the editor's program with the same state most of its next loadModel(). */
  get surface() { return this.#saved('fur_saveSurface'); }
  /** `type`: of the fur, 0 to 3. */
  loadTypeSet(bytes, name, type = 0) { this.#callOrThrow('fur_loadTypeSet', bytes, bytes.byteLength, name, type); }
  /** Its colour map: a file (PNG, JPEG, WebP) and what is in it. */
  setTypePicture(type, bytes, { width, height, data }) {
    this.#callOrThrow('fur_setTypePicture', type, bytes, bytes.byteLength, width, height, data);
  }
  /** Throws where a picture has more pixels than are read. */
  checkPicture(bytes, name) { this.program.callOrThrow('fur_checkPicture', bytes, bytes.byteLength, name); }
  /** Colour maps that the scene has brought and nobody has decoded: [{ number, bytes }]. */
  pendingPictures() {
    const all = [];
    for (let number; (number = this.#call('fur_pendingPicture', all.length) >>> 0) !== 0;)
      all.push({ number, bytes: this.#saved('fur_typePicture', number) });
    return all;
  }
  provideTypePicture(number, { width, height, data }) { this.#callOrThrow('fur_provideTypePicture', number, width, height, data); }
  #saved(name, ...args) {
    const byteLength = this.#callOrThrow(name, ...args);
    const bytes = this.program.array(Uint8Array, this.program.call('fur_savedBytes'), byteLength);
    this.program.call('fur_forgetSavedBytes');
    return bytes;
  }
  /** The model's own picture, encoded, or null. */
  pendingImage() {
    const mimeType = this.#text('fur_imageType');
    if (!mimeType) return null;
    const [byteLength, width, height] = this.program.numbers(this.#call('fur_imageInfo'), 3);
    return { mimeType, width, height, bytes: this.program.array(Uint8Array, this.#call('fur_imageBytes'), byteLength) };
  }
  provideImage(width, height, rgba) { this.#callOrThrow('fur_provideImage', width, height, rgba); }

  /** Number, boolean, option name or "#rrggbb"; undefined for an unknown name. */
  getSetting(name) {
    if (name === 'skin.picture') return this.#text('fur_getSetting', name);
    if (name === 'lightRig') return this.#text('fur_getSetting', name) || undefined;
    const [, ofType] = /^type[1-4]\.(\w+)$/.exec(name) ?? [];
    const field = this.settingsTable.find((one) => (ofType ? one.ofType && one.name === ofType : one.name === name));
    if (!field) return ofType && ['name', 'picture', 'typeSet'].includes(ofType) ? this.#text('fur_getSetting', name) : undefined;
    const text = this.#text('fur_getSetting', name);
    if (field.type === 'bool') return text === 'true';
    return field.type === 'float' || field.type === 'int' ? Number(text) : text;
  }
  setSetting(name, value) { return this.#call('fur_setSetting', name, String(value)) !== 0; }
  /** The preset whose coat it is, or ''. Setting a name that is none warns. */
  get preset() { return this.#text('fur_getPreset'); }
  set preset(name) { this.#call('fur_applyPreset', name, 0); }
  get camera() {
    const [yaw, pitch, distance, ...target] = this.program.numbers(this.#call('fur_getCamera'), 6);
    return { yaw, pitch, distance, target };
  }
  set camera({ yaw, pitch, distance, target }) { this.#call('fur_setCamera', yaw, pitch, distance, ...target); }
  get state() { return this.#text('fur_getState'); }
  set state(json) { this.#callOrThrow('fur_setState', json); }
  /** As bytes; `leaves`: another model comes now, to which a redo will lead. */
  saveHistory(leaves) { return this.#saved('fur_saveHistory', leaves ? 1 : 0); }
  restoreHistory(bytes) { this.#callOrThrow('fur_restoreHistory', bytes, bytes.byteLength); }
  takeWarnings() { return this.program.lines(this.#call('fur_takeWarnings')); }

  get tool() { return this.#text('fur_getTool'); }
  set tool(name) { this.#call('fur_setTool', name); }
  stamp({ coverage, width, height }, x, y, across, amount) {
    this.#call('fur_stamp', coverage, width, height, x, y, across, amount);
  }
  get waterAccounts() {
    const values = this.program.numbers(this.#call('fur_waterAccounts'), accountNames.length);
    return Object.fromEntries(accountNames.map((name, index) => [name, values[index]]));
  }
  /** All of it, and what was done with it, as bytes for another program with the same model. */
  get water() { return this.#saved('fur_saveWater'); }
  set water(bytes) { this.#callOrThrow('fur_restoreWater', bytes, bytes.byteLength); }
  /** Coats from files and colour maps of fur types, as bytes for another program with the same state. */
  get typeFiles() { return this.#saved('fur_saveTypeFiles'); }
  set typeFiles(bytes) { this.#callOrThrow('fur_restoreTypeFiles', bytes, bytes.byteLength); }
  /** As bytes, for another program with the same model. */
  get groom() { return this.#saved('fur_saveGroom'); }
  restoreGroom(bytes, undoable) { this.#callOrThrow('fur_restoreGroom', bytes, bytes.byteLength, undoable ? 1 : 0); }
  /** The same of long hair; without any there are none. */
  get hair() { return this.haired ? this.#saved('fur_saveHair') : new Uint8Array(); }
  restoreHair(bytes, undoable) { this.#callOrThrow('fur_restoreHair', bytes, bytes.byteLength, undoable ? 1 : 0); }
  // These are in the editor's program only.
  giveSurface(bytes) { this.#callOrThrow('fur_giveSurface', bytes, bytes.byteLength); }
  saveTypeSet(type = 0) { return this.#saved('fur_saveTypeSet', type); }
  saveCoat(name, type = 0) { return this.#saved('fur_saveCoat', name, type); }
  saveFo() { return this.#saved('fur_saveFo'); }
  saveHairFile() { return this.#saved('fur_saveHairFile'); }
  loadHair(bytes, name) { this.#callOrThrow('fur_loadHair', bytes, bytes.byteLength, name); }
  get lostBySaving() { return this.program.lines(this.#call('fur_lostBySaving')); }
  saveScene() { return this.#saved('fur_saveScene'); }
  groomAll(edit, value, [x, y, z], color = '') { this.#callOrThrow('fur_groomAll', edit, value, x, y, z, color ? parseInt(color.slice(1), 16) : -1); }
  editHair(edit, value, [x, y, z]) { this.#callOrThrow('fur_editHair', edit, value, x, y, z); }
  usePicture(use, name, { width, height, data }) { this.#callOrThrow('fur_usePicture', use, name, width, height, data); }
  groomFromImage(what, name, { width, height, data }) { this.#callOrThrow('fur_groomFromImage', what, name, width, height, data); }
  /** {u, v} of the surface under the pixel, or null. */
  pick(x, y) {
    const hit = this.program.numbers(this.#call('fur_pick', x, y), 2);
    return hit && { u: hit[0], v: hit[1] };
  }

  /** Where keys put the tool to work. */
  get cursor() { return this.program.numbers(this.#call('fur_cursor'), 2); }
  /** x, y, x, y, ... round what the tool would reach from there, or null. */
  brushRing(x, y) {
    const points = this.#call('fur_brushRing', x, y);
    return points ? this.program.array(Float32Array, points, 2 * ringCorners) : null;
  }

  pointer(phase, event, x, y) {
    return this.#call('fur_pointer', phases.indexOf(phase), Math.max(0, pointerKinds.indexOf(event.pointerType)),
      event.pointerId, x, y, event.buttons, modifiersOf(event), event.pressure ?? 1) !== 0;
  }
  key(event, down = true) { return this.#call('fur_key', event.key, modifiersOf(event) | (down ? 0 : 8)) !== 0; }
  /** 0: as it is seen; 1: for a picture that is saved; 3: without what is behind the model. */
  set saved(how) { this.#call('fur_setSaved', how); }
  /** Shares of the picture from its left, top, right and bottom edge. */
  setPadding(shares, atOnce) { this.#call('fur_setPadding', ...shares, atOnce ? 1 : 0); }

  /** `coatBudget`: seconds that may go into a coat that grows. */
  tick(seconds, coatBudget = 1e9) { return this.#call('fur_tick', seconds, coatBudget) !== 0; }
  /** For `pictures.best`, `.moving` or `.still`, as app/App.h tells. */
  draw(picture = pictures.best, samples = 1) {
    this.#screen.fit();
    this.#callOrThrow('fur_draw', picture, samples);
  }
  set governed(governed) { this.#call('fur_setQuality', 0, governed ? 1 : 0); }
  /** A step towards the best picture; whether there is another one to show. */
  improve() {
    this.#screen.fit();
    return this.#callOrThrow('fur_improve') === 1;
  }
  /** What has been gathered of the picture, once more; false: draw it. */
  showAgain() {
    this.#screen.fit();
    return this.#callOrThrow('fur_showAgain') === 1;
  }
  get stats() {
    const values = this.program.numbers(this.#call('fur_stats'), statNames.length);
    return Object.fromEntries(statNames.map((name, index) => [name, values[index]]));
  }

  #crossing(name, result, args) {
    if (result === 'Done') return void this.#callOrThrow(name, ...args);
    const value = this.#call(name, ...args);
    if (result === 'Number' || result === 'Nothing') return value;
    if (result === 'Truth') return value !== 0;
    return result === 'Lines' ? this.program.lines(value) : this.program.text(value);
  }

  static {
    forEach(methods, (name, result) => {
      this.prototype[name] = function method(...args) { return this.#crossing(`fur_${name}`, result, args); };
    });
    forEach(queries, (name, result) => {
      Object.defineProperty(this.prototype, name, { get() { return this.#crossing(`fur_${name}`, result, []); } });
    });
  }
}
