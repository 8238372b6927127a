// The page's work, kept in the browser's storage from visit to visit.
//
// Every tab has a record of its own and writes to no other, so that two tabs cannot destroy each other's work. A tab that
// is opened goes on with the newest record that no open tab holds, which a lock tells; one that is reloaded with its own.
// A link that says what is to be seen begins a new record. The newest few stay.
import { modelNames } from './models.js';
import { newId, openDatabase, result, written } from './storage.js';

const mostRecords = 4;
const quietMilliseconds = 1000, latestMilliseconds = 5000;
/** Water that dries and a view that turns are worth a write now and then. */
const driftMilliseconds = 15000;
const sessionKey = 'wet-fur-record';

function makeStores(database) {
  database.createObjectStore('records', { keyPath: 'id' });
  database.createObjectStore('models');  // as opened, by the record's id: written once, not with every change
}

/** This tab's, which outlives a reload. */
const session = {
  get id() {
    try {
      return sessionStorage.getItem(sessionKey);
    } catch {
      return null;
    }
  },
  set id(id) {
    try {
      sessionStorage.setItem(sessionKey, id);
    } catch {
      // Then a reload is as another visit.
    }
  },
};

const lockName = (id) => `wet-fur-record ${id}`;

/** Whether no tab holds it; with `holdOn` this one does from now on. */
function isFree(id, holdOn) {
  if (!navigator.locks) return Promise.resolve(true);
  return new Promise((resolve) => {
    navigator.locks.request(lockName(id), { ifAvailable: true }, (lock) => {
      resolve(lock !== null);
      return lock && holdOn ? new Promise(() => {}) : undefined;
    }).catch(() => resolve(true));
  });
}

export class Autosave {
  #fur;
  #link;
  #onFailure;
  #database = null;
  #id = null;
  #keptSource = null;
  #seen = null;
  #changed = false;
  #since = 0;
  #timer = 0;
  #writing = null;
  #failed = false;

  /**
   * @param {import('./element.js').WetFurElement} fur
   * @param {string} link what the address says of the scene, '' for nothing
   * @param {(reason: string) => void} onFailure told once
   */
  constructor(fur, link, onFailure) {
    this.#fur = fur;
    this.#link = link;
    this.#onFailure = onFailure;
  }

  /** Whether closing the tab would lose something. */
  get unsaved() { return this.#failed && this.#changed; }

  /**
   * Work of before, newest first, and whether it is to be shown: else a link wins over it.
   * @returns {Promise<{ document: import('./documents.js').Document, shows: boolean } | null>}
   */
  async find() {
    try {
      return await this.#find();
    } catch {
      return null;  // told when there is something to keep
    } finally {
      this.#id ??= newId();
      isFree(this.#id, true);  // where it does not hold it already
      session.id = this.#id;
    }
  }

  async #find() {
    const database = await this.#open();
    const records = await result(database.transaction('records').objectStore('records').getAll());
    records.sort((a, b) => b.time - a.time);
    const own = records.find(({ id, link }) => id === session.id && link === this.#link);
    let record = own;
    for (const one of own ? [] : records) if (!record && await isFree(one.id)) record = one;
    if (!record) return null;
    const shows = Boolean(own) || !this.#link;
    // A tab that was duplicated begins with a copy; where no lock tells, every tab does.
    if (shows && (own || navigator.locks) && await isFree(record.id, true)) this.#id = record.id;
    const source = record.source ?? await result(database.transaction('models').objectStore('models').get(record.id));
    return source ? { document: { ...record.document, source }, shows } : null;
  }

  async #open() {
    this.#database ??= openDatabase('wet-fur', makeStores);
    try {
      return await this.#database;
    } catch (error) {
      this.#database = null;
      throw error;
    }
  }

  /** From now on changes are kept, those since `seen` as well: people begin while pictures of the model are still decoded. */
  begin(seen) {
    this.#seen = seen;
    const fur = this.#fur;
    for (const type of ['state-change', 'stroke-end', 'load']) fur.addEventListener(type, () => this.#onChange());
    for (const type of ['wetness-change', 'camera-change']) fur.addEventListener(type, () => this.#onDrift());
    const now = () => this.write();
    document.addEventListener('visibilitychange', () => { if (document.hidden) now(); });
    addEventListener('pagehide', now);
    this.#onChange();
  }

  /** What there is now is nothing to keep. */
  async forget() {
    clearTimeout(this.#timer);
    this.#timer = 0;
    this.#changed = false;
    this.#keptSource = null;
    this.#seen = this.#fur.fur.changes;
    await this.#writing;
    try {
      await this.#delete([this.#id]);
    } catch {
      // Then there is none.
    }
  }

  async #delete(ids) {
    const transaction = (await this.#open()).transaction(['records', 'models'], 'readwrite');
    for (const store of ['records', 'models']) for (const id of ids) transaction.objectStore(store).delete(id);
    await written(transaction);
  }

  /** Whether there is anything that a fresh page has not. */
  get #worthKeeping() {
    const fur = this.#fur;
    if (!fur.loaded || fur.fur.changes === this.#seen) return false;
    return fur.canUndo || fur.canRedo || (fur.groomed && !fur.fur.cameWith?.groom) || fur.meanWetness > 0;
  }

  #onChange() {
    if (!this.#worthKeeping) return;
    const now = Date.now();
    if (!this.#changed) this.#since = now;
    this.#changed = true;
    if (this.#timer && now - this.#since > latestMilliseconds) return;
    clearTimeout(this.#timer);
    this.#writeIn(quietMilliseconds);
  }

  #onDrift() {
    if (this.#timer || !this.#worthKeeping) return;
    this.#writeIn(driftMilliseconds);
  }

  #writeIn(milliseconds) {
    const whenIdle = globalThis.requestIdleCallback ?? ((work) => work());
    this.#timer = setTimeout(() => whenIdle(() => this.write(), { timeout: 2000 }), milliseconds);
  }

  /** Now, if there is anything new. */
  async write() {
    const due = this.#timer || this.#changed;
    clearTimeout(this.#timer);
    this.#timer = 0;
    if (!due || !this.#fur.loaded) return;
    await this.#writing;
    this.#writing = this.#write();
    await this.#writing;
  }

  async #write() {
    this.#changed = false;
    const { source, ...rest } = this.#fur.fur.document;
    const shipped = modelNames.includes(source.src);
    try {
      const transaction = (await this.#open()).transaction(['records', 'models'], 'readwrite');
      transaction.objectStore('records').put({
        id: this.#id, time: Date.now(), link: this.#link, source: shipped ? { src: source.src } : null, document: rest,
      });
      const models = transaction.objectStore('models');
      if (shipped) models.delete(this.#id);
      else if (source !== this.#keptSource) models.put(source, this.#id);
      await written(transaction);
      this.#keptSource = shipped ? null : source;
      this.#failed = false;
      await this.#forgetOldest();
    } catch (error) {
      this.#changed = true;
      this.#keptSource = null;
      const isFirst = !this.#failed;
      this.#failed = true;
      if (isFirst) this.#onFailure(error.message || error.name);
    }
  }

  async #forgetOldest() {
    const records = (await this.#open()).transaction('records').objectStore('records');
    if (await result(records.count()) <= mostRecords) return;
    const all = await result((await this.#open()).transaction('records').objectStore('records').getAll());
    const old = all.sort((a, b) => b.time - a.time).slice(mostRecords);
    const free = await Promise.all(old.map(({ id }) => isFree(id)));
    await this.#delete(old.filter((_, i) => free[i]).map(({ id }) => id));
  }
}
