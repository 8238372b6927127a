// How a visit of the demo page begins: with what the link says, else with the work of before, and always with a model.
import { Autosave } from './autosave.js';
import { listed } from './download.js';
import { firstModel, plainModel } from './models.js';
import { compileProgram } from './runtime.js';
import { unpackBytes } from './packed.js';
import { unpackWater } from './packedwater.js';
import { unpackStrokes } from './strokes.js';

/** Where another model would fare no better. */
const hopeless = ['webgl-unavailable', 'wasm-blocked', 'wasm-load', 'out-of-memory'];
/** Of what a link holds, that which lies on the model, and all that is about the scene. */
const parts = ['groom', 'hair', 'strokes', 'water'];
const sceneKeys = ['src', 'state', ...parts, 'preset', 'light', 'wetness', 'camera'];

/** What the address says of the scene, '' for nothing. */
const sceneOf = (link) => {
  const said = [...sceneKeys.filter((key) => (link[key] ?? '') !== '').map((key) => [key, link[key]]), ...link.settings];
  return said.length > 0 ? JSON.stringify(said) : '';
};
/** Whether it does, read or refused. */
export const asksForScene = (link) => sceneOf(link) !== '' || link.warnings.length > 0;
/** Whether it says what no address from before the otter could. */
const isNewer = (link) => link.wetness !== undefined || link.settings.some(([key]) => key === 'behaviour');
/** An address that says how the scene looks but not of which model is from before there was another than the bunny, unless it is newer. */
export const modelOf = (link) => link.src ?? (sceneOf(link) && !isNewer(link) ? plainModel : firstModel);
const withoutScene = (link) => ({ ...link, ...Object.fromEntries(sceneKeys.map((key) => [key, undefined])), settings: [] });
/** Not where a picture is to come out the same at every visit, nor inside another page. */
const keepsWork = (link) => link.autoplay !== false && link.frames === undefined && !link.dt && link.ui !== false;

export class Visit {
  #fur;
  #link;
  #messages;
  #autosave = null;
  /** Whether nobody has been here before, and nothing was asked for; known once open() has ended. */
  isFirst = false;

  /**
   * @param {import('./element.js').WetFurElement} fur @param {ReturnType<import('./link.js').readLink>} link
   * @param {import('./messages.js').Messages} messages
   */
  constructor(fur, link, messages) {
    this.#fur = fur;
    this.#link = link;
    this.#messages = messages;
    if (keepsWork(link)) this.#autosave = new Autosave(fur, sceneOf(link), (reason) => this.#onFailure(reason));
  }

  /** Until a model is shown. @param {(link: object, ofBefore?: boolean) => void} apply what else the link asks for */
  async open(apply) {
    compileProgram('viewer').catch(() => {});  // meanwhile
    const found = await this.#autosave?.find();
    const restored = found?.shows ? await this.#restore(found.document, apply) : null;
    const seen = restored === null ? await this.#openLink(apply) : this.#fur.fur.changesAtLoad;
    this.#autosave?.begin(seen);
    this.isFirst = Boolean(this.#autosave) && !found && !sceneOf(this.#link);
    if (restored !== null) this.#offer(`Your last work is back${restored}.`, 'Start afresh', () => this.#startAfresh(apply));
    else if (found) this.#offer('Your earlier work is saved.', 'Show it', () => this.#fur.fur.openDocument(found.document).catch(() => {}));
  }

  /** What there is to say of it; null: it could not be. */
  async #restore(document, apply) {
    apply(withoutScene(this.#link), true);
    if (document.source.src !== firstModel) this.#fur.querySelector('[slot=poster]')?.remove();
    try {
      await this.#fur.fur.openDocument(document);
    } catch (error) {
      this.#messages.error(`Your last work could not be opened: ${error.message}`);
      return null;
    }
    // An older version of the page may have written them otherwise.
    const lost = ['groom', 'water', 'coat'].filter((part) => this.#fur.warnings.some((text) => text.startsWith(`${part}: `)));
    return lost.length > 0 ? `, without its ${listed(lost)}` : '';
  }

  /** What `changes` was before anybody did anything; null: somebody has brought a file meanwhile. */
  async #openLink(apply) {
    const fur = this.#fur, { src } = this.#link;
    const shown = new Promise((resolve) => fur.addEventListener('load', resolve, { once: true }));
    apply(this.#link);
    fur.src = modelOf(this.#link);
    let isAsLinked = true;
    await fur.ready.catch((error) => {
      if (fur.src === plainModel || hopeless.includes(error.code)) return;  // the element says it, with a button to try again
      isAsLinked = false;
      this.#messages.error(`${error.message}. The bunny is shown instead.`);
      fur.src = plainModel;
    });
    const { detail } = await shown;
    if (detail.src === null) return null;
    if (!isAsLinked || !parts.some((part) => this.#link[part])) return fur.fur.changesAtLoad;
    await this.#takeParts(false);
    return fur.fur.changes;
  }

  /** What lies on the model: the groom first, over which water runs. */
  async #takeParts(undoable) {
    const { fur } = this.#fur;
    for (const [part, what, unpack] of [['groom', 'groom', unpackBytes], ['hair', 'long hair', unpackBytes],
      ['water', 'water', (text) => unpackWater(text, fur.document.water)]]) {
      if (!this.#link[part]) continue;
      try {
        await fur.takeParts({ [part]: await unpack(this.#link[part]) });
      } catch {
        this.#messages.error(`The link's ${what} could not be read.`);
      }
    }
    if (this.#link.strokes) await this.#paint(this.#link.strokes, undoable);
  }

  async #paint(strokes, undoable) {
    try {
      this.#fur.replay(await unpackStrokes(strokes), { undoable });
    } catch {
      this.#messages.error("The link's water could not be read.");
    }
  }

  /** As the link says or as the page is at first; undo leads back. */
  async #startAfresh(apply) {
    const { state = '{"version":1}' } = this.#link, src = modelOf(this.#link);
    try {
      await this.#fur.fur.openDocument({ source: { src }, state, brings: !this.#link.state });
    } catch {
      return;  // the error event carries it
    }
    apply(this.#link);
    await this.#takeParts(true);
    await this.#autosave.forget();
  }

  #offer(text, label, action) {
    const box = this.#messages.offer(text, label, action);
    // Who goes on working, or to another model, has answered.
    for (const event of ['stroke-start', 'load']) this.#fur.addEventListener(event, () => box.remove(), { once: true });
  }

  #onFailure(reason) {
    this.#messages.error(`This browser does not keep your work (${reason}). Save the scene before you leave.`);
    addEventListener('beforeunload', (event) => { if (this.#autosave.unsaved) event.preventDefault(); });
  }
}
