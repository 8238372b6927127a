// The demo page's chooser of coats: a button, and a panel of presets beside the bar that the button is in.

/** What a coat looks like at a glance: from its roots, below, to its tips. */
function swatch({ rootColor, tipColor }) {
  const disc = document.createElement('i');
  disc.style.background = `radial-gradient(circle at 50% 108%, ${rootColor} 18%, ${tipColor} 82%)`;
  return disc;
}

function coatButton({ name, label, description, settings }) {
  const button = document.createElement('button');
  button.type = 'button';
  button.title = description;
  button.dataset.coat = name;
  const text = document.createElement('span');
  text.textContent = label;
  button.append(swatch(settings), text);
  return button;
}

export class Coats {
  #opener;
  #panel;
  #fur;

  /** @param {HTMLButtonElement} opener @param {HTMLElement} panel @param {import('./element.js').WetFurElement} fur */
  constructor(opener, panel, fur) {
    this.#opener = opener;
    this.#panel = panel;
    this.#fur = fur;
    opener.addEventListener('click', () => (panel.hidden ? this.#open() : this.close()));
    panel.addEventListener('click', ({ target }) => {
      const button = target.closest('[data-coat]');
      if (button) fur.preset = button.dataset.coat;
    });
    panel.addEventListener('keydown', (event) => this.#onKey(event));
    addEventListener('pointerdown', ({ target }) => {
      if (!panel.contains(target) && !opener.contains(target)) this.close();
    }, true);
    addEventListener('resize', () => this.close());
  }

  get #buttons() { return [...this.#panel.children]; }

  showChosen() {
    const chosen = this.#panel.hidden ? '' : this.#fur.preset;
    for (const button of this.#buttons) button.setAttribute('aria-pressed', String(button.dataset.coat === chosen));
  }

  #open() {
    if (!this.#fur.presets) return;
    if (this.#buttons.length === 0) this.#panel.append(...this.#fur.presets.map(coatButton));
    this.#panel.hidden = false;
    this.#opener.setAttribute('aria-expanded', 'true');
    const bar = this.#opener.closest('.bar').getBoundingClientRect();
    this.#panel.style.bottom = `${innerHeight - bar.top + 8}px`;
    this.#panel.style.left = `${(bar.left + bar.right) / 2}px`;
    this.showChosen();
    (this.#panel.querySelector('[aria-pressed=true]') ?? this.#buttons[0]).focus({ focusVisible: false });
  }

  /** Whether it was open. */
  close() {
    if (this.#panel.hidden) return false;
    const inside = this.#panel.contains(document.activeElement);
    this.#panel.hidden = true;
    this.#opener.setAttribute('aria-expanded', 'false');
    if (inside) this.#opener.focus({ focusVisible: false });
    return true;
  }

  #onKey(event) {
    const step = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    if (!step) return;
    const buttons = this.#buttons;
    buttons[buttons.indexOf(event.target) + step]?.focus();
    event.preventDefault();
  }
}
