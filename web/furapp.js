// app/App.h as JavaScript methods: one handle in one Program. Positions are pixels of the drawing buffer.

export const phases = ['down', 'move', 'up', 'cancel'];
export const pointerKinds = ['mouse', 'touch', 'pen'];
export const pictures = { best: 0, moving: 1, still: 2 };
const statNames = [
  'vertices', 'triangles', 'strands', 'layers', 'finEdges', 'cpuBytes', 'gpuBytes', 'uploadedBytes', 'framesDrawn',
  'level', 'pixels', 'frameTime',
];

const accountNames = ['held', 'film', 'drops', 'dripped', 'evaporated', 'removed', 'painted', 'rained'];

/** Bit 0 shift, 1 control (or the command key), 2 alt. */
export const modifiersOf = (event) =>
  (event.shiftKey ? 1 : 0) | (event.ctrlKey || event.metaKey ? 2 : 0) | (event.altKey ? 4 : 0);

export class FurApp {
  constructor(program) {
    this.program = program;
    this.handle = program.callOrThrow('fur_create');
    this.presets = Object.freeze(JSON.parse(program.text(program.call('fur_presetTable'))));
    this.settingsTable = Object.freeze(JSON.parse(program.text(program.call('fur_settingsTable'))).map(readableField));
  }

  #call(name, ...args) { return this.program.call(name, this.handle, ...args); }
  #callOrThrow(name, ...args) { return this.program.callOrThrow(name, this.handle, ...args); }
  #text(name, ...args) { return this.program.text(this.#call(name, ...args)); }

  attach() { this.#callOrThrow('fur_attach'); }
  /** Deletes what it made in the context, which may have been lost. */
  detach() { this.#call('fur_detach', 0); }
  destroy() {
    this.#call('fur_destroy');
    this.handle = 0;
  }
  resize(width, height, pixelRatio) { this.#call('fur_resize', width, height, pixelRatio); }

  loadPrimitive(name) { this.#callOrThrow('fur_loadPrimitive', name); }
  /**
   * @param {Map<string, Uint8Array>} files what came along, by the name that the model uses
   * @param {boolean} keepState not the settings that a saved scene brings
   */
  loadModel(bytes, name, files, keepState = false) {
    this.program.call('fur_clearStagedFiles');
    for (const [fileName, content] of files)
      this.program.callOrThrow('fur_stageFile', fileName, content, content.byteLength);
    this.#callOrThrow('fur_loadModel', bytes, bytes.byteLength, name, keepState ? 1 : 0);
  }
  loadTypeSet(bytes, name) { this.#callOrThrow('fur_loadTypeSet', bytes, bytes.byteLength, name); }
  #saved(name, ...args) {
    const byteLength = this.#callOrThrow(name, ...args);
    const bytes = this.program.array(Uint8Array, this.program.call('fur_savedBytes'), byteLength);
    this.program.call('fur_forgetSavedBytes');
    return bytes;
  }
  /** Whether it comes from a type set, until a setting changes that grows another. */
  get coatGiven() { return this.#call('fur_coatGiven') !== 0; }
  /** Another number whenever another coat is drawn. */
  get coatRevision() { return this.#call('fur_coatRevision'); }
  /** The model's own picture, encoded, or null. */
  pendingImage() {
    const mimeType = this.#text('fur_imageType');
    if (!mimeType) return null;
    const [byteLength, width, height] = this.program.numbers(this.#call('fur_imageInfo'), 3);
    return { mimeType, width, height, bytes: this.program.array(Uint8Array, this.#call('fur_imageBytes'), byteLength) };
  }
  provideImage(width, height, rgba) { this.#callOrThrow('fur_provideImage', width, height, rgba); }
  /** Names of what the model can play: the setting `animation` counts from 1. */
  get animations() { return this.program.lines(this.#call('fur_animations')); }
  get modelName() { return this.#text('fur_modelName'); }

  /** Number, boolean, option name or "#rrggbb"; undefined for an unknown name. */
  getSetting(name) {
    const field = this.settingsTable.find((one) => one.name === name);
    if (!field) return undefined;
    const text = this.#text('fur_getSetting', name);
    if (field.type === 'bool') return text === 'true';
    return field.type === 'float' || field.type === 'int' ? Number(text) : text;
  }
  setSetting(name, value) { return this.#call('fur_setSetting', name, String(value)) !== 0; }
  /** The preset whose coat it is, or ''. Setting a name that is none warns. */
  get preset() { return this.#text('fur_getPreset'); }
  set preset(name) { this.#call('fur_applyPreset', name); }
  get camera() {
    const [yaw, pitch, distance, ...target] = this.program.numbers(this.#call('fur_getCamera'), 6);
    return { yaw, pitch, distance, target };
  }
  set camera({ yaw, pitch, distance, target }) { this.#call('fur_setCamera', yaw, pitch, distance, ...target); }
  resetCamera() { this.#call('fur_resetCamera'); }
  get state() { return this.#text('fur_getState'); }
  set state(json) { this.#callOrThrow('fur_setState', json); }
  undo() { return this.#call('fur_undo') !== 0; }
  redo() { return this.#call('fur_redo') !== 0; }
  /** -1: the model before this one is to be shown, 1: the one after, 0: neither. Told once. */
  takeModelStep() { return this.#call('fur_takeModelStep'); }
  /** Undo leads from this model to another. */
  followModel() { this.#call('fur_followModel'); }
  /** As bytes; `leaves`: another model comes now, to which a redo will lead. */
  saveHistory(leaves) { return this.#saved('fur_saveHistory', leaves ? 1 : 0); }
  restoreHistory(bytes) { this.#callOrThrow('fur_restoreHistory', bytes, bytes.byteLength); }
  get canUndo() { return this.#call('fur_canUndo') !== 0; }
  /** Another number whenever the settings, the tool or what can be undone have changed. */
  get changes() { return this.#call('fur_changes'); }
  get canRedo() { return this.#call('fur_canRedo') !== 0; }
  takeWarnings() { return this.program.lines(this.#call('fur_takeWarnings')); }

  get tool() { return this.#text('fur_getTool'); }
  set tool(name) { this.#call('fur_setTool', name); }
  splashAt(u, v, radius, amount) { this.#call('fur_splashAt', u, v, radius, amount); }
  splashPixel(x, y, radius, amount) { return this.#call('fur_splashPixel', x, y, radius, amount) !== 0; }
  setWetness(amount) { this.#call('fur_setWetness', amount); }
  dry(seconds) { this.#call('fur_dry', seconds); }
  shake() { this.#call('fur_shake'); }
  stamp({ coverage, width, height }, x, y, across, amount) {
    this.#call('fur_stamp', coverage, width, height, x, y, across, amount);
  }
  get recordedStrokes() { return this.#text('fur_recordedStrokes'); }
  replay(json) { this.#callOrThrow('fur_replay', json); }
  get waterAccounts() {
    const values = this.program.numbers(this.#call('fur_waterAccounts'), accountNames.length);
    return Object.fromEntries(accountNames.map((name, index) => [name, values[index]]));
  }
  wetnessAt(u, v) { return this.#call('fur_wetnessAt', u, v); }
  get meanWetness() { return this.#call('fur_meanWetness'); }
  get wetnessHash() { return this.#text('fur_wetnessHash'); }
  /** All of it, and what was done with it, as bytes for another program with the same model. */
  get water() { return this.#saved('fur_saveWater'); }
  set water(bytes) { this.#callOrThrow('fur_restoreWater', bytes, bytes.byteLength); }
  /** As bytes, for another program with the same model. */
  get groom() { return this.#saved('fur_saveGroom'); }
  restoreGroom(bytes, undoable) { this.#callOrThrow('fur_restoreGroom', bytes, bytes.byteLength, undoable ? 1 : 0); }
  clearGroom() { this.#call('fur_clearGroom'); }
  get groomed() { return this.#call('fur_groomed') !== 0; }
  // These are in the editor's program only.
  saveTypeSet() { return this.#saved('fur_saveTypeSet'); }
  saveFo() { return this.#saved('fur_saveFo'); }
  get lostBySaving() { return this.program.lines(this.#call('fur_lostBySaving')); }
  saveScene() { return this.#saved('fur_saveScene'); }
  groomAll(edit, value, [x, y, z]) { this.#call('fur_groomAll', edit, value, x, y, z); }
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
    return points ? this.program.array(Float32Array, points, 48) : null;
  }

  pointer(phase, event, x, y) {
    return this.#call('fur_pointer', phases.indexOf(phase), Math.max(0, pointerKinds.indexOf(event.pointerType)),
      event.pointerId, x, y, event.buttons, modifiersOf(event), event.pressure ?? 1) !== 0;
  }
  wheel(notches, x, y) { return this.#call('fur_wheel', notches, x, y) !== 0; }
  key(event) { return this.#call('fur_key', event.key, modifiersOf(event)) !== 0; }
  /** 0: as it is seen; 1: for a picture that is saved; 3: without what is behind the model. */
  set saved(how) { this.#call('fur_setSaved', how); }
  /** Shares of the picture from its left, top, right and bottom edge. */
  setPadding(shares, atOnce) { this.#call('fur_setPadding', ...shares, atOnce ? 1 : 0); }
  set autoRotate(enabled) { this.#call('fur_setAutoRotate', enabled ? 1 : 0); }
  set fieldOfView(radians) { this.#call('fur_setFieldOfView', radians); }
  set cameraControls(enabled) { this.#call('fur_setCameraControls', enabled ? 1 : 0); }

  /** `coatBudget`: seconds that may go into a coat that grows. */
  tick(seconds, coatBudget = 1e9) { return this.#call('fur_tick', seconds, coatBudget) !== 0; }
  /** 0..1; 1: the coat in the picture is the one that the settings ask for. */
  get coatProgress() { return this.#call('fur_coatProgress'); }
  get active() { return this.#call('fur_active') !== 0; }
  set reducedMotion(reduced) { this.#call('fur_setReducedMotion', reduced ? 1 : 0); }
  /** For `pictures.best`, `.moving` or `.still`, as app/App.h tells. */
  draw(picture = pictures.best) { this.#callOrThrow('fur_draw', picture); }
  set governed(governed) { this.#call('fur_setQuality', 0, governed ? 1 : 0); }
  set frameBudget(milliseconds) { this.#call('fur_setFrameBudget', milliseconds); }
  frameShown(milliseconds, drawing) { this.#call('fur_frameShown', milliseconds, drawing); }
  /** A step towards the best picture; whether there is another one to show. */
  improve() { return this.#callOrThrow('fur_improve') === 1; }
  get improvable() { return this.#call('fur_improvable') !== 0; }
  invalidate() { this.#call('fur_invalidate'); }
  get stats() {
    const values = this.program.numbers(this.#call('fur_stats'), statNames.length);
    return Object.fromEntries(statNames.map((name, index) => [name, values[index]]));
  }
}

/** A row of the table as people want it: the options as a list, bounds only where they mean something. */
function readableField({ options, min, max, ...field }) {
  if (field.type === 'choice') return Object.freeze({ ...field, options: Object.freeze(options.split('|')) });
  return Object.freeze(field.type === 'float' || field.type === 'int' ? { ...field, min, max } : field);
}
