// <wet-fur-slider for="fig" setting="curl">: a range for a value of the figure. Label, range, step and unit are those of the settings
// table unless the tag has its own. Without `setting` it is a number of its own, for plots and scripts.
import { Companion, make, MarkupError } from './companion.js';
import { digitsOf, fieldOf, setValueIn, stepOf, textOf, valueIn } from './values.js';

export class WetFurSliderElement extends Companion {
  static observedAttributes = [...Companion.observedAttributes, 'setting', 'min', 'max', 'step', 'unit', 'value'];
  static events = [...Companion.events, 'wetness-change'];

  #input = make('input', { type: 'range', id: 'input', part: 'input' });
  #label = make('label', { for: 'input', part: 'label' });
  #value = make('span', { part: 'value', 'aria-hidden': 'true' });
  #row = make('div', { class: 'row' }, this.#label, this.#value);
  #how = {};
  #given = null;
  #dragged = null;  // since when one drags: of what was told last, whether that is a step of undo

  constructor() {
    super();
    this.#input.addEventListener('input', () => this.#onInput());
    this.#input.addEventListener('change', () => {
      this.#dragged = null;
      this.refreshSafely();
      this.dispatchEvent(new Event('change', { bubbles: true }));
    });
  }

  get setting() { return this.getAttribute('setting') ?? ''; }
  set setting(name) { this.setAttribute('setting', name); }
  get alone() { return !this.setting; }

  get value() { return this.#input.valueAsNumber; }
  set value(value) {
    if (!this.built) {
      this.setAttribute('value', value);
      return;
    }
    this.#input.value = value;
    if (this.setting) this.#apply();
    this.#showValue();
  }

  build() {
    const name = this.setting;
    const field = name ? fieldOf(name) : { type: 'float', min: 0, max: 1, label: '' };
    this.show();
    if (!field) throw new MarkupError(`There is no setting “${name}”.`);
    if (field.type !== 'float' && field.type !== 'int') throw new MarkupError(`The setting “${name}” is no number: <wet-fur-choice> is for such.`);
    const min = this.number('min', field.min), max = this.number('max', field.max);
    if (!(min < max)) throw new MarkupError(`min ${min} is not less than max ${max}.`);
    const step = this.number('step', stepOf({ type: field.type, min, max }));
    if (!(step > 0)) throw new MarkupError(`step ${step} is not more than 0.`);
    this.#how = { unit: this.getAttribute('unit') ?? field.unit, digits: digitsOf(step) };
    this.#label.textContent = this.label || field.label || 'Value';
    Object.assign(this.#input, { min, max, step });
    this.#takeValue(field.default ?? min);
    this.show(this.#row, this.#input);
    this.#showValue();
  }

  /** What the tag says counts when it says something new: else what a person has set stays. */
  #takeValue(otherwise) {
    const given = `${this.setting} ${this.getAttribute('value')}`;
    if (given === this.#given) return;
    this.#given = given;
    this.#input.value = this.number('value', otherwise);
    if (this.setting && this.hasAttribute('value')) this.whenLoaded(() => this.#apply());
  }

  refresh() {
    this.#input.disabled = !this.alone && !this.figure;
    if (this.alone || !this.figure || !fieldOf(this.setting) || this.#dragged) return;
    const value = valueIn(this.figure, this.setting);
    if (typeof value === 'number') this.#input.value = value;
    this.#showValue();
  }

  #onInput() {
    this.ask();
    if (this.setting) this.#apply(true);
    this.#showValue();
  }

  #apply(drags = false) {
    const { figure, setting: name, value } = this;
    if (!figure) return;
    // A drag is one step of undo; settings see to that themselves.
    if (name === 'wetness' && this.#dragged?.undoable) figure.undo();
    const before = name === 'wetness' && figure.loaded ? figure.meanWetness : 0;
    if (!setValueIn(figure, name, value)) this.whenLoaded(() => setValueIn(figure, name, this.value));
    if (drags) this.#dragged = { undoable: name === 'wetness' && figure.loaded && figure.meanWetness !== before };
  }

  #showValue() {
    const text = textOf(this.value, this.#how, this.language);
    this.#value.textContent = text;
    this.#input.ariaValueText = text.replace('\u00a0', ' ');
  }
}
