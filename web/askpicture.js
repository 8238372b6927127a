// Asks what a picture is that somebody has dropped or opened.
import './host.js';  // which has fetched this: named here, what both need is joined into one file with it
import { pictureUses } from '#tables';

const style = `
  dialog { border: 0; border-radius: 10px; padding: 16px; max-width: min(360px, calc(100vw - 32px)); box-sizing: border-box;
    font: 15px/1.4 system-ui, sans-serif; color: CanvasText; background: Canvas; color-scheme: light dark; box-shadow: 0 8px 40px #0008; }
  dialog::backdrop { background: #0006; }
  h2 { font-size: 17px; margin: 0 0 4px; }
  p { margin: 0 0 10px; opacity: 0.7; overflow-wrap: anywhere; }
  button { display: block; width: 100%; min-height: 44px; margin: 4px 0 0; padding: 6px 12px; font: inherit; text-align: start; color: inherit;
    background: color-mix(in srgb, CanvasText 8%, Canvas); border: 1px solid transparent; border-radius: 6px; cursor: pointer; }
  button:hover { background: color-mix(in srgb, CanvasText 16%, Canvas); }
  button:focus-visible { outline: 2px solid Highlight; }
`;

/** A name of '#tables' pictureUses, or null. @param {string} name of the file @param {HTMLElement} canvas that takes the focus again */
export function askPicture(name, canvas) {
  const host = document.createElement('div');
  const root = host.attachShadow({ mode: 'open' });
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(style);
  root.adoptedStyleSheets = [sheet];
  const make = (tag, properties) => Object.assign(document.createElement(tag), properties);
  const dialog = make('dialog', {});
  const title = make('h2', { id: 'title', textContent: 'What is this picture?' });
  dialog.setAttribute('aria-labelledby', 'title');
  dialog.append(title, make('p', { textContent: name }));
  for (const { name: use, label, doc } of pictureUses) dialog.append(make('button', { type: 'button', value: use, textContent: label, title: doc }));
  dialog.append(make('button', { type: 'button', value: '', textContent: 'Cancel' }));
  root.append(dialog);
  document.body.append(host);
  return new Promise((resolve) => {
    const choices = [...dialog.querySelectorAll('button')];
    dialog.addEventListener('click', ({ target }) => {
      if (target.localName === 'button') dialog.close(target.value);
      else if (target === dialog) dialog.close('');  // beside it, on its backdrop
    });
    dialog.addEventListener('keydown', (event) => {
      event.stopPropagation();
      const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
      if (!step) return;
      event.preventDefault();
      choices[(choices.indexOf(root.activeElement) + step + choices.length) % choices.length].focus();
    });
    dialog.addEventListener('close', () => {
      host.remove();
      canvas.focus({ preventScroll: true });
      resolve(dialog.returnValue || null);
    });
    dialog.showModal();
    choices[0].focus();
  });
}
