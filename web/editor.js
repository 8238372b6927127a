/**
 * The editor: Dear ImGui over the picture, in a program of its own that is fetched when it is asked for.
 * `await openEditor(element)`; the scene moves over with its water, and back.
 */
import './host.js';  // which has fetched this: named here, what both need is joined into one file with it
import { download } from './download.js';
import { modifiersOf, phases, pointerKinds } from './furapp.js';
import { coatFileName, deleteOwnCoat, keepOwnCoat, listOwnCoats, ownCoat, ownCoatsChanges, renameOwnCoat } from './owncoats.js';
import { compileProgram } from './runtime.js';
import { savePicture, saveTurntable } from './studio.js';
import { Versions } from './versions.js';

/** @param {import('./types/index.d.ts').WetFurApi} fur */
export const openEditor = (fur) => fur.openEditor();
export const closeEditor = (fur) => fur.closeEditor();

/** Fetches and compiles it before it is needed. */
export async function preloadEditor(onBytes) {
  await compileProgram('editor', onBytes);
}

/** Pixels along the picture of a coat that is kept. */
const ownCoatSide = 112;
const wants = { pointer: 1, text: 4, number: 8 };
// What the person made of the panel's size, kept from visit to visit.
const layoutKey = 'wet-fur-panel';
// For the page's style: how much of the right edge the panel hides.
const widthProperty = '--wet-fur-panel-width';

/**
 * What the panel cannot do itself.
 * @typedef {object} PanelHost
 * @property {import('./host.js').WetFur} fur
 * @property {() => void} wake
 * @property {() => void} openDialog
 */

/** The panel of one app: web/editor/EditorBindings.cpp as methods, and a hidden text field for keyboards on screens. */
export class EditorPanel {
  #app;
  #canvas;
  #host;
  #field = document.createElement('input');
  #stop = new AbortController();
  #layout = '';
  #width = '';
  #versions;

  /** @param {import('./furapp.js').FurApp} app @param {HTMLCanvasElement} canvas @param {PanelHost} host */
  constructor(app, canvas, host) {
    this.#app = app;
    this.#canvas = canvas;
    this.#host = host;
    this.attach();
    this.#readLayout();
    this.#listen();
    this.#versions = new Versions(this, host.fur);
    this.#showOwnCoats();
    ownCoatsChanges.addEventListener('change', () => this.#showOwnCoats(), { signal: this.#stop.signal });
  }

  #call(name, ...args) { return this.#app.program.call(`fur_editor_${name}`, this.#app.handle, ...args); }

  attach() { this.#app.program.callOrThrow('fur_editor_attach', this.#app.handle); }
  detach(lost) { this.#call('detach', lost ? 1 : 0); }
  resize(width, height, pixelRatio) { this.#call('resize', width, height, pixelRatio); }

  dispose() {
    this.#stop.abort();
    this.#field.remove();
    this.#canvas.style.cursor = '';
    document.documentElement.style.removeProperty(widthProperty);
    this.detach(false);
  }

  // --- input; true: it was for the panel ---

  get wantsPointer() { return (this.#call('wants') & wants.pointer) !== 0; }

  pointer(phase, event, x, y) {
    return this.#call('pointer', phases.indexOf(phase), Math.max(0, pointerKinds.indexOf(event.pointerType)),
      event.pointerId, x, y, event.buttons, modifiersOf(event), event.timeStamp / 1000) !== 0;
  }
  wheel(notches, x, y) { return this.#call('wheel', notches, x, y) !== 0; }

  key(event, down) {
    const command = event.ctrlKey || event.metaKey;
    // The browser's own paste event brings the text without asking for a permission.
    if (command && event.key.toLowerCase() === 'v') return false;
    const used = this.#call('key', event.key, down ? 1 : 0, modifiersOf(event)) !== 0;
    const typed = down && !command && event.key.length === 1 && event.target !== this.#field;
    return (typed && this.#call('text', event.key) !== 0) || used;
  }

  message(text, isError) { this.#call('message', text, isError ? 1 : 0); }

  // --- frames ---

  update(seconds) { return this.#call('update', seconds) !== 0; }
  draw() { this.#call('draw'); }
  get active() { return this.#call('active') !== 0; }

  /** After a frame: the cursor, the on-screen keyboard, and what the panel asks of the page. */
  afterFrame() {
    this.#canvas.style.cursor = this.#app.program.text(this.#call('cursor'));
    this.#followTextFocus();
    this.#followLayout();
    const next = () => this.#app.program.text(this.#call('command'));
    for (let command = next(); command; command = next()) this.#actions[command](this.#app.program.text(this.#app.program.call('fur_editor_commandText')));
  }

  /** What the panel asks of the page (app/editor/PlatformCommands.inc). */
  #actions = {
    OpenDialog: () => this.#host.openDialog(),
    LoadShipped: (name) => { this.#host.fur.src = name; },
    CopyText: (text) => this.#copy(text),
    PasteRequest: () => this.#paste(),
    SaveTypeSet: (name) => this.#save(() => this.#host.fur.saveTypeSet(this.coatType + 1), name),
    KeepCoat: (name) => this.#withCoats(`"${name}" was not kept`, () => this.#keepCoat(name)),
    WearCoat: (id) => this.#withCoats('The coat was not put on', () => this.#wearCoat(id)),
    SaveOwnCoat: (id) => this.#withCoats('The coat was not saved', async () => {
      const { bytes, name } = await ownCoat(id);
      download(bytes, coatFileName(name));
    }),
    RenameCoat: (idAndName) => this.#withCoats('The coat was not renamed', () => renameOwnCoat(...idAndName.split('\n'))),
    DeleteCoat: (id) => this.#withCoats('The coat was not deleted', () => deleteOwnCoat(id)),
    SaveHair: (name) => this.#save(() => this.#host.fur.saveHair(), name),
    SaveFo: (name) => this.#save(() => this.#host.fur.saveFo(), name),
    SaveScene: (name) => this.#save(() => this.#host.fur.save(), name),
    SaveMaps: (name) => this.#save(() => this.#maps(), `${name}.zip`),
    SavePicture: (name) => this.#shoot(savePicture, name),
    SaveTurntable: (name) => this.#shoot(saveTurntable, name),
    KeepVersion: (name) => this.#versions.keep(name),
    OpenVersion: (id) => this.#versions.open(id),
    RenameVersion: (idAndName) => this.#versions.rename(...idAndName.split('\n')),
    DeleteVersion: (id) => this.#versions.delete(id),
  };

  #copy(text) {
    navigator.clipboard.writeText(text).catch((error) => this.message(`Nothing was copied: ${error.message}`, true));
  }

  // --- versions ---

  /** RGBA of the scene as it is, 144 x 96. */
  versionPicture() {
    const { program } = this.#app;
    const byteLength = program.callOrThrow('fur_editor_versionPicture', this.#app.handle);
    const rgba = program.array(Uint8Array, program.call('fur_savedBytes'), byteLength);
    program.call('fur_forgetSavedBytes');
    return rgba;
  }

  /** @param {{ id: string, name: string, time: number, picture: Uint8Array }[]} versions newest first */
  showVersions(versions) {
    for (const { id, name, time, picture } of versions) this.#call('addVersion', id, name, new Date(time).toLocaleString(), picture);
    this.#call('showVersions');
    this.#host.wake();
  }

  // --- coats of one's own ---

  async #showOwnCoats() {
    for (const { id, name } of await listOwnCoats()) if (!this.#stop.signal.aborted) this.#call('addOwnCoat', id, name);
    if (this.#stop.signal.aborted) return;
    this.#call('showOwnCoats');
    this.#host.wake();
  }

  async #keepCoat(name) {
    const { fur } = this.#host;
    const bytes = await fur.saveCoat({ name, type: this.coatType + 1 });
    await keepOwnCoat(name, bytes, await fur.toBlob({ width: ownCoatSide, height: ownCoatSide }));
  }

  async #wearCoat(id) {
    const { bytes, name } = await ownCoat(id);
    await this.#host.fur.loadTypeSet(bytes, { name }).catch(() => {});  // the panel says it
  }

  async #withCoats(failure, work) {
    try {
      await work();
    } catch (error) {
      this.message(`${failure}: ${error.message || error.name}`, true);
      this.#host.wake();
    }
  }

  // --- pictures ---

  /** The next part of the picture or film that was begun, null: it was given up. */
  nextBand() {
    const { program } = this.#app;
    const numbers = program.numbers(this.#call('nextBand'), 8);
    if (!numbers) return null;
    const [width, height, frames, rate, frame, top, rows, last] = numbers;
    const rgba = program.array(Uint8ClampedArray, program.call('fur_savedBytes'), 4 * width * rows);
    program.call('fur_forgetSavedBytes');
    this.#host.wake();
    return { width, height, frames, rate, frame, top, rows, last: last !== 0, rgba };
  }

  async #shoot(work, name) {
    try {
      const done = await work(this, name);
      if (done) this.message(`Saved as ${download(done.blob, done.name)}`, false);
    } catch (error) {
      this.#call('endPicture');
      this.message(error.message, true);
    }
    this.#host.wake();
  }

  async #save(makeBytes, name) {
    try {
      download(await makeBytes(), name);
    } catch (error) {
      this.message(`${name} was not saved: ${error.message}`, true);
    }
  }

  #maps() {
    const { program, handle } = this.#app;
    const byteLength = program.callOrThrow('fur_saveMaps', handle);
    const bytes = program.array(Uint8Array, program.call('fur_savedBytes'), byteLength);
    program.call('fur_forgetSavedBytes');
    return bytes;
  }

  async #paste() {
    try {
      this.#call('paste', await navigator.clipboard.readText());
      this.#host.wake();
    } catch (error) {
      this.message(`Nothing was pasted: ${error.message}`, true);
    }
  }

  /** The fur type, 0 to 3, that the panel edits. */
  get coatType() { return this.#call('coatType'); }

  #followTextFocus() {
    const now = this.#call('wants');
    const wanted = (now & wants.text) !== 0;
    this.#field.inputMode = now & wants.number ? 'decimal' : 'text';
    const root = this.#canvas.getRootNode();
    if (wanted && root.activeElement === this.#canvas) this.#field.focus({ preventScroll: true });
    if (!wanted && root.activeElement === this.#field) this.#canvas.focus({ preventScroll: true });
  }

  #readLayout() {
    try {
      this.#call('setLayout', localStorage.getItem(layoutKey) ?? '');
    } catch { /* A page without storage has the panel at its first size. */ }
    this.#layout = this.#app.program.text(this.#call('layout'));
  }

  #followLayout() {
    const width = `${Math.round(this.#call('coveredWidth'))}px`;
    if (width !== this.#width) document.documentElement.style.setProperty(widthProperty, width);
    this.#width = width;
    const layout = this.#app.program.text(this.#call('layout'));
    if (layout === this.#layout || this.wantsPointer) return;  // not while it is dragged
    this.#layout = layout;
    try { localStorage.setItem(layoutKey, layout); } catch { /* As above. */ }
  }

  #listen() {
    const { signal } = this.#stop;
    const field = this.#field;
    field.setAttribute('aria-label', 'Text for the editor');
    field.autocapitalize = field.autocomplete = 'off';
    field.tabIndex = -1;
    // 16 px: below that some phones zoom into what has the focus.
    field.style.cssText = 'position:absolute;left:0;top:0;width:1px;height:1px;padding:0;border:0;opacity:0;font-size:16px';
    this.#canvas.after(field);
    const onKey = (down) => (event) => {
      if (event.isComposing) return;
      // Of the keys with a sign only Ctrl+S: the others are what the field is for.
      if (this.key(event, down) && (event.key.length > 1 || (event.key === 's' && (event.ctrlKey || event.metaKey)))) event.preventDefault();
      this.#host.wake();
    };
    field.addEventListener('keydown', onKey(true), { signal });
    field.addEventListener('keyup', onKey(false), { signal });
    const take = () => {
      if (field.value) this.#call('text', field.value);
      field.value = '';
      this.#host.wake();
    };
    field.addEventListener('input', (event) => { if (!event.isComposing) take(); }, { signal });
    field.addEventListener('compositionend', take, { signal });
    const paste = (event) => {
      this.#call('paste', event.clipboardData.getData('text/plain'));
      event.preventDefault();
      this.#host.wake();
    };
    for (const target of [field, this.#canvas]) target.addEventListener('paste', paste, { signal });
    this.#canvas.addEventListener('pointerleave', () => {
      this.#call('pointerLeft');
      this.#host.wake();
    }, { signal });
    // While it is on its way the focus is nowhere, so only the event tells where it goes.
    this.#canvas.addEventListener('blur', (event) => {
      if (event.relatedTarget !== field) this.#call('focusLost');
    }, { signal });
  }
}
