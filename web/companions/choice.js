// <wet-fur-choice for="fig" setting="view">: one of several values of the figure, as buttons where they are few, else as a list; a tick for
// what is on or off, a colour for colours. With `method` each value is what that is called with.
import { callIn, checkMethod } from './calls.js';
import { Companion, make, MarkupError } from './companion.js';
import { fieldOf, setValueIn, valueIn, words } from './values.js';

/** As many are shown side by side. */
const mostButtons = 4;
let groups = 0;

export class WetFurChoiceElement extends Companion {
  static observedAttributes = [...Companion.observedAttributes, 'setting', 'method', 'values'];
  static events = [...Companion.events, 'action-start', 'action-end', 'wetness-change'];

  #field = null;
  #shown = '';  // the values that there are controls for
  #inputs = null;

  get setting() { return this.getAttribute('setting') ?? ''; }
  set setting(name) { this.setAttribute('setting', name); }
  get method() { return this.getAttribute('method') ?? ''; }
  set method(name) { this.setAttribute('method', name); }

  get value() {
    const [first] = this.#inputs ?? [];
    if (!first) return undefined;
    if (first.type === 'checkbox') return first.checked;
    return first.type === 'radio' ? this.#inputs.find(({ checked }) => checked)?.value : first.value;
  }
  set value(value) {
    this.#mark(value);
    this.#apply(value);
  }

  build() {
    const { setting, method } = this;
    this.#shown = '';
    this.#inputs = null;
    this.show();
    if (Boolean(setting) === Boolean(method)) throw new MarkupError('A choice is of a setting or of a method.');
    if (method) checkMethod(method);
    this.#field = method ? { type: 'choice', label: words(method) } : fieldOf(setting);
    if (!this.#field) throw new MarkupError(`There is no setting “${setting}”.`);
    this.#makeControls();
  }

  refresh() {
    if (!this.#field) return;
    if (this.method) this.#makeControls();
    for (const input of this.#inputs ?? []) input.disabled = !this.figure;
    if (this.figure && this.setting) this.#mark(valueIn(this.figure, this.setting) ?? this.#field.default ?? '');
    else if (this.figure && this.method === 'act') this.#mark(this.figure.action);
  }

  /** [value, label] each: of the attribute ("shells, final=Finished"), of the table, or of what an animal can do. */
  #values() {
    const given = this.getAttribute('values');
    if (given !== null) return given.split(',').map((one) => one.trim()).filter(Boolean).map((one) => {
      const [value, ...label] = one.split('=');
      return [value.trim(), label.join('=').trim() || this.#labelOf(value.trim())];
    });
    const names = this.#field.options ?? (this.method === 'act' ? this.figure?.actions ?? [] : []);
    return names.map((name) => [name, this.#labelOf(name)]);
  }
  #labelOf(value) { return this.#field.labels?.[value] ?? words(value); }

  #makeControls() {
    const { type } = this.#field;
    const values = this.#values();
    const shown = JSON.stringify([values, type]);
    if (shown === this.#shown) return;
    this.#shown = shown;
    const label = this.label || this.#field.label || words(this.setting);
    if (values.length === 0 && type === 'bool') this.#makeOne(label, make('input', { type: 'checkbox', id: 'input', part: 'input' }), 'check');
    else if (values.length === 0 && type === 'color') this.#makeOne(label, make('input', { type: 'color', id: 'input', part: 'input' }), 'row');
    else if (values.length === 0 && this.method !== 'act') throw new MarkupError('It needs values="…", separated by commas.');
    else if (values.length > mostButtons || this.method) this.#makeList(label, values);
    else this.#makeButtons(label, values);
    for (const input of this.#inputs) input.addEventListener(type === 'color' ? 'input' : 'change', () => this.#onChange());
  }

  #makeOne(label, input, look) {
    const name = make('label', { for: 'input', part: 'label' }, label);
    this.#inputs = [input];
    this.show(make('div', { class: look }, ...look === 'check' ? [input, name] : [name, input]));
  }
  #makeList(label, values) {
    const list = make('select', { id: 'input', part: 'input' }, ...values.map(([value, text]) => make('option', { value }, text)));
    list.selectedIndex = -1;
    this.#inputs = [list];
    this.show(make('div', { class: 'row' }, make('label', { for: 'input', part: 'label' }, label), list));
  }
  #makeButtons(label, values) {
    const group = `wet-fur-choice-${++groups}`;
    const picks = values.map(([value, text]) => make('label', { class: 'pick' },
      make('input', { type: 'radio', name: group, value }), make('span', { part: 'button' }, text)));
    this.#inputs = picks.map((pick) => pick.firstChild);
    this.show(make('fieldset', {}, make('legend', { part: 'label' }, label), make('div', { class: 'picks' }, ...picks)));
  }

  #mark(value) {
    for (const input of this.#inputs ?? []) {
      if (input.type === 'checkbox') input.checked = Boolean(value);
      else if (input.type === 'radio') input.checked = input.value === String(value);
      else if (input.type === 'color') input.value = value || '#000000';
      else input.selectedIndex = [...input.options].findIndex((option) => option.value === String(value));
    }
  }

  #onChange() {
    const { value } = this;
    this.ask();
    this.#apply(value);
    this.dispatchEvent(new Event('change', { bubbles: true }));
  }
  #apply(given) {
    const { figure } = this;
    if (!figure) return;
    const { type } = this.#field;
    const isNumber = type === 'float' || type === 'int' || (this.method && given !== '' && Number.isFinite(Number(given)));
    const value = type === 'bool' ? given === true || given === 'true' : isNumber ? Number(given) : given;
    if (this.method) this.whenLoaded(() => callIn(figure, this.method, [value]).then(() => this.tell('call', ''), (error) => this.tell('call', error.message)));
    else if (!setValueIn(figure, this.setting, value)) this.whenLoaded(() => setValueIn(figure, this.setting, value));
  }
}
