// The demo page's bar: one stop for Tab, arrow keys between its controls and those of what opens beside it, and how much of the
// picture it leaves free. Where its groups stand is page.css's: a row, two rows, or a rail at each side.

const gap = 8;
const controlsIn = 'button, a, select, input:not([type=file])';
const usableIn = (part) => [...part.querySelectorAll(controlsIn)].filter((control) => !control.disabled && control.checkVisibility());

export class Toolbar {
  #bar;
  #groups;
  #panels;
  #resized;

  /** @param {HTMLElement} bar role=toolbar @param {HTMLElement[]} panels popovers that buttons of it open */
  constructor(bar, panels) {
    this.#bar = bar;
    this.#groups = [...bar.querySelectorAll('.group')];
    this.#panels = panels;
    bar.addEventListener('keydown', (event) => moveFocus(event, this.#controls, { wraps: true }));
    for (const panel of panels) panel.addEventListener('keydown', (event) => moveFocus(event, usableIn(panel)));
    bar.addEventListener('focusin', ({ target }) => this.#makeStop(target));
    this.#makeStop(this.#controls[0]);
    for (const group of this.#groups) group.addEventListener('scroll', () => showEnds(group), { passive: true });
    for (const panel of panels) panel.addEventListener('beforetoggle', ({ newState }) => {
      // It can be measured once it is open, and is seen only after that.
      if (newState === 'open') requestAnimationFrame(() => this.#place(panel));
    });
  }

  /** Calls back with { left, top, right, bottom }, CSS pixels that it covers, whenever those may have changed. */
  watch(others, onCovered) {
    this.#resized = () => {
      this.#groups.forEach(showEnds);
      for (const panel of this.#panels) if (panel.matches(':popover-open')) this.#place(panel);
      onCovered(this.#covered(others));
    };
    const observer = new ResizeObserver(this.#resized);
    for (const part of [this.#bar, ...this.#groups, ...others]) observer.observe(part);
    addEventListener('resize', this.#resized);
  }

  /** Something moved without being resized. */
  refresh() {
    this.#resized?.();
    if (!this.#controls.some(({ tabIndex }) => tabIndex === 0)) this.#makeStop(this.#controls[0]);
  }

  // --- keys ---

  get #controls() { return usableIn(this.#bar); }

  #makeStop(control) {
    if (!control?.matches(controlsIn)) return;
    for (const one of this.#bar.querySelectorAll(controlsIn)) one.tabIndex = one === control ? 0 : -1;
  }

  /** `[button, enabled]` each: one that is disabled while it has the focus hands that on. */
  enable(pairs) {
    const lost = pairs.some(([button, enabled]) => !enabled && button === document.activeElement);
    for (const [button, enabled] of pairs) button.disabled = !enabled;
    if (lost) (pairs.find(([, enabled]) => enabled)?.[0] ?? this.#controls[0]).focus();
  }

  // --- room ---

  get #rails() { return getComputedStyle(this.#bar).getPropertyValue('--rails').trim() === '1'; }

  #place(panel) {
    const opener = this.#bar.querySelector(`[popovertarget=${panel.id}]`);
    const box = panel.getBoundingClientRect(), from = opener.getBoundingClientRect();
    let left = (from.left + from.right - box.width) / 2, top = (from.top + from.bottom - box.height) / 2;
    const beside = (this.#rails ? opener.closest('.group') : this.#bar).getBoundingClientRect();
    if (this.#rails) left = beside.left > innerWidth / 2 ? beside.left - gap - box.width : beside.right + gap;
    else top = beside.top > innerHeight / 2 ? beside.top - gap - box.height : beside.bottom + gap;
    const within = (at, size, all) => Math.max(gap, Math.min(at, all - size - gap));
    panel.style.inset = `${within(top, box.height, innerHeight)}px auto auto ${within(left, box.width, innerWidth)}px`;
  }

  #covered(others) {
    const out = { left: 0, top: 0, right: 0, bottom: 0 };
    const cover = (side, pixels) => { out[side] = Math.max(out[side], Math.round(pixels)); };
    for (const part of [...(this.#rails ? this.#groups : [this.#bar]), ...others]) {
      const { left, top, right, bottom, width, height } = part.getBoundingClientRect();
      // What is in a corner hides nothing of the model.
      if (width === 0 || height === 0 || (others.includes(part) && width < innerWidth / 2)) continue;
      // A rail is higher than wide, all else lies along the upper or lower edge.
      if (this.#rails && height > width) {
        if (left < innerWidth / 2) cover('left', right);
        else cover('right', innerWidth - left);
      } else if (top < innerHeight / 2) cover('top', bottom);
      else cover('bottom', innerHeight - top);
    }
    return out;
  }
}

/**
 * Arrows, Home and End go from one of `controls` to another, but for the keys that the one with the focus needs itself.
 * `wraps`: from the last to the first, too.
 */
function moveFocus(event, controls, { wraps = false } = {}) {
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  const { key, target } = event;
  const types = target.matches('input') && !/range|checkbox|color|file/.test(target.type);
  const ranges = target.type === 'range';  // it is left up or down
  const step = { ArrowRight: !ranges && 1, ArrowLeft: !ranges && -1, ArrowDown: 1, ArrowUp: -1 }[key];
  const end = { Home: 0, End: -1 }[key];
  // Up and down choose in a list, as everywhere; text is left by Tab.
  if (types || (target.matches('select') && /Up|Down/.test(key))) return;
  if (!step && (end === undefined || ranges)) return;
  const at = controls.indexOf(target);
  const next = step ? controls[wraps ? (at + step + controls.length) % controls.length : at + step] : controls.at(end);
  next?.focus();
  next?.scrollIntoView({ block: 'nearest', inline: 'nearest' });
  event.preventDefault();
}

/** Which ends of a scrolling group have more behind them. */
function showEnds(group) {
  const along = group.scrollWidth > group.clientWidth + 1
    ? [group.scrollLeft, group.scrollWidth - group.clientWidth] : [group.scrollTop, group.scrollHeight - group.clientHeight];
  group.toggleAttribute('data-before', along[0] > 1);
  group.toggleAttribute('data-after', along[0] < along[1] - 1);
}
