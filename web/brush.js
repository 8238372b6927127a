// The demo page's brush: sliders for its size and for the water that it brings, and the keys [ and ].

const keyStep = 1.2;

/** Whether the key is written into something. */
function isTyped(event) {
  const [target] = event.composedPath();
  return target.isContentEditable || (target.matches?.('input, textarea') && !/range|checkbox|button/.test(target.type));
}

/** @param {HTMLElement} panel with an input[data-setting] for each @param {import('./element.js').WetFurElement} fur */
export function wireBrush(panel, fur) {
  const sliders = [...panel.querySelectorAll('[data-setting]')];
  const fieldOf = (slider) => fur.settingsTable.find(({ name }) => name === slider.dataset.setting);
  const show = () => {
    if (!fur.settingsTable) return;
    for (const slider of sliders) {
      const { min, max } = fieldOf(slider);
      Object.assign(slider, { min, max, step: (max - min) / 100, value: fur.settings[slider.dataset.setting] });
      const text = `${Math.round(100 * (slider.value - min) / (max - min))} %`;
      slider.ariaValueText = slider.parentElement.querySelector('output').value = text;
    }
  };
  for (const slider of sliders)
    slider.addEventListener('input', () => { fur.settings[slider.dataset.setting] = Number(slider.value); });
  panel.addEventListener('beforetoggle', show);
  for (const type of ['load', 'state-change']) fur.addEventListener(type, show);
  addEventListener('keydown', (event) => {
    const way = { '[': -1, ']': 1 }[event.key];
    if (!way || !fur.loaded || event.defaultPrevented || event.ctrlKey || event.metaKey || isTyped(event)) return;
    const { min, max } = fieldOf(sliders[0]);
    fur.settings.brushRadius = Math.min(max, Math.max(min, fur.settings.brushRadius * keyStep ** way));
    event.preventDefault();
  });
}
