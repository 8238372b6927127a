// What `src` and a dropped or picked file mean, and the pictures that models bring.
import { kindOfEnding } from '#tables';
import { FurError } from './errors.js';
import { fetchBytes, fileNameOf, maxFileBytes } from './fetching.js';
import { pause, pieceSeconds } from './schedule.js';

export const primitives = Object.freeze(['sphere', 'torus', 'plane']);
/** Models with a groom, a look and a camera of their own (assets/scenes/scenes.mjs). */
export const sceneNames = Object.freeze(['five-coats', 'shells-8', 'shells-16', 'shells-32', 'fins-everywhere', 'fins-outline', 'fading', 'variance', 'interpolation',
  'wet-bunny', 'half-wet', 'wet-letters', 'wet-straight', 'wet-bent', 'wet-tile', 'hair-short', 'hair-shoulder', 'hair-pony']);
/** Shown where nothing else is asked for; others where it cannot be, and at addresses from before there was the first. */
export const firstModel = 'otter', plainModel = 'bunny';
/** Models that move by themselves, with a coat and a camera of their own. */
export const animalNames = Object.freeze(['otter', 'pony']);
/** `plain-bunny`: the scan without eyes, by which pictures are measured. */
const shippedModels = Object.freeze([...animalNames, 'bunny', 'plain-bunny', ...sceneNames]);
/** The names that `src` takes beside addresses. */
export const modelNames = Object.freeze([...shippedModels, ...primitives]);

const kindOf = ({ name }) => kindOfEnding[/\.\w+$/.exec(name)?.[0].toLowerCase()];
/** What a file dialog offers: models, coats, what a model refers to, and whatever pictures the browser reads. */
export const acceptedFiles = [...Object.keys(kindOfEnding), 'image/*'].join();
/** Endings of models, coats and hair, for people. */
export const readEndings = Object.keys(kindOfEnding).filter((ending) => /Model|Coat|Hair/.test(kindOfEnding[ending]));

/** Some systems give files no type. */
const isPicture = ({ name, type }) => /^image\//.test(type) || (!type && /\.(png|jpe?g|webp|avif|gif|bmp)$/i.test(name));

/**
 * Which of the files that were picked or dropped together is the model, which the coat, which the hair, and which a picture that
 * comes alone; undefined for none.
 */
export function sortFiles(files) {
  const list = [...files];
  const model = list.find((file) => kindOf(file) === 'Model');
  const typeSet = list.find((file) => kindOf(file) === 'Coat');
  const hair = list.find((file) => kindOf(file) === 'Hair');
  const image = list.length === 1 && isPicture(list[0]) ? list[0] : undefined;
  return { model, typeSet, hair, image, others: list.filter((file) => file !== model && file !== typeSet && file !== hair) };
}

/** Pictures are made smaller than this: beyond it fur shows no difference. */
const maxImageSide = 2048;

let modelsUrl = new URL('./models/', import.meta.url);
export function setModelsUrl(url) {
  modelsUrl = new URL(url, document.baseURI);
}

/**
 * @typedef {{ name: string, primitive?: string, bytes?: Uint8Array, files: Map<string, Uint8Array> }} ModelSource
 * A model with all bytes at hand: it can be loaded again into another program.
 */

/** The addresses that a .gltf names, without those inside it. */
function externalUris(bytes) {
  let json;
  try {
    json = JSON.parse(new TextDecoder().decode(bytes));
  } catch {
    return [];  // the importer says what is wrong with it
  }
  const list = (value) => (Array.isArray(value) ? value : []);
  return [...list(json?.buffers), ...list(json?.images)]
    .map((entry) => entry?.uri)
    .filter((uri) => typeof uri === 'string' && !uri.startsWith('data:'));
}

/** As the importer asks for it. */
function unescaped(uri) {
  try {
    return decodeURIComponent(uri);
  } catch {
    return uri;
  }
}

/** Whether it is a .gltf: of all formats only that begins with a brace. */
const isJson = (bytes) => /^\s*\{/.test(new TextDecoder().decode(bytes.subarray(0, 64)));

/** Says more where it would seem to name a model, or is needed by one. */
async function fetchNamed(url, what, onBytes, signal) {
  try {
    return await fetchBytes(url, onBytes, signal);
  } catch (error) {
    if (error instanceof FurError) error.message += what;
    throw error;
  }
}

/** The bytes behind `src`: a name of modelNames, or the address of a file that is read. @returns {Promise<ModelSource>} */
export async function fetchModel(src, onBytes, signal) {
  if (primitives.includes(src)) return { name: src, primitive: src, files: new Map() };
  const url = shippedModels.includes(src) ? new URL(`${src}.glb`, modelsUrl) : new URL(src, document.baseURI);
  const isAddress = /[./]/.test(src), names = isAddress ? '' : `; models that go by a name are ${modelNames.join(', ')}`;
  const bytes = heldOnce(await fetchNamed(url, names, onBytes, signal));
  const files = new Map();
  for (const uri of isJson(bytes) ? externalUris(bytes) : [])
    files.set(unescaped(uri), await fetchNamed(new URL(uri, url), `; ${fileNameOf(url)} needs it`, undefined, signal));
  return { name: shippedModels.includes(src) ? src : fileNameOf(url), bytes, files };
}

/** Files that figures hold, each once. @type {WeakRef<Uint8Array>[]} */
let held = [];
function heldOnce(bytes) {
  held = held.filter((one) => one.deref());
  for (const one of held) {
    const other = one.deref();
    if (other?.length !== bytes.length) continue;
    let same = 0;
    while (same < bytes.length && other[same] === bytes[same]) ++same;
    if (same === bytes.length) return other;
  }
  held.push(new WeakRef(bytes));
  return bytes;
}

const bytesOf = async (blob, name) => {
  if (blob.size > maxFileBytes)
    throw new FurError('too-large', `${name}: files of at most ${maxFileBytes >> 20} MiB are read`);
  try {
    return new Uint8Array(await blob.arrayBuffer());
  } catch (error) {
    throw new FurError('network', `${name}: could not be read (${error.message})`);
  }
};

/** The bytes of a File, Blob, ArrayBuffer or typed array. @returns {Promise<{ name: string, bytes: Uint8Array }>} */
export async function readGiven(given, name) {
  if (given instanceof ArrayBuffer) return { name, bytes: new Uint8Array(given.slice(0)) };
  if (ArrayBuffer.isView(given))
    return { name, bytes: new Uint8Array(given.buffer, given.byteOffset, given.byteLength).slice() };
  if (given instanceof Blob) return { name, bytes: await bytesOf(given, name) };
  throw new TypeError('expected a File, Blob, ArrayBuffer or typed array');
}

/**
 * The model in a File, Blob, ArrayBuffer or typed array.
 * @param {{ name?: string, files?: Iterable<File> }} options `files`: buffers and images beside a .gltf
 * @returns {Promise<ModelSource>}
 */
export async function readModel(given, { name, files = [] } = {}) {
  const model = await readGiven(given, name ?? given?.name ?? 'model');
  const byName = new Map();
  // The importer looks for a name with its folders first, then without: a drop brings bare names.
  if (isJson(model.bytes)) for (const file of files) byName.set(file.name, await bytesOf(file, file.name));
  return { ...model, files: byName };
}

/** What each app has prepared. @type {WeakMap<import('./furapp.js').FurApp, ModelSource>} */
const prepared = new WeakMap();

/** Does in pieces what takes long of loadInto(), which follows. A failure throws. @param {ModelSource} source @param {() => boolean} wanted still; the result is the last answer */
export async function prepare(app, source, wanted) {
  prepared.delete(app);
  if (source.primitive) app.beginPrimitive(source.primitive);
  else app.beginModel(source.bytes, source.name, source.files);
  do {
    await pause();
    if (!wanted()) return false;
  } while (!app.workOnComing(pieceSeconds));
  prepared.set(app, source);
  return true;
}

/** Loads into the app; a failure throws a FurError and leaves the app's old scene. @param {ModelSource} source */
export function loadInto(app, source, keepState) {
  const isPrepared = prepared.get(app) === source;
  prepared.delete(app);
  if (isPrepared) app.showComing(keepState && !source.primitive ? 1 : 0);
  else if (source.primitive) app.loadPrimitive(source.primitive);
  else app.loadModel(source.bytes, source.name, source.files, keepState);
}

/** An encoded picture as { width, height, data }; `options` as createImageBitmap() has them. */
export async function decodeImage(blob, options) {
  const bitmap = await createImageBitmap(blob, { colorSpaceConversion: 'none', premultiplyAlpha: 'none', ...options });
  const { width, height } = bitmap;
  const context = new OffscreenCanvas(width, height).getContext('2d', { willReadFrequently: true });
  context.drawImage(bitmap, 0, 0);
  bitmap.close();
  return context.getImageData(0, 0, width, height);
}

/** A picture that a person gave (Blob, buffer), as { image, blob }; a FurError that names it where it is none or too large. @param {import('./furapp.js').FurApp} app */
export async function readPicture(app, given) {
  const { name, bytes } = await readGiven(given, given.name || 'picture');
  app.checkPicture(bytes, name);
  const blob = given instanceof Blob ? given : new Blob([bytes]);
  try {
    return { image: await decodeImage(blob), blob };
  } catch (error) {
    throw new FurError('bad-file', `${name}: it is no picture that this browser reads (${error.message})`);
  }
}

/** The same as { image, bytes }: no larger than programs take, and a file of it that they keep. */
export async function readColorMap(app, given) {
  const { image: whole, blob } = await readPicture(app, given);
  let image = whole;
  const shrink = maxImageSide / Math.max(image.width, image.height), kept = ['image/png', 'image/jpeg', 'image/webp'].includes(blob.type);
  if (shrink >= 1 && kept) return { image, bytes: new Uint8Array(await blob.arrayBuffer()) };
  if (shrink < 1) image = await decodeImage(blob, { resizeWidth: Math.round(image.width * shrink) || 1, resizeHeight: Math.round(image.height * shrink) || 1, resizeQuality: 'high' });
  const canvas = new OffscreenCanvas(image.width, image.height);
  canvas.getContext('2d').putImageData(image, 0, 0);
  return { image, bytes: new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer()) };
}

/** Decodes the colour maps of fur types that the scene brought; returns a warning when one cannot be read. */
export async function provideTypePictures(app, wanted) {
  let warning = null;
  for (const { number, bytes } of app.pendingPictures()) {
    try {
      const image = await decodeImage(new Blob([bytes]));
      if (!wanted()) return null;
      app.provideTypePicture(number, image);
    } catch (error) {
      warning = `a colour map could not be read (${error.message})`;
    }
  }
  return warning;
}

/** Decodes the pictures that the model brought; returns a warning when one cannot be read. `wanted()`: still. */
export async function provideModelImages(app, source, wanted) {
  let warning = null;
  for (let image = app.pendingImage(); image && wanted(); image = wanted() && app.pendingImage()) {
    warning = await provideModelImage(app, image, source, wanted) ?? warning;
  }
  return warning;
}

async function provideModelImage(app, image, source, wanted) {
  try {
    const shrink = Math.min(1, maxImageSide / Math.max(image.width, image.height, 1));
    const smaller = shrink < 1
      ? { resizeWidth: Math.round(image.width * shrink) || 1, resizeHeight: Math.round(image.height * shrink) || 1, resizeQuality: 'high' }
      : {};
    const { width, height, data } = await decodeImage(new Blob([image.bytes], { type: image.mimeType }), smaller);
    if (wanted()) app.provideImage(width, height, data);
    return null;
  } catch (error) {
    if (wanted()) app.provideImage(0, 0, new Uint8Array());
    return `${source.name}: a picture could not be read (${error.message}); it is left out`;
  }
}
