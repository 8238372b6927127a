// Curves of functions of core.equations as numbers: what a plot's tag says is read here, and worked out.
import { MarkupError } from './companion.js';

/** Names that an argument, or a list or an object of arguments, refers to. */
function namesIn(given) {
  if (typeof given === 'string') return [given];
  return given && typeof given === 'object' ? Object.values(given).flatMap(namesIn) : [];
}

function resolved(given, values) {
  if (typeof given === 'string') return values[given];
  if (Array.isArray(given)) return given.map((one) => resolved(one, values));
  if (given && typeof given === 'object') return Object.fromEntries(Object.entries(given).map(([name, one]) => [name, resolved(one, values)]));
  return given;
}

/** @param {object[]} equations as in the attribute @param {string[]} known names that arguments may refer to */
export function checkEquations(equations, known) {
  if (!Array.isArray(equations) || equations.length === 0) throw new MarkupError('equations is no list: it is written [{"label": "…", "f": "clumpProfile", "args": ["h", "w", "layers"]}].');
  for (const { f, args = [] } of equations) {
    if (typeof f !== 'string') throw new MarkupError('An equation needs its function: "f": "clumpProfile".');
    const strange = namesIn(args).find((name) => !known.includes(name));
    if (strange !== undefined) throw new MarkupError(`${f} is given “${strange}”, which is neither x nor a parameter.`);
  }
}

/**
 * The points of each equation. Of a function with several results `part` says which; two of them, `xy`, are a curve in the plane.
 * @returns {{ label: string, points: [number, number][] }[]}
 */
export function curvesOf(core, equations, { x, from, to, samples, parameters }) {
  return equations.map(({ label, f, args = [], part = 0, xy }) => {
    const compute = Object.hasOwn(core.equations, f) ? core.equations[f] : undefined;
    if (!compute) throw new MarkupError(`There is no equation “${f}”.`);
    const points = Array.from({ length: samples }, (_, i) => {
      const at = from + ((to - from) * i) / (samples - 1);
      const result = compute(...resolved(args, { ...parameters, [x]: at }));
      if (xy && Array.isArray(result)) return [result[xy[0]], result[xy[1]]];
      return [at, Number(Array.isArray(result) ? result[part] : result)];
    });
    return { label: label ?? f, points };
  });
}

/** Round numbers from at most `low` to at least `high`, about as many as `count`. */
export function ticksOf(low, high, count = 5) {
  const rough = (high - low) / count;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5].find((one) => one * power >= rough * 0.999) ?? 10);
  const first = Math.floor(low / step + 1e-9), last = Math.ceil(high / step - 1e-9);
  return Array.from({ length: last - first + 1 }, (_, i) => Number(((first + i) * step).toPrecision(12)));
}
