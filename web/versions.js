// Scenes that a person keeps under names, in the browser's storage beside the records of autosave.js: for the editor.
import { keptStores, newId, result } from './storage.js';

const stores = ['versions', 'documents', 'models'];

function makeStores(database) {
  database.createObjectStore('versions', { keyPath: 'id' });  // name, time, picture, modelId: what the list shows
  database.createObjectStore('documents');  // by the version's id
  database.createObjectStore('models');  // as opened, by what they hold: once for all their versions
}
/** A database of its own: tabs of before go on with theirs. */
const { change, read } = keptStores('wet-fur-versions', stores, makeStores);

const hex = (bytes) => Array.from(new Uint8Array(bytes), (byte) => byte.toString(16).padStart(2, '0')).join('');

/** The same for the same model. Pages without the browser's hashing keep each version's model for itself. */
async function idOfModel({ name, bytes, files }) {
  if (!globalThis.crypto?.subtle) return newId();
  const hashes = [name];
  for (const [file, content] of [['', bytes], ...files ?? []]) hashes.push(file, hex(await crypto.subtle.digest('SHA-256', content)));
  return hashes.join(' ');
}

const reason = (error) => (error.name === 'QuotaExceededError' ? 'the browser has no room left; deleting versions makes some' : error.message || error.name);

export class Versions {
  #panel;
  #fur;

  /** @param {import('./editor.js').EditorPanel} panel @param {import('./host.js').WetFur} fur */
  constructor(panel, fur) {
    this.#panel = panel;
    this.#fur = fur;
    this.show();
  }

  /** What there is, in the panel. */
  async show() {
    try {
      const versions = await read('versions');
      this.#panel.showVersions(versions.sort((a, b) => b.time - a.time));
    } catch {
      // A page without storage has none; told when there is something to keep.
    }
  }

  keep(name) {
    return this.#do(`"${name}" was not kept`, async () => {
      const picture = this.#panel.versionPicture();
      const { source, ...document } = this.#fur.document;
      const modelId = source.bytes ? await idOfModel(source) : null;
      const id = newId();
      navigator.storage?.persist?.().catch(() => {});
      await change(async ({ versions, documents, models }) => {
        versions.put({ id, name, time: Date.now(), picture, modelId, ...modelId ? {} : { source } });
        documents.put(document, id);
        if (modelId && await result(models.count(modelId)) === 0) models.put(source, modelId);
      });
    });
  }

  /** One step of undo leads back to what there is now. */
  open(id) {
    return this.#do('The version was not opened', async () => {
      const { modelId, name, source = await read('models', modelId) } = await read('versions', id);
      const document = await read('documents', id);
      if (!source || !document) throw new Error(`"${name}" is no longer in the browser's storage`);
      await this.#fur.openDocument({ ...document, source });
    });
  }

  rename(id, name) {
    return this.#do(`It was not renamed "${name}"`, () => change(async ({ versions }) => {
      versions.put({ ...await result(versions.get(id)), name });
    }));
  }

  delete(id) {
    return this.#do('The version was not deleted', () => change(async ({ versions, documents, models }) => {
      const { modelId } = await result(versions.get(id));
      versions.delete(id);
      documents.delete(id);
      const others = await result(versions.getAll());
      if (modelId && !others.some((one) => one.modelId === modelId)) models.delete(modelId);
    }));
  }

  async #do(failure, work) {
    try {
      await work();
    } catch (error) {
      this.#panel.message(`${failure}: ${reason(error)}`, true);
    }
    await this.show();
  }
}
