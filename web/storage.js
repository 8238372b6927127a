// The browser's storage (IndexedDB), as promises.

export const result = (request) => new Promise((resolve, reject) => {
  request.onsuccess = () => resolve(request.result);
  request.onerror = () => reject(request.error);
});

/** Until all of it is written. */
export const written = (transaction) => new Promise((resolve, reject) => {
  transaction.oncomplete = resolve;
  transaction.onabort = () => reject(transaction.error ?? new Error('the browser gave up'));
});

/** @param {string} name @param {(database: IDBDatabase) => void} makeStores of a new one */
export async function openDatabase(name, makeStores) {
  const request = indexedDB.open(name, 1);
  request.onupgradeneeded = () => makeStores(request.result);
  const database = await result(request);
  database.onversionchange = () => database.close();
  return database;
}

/**
 * Stores of a database that is open only while it is worked with: change(work), of which all is done or nothing, where `work` is given
 * the stores by name and may only await their requests; read(store, id), all of a store without an id.
 */
export function keptStores(name, stores, makeStores) {
  const during = async (work) => {
    const database = await openDatabase(name, makeStores);
    try {
      return await work(database);
    } finally {
      database.close();
    }
  };
  return {
    change: (work) => during(async (database) => {
      const transaction = database.transaction(stores, 'readwrite');
      const done = written(transaction);
      done.catch(() => {});
      await work(Object.fromEntries(stores.map((store) => [store, transaction.objectStore(store)])));
      await done;
    }),
    read: (store, id) => during((database) => {
      const all = database.transaction(store).objectStore(store);
      return result(id === undefined ? all.getAll() : all.get(id));
    }),
  };
}

/** Of a record. */
export const newId = () => `${Date.now().toString(36)}-${Math.random().toString(36).slice(2)}`;
