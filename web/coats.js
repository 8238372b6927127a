// The demo page's chooser of coats: pictures of the presets, and the coat that the model came with.

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

export class Coats {
  #panel;
  #fur;
  #original = document.createElement('canvas');
  #loaded = {};  // settings of the coat as it came

  /** @param {HTMLElement} panel a popover @param {import('./element.js').WetFurElement} fur */
  constructor(panel, fur) {
    this.#panel = panel;
    this.#fur = fur;
    Object.assign(this.#original, { width: 2 * pictureSide, height: 2 * pictureSide });
    fur.addEventListener('load', () => this.#onLoad());
    panel.addEventListener('beforetoggle', ({ newState }) => { if (newState === 'open') this.#fill(); });
    panel.addEventListener('toggle', ({ newState }) => { if (newState === 'open') this.#focusChosen(); });
    panel.addEventListener('click', ({ target }) => this.#choose(target.closest('[data-coat]')?.dataset.coat));
    panel.addEventListener('keydown', (event) => this.#onKey(event));
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
    const shown = this.#fur.shadowRoot.querySelector('canvas');
    const ratio = shown.width / shown.clientWidth;
    const [x, y, side] = this.#furrySquare(shown).map((length) => length * ratio);
    const { width } = this.#original;
    this.#original.getContext('2d').drawImage(shown, x - side, y - side, 2 * side, 2 * side, 0, 0, width, width);
    this.showChosen();
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
    const isOriginal = JSON.stringify(this.#coatNow()) === JSON.stringify(this.#loaded);
    const chosen = isOriginal ? 'original' : this.#fur.preset;
    for (const button of this.#buttons) button.setAttribute('aria-pressed', String(button.dataset.coat === chosen));
  }

  #fill() {
    const { presets } = this.#fur;
    if (!presets || this.#buttons.length > 0) return;
    this.#panel.append(coatButton({ name: 'original', label: 'Original', description: 'The coat that the model came with' }, this.#original),
      ...presets.map((preset, index) => coatButton(preset, presetPicture(index))));
    this.showChosen();
  }

  #choose(name) {
    if (!name) return;
    if (name !== 'original') this.#fur.preset = name;
    else {
      const state = JSON.parse(this.#fur.getState());
      const others = Object.entries(state.settings ?? {}).filter(([field]) => !coatFields(this.#fur.settingsTable).includes(field));
      this.#fur.setState({ version: state.version, settings: { ...Object.fromEntries(others), ...this.#loaded } });
    }
    this.showChosen();
  }

  #focusChosen() {
    (this.#panel.querySelector('[aria-pressed=true]') ?? this.#buttons[0])?.focus({ focusVisible: false });
  }

  #onKey(event) {
    const buttons = this.#buttons;
    const at = buttons.indexOf(event.target);
    const next = { ArrowLeft: at - 1, ArrowRight: at + 1, Home: 0, End: buttons.length - 1 }[event.key];
    if (next === undefined) return;
    buttons[next]?.focus();
    event.preventDefault();
  }
}
