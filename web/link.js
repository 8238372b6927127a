// The demo page's address: what it may ask for, and the link that restores a scene.
// Every value comes from a stranger: keys are allow-listed, values bounded, and what is refused warns.
import { modelNames } from './models.js';
import { choices } from './options.js';
import { fromBase64Url, toBase64Url } from './packed.js';

/** Of all that is in it of the scene. */
const maxStateCharacters = 8 * 1024;
const maxParameters = 100;
const maxValueCharacters = 512;

/** A name of modelNames, or an address on this page's own server. */
export function isAllowedSrc(src, pageUrl) {
  if (modelNames.includes(src)) return true;
  try {
    const url = new URL(src, pageUrl);
    return url.origin === new URL(pageUrl).origin && /^https?:$/.test(url.protocol);
  } catch {
    return false;
  }
}

function boundedNumber(low, high, whole) {
  return (text, warn) => {
    const given = text.trim() === '' ? NaN : Number(text);
    if (!Number.isFinite(given)) return warn('is not a number');
    const value = Math.min(high, Math.max(low, whole ? Math.round(given) : given));
    if (value !== given) warn(`is outside ${low} to ${high}, ${value} is used`);
    return value;
  };
}
const oneOf = (list) => (text, warn) => (list.includes(text) ? text : warn(`is not one of ${list.join(', ')}`));
const flag = (text, warn) => (['0', '1'].includes(text) ? text === '1' : warn('is not 0 or 1'));

function readState(text, warn) {
  if (text.length > maxStateCharacters) return warn(`is longer than ${maxStateCharacters} characters`);
  try {
    const json = new TextDecoder('utf-8', { fatal: true }).decode(fromBase64Url(text));
    JSON.parse(json);
    return json;
  } catch {
    return warn('cannot be read');
  }
}

const readPacked = (text, warn) => (text.length <= maxStateCharacters ? text : warn(`is longer than ${maxStateCharacters} characters`));
const packedKeys = ['state', 'groom', 'hair', 'strokes', 'water'];

const readers = {
  src: (text, warn, pageUrl) => (isAllowedSrc(text, pageUrl) ? text : warn('is neither a model of this page nor a file of its server')),
  state: readState,
  strokes: readPacked,
  groom: readPacked,
  hair: readPacked,
  water: readPacked,
  preset: (text) => text,  // the program knows the names
  light: (text) => text,  // likewise
  wetness: boundedNumber(0, 1, false),
  tool: oneOf(choices.tool),
  quality: oneOf(choices.quality),
  motion: oneOf(choices.motion),
  camera: (text) => text,
  dt: boundedNumber(0, 1, false),
  frames: boundedNumber(0, 10000, true),
  ui: flag,
  editor: flag,
  autoplay: flag,
};

/**
 * @param {string} pageUrl the page's whole address
 * @returns {{ src?: string, state?: string, strokes?: string, groom?: string, hair?: string, water?: string, preset?: string, light?: string, wetness?: number, tool?: string, quality?: string, motion?: string, camera?: string, dt?: number,
 *   frames?: number, ui?: boolean, editor?: boolean, autoplay?: boolean, settings: [string, string][], warnings: string[] }}
 *   `settings` holds the keys that are none of these: fields of the settings table, or unknown; the program knows which.
 */
export function readLink(pageUrl) {
  const out = { settings: [], warnings: [] };
  const entries = [...new URL(pageUrl).searchParams];
  if (entries.length > maxParameters) out.warnings.push(`only the first ${maxParameters} of ${entries.length} parameters are read`);
  for (const [key, text] of entries.slice(0, maxParameters)) {
    const warn = (why) => void out.warnings.push(`${key.slice(0, 64)}: "${text.slice(0, 64)}" ${why}`);
    if (!packedKeys.includes(key) && text.length > maxValueCharacters) warn(`is longer than ${maxValueCharacters} characters`);
    else if (!Object.hasOwn(readers, key)) out.settings.push([key, text]);
    else {
      const value = readers[key](text, warn, pageUrl);
      if (value !== undefined) out[key] = value;
    }
  }
  return out;
}

/**
 * The page's address with this scene in it; readLink gives it back.
 * @param {{ groom?: string | null, hair?: string | null, strokes?: string | null, water?: string | null }} parts as packed.js, packStrokes()
 * and packWater() make them; those that do not fit beside what comes before them are left out
 */
export function makeLink(pageUrl, { src, state, tool, ...parts }) {
  const url = new URL(pageUrl);
  url.search = url.hash = '';
  if (src && src !== 'bunny') url.searchParams.set('src', src);
  if (tool && tool !== 'droplet') url.searchParams.set('tool', tool);
  let length = 0;
  const add = (key, text) => {
    if (!text || (length > 0 && length + text.length > maxStateCharacters)) return;
    length += text.length;
    url.searchParams.set(key, text);
  };
  add('state', toBase64Url(new TextEncoder().encode(state)));
  for (const key of packedKeys) if (key !== 'state') add(key, parts[key]);
  return url.href;
}
