// The demo page's chooser of coats: pictures of the presets, the coat that the model came with, and coats of one's own.
import { CoatDialog } from './coatdialog.js';
import { listOwnCoats, ownCoat, ownCoatsChanges, settingsOfCoat } from './owncoats.js';

/** Names of the settings that presets decide about. */
export const coatFields = (table) => table.filter(({ coat }) => coat).map(({ name }) => name);

const pictureSide = 56;

function coatButton({ name, label, description }, picture) {
  const button = document.createElement('button');
  button.type = 'button';
  button.title = description;
  button.dataset.coat = name;
  const text = document.createElement('span');
  text.textContent = label;
  button.append(picture, text);
  return button;
}

/** Of the sheet coats.jpg, which has them side by side. */
function presetPicture(index) {
  const picture = document.createElement('i');
  picture.style.backgroundPositionX = `${-pictureSide * index}px`;
  return picture;
}

/** How it looked when it was kept. */
function ownPicture({ picture }) {
  const image = document.createElement('i');
  image.className = 'own';
  if (!picture) return image;
  const url = URL.createObjectURL(picture);
  image.style.backgroundImage = `url("${url}")`;
  return image;
}

export class Coats {
  #panel;
  #fur;
  #onError;
  #dialog;
  #own = [];
  #original = document.createElement('canvas');
  #loaded = {};  // settings of the coat as it came

  /** @param {HTMLElement} panel a popover @param {import('./element.js').WetFurElement} fur @param {(text: string) => void} onError */
  constructor(panel, fur, onError) {
    this.#panel = panel;
    this.#fur = fur;
    this.#onError = onError;
    Object.assign(this.#original, { width: 2 * pictureSide, height: 2 * pictureSide });
    fur.addEventListener('load', () => this.#onLoad());
    panel.addEventListener('beforetoggle', ({ newState }) => { if (newState === 'open') this.#fill(); });
    panel.addEventListener('toggle', ({ newState }) => { if (newState === 'open') this.#focusChosen(); });
    panel.addEventListener('click', ({ target }) => this.#choose(target.closest('button')));
    ownCoatsChanges.addEventListener('change', () => this.#showOwn());
  }

  get #buttons() { return [...this.#panel.children]; }

  #coatNow() {
    const { settings = {} } = JSON.parse(this.#fur.getState());
    const fields = coatFields(this.#fur.settingsTable);
    return Object.fromEntries(Object.entries(settings).filter(([name]) => fields.includes(name)));
  }

  /** The coat as the model brought it, or as it was worn when the model came; and how it looks on it. */
  #onLoad() {
    this.#loaded = this.#coatNow();
    this.#drawOn(this.#original);
    this.showChosen();
  }

  /** How the coat looks on the model now. */
  #drawOn(canvas) {
    const shown = this.#fur.shadowRoot.querySelector('canvas');
    const ratio = shown.width / shown.clientWidth;
    const [x, y, side] = this.#furrySquare(shown).map((length) => length * ratio);
    canvas.getContext('2d').drawImage(shown, x - side, y - side, 2 * side, 2 * side, 0, 0, canvas.width, canvas.width);
  }

  async #saveCoat(name) {
    const canvas = new OffscreenCanvas(this.#original.width, this.#original.height);
    this.#drawOn(canvas);
    return { bytes: await this.#fur.saveCoat({ name }), picture: await canvas.convertToBlob() };
  }

  /** Middle and half side, in CSS pixels, of a square with nothing but the model in it, if there is one near the middle. */
  #furrySquare({ clientWidth, clientHeight }) {
    const half = Math.min(clientWidth, clientHeight) / 10;
    const corners = [[0, 0], [-1, -1], [1, -1], [-1, 1], [1, 1]];
    const steps = [0, 1, -1, 2, -2];
    const middles = steps.flatMap((down) => steps.map((across) => [clientWidth / 2 + across * half, clientHeight / 2 + down * half]));
    const isFurry = ([x, y]) => corners.every(([i, j]) => this.#fur.pick({ x: x + i * half, y: y + j * half }));
    return [...(middles.find(isFurry) ?? middles[0]), half];
  }

  showChosen() {
    if (this.#buttons.length === 0) return;
    const now = JSON.stringify(this.#coatNow());
    const isOriginal = now === JSON.stringify(this.#loaded), own = this.#own.find(({ settings }) => settings === now);
    const chosen = this.#fur.preset || (isOriginal ? 'original' : own?.id);
    for (const button of this.#buttons) {
      const { coat, own: id } = button.dataset;
      if (coat || id) button.setAttribute('aria-pressed', String((coat ?? id) === chosen));
    }
  }

  #fill() {
    const { presets } = this.#fur;
    if (!presets || this.#buttons.length > 0) return;
    const manage = coatButton({ label: 'My coats', description: 'Coats of your own: keep this one, rename, save as a file, delete' }, document.createElement('i'));
    delete manage.dataset.coat;
    manage.id = 'own-coats';
    manage.firstElementChild.className = 'more';
    this.#panel.append(coatButton({ name: 'original', label: 'Original', description: 'The coat that the model came with' }, this.#original),
      ...presets.map((preset, index) => coatButton(preset, presetPicture(index))), manage);
    this.showChosen();
    this.#showOwn();
  }

  /** Before the last button. */
  async #showOwn() {
    const coats = await listOwnCoats();
    if (this.#buttons.length === 0) return;
    for (const button of this.#buttons) {
      if (!button.dataset.own) continue;
      URL.revokeObjectURL(/url\("(.*)"\)/.exec(button.firstElementChild.style.backgroundImage)?.[1] ?? '');
      button.remove();
    }
    this.#own = coats.map((coat) => ({ id: coat.id, settings: JSON.stringify(settingsOfCoat(coat)) }));
    this.#panel.lastElementChild.before(...coats.map((coat) => {
      const button = coatButton({ label: coat.name, description: coat.name }, ownPicture(coat));
      delete button.dataset.coat;
      button.dataset.own = coat.id;
      return button;
    }));
    this.showChosen();
  }

  async #choose(button) {
    const { coat, own } = button?.dataset ?? {};
    if (own) await this.#wear(own);
    else if (coat === 'original') {
      const state = JSON.parse(this.#fur.getState());
      const others = Object.entries(state.settings ?? {}).filter(([field]) => !coatFields(this.#fur.settingsTable).includes(field));
      this.#fur.setState({ version: state.version, settings: { ...Object.fromEntries(others), ...this.#loaded } });
    } else if (coat) this.#fur.preset = coat;
    else if (button) {
      this.#dialog ??= new CoatDialog((name) => this.#saveCoat(name));
      await this.#dialog.open();  // which closes the panel
      this.#panel.showPopover();
    }
    this.showChosen();
  }

  async #wear(id) {
    try {
      const { bytes, name } = await ownCoat(id);
      await this.#fur.loadTypeSet(bytes, { name, type: 1 });
    } catch (error) {
      if (!error.code) this.#onError(error.message);  // others the error event carries
    }
  }

  #focusChosen() {
    (this.#panel.querySelector('[aria-pressed=true]') ?? this.#buttons[0])?.focus({ focusVisible: false });
  }
}
