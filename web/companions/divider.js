// The line between two pictures that lie one over the other: a separator that pointers, fingers and keys move.
import { make } from './companion.js';

const keySteps = { ArrowLeft: -2, ArrowRight: 2, PageDown: -10, PageUp: 10 };

export class Divider {
  #frame;
  #onMove;
  #handle = make('div', {
    part: 'divider', role: 'separator', tabindex: '0', 'aria-orientation': 'vertical', 'aria-valuemin': '0', 'aria-valuemax': '100',
  });
  #percent = 50;

  /** @param {HTMLElement} frame what it divides @param {(percent: number) => void} onMove a person did */
  constructor(frame, onMove) {
    this.#frame = frame;
    this.#onMove = onMove;
    frame.append(this.#handle);
    this.#handle.addEventListener('pointerdown', (event) => this.#begin(event));
    this.#handle.addEventListener('pointermove', (event) => { if (this.#handle.hasPointerCapture(event.pointerId)) this.#moveTo(event.clientX); });
    this.#handle.addEventListener('keydown', (event) => this.#onKey(event));
  }

  set label(text) { this.#handle.ariaLabel = text; }

  get rightToLeft() { return getComputedStyle(this.#frame).direction === 'rtl'; }

  /** Of the width, from where lines of text begin. */
  get percent() { return this.#percent; }
  set percent(percent) {
    this.#percent = Math.min(Math.max(percent, 0), 100);
    this.#frame.style.setProperty('--at', `${this.#percent}%`);
    this.#handle.ariaValueNow = String(Math.round(this.#percent));
    this.#handle.ariaValueText = `${Math.round(this.#percent)} percent before`;
    const [left, right] = this.rightToLeft ? [0, this.#percent] : [this.#percent, 0];
    this.#frame.style.setProperty('--seen', `inset(0 ${right}% 0 ${left}%)`);
  }

  #begin(event) {
    if (event.button !== 0) return;
    event.preventDefault();
    this.#handle.focus();
    this.#handle.setPointerCapture(event.pointerId);
  }

  #moveTo(x) {
    const { left, width } = this.#frame.getBoundingClientRect();
    const share = (100 * (x - left)) / width;
    this.#told(this.rightToLeft ? 100 - share : share);
  }

  #onKey(event) {
    const step = keySteps[event.key];
    const toEnd = { Home: 0, End: 100 }[event.key];
    if ((step === undefined && toEnd === undefined) || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    const towards = this.rightToLeft && event.key.startsWith('Arrow') ? -1 : 1;
    this.#told(toEnd ?? this.#percent + step * towards * (event.shiftKey ? 5 : 1));
  }

  #told(percent) {
    this.percent = percent;
    this.#onMove(this.#percent);
  }
}
