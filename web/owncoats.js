// Coats that a person keeps under names beside the presets, in the browser's storage: for the page and the editor.
import { keptStores, newId, result } from './storage.js';

/** { id, name, time, bytes: a .coat file (src/scene/CoatFile.h), picture: a Blob or null } */
const kept = keptStores('wet-fur-coats', ['coats'], (database) => database.createObjectStore('coats', { keyPath: 'id' }));

/** Tells 'change' on this page. */
export const ownCoatsChanges = new EventTarget();

async function change(work) {
  try {
    await kept.change(({ coats }) => work(coats));
  } catch (error) {
    throw error.name === 'QuotaExceededError' ? new Error('the browser has no room left; deleting coats or versions makes some') : error;
  }
  ownCoatsChanges.dispatchEvent(new Event('change'));
}

/** By name. A browser without storage has none, which is told when there is something to keep. */
export async function listOwnCoats() {
  const all = await kept.read('coats').catch(() => []);
  return all.sort((a, b) => a.name.localeCompare(b.name) || a.time - b.time);
}

export async function ownCoat(id) {
  const coat = await kept.read('coats', id);
  if (!coat) throw new Error("the coat is no longer in the browser's storage");
  return coat;
}

/** @param {Uint8Array} bytes as saveCoat() gives them @param {Blob | null} picture */
export async function keepOwnCoat(name, bytes, picture) {
  navigator.storage?.persist?.().catch(() => {});
  await change(async (coats) => { coats.put({ id: newId(), name, time: Date.now(), bytes, picture }); });
}

export const renameOwnCoat = (id, name) => change(async (coats) => {
  const coat = await result(coats.get(id));
  if (!coat) return;
  const file = { ...JSON.parse(new TextDecoder().decode(coat.bytes)), name };
  coats.put({ ...coat, name, bytes: new TextEncoder().encode(JSON.stringify(file)) });
});

export const deleteOwnCoat = (id) => change(async (coats) => { coats.delete(id); });

/** The settings of one of them, as states have them. */
export const settingsOfCoat = ({ bytes }) => JSON.parse(new TextDecoder().decode(bytes)).settings ?? {};

/** "Winter fox!" as "Winter-fox.coat". */
export const coatFileName = (name) => `${name.replace(/[^\p{L}\p{N}]+/gu, '-').replace(/^-+|-+$/g, '').slice(0, 64) || 'coat'}.coat`;
