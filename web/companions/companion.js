// What all companions have in common: the figure that they are about, their texts, and what they say when something is wrong.
import { sheet } from './styles.js';
import { findFigure, unwatch, watch } from './watching.js';

/** In Node there is no HTMLElement: importing must work all the same. */
const Base = globalThis.HTMLElement ?? class {};

/** What the author of a page has to know; told as text in the element. */
export class MarkupError extends Error {}

export function make(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) if (value !== undefined) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

/** A figure out of sight tells of its water only when it is seen again; what one companion changes the others show at once. */
const changedByCompanion = 'wet-fur-companion-change';
export const tellOthers = (figure) => figure.dispatchEvent(new Event(changedByCompanion));

let elementAsked = false;
/** Pages may have companions alone: <wet-fur> comes with the first that is about one, unless the page brings it itself. */
function fetchElement() {
  if (elementAsked) return;
  elementAsked = true;
  const ask = () => { if (!customElements.get('wet-fur')) import('../element.js').catch((error) => console.error('wet-fur:', error)); };
  if (document.readyState === 'complete') ask();
  else addEventListener('load', ask, { once: true });
}

export class Companion extends Base {
  static observedAttributes = ['for', 'label'];
  /** Events of the figure upon which refresh() is called. */
  static events = ['load', 'state-change'];
  /** Options of its shadow root. */
  static shadow = { delegatesFocus: true };

  #figure = null;
  #unbind = null;
  #waiting = [];
  #built = false;
  #soon = false;
  #problems = new Map();
  #notice = make('p', { part: 'error', role: 'status', hidden: '' });

  constructor() {
    super();
    this.attachShadow({ mode: 'open', ...this.constructor.shadow }).append(this.#notice);
    this.shadowRoot.adoptedStyleSheets = [sheet()];
  }

  // --- for those that extend it ---

  /** Whether it can do without a figure. */
  get alone() { return false; }
  /** Makes what it shows, of its attributes alone. May throw a MarkupError. */
  build() {}
  /** Shows what the figure has now; `figure` may be null. */
  refresh() {}

  /** Whether it shows anything yet; values that are set before wait in their attributes. */
  get built() { return this.#built; }
  /** The <wet-fur> that this is about; null while there is none. */
  get figure() { return this.#figure; }
  get label() { return this.getAttribute('label') ?? ''; }
  set label(text) { this.setAttribute('label', text); }
  get language() { return this.closest('[lang]')?.lang || document.documentElement.lang; }

  /** A number among the attributes; `otherwise` where there is none. */
  number(name, otherwise) {
    const text = this.getAttribute(name);
    if (text === null || text.trim() === '') return otherwise;
    if (!Number.isFinite(Number(text))) throw new MarkupError(`${name}="${text}" is not a number.`);
    return Number(text);
  }

  /** What an attribute has as JSON; `otherwise` where there is none. */
  json(name, otherwise, element = this) {
    const text = element.getAttribute(name);
    if (text === null) return otherwise;
    try {
      return JSON.parse(text);
    } catch (error) {
      throw new MarkupError(`${name} is not JSON: ${error.message}`);
    }
  }

  /** In place of all that is shown but what is wrong. */
  show(...nodes) { this.shadowRoot.replaceChildren(...nodes, this.#notice); }

  /** What is wrong with `part` of it; '' when nothing is. */
  tell(part, text) {
    if (text) this.#problems.set(part, text);
    else this.#problems.delete(part);
    const all = [...this.#problems.values()].join(' ');
    if (this.#notice.textContent !== all) this.#notice.textContent = all;
    this.#notice.hidden = !all;
  }

  /** Does it, and tells what goes wrong. */
  attempt(part, work) {
    try {
      const result = work();
      this.tell(part, '');
      return result;
    } catch (error) {
      if (!(error instanceof MarkupError) && error?.name !== 'FurError') throw error;
      this.tell(part, error.message);
      return undefined;
    }
  }

  /** A person wants something of the figure: one that waits to be asked is shown. */
  ask() { if (this.#figure?.reveal === 'interaction' && !this.#figure.loaded) this.#figure.dismissPoster(); }

  /** Now, or once the figure shows a model. */
  whenLoaded(work) {
    if (this.#figure?.loaded) work(this.#figure);
    else this.#waiting.push(work);
  }

  // --- life ---

  connectedCallback() {
    watch(this);
    this.#upgradeProperties();
    this.#rebuild();
    if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', () => this.look(), { once: true });
  }

  /** Values that were set before the class was known lie on the element itself. */
  #upgradeProperties() {
    for (const name of Object.keys(this).filter((one) => one in Object.getPrototypeOf(this))) {
      const value = this[name];
      delete this[name];
      this[name] = value;
    }
  }

  /** One that is only moved keeps what it has. */
  disconnectedCallback() {
    unwatch(this);
    queueMicrotask(() => {
      if (this.isConnected) return;
      this.#bind(null);
      this.removed();
    });
  }
  /** It has gone for good, or for now. */
  removed() {}

  attributeChangedCallback(name, before, value) {
    if (before === value || this.#soon || !this.#built) return;
    this.#soon = true;
    queueMicrotask(() => {
      this.#soon = false;
      if (this.isConnected) this.#rebuild();
    });
  }

  #rebuild() {
    this.#built = true;
    this.tell('values', '');
    this.attempt('markup', () => this.build());
    this.look();
    this.refreshSafely();
  }

  /** The same, as far as its tag can be understood. */
  refreshSafely() { if (!this.#problems.has('markup')) this.attempt('values', () => this.refresh()); }

  /** The page has changed: the figure may be another one. */
  look() {
    if (!this.isConnected) return;
    const found = findFigure(this);
    if (found && found.localName !== 'wet-fur') this.#tellFigure(`The element “${found.id}” is no <wet-fur>.`);
    else if (found && !found.settings) {
      this.#tellFigure('');
      fetchElement();
      customElements.whenDefined('wet-fur').then(() => this.look());
    } else if (found) this.#tellFigure('');
    else this.#tellMissing();
    this.#bind(found?.settings ? found : null);
  }

  #tellMissing() {
    const id = this.getAttribute('for');
    const missing = document.readyState !== 'loading' && !this.alone;
    this.#tellFigure(!missing ? '' : id ? `There is no figure with the id “${id}” on this page.` : 'There is no figure on this page.');
  }
  #tellFigure(text) { this.tell('figure', text); }

  #bind(figure) {
    if (figure === this.#figure) return;
    this.#unbind?.abort();
    const before = this.#figure;
    this.#figure = figure;
    this.#waiting = [];
    this.#unbind = new AbortController();
    const { signal } = this.#unbind;
    if (figure) {
      figure.addEventListener('load', () => {
        const waiting = this.#waiting;
        this.#waiting = [];
        for (const work of waiting) work(figure);
      }, { signal });
      for (const type of [...this.constructor.events, changedByCompanion]) figure.addEventListener(type, (event) => this.onFigureEvent(event), { signal });
    }
    this.onFigure(figure, before);
    this.refreshSafely();
  }
  /** Another figure than before, or none. */
  onFigure() {}
  onFigureEvent() { this.refreshSafely(); }
}

/** In Node, and where another copy has done so, there is nothing to define. */
export function define(name, type) {
  if (globalThis.customElements && !customElements.get(name)) customElements.define(name, type);
}
