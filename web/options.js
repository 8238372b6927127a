// What can be set beside the fields of the settings table, and what is made of a value that is given.
import { toolNames } from '#tables';

/**
 * What `quality` stands for; `layers` only where none are given. governed: moving pictures
 * are drawn with less where frames would be too slow.
 */
export const qualities = Object.freeze({
  auto: { maxPixelRatio: 2, antialias: true, governed: true },
  low: { maxPixelRatio: 1, antialias: false, layers: 16 },
  medium: { maxPixelRatio: 1.5, antialias: true, layers: 24 },
  high: { maxPixelRatio: 3, antialias: true, layers: 48 },
});

export const optionDefaults = Object.freeze({
  preset: '', wetness: '', tool: 'none', cameraControls: false, cameraOrbit: '', cameraTarget: '', fieldOfView: 'auto', autoRotate: false, quality: 'auto', frameBudget: 1000 / 60, background: '', fixedDt: 0, paused: false,
  wheel: 'focus', touchAction: '', motion: 'auto', editor: false,
});

export const choices = Object.freeze({
  tool: toolNames,
  wheel: ['page', 'focus', 'zoom'],
  motion: ['auto', 'full', 'reduced'],
  quality: Object.keys(qualities),
});

/** A time step in seconds: 0 to 1, 0 for what is no number. */
export function clampDt(value) {
  const seconds = Number(value);
  return Number.isFinite(seconds) ? Math.min(Math.max(seconds, 0), 1) : 0;
}

/** Milliseconds: 4 to 1000, that of 60 frames a second for what is no number. */
function clampBudget(value) {
  const milliseconds = Number(value);
  return milliseconds > 0 ? Math.min(Math.max(milliseconds, 4), 1000) : optionDefaults.frameBudget;
}

/** How wet a model is when it comes, 0 to 1; '': as it came. */
function clampWetness(value) {
  const wetness = Number(value);
  return value === '' || !Number.isFinite(wetness) ? '' : Math.min(Math.max(wetness, 0), 1);
}

/** The value as the option holds it; undefined when it is none of the option's choices. */
export function optionValue(name, value) {
  if (choices[name]) return choices[name].includes(value) ? value : undefined;
  const kind = typeof optionDefaults[name];
  if (name === 'frameBudget') return clampBudget(value);
  if (name === 'wetness') return clampWetness(value ?? '');
  if (kind === 'boolean') return Boolean(value);
  return kind === 'number' ? clampDt(value) : value;
}

/**
 * The settings fields as properties of an object. `names()` lists what is known now: before the
 * program is there, what was set.
 */
export function settingsObject({ names, get, set }) {
  const describe = (name) => (names().includes(name)
    ? { enumerable: true, configurable: true, writable: true, value: get(name) }
    : undefined);
  return new Proxy({}, {
    get: (_, name) => (typeof name === 'string' ? get(name) : undefined),
    set: (_, name, value) => {
      set(String(name), value);
      return true;
    },
    has: (_, name) => names().includes(name),
    ownKeys: () => names(),
    getOwnPropertyDescriptor: (_, name) => describe(name),
  });
}
