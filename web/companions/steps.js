// <wet-fur-steps for="fig"> with a <section data-set='{"view": "layers"}' data-call='[["shake"]]'> for each step: as one reads on, the figure
// follows. A step changes what it names; all else is as the steps before it left it, also on the way back. The figure may stand inside
// (slot="figure"): then it stays in view beside the text. Without scripts and on paper it is a text like any other.
import { callIn, checkMethod } from './calls.js';
import { Companion, make, MarkupError } from './companion.js';
import { fieldOf, setValueIn, valueIn } from './values.js';

/** A step begins when its top has come so far up, as a share of the window's height. */
const line = 0.6;

export class WetFurStepsElement extends Companion {
  static events = ['load'];
  static shadow = {};

  #frame = make('div', { class: 'steps', part: 'frame' }, make('div', { class: 'layout' },
    make('div', { class: 'beside', part: 'figure' }, make('slot', { name: 'figure' })), make('div', { part: 'steps' }, make('slot'))));
  #children = new MutationObserver(() => this.#onChildren());
  #observer = new IntersectionObserver(() => this.#onScroll(), { rootMargin: `0px 0px ${-100 * (1 - line)}% 0px` });
  #steps = [];  // { element, set, calls }
  #current = -1;
  #base = null;  // what the steps change, as it was before them
  #wanted = {};

  /** The step that is read now, from 0; -1 before the first. */
  get current() { return this.#current; }

  connectedCallback() {
    super.connectedCallback();
    this.#children.observe(this, { childList: true, subtree: true, attributeFilter: ['data-set', 'data-call', 'slot'] });
    this.#onChildren();
  }
  removed() {
    this.#children.disconnect();
    this.#observer.disconnect();
  }

  build() { this.show(this.#frame); }

  #onChildren() {
    const given = [...this.children];
    this.#frame.classList.toggle('drives', given.some(({ slot }) => slot === 'figure'));
    this.#observer.disconnect();
    this.#steps = this.attempt('steps', () => given.filter(({ slot }) => !slot).map((element) => this.#step(element))) ?? [];
    for (const { element } of this.#steps) this.#observer.observe(element);
    if (this.#base) this.#rememberBase();
  }

  #step(element) {
    const set = this.json('data-set', {}, element), calls = this.json('data-call', [], element);
    for (const name of Object.keys(set)) if (!fieldOf(name)) throw new MarkupError(`There is no setting “${name}”.`);
    if (!Array.isArray(calls) || !calls.every(Array.isArray)) throw new MarkupError('data-call is no list of calls: it is written [["shake"]].');
    for (const [method] of calls) checkMethod(method);
    return { element, set, calls };
  }

  onFigure() {
    this.#base = null;
    this.#wanted = {};
    this.whenLoaded(() => {
      this.#rememberBase();
      this.#apply(true);
    });
  }

  #rememberBase() {
    const names = this.#steps.flatMap(({ set }) => Object.keys(set));
    const now = (name) => (name === 'cameraOrbit' ? this.figure.cameraOrbitText : valueIn(this.figure, name));
    this.#base = Object.fromEntries([...new Set(names)].map((name) => [name, this.#base?.[name] ?? now(name)]));
  }

  #onScroll() {
    const edge = line * innerHeight;
    const index = this.#steps.findLastIndex(({ element }) => element.getBoundingClientRect().top <= edge);
    if (index === this.#current) return;
    this.#current = index;
    this.#steps.forEach(({ element }, i) => {
      if (i === index) element.setAttribute('aria-current', 'step');
      else element.removeAttribute('aria-current');
    });
    if (this.#base) this.#apply();
    this.dispatchEvent(new CustomEvent('step-change', { detail: { index } }));
  }

  /** What the steps up to this one say, but for what a person has changed and they do not mention. */
  #apply(atFirst = false) {
    const { figure } = this;
    const step = this.#steps[this.#current];
    const wanted = Object.assign({ ...this.#base }, ...this.#steps.slice(0, this.#current + 1).map(({ set }) => set));
    for (const [name, value] of Object.entries(wanted)) {
      const isNew = atFirst ? value !== this.#base[name] : value !== this.#wanted[name];
      if (isNew || (step && Object.hasOwn(step.set, name))) setValueIn(figure, name, value);
    }
    this.#wanted = wanted;
    for (const [method, ...args] of step?.calls ?? []) {
      callIn(figure, method, args).then(() => this.tell('call', ''), (error) => this.tell('call', error.message));
    }
  }
}
