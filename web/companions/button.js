// <wet-fur-button for="fig" method="splash" args='[{"u": 0.5, "v": 0.5}]'>Label</wet-fur-button>: calls a method of the figure, once
// that shows a model.
import { callIn, checkMethod, needsModel } from './calls.js';
import { Companion, make, MarkupError } from './companion.js';
import { words } from './values.js';

export class WetFurButtonElement extends Companion {
  static observedAttributes = [...Companion.observedAttributes, 'method', 'args'];

  #method = '';
  #args = [];
  #slot = make('slot');
  #button = make('button', { type: 'button', part: 'button' }, this.#slot);

  constructor() {
    super();
    this.#button.addEventListener('click', () => this.#press());
  }

  get method() { return this.getAttribute('method') ?? ''; }
  set method(name) { this.setAttribute('method', name); }

  build() {
    this.show();
    this.#method = this.method;
    checkMethod(this.#method);
    this.#args = this.json('args', []);
    if (!Array.isArray(this.#args)) throw new MarkupError('args is no list: it is written [ … ].');
    this.#slot.textContent = this.label || words(this.#method);
    this.show(this.#button);
  }

  refresh() { this.#button.disabled = !this.figure; }

  #press() {
    this.ask();
    if (!needsModel(this.#method) || this.figure.loaded) return void this.#call();
    this.#button.ariaBusy = 'true';
    this.whenLoaded(() => this.#call());
  }

  async #call() {
    this.#button.ariaBusy = 'true';
    try {
      await callIn(this.figure, this.#method, this.#args);
      this.tell('call', '');
    } catch (error) {
      this.tell('call', `${words(this.#method)}: ${error.message}`);
    }
    this.#button.ariaBusy = 'false';
  }
}
