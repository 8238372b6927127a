// The demo page's dialog of coats of one's own: keeps the one that is shown, renames, saves as files and deletes.
import { download } from './download.js';
import { coatFileName, deleteOwnCoat, keepOwnCoat, listOwnCoats, renameOwnCoat } from './owncoats.js';

const mostNameCharacters = 80;

const make = (tag, properties, ...children) => {
  const element = Object.assign(document.createElement(tag), properties);
  element.append(...children);
  return element;
};
const button = (textContent, onclick, label = textContent) => make('button', { type: 'button', textContent, onclick, ariaLabel: label });

export class CoatDialog {
  #dialog = make('dialog', { className: 'own-coats' });
  #list = make('ul', {});
  #name = make('input', { maxLength: mostNameCharacters, autocomplete: 'off', ariaLabel: 'Name of the coat', required: true, pattern: '.*\\S.*' });
  #status = make('p', { role: 'status' });
  #saveCoat;

  /** @param {(name: string) => Promise<{ bytes: Uint8Array, picture: Blob | null }>} saveCoat of the coat that is shown */
  constructor(saveCoat) {
    this.#saveCoat = saveCoat;
    const title = make('h2', { id: 'own-coats-title', textContent: 'Coats of your own' });
    const form = make('form', {}, this.#name, make('button', { textContent: 'Keep this coat' }));
    form.addEventListener('submit', (event) => {
      event.preventDefault();
      this.#keep();
    });
    this.#dialog.setAttribute('aria-labelledby', title.id);
    this.#dialog.append(title, form, this.#list, this.#status, button('Close', () => this.#dialog.close()));
    this.#dialog.addEventListener('keydown', (event) => event.stopPropagation());
    this.#dialog.addEventListener('click', ({ target }) => { if (target === this.#dialog) this.#dialog.close(); });
    document.body.append(this.#dialog);
  }

  /** Until it is closed. */
  async open() {
    const coats = await this.#show();
    this.#name.value = `Coat ${coats.length + 1}`;
    this.#status.textContent = '';
    this.#dialog.showModal();
    this.#name.select();
    await new Promise((resolve) => this.#dialog.addEventListener('close', resolve, { once: true }));
  }

  async #show() {
    const coats = await listOwnCoats();
    this.#list.replaceChildren(...coats.map((coat) => this.#row(coat)));
    return coats;
  }

  #row({ id, name, bytes }) {
    const field = make('input', { value: name, maxLength: mostNameCharacters, autocomplete: 'off', ariaLabel: `Name of ${name}` });
    const rename = () => {
      const wanted = field.value.trim();
      if (wanted && wanted !== name) this.#do(`It was not renamed "${wanted}"`, () => renameOwnCoat(id, wanted));
      else field.value = name;
    };
    field.addEventListener('change', rename);
    return make('li', {}, field,
      button('Save file', () => download(bytes, coatFileName(name)), `Save ${name} as a file`),
      button('Delete', ({ target }) => this.#askToDelete(target, id, name), `Delete ${name}`));
  }

  /** The second press does it. */
  #askToDelete(target, id, name) {
    if ('asked' in target.dataset) return this.#do(`${name} was not deleted`, () => deleteOwnCoat(id));
    Object.assign(target, { textContent: 'For good?', ariaLabel: `Delete ${name} for good` });
    target.dataset.asked = '';
  }

  #keep() {
    const name = this.#name.value.trim();
    return this.#do(`"${name}" was not kept`, async () => {
      const { bytes, picture } = await this.#saveCoat(name);
      await keepOwnCoat(name, bytes, picture);
      this.#status.textContent = `"${name}" is kept beside the other coats`;
    });
  }

  async #do(failure, work) {
    this.#status.textContent = '';
    try {
      await work();
    } catch (error) {
      this.#status.textContent = `${failure}: ${error.message || error.name}`;
    }
    await this.#show();
  }
}
