// <wet-fur-compare>: before and after, with a divider between them. Of two figures (or pictures) inside it, which stay alive and share their
// camera; or, with `for`, `before` and `after`, of one figure in two states, as two pictures of the moment: a second live figure would
// have neither the first one's water nor its time, and drawing one by turns would cost twice as much for as long as it is seen. They are
// taken anew when the figure has changed and come to rest. States that grow another coat keep the page busy for as long as that takes:
// for those two figures are better.
import { Companion, make, MarkupError } from './companion.js';
import { Divider } from './divider.js';
import { pictureWith } from './states.js';
import { fieldOf } from './values.js';

const restMilliseconds = 300;

function side(name) {
  const slot = make('slot'), canvas = make('canvas', { 'aria-hidden': 'true', hidden: '' }), caption = make('span', { part: 'caption', hidden: '' });
  const box = make('div', { class: `side ${name}`, part: name }, slot, canvas, caption);
  return { box, slot, canvas, caption };
}

export class WetFurCompareElement extends Companion {
  static observedAttributes = [...Companion.observedAttributes, 'before', 'after', 'before-label', 'after-label', 'position'];
  static events = [...Companion.events, 'camera-change', 'wetness-change'];
  static shadow = { slotAssignment: 'manual' };

  #before = side('before');
  #after = side('after');
  #frame = make('div', { class: 'compare', part: 'frame' }, this.#before.box, this.#after.box);
  #divider = new Divider(this.#frame, () => this.dispatchEvent(new CustomEvent('divide', { detail: { position: this.#divider.percent } })));
  #children = new MutationObserver(() => this.#assign());
  #seen = new IntersectionObserver((entries) => {
    this.#inView = entries.at(-1).isIntersecting;
    this.refreshSafely();
  });
  #inView = false;
  #states = null;
  #taken = '';
  #timer = 0;
  #unlink = null;

  constructor() {
    super();
    this.#after.box.style.clipPath = 'var(--seen)';
  }

  get alone() { return !this.hasAttribute('for'); }
  /** Percent of the width that shows what was before. */
  get position() { return this.#divider.percent; }
  set position(percent) {
    if (this.built) this.#divider.percent = Number(percent);
    else this.setAttribute('position', percent);
  }

  connectedCallback() {
    super.connectedCallback();
    this.#children.observe(this, { childList: true, attributeFilter: ['slot'], subtree: true });
    this.#seen.observe(this);
    this.#assign();
  }
  removed() {
    this.#children.disconnect();
    this.#seen.disconnect();
    this.#unlink?.abort();
    clearTimeout(this.#timer);
  }

  build() {
    this.#states = null;
    this.#taken = '';
    this.show(this.#frame);
    this.#divider.percent = this.number('position', 50);
    this.#divider.label = this.label || 'Before and after';
    for (const [name, { caption }] of [['before', this.#before], ['after', this.#after]]) {
      caption.textContent = this.getAttribute(`${name}-label`) ?? (this.alone ? '' : name === 'before' ? 'Before' : 'After');
      caption.hidden = !caption.textContent;
    }
    if (this.alone) return;
    this.#states = ['before', 'after'].map((name) => this.#values(name));
  }

  #values(name) {
    const values = this.json(name, {});
    for (const key of Object.keys(values)) {
      const field = fieldOf(key);
      if (!field) throw new MarkupError(`There is no setting “${key}”.`);
      if (key !== 'cameraOrbit' && (field.type === 'text' || key === 'preset')) throw new MarkupError(`${name} takes settings, wetness and cameraOrbit: for “${key}” put two figures into this element.`);
    }
    return values;
  }

  // --- two figures ---

  #assign() {
    if (!this.alone) return;
    const given = [...this.children];
    const named = (name) => given.find((one) => one.slot === name);
    const rest = given.filter((one) => !one.slot);
    const before = named('before') ?? rest.shift(), after = named('after') ?? rest.shift();
    this.#before.slot.assign(...before ? [before] : []);
    this.#after.slot.assign(...after ? [after] : []);
    this.tell('children', before && after ? '' : 'It needs two figures, or for="…" with before="…" and after="…".');
    this.#link([before, after]);
  }

  /** Of two figures, the one that a person turns to leads the other's camera. */
  #link(pair) {
    this.#unlink?.abort();
    this.#unlink = new AbortController();
    if (!pair.every((one) => one?.localName === 'wet-fur')) return;
    const { signal } = this.#unlink;
    let leader = pair[0];
    pair.forEach((one, i) => {
      const other = pair[1 - i];
      for (const type of ['pointerdown', 'focusin', 'wheel']) one.addEventListener(type, () => { leader = one; }, { signal, passive: true });
      const follow = () => {
        if (leader === one && one.loaded && other.loaded && other.cameraOrbitText !== one.cameraOrbitText) other.cameraOrbit = one.cameraOrbitText;
      };
      one.addEventListener('camera-change', follow, { signal });
    });
  }

  // --- one figure in two states ---

  refresh() {
    const { figure } = this;
    for (const { canvas, slot } of [this.#before, this.#after]) {
      canvas.hidden = this.alone;
      slot.hidden = !this.alone;
    }
    clearTimeout(this.#timer);
    if (!this.#states || !figure) return;
    // As large as the pictures will be: nothing moves when they come.
    if (!this.#taken && figure.clientWidth) for (const { canvas } of [this.#before, this.#after]) Object.assign(canvas, { width: figure.clientWidth, height: figure.clientHeight });
    if (figure.loaded && this.#inView) this.#timer = setTimeout(() => this.#take(figure), restMilliseconds);
  }

  async #take(figure) {
    const state = () => JSON.stringify([figure.getState(), figure.wetnessHash, figure.modelName, figure.clientWidth, figure.clientHeight, this.#states]);
    const seen = state();
    if (seen === this.#taken || figure !== this.figure || !figure.loaded) return;
    this.#taken = seen;
    try {
      const blobs = await Promise.all(this.#states.map((values) => pictureWith(figure, values)));
      const pictures = await Promise.all(blobs.map((blob) => createImageBitmap(blob)));
      if (seen !== this.#taken) {  // others have been asked for meanwhile
        for (const picture of pictures) picture.close();
        return;
      }
      [this.#before, this.#after].forEach(({ canvas }, i) => {
        Object.assign(canvas, { width: pictures[i].width, height: pictures[i].height });
        canvas.getContext('2d').drawImage(pictures[i], 0, 0);
        pictures[i].close();
      });
      this.tell('picture', '');
      this.dispatchEvent(new CustomEvent('picture-change'));
    } catch (error) {
      if (seen !== this.#taken) return;
      this.#taken = '';
      this.tell('picture', error.message);
    }
  }
}
