/**
 * Registers <wet-fur>:
 * `<wet-fur src="otter.glb" alt="An otter; click to wet its fur" camera-controls tool="droplet"></wet-fur>`
 */
import { keyTexts } from '#tables';
import { buildShadow, elementStyles } from './element-shadow.js';
import { WetFur } from './host.js';
import { optionDefaults } from './options.js';

// Settings fields that have an attribute; every other field is a property only.
const settingAttributes = ['wind', 'dryRate', 'brushRadius', 'brushFlow', 'exposure', 'seed', 'view', 'refine', 'lightRig', 'behaviour'];
const ownAttributes = ['src', 'alt', 'poster', 'loading', 'reveal', 'interactionPrompt'];
const hostOptions = Object.keys(optionDefaults);
const forwardedEvents = [
  'load', 'progress', 'error', 'warning', 'camera-change', 'wetness-change', 'cursor-move', 'stroke-start', 'stroke-end', 'action-start', 'action-end',
  'state-change', 'context-lost', 'context-restored', 'model-visibility',
];
const kebab = (name) => name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
const camel = (name) => name.replace(/-([a-z])/g, (_, letter) => letter.toUpperCase());
const announceAfterMilliseconds = 1200;
const announceStep = 1;
const isBoolean = (name) => optionDefaults[name] === false;

/** In Node there is no HTMLElement: importing must work all the same. */
const Base = globalThis.HTMLElement ?? class {};

export class WetFurElement extends Base {
  static observedAttributes = [...ownAttributes, ...hostOptions, ...settingAttributes].map(kebab);

  #parts = buildShadow(this.attachShadow({ mode: 'open' }));
  #host = this.#newHost();
  #asked = false;
  #near = null;
  #announceTimer = 0;

  constructor() {
    super();
    this.shadowRoot.adoptedStyleSheets = [elementStyles()];
    this.#parts.reload.addEventListener('click', () => this.reload());
    this.#parts.poster.addEventListener('click', () => this.dismissPoster());
    this.#parts.poster.addEventListener('keydown', (event) => {
      if (event.key !== 'Enter' && event.key !== ' ') return;
      event.preventDefault();
      this.dismissPoster();
    });
  }

  // --- life ---

  connectedCallback() {
    this.#upgradeProperties([...ownAttributes, ...hostOptions, ...settingAttributes]);
    this.#describe();
    this.#loadWhenDue();
  }

  /** An element that is only moved keeps its picture. */
  disconnectedCallback() {
    queueMicrotask(() => { if (!this.isConnected) this.dispose(); });
  }

  /** Frees everything; when it is connected again it starts anew. */
  dispose() {
    this.#near?.disconnect();
    clearTimeout(this.#announceTimer);
    this.#announceTimer = 0;
    this.#host.dispose();
    const fresh = document.createElement('canvas');
    fresh.setAttribute('part', 'canvas');
    this.#parts.canvas.replaceWith(fresh);
    this.#parts.canvas = fresh;
    this.#host = this.#newHost();
    this.#asked = false;
    for (const { name, value } of this.attributes) this.attributeChangedCallback(name, null, value);
    this.#showState();
  }

  attributeChangedCallback(attribute, before, value) {
    const name = camel(attribute);
    if (name === 'src') this.#onSrc(before, value);
    else if (name === 'loading' || name === 'reveal' || name === 'interactionPrompt') this.#loadWhenDue();
    else if (name === 'alt') this.#describe();
    else if (name === 'poster') this.#parts.showPoster(value);
    else if (hostOptions.includes(name)) this.#setOption(name, value);
    else if (settingAttributes.includes(name)) this.#setSetting(name, value);
  }

  #setOption(name, value) {
    if (isBoolean(name)) this.#host.set(name, value !== null);
    else this.#host.set(name, value ?? optionDefaults[name]);
    this.#describe();
  }

  #setSetting(name, value) {
    const given = value ?? this.settingsTable?.find((field) => field.name === name)?.default;
    if (given !== undefined) this.#host.set(name, given);
  }

  #newHost() {
    const host = new WetFur(this.#parts.canvas);
    host.ring = this.#parts.ring;
    for (const type of forwardedEvents) host.addEventListener(type, (event) => this.#onHostEvent(type, event.detail));
    return host;
  }

  // --- loading ---

  #onSrc(before, value) {
    if (before === value || !value) return;
    if (this.#asked) this.#host.src = value;
    else this.#loadWhenDue();
  }

  /**
   * eager: at once; else as soon as it comes near the window; with reveal="interaction" not before the person asks, with
   * "manual" not before dismissPoster().
   */
  #loadWhenDue() {
    if (!this.isConnected || this.#asked || !this.src) return;
    this.#near?.disconnect();
    this.#parts.poster.tabIndex = 0;
    this.#parts.poster.inert = this.reveal !== 'interaction';
    this.#showState();
    if (this.reveal === 'interaction' || this.reveal === 'manual') return;
    if (this.loading === 'eager') {
      this.#askFor();
      return;
    }
    this.#near = new IntersectionObserver((entries) => {
      if (entries.some((entry) => entry.isIntersecting)) this.#askFor();
    }, { rootMargin: '200px' });
    this.#near.observe(this);
  }

  /** Loads what the poster stands for, which goes when that is there. */
  dismissPoster() { if (this.src) this.#askFor(); }

  #askFor() {
    if (this.#asked) return;
    this.#near?.disconnect();
    this.#asked = true;
    this.#host.src = this.src;
    this.#showState();
  }

  reload() {
    this.#asked = true;
    if (this.#host.src !== this.src) {
      this.#host.src = this.src;
      return this.#host.ready;
    }
    return this.#host.reload().catch(() => {});
  }

  async loadModel(given, options) {
    this.#asked = true;
    await this.#host.loadModel(given, options);
  }

  // --- telling ---

  #onHostEvent(type, detail) {
    if (type === 'progress') this.#parts.showProgress(detail);
    if (type === 'load') this.#onLoad();
    if (type === 'error') this.#lastError = detail;
    if (type === 'error' || type === 'state-change') this.#showState();
    if (type === 'wetness-change' || type === 'cursor-move') this.#announceSoon();
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }
  #lastError = null;

  #onLoad() {
    defineSettingProperties(this.settingsTable);
    this.#upgradeProperties(this.settingsTable.map((field) => field.name));
    this.#describe();
    this.#showState();
  }

  #showState() {
    const { state, loaded } = this.#host;
    const failed = state === 'error' || state === 'unsupported';
    const dismissed = this.#parts.showState({
      waiting: !loaded,
      prompt: !this.#asked && this.reveal === 'interaction' && this.interactionPrompt !== 'none',
      loading: state === 'loading',
      message: failed ? this.#lastError?.message ?? 'It could not be shown.' : state === 'lost' ? 'The graphics device was reset; the picture will be back in a moment.' : '',
      unsupported: state === 'unsupported',
      retry: failed,
    });
    if (dismissed) this.dispatchEvent(new CustomEvent('poster-dismissed'));
  }

  #describe() {
    const { canvas } = this.#parts;
    const interactive = this.#host.interactive;
    canvas.setAttribute('role', interactive ? 'application' : 'img');
    canvas.setAttribute('aria-label', this.alt || 'A furry model');
    if (interactive) {
      const keys = [];
      if (this.cameraControls) keys.push('Arrow keys turn the view, plus and minus zoom, Home resets it.');
      if (keyTexts[this.tool])
        keys.push(`${this.cameraControls ? 'Shift with arrow keys moves' : 'Arrow keys move'} the tool over the model, from the middle of the picture. Space ${keyTexts[this.tool]} there.`);
      canvas.setAttribute('aria-description', keys.join(' '));
    }
  }

  /** Politely: a moment after the water changed, and while it dries only at every percent. */
  #announceSoon() {
    if (this.#announceTimer) return;
    this.#announceTimer = setTimeout(() => {
      this.#announceTimer = 0;
      const percent = this.meanWetness * 100;
      const spot = this.#host.spotWetness;
      if (spot === undefined && percent > 0 && Math.abs(percent - this.#announced) < announceStep) return;
      this.#announced = percent;
      const here = spot === undefined ? '' : spot === null ? 'Beside the model. ' : `Here ${Math.ceil(spot * 100)} percent. `;
      this.#parts.status.textContent = here + (percent > 0 ? `Wetness ${Math.ceil(percent)} percent` : 'Dry');
    }, announceAfterMilliseconds);
  }
  #announced = 0;

  // --- properties ---

  /** Values that were set before the class or the field was known lie on the element itself. */
  #upgradeProperties(names) {
    for (const name of names) {
      if (!Object.hasOwn(this, name)) continue;
      const value = this[name];
      delete this[name];
      this[name] = value;
    }
  }

  /** @internal what the prototype's forwarding properties stand on */
  get fur() { return this.#host; }
}

function defineProperties(prototype) {
  const define = (name, descriptor) => Object.defineProperty(prototype, name, { enumerable: true, configurable: true, ...descriptor });
  for (const name of [...ownAttributes, ...hostOptions]) {
    const attribute = kebab(name);
    const standard = { loading: 'auto', reveal: 'auto', interactionPrompt: 'auto' }[name] ?? '';
    define(name, isBoolean(name)
      ? { get() { return this.hasAttribute(attribute); }, set(value) { this.toggleAttribute(attribute, Boolean(value)); } }
      : {
        get() { return hostOptions.includes(name) ? this.fur.get(name) : this.getAttribute(attribute) ?? standard; },
        set(value) {
          if (value === null || value === undefined) this.removeAttribute(attribute);
          else this.setAttribute(attribute, String(value));
        },
      });
  }
}

/** What else the model on the canvas offers. */
function forwardTheRest(prototype) {
  for (const [name, { value }] of Object.entries(Object.getOwnPropertyDescriptors(WetFur.prototype))) {
    if (name in prototype) continue;
    Object.defineProperty(prototype, name, {
      enumerable: true, configurable: true,
      ...(value ? { writable: true, value(...args) { return this.fur[name](...args); } } : { get() { return this.fur[name]; } }),
    });
  }
}

function defineSettingProperties(table) {
  for (const { name } of table) {
    if (name in WetFurElement.prototype) continue;
    Object.defineProperty(WetFurElement.prototype, name, {
      enumerable: true,
      configurable: true,
      get() { return this.fur.get(name); },
      set(value) { this.fur.set(name, value); },
    });
  }
}

defineProperties(WetFurElement.prototype);
forwardTheRest(WetFurElement.prototype);
defineSettingProperties(settingAttributes.map((name) => ({ name })));
if (globalThis.customElements && !customElements.get('wet-fur')) customElements.define('wet-fur', WetFurElement);
