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

/** Of a record. */
export const newId = () => `${Date.now().toString(36)}-${Math.random().toString(36).slice(2)}`;
