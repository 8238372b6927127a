// What the first visit begins with: some drops fall on the model, and a line says what the mouse does.
import { captions } from './captions.js';

const firstDropAfter = 900, betweenDrops = 170, drops = 16;  // milliseconds
const hintFor = 14000;

const touches = () => matchMedia('(hover: none)').matches;
const calm = (fur) => fur.motion === 'reduced' || (fur.motion === 'auto' && matchMedia('(prefers-reduced-motion: reduce)').matches);

/** @param {import('./element.js').WetFurElement} fur @param {HTMLElement} hint empty: nothing is said */
export function welcome(fur, hint) {
  const stop = new AbortController(), { signal } = stop;
  const name = captions[fur.modelName] ? 'it' : `the ${fur.modelName}`;
  hint.textContent = `${touches() ? 'Stroke' : 'Drag on'} ${name} to wet it, beside it to turn the view`;
  const end = () => stop.abort();
  const timers = [setTimeout(end, hintFor)];
  signal.addEventListener('abort', () => {
    hint.textContent = '';
    timers.forEach(clearTimeout);
  });
  // Who begins has seen it; drops that fall meanwhile would be in the way.
  for (const type of ['stroke-start', 'load']) fur.addEventListener(type, end, { signal });
  for (const type of ['keydown', 'wheel', 'pointerdown']) addEventListener(type, end, { signal, passive: true });
  if (calm(fur)) return;
  for (let i = 0; i < drops; ++i) timers.push(setTimeout(() => fur.sprinkle(1), firstDropAfter + i * betweenDrops));
}
