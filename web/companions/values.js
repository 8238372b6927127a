// The values of a figure that companions show and change, by name: fields of the settings table ("curl", "type2.curl"), how wet
// it is ("wetness"), options ("preset", "tool", "cameraOrbit") and, to be read only, members of `stats` and of the figure.
import { fields, labelsOfPresets, labelsOfTools } from '#settings';
import { tellOthers } from './companion.js';

const radiansToDegrees = 180 / Math.PI;

/** Beside the settings table: what companions may set, and what else is known of it. */
const options = {
  wetness: { label: 'Wetness', type: 'float', min: 0, max: 1, default: 0, unit: '%' },
  preset: { label: 'Coat', type: 'choice', options: Object.keys(labelsOfPresets), labels: labelsOfPresets },
  tool: { label: 'Tool', type: 'choice', default: 'none', options: Object.keys(labelsOfTools), labels: labelsOfTools },
  lightRig: { label: 'Light', type: 'choice', options: ['daylight', 'studio', 'sunset', 'overcast', 'backlit', 'night'] },
  quality: { label: 'Quality', type: 'choice', default: 'auto', options: ['auto', 'low', 'medium', 'high'] },
  motion: { label: 'Motion', type: 'choice', default: 'auto', options: ['auto', 'full', 'reduced'] },
  paused: { label: 'Paused', type: 'bool', default: false },
  autoRotate: { label: 'Turn round', type: 'bool', default: false },
  cameraControls: { label: 'Camera', type: 'bool', default: false },
  ...Object.fromEntries(['src', 'alt', 'cameraOrbit', 'cameraTarget', 'fieldOfView', 'background'].map((name) => [name, { label: '', type: 'text' }])),
};
const statUnits = { frameTime: 'ms', cpuBytes: 'MB', gpuBytes: 'MB', uploadedBytes: 'MB' };
const statNames = ['vertices', 'triangles', 'strands', 'layers', 'finEdges', 'framesDrawn', 'level', 'pixels', ...Object.keys(statUnits)];
/** What of a figure can be read beside what can be set. */
const memberNames = ['action', 'state', 'modelName'];

/** "frameTime", "wet-fur": as words that begin a sentence. */
export function words(name) {
  const text = name.replace(/[A-Z]/g, (letter) => ` ${letter.toLowerCase()}`).replaceAll('-', ' ').trim();
  return text.charAt(0).toUpperCase() + text.slice(1);
}

/** What is known of a value that can be set: { label, type, min, max, unit, options, labels }; undefined for no such name. */
export function fieldOf(name) {
  const own = Object.hasOwn(options, name) ? options[name] : undefined;
  const [, ofType] = /^type[1-4]\.(\w+)$/.exec(name) ?? [];
  const field = own ?? (Object.hasOwn(fields, ofType ?? name) ? fields[ofType ?? name] : undefined);
  return field && typeof field.options === 'string' ? { ...field, options: field.options.split('|') } : field;
}

/** The same of a value that can only be read. */
export function readableOf(name) {
  const field = fieldOf(name);
  if (field) return field;
  if (statNames.includes(name)) return { label: words(name), type: 'float', unit: statUnits[name] ?? '', stat: true };
  return memberNames.includes(name) ? { label: words(name), type: 'text' } : undefined;
}

/** The value as the figure has it now; undefined while it is not known. */
export function valueIn(figure, name) {
  if (name === 'wetness') return figure.loaded ? figure.meanWetness : 0;
  if (memberNames.includes(name) || Object.hasOwn(options, name)) return figure[name];
  const field = readableOf(name);
  if (!field.stat) return figure.settings[name];
  const value = figure.stats?.[name];
  if (name === 'frameTime' && value === 0) return undefined;  // before anything has moved
  return field.unit === 'MB' && value !== undefined ? value / 1e6 : value;
}

/** Sets it and tells no other companion; what needs a model and finds none is left to the caller, who is told by false. */
export function setQuietly(figure, name, value) {
  if (name === 'wetness') {
    if (!figure.loaded) return false;
    figure.setWetness(Number(value));
  } else if (Object.hasOwn(options, name)) figure[name] = value;
  else figure.settings[name] = value;
  return true;
}

/** The same, and tells the others. */
export function setValueIn(figure, name, value) {
  const done = setQuietly(figure, name, value);
  if (done) tellOthers(figure);
  return done;
}

/** A step that divides the range into about a hundred: 1, 2 or 5 of some power of ten. */
export function stepOf({ type, min, max }) {
  if (type === 'int') return 1;
  const wanted = (max - min) / 100;
  const power = 10 ** Math.floor(Math.log10(wanted) + 1e-9);
  return Number((power * ([1, 2, 5].find((one) => one * power >= wanted * 0.999) ?? 10)).toPrecision(1));
}

export const digitsOf = (step) => Math.max(0, Math.ceil(-Math.log10(step) - 1e-9));

/** A value for people, in the language of the page. @param {{ unit?: string, digits?: number }} how */
export function textOf(value, { unit = '', digits }, language) {
  if (value === undefined || value === null || value === '') return '–';
  if (typeof value === 'boolean') return value ? 'on' : 'off';
  if (typeof value !== 'number') return words(String(value));
  const number = (shown, most) => new Intl.NumberFormat(language || undefined, { minimumFractionDigits: most, maximumFractionDigits: most }).format(shown);
  const most = digits ?? (Number.isInteger(value) ? 0 : Math.abs(value) < 10 ? 2 : 1);
  if (unit === '%') return `${number(100 * value, Math.max(0, most - 2))}\u00a0%`;
  if (unit === 'rad') return `${number(radiansToDegrees * value, Math.max(0, most - 2))}°`;
  if (unit === 'x') return `${number(value, most)}×`;
  return `${number(value, most)}${unit && (/^[°/]/.test(unit) ? unit : `\u00a0${unit}`)}`;
}
