// <wet-fur-readout for="fig" value="frameTime">: a value of the figure as text. What is counted while it draws is looked up twice a second,
// as long as the page is seen; all else when the figure tells.
import { Companion, make, MarkupError } from './companion.js';
import { readableOf, textOf, valueIn } from './values.js';

const lookMilliseconds = 500;

export class WetFurReadoutElement extends Companion {
  static observedAttributes = [...Companion.observedAttributes, 'value', 'digits', 'unit'];
  static events = [...Companion.events, 'wetness-change', 'camera-change', 'action-start', 'action-end'];
  static shadow = {};

  #field = null;
  #how = {};
  #timer = 0;
  #label = make('span', { part: 'label' });
  // Not live: whoever reads along would hear nothing else.
  #value = make('output', { part: 'value', 'aria-live': 'off' });

  get value() { return this.getAttribute('value') ?? ''; }
  set value(name) { this.setAttribute('value', name); }

  build() {
    this.show();
    this.#field = readableOf(this.value);
    if (!this.#field) throw new MarkupError(this.value ? `There is no value “${this.value}”.` : 'It needs value="…".');
    this.#how = { unit: this.getAttribute('unit') ?? this.#field.unit, digits: this.number('digits', this.#field.unit === '%' ? 2 : undefined) };
    if (this.#how.unit === '%' && this.hasAttribute('digits')) this.#how.digits += 2;
    this.#label.textContent = this.label || this.#field.label;
    this.show(this.#label, ' ', this.#value);
  }

  refresh() {
    if (!this.#field) return;
    const text = textOf(this.figure ? valueIn(this.figure, this.value) : undefined, this.#how, this.language);
    if (this.#value.textContent !== text) this.#value.textContent = text;
    clearTimeout(this.#timer);
    if (this.figure && this.#field.stat && this.isConnected) this.#timer = setTimeout(() => this.#lookAgain(), lookMilliseconds);
  }

  #lookAgain() {
    if (document.hidden) document.addEventListener('visibilitychange', () => this.refreshSafely(), { once: true });
    else this.refreshSafely();
  }

  removed() { clearTimeout(this.#timer); }
}
