// The menu of what an animal can do: a button an action, and whether it does anything by itself.

const labelOf = (name) => `${name[0].toUpperCase()}${name.slice(1)}`;

/** @param {HTMLElement} opener hidden for models that are no animals @param {HTMLElement} panel @param {import('./element.js').WetFurElement} fur */
export function wireActs(opener, panel, fur) {
  const byItself = Object.assign(document.createElement('button'), { type: 'button', textContent: 'By itself', title: 'It looks about, breathes and moves by itself' });
  byItself.addEventListener('click', () => { fur.behaviour = fur.behaviour === 'auto' ? 'none' : 'auto'; });
  const buttonOf = (action) => {
    const button = Object.assign(document.createElement('button'), { type: 'button', textContent: labelOf(action) });
    button.dataset.action = action;
    button.addEventListener('click', () => fur.act(action));
    return button;
  };
  const show = () => {
    byItself.setAttribute('aria-pressed', String(fur.behaviour === 'auto'));
    for (const button of panel.querySelectorAll('[data-action]')) button.setAttribute('aria-pressed', String(button.dataset.action === fur.action));
  };
  fur.addEventListener('load', () => {
    const { actions } = fur;
    opener.hidden = actions.length === 0;
    if (opener.hidden && panel.matches(':popover-open')) panel.hidePopover();
    panel.replaceChildren(...actions.map(buttonOf), byItself);
    show();
  });
  for (const type of ['action-start', 'action-end', 'state-change']) fur.addEventListener(type, show);
}
