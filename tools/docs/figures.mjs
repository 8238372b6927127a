// Figures of the pages: a live <wet-fur> with the still picture that stands for it, controls for it, a caption; and plots of equations.
import { relative, dirname } from 'node:path/posix';
import { Stop } from '../process.mjs';

export const escaped = (text) => String(text).replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/>/g, '&gt;').replace(/"/g, '&quot;');

/** Attributes of a tag: true stands alone, false and undefined not at all. */
export const attributes = (values) => Object.entries(values).filter(([, value]) => value !== undefined && value !== false)
  .map(([name, value]) => (value === true ? ` ${name}` : ` ${name}="${escaped(typeof value === 'object' ? JSON.stringify(value) : value)}"`)).join('');

/** A figure's picture is at most as large as this. */
const posterBytes = 19000;
const knownParts = ['id', 'src', 'alt', 'preset', 'light', 'set', 'call', 'camera', 'tool', 'wetness', 'draw', 'controls', 'still', 'attributes', 'size', 'slot'];

/** Elements that change the figure `id`: a setting's name stands for its slider. */
export function controls(id, list = []) {
  const tags = list.map((one) => {
    if (typeof one === 'string') return `<wet-fur-slider${attributes({ for: id, setting: one })}></wet-fur-slider>`;
    const { slider, choice, button, readout, ...rest } = one;
    if (slider) return `<wet-fur-slider${attributes({ for: id, setting: slider, ...rest })}></wet-fur-slider>`;
    if (choice) return `<wet-fur-choice${attributes({ for: id, setting: rest.method ? undefined : choice, ...rest })}></wet-fur-choice>`;
    if (button) return `<wet-fur-button${attributes({ for: id, ...rest })}>${escaped(button)}</wet-fur-button>`;
    if (readout) return `<wet-fur-readout${attributes({ for: id, value: readout, ...rest })}></wet-fur-readout>`;
    throw new Stop(`docs: ${id}: ${JSON.stringify(one)} is no control`);
  });
  const groups = [/slider|choice/, /button/, /readout/].map((kind) => tags.filter((tag) => kind.test(/^<wet-fur-\w+/.exec(tag)[0])).join('')).filter(Boolean);
  return tags.length ? `<div class="controls">${groups.map((group) => (/^<wet-fur-(button|readout)/.test(group) ? `<div class="row">${group}</div>` : group)).join('')}</div>` : '';
}

/**
 * One element alone, without caption. `spec.set` are settings, `spec.call` methods to call when it is there, `spec.wetness` how wet all
 * of it is, `spec.draw` more options of `npm run render` for the picture alone. @param {Map<string, object>} wanted pictures, by file name
 */
export function liveElement(spec, page, wanted) {
  const { id, src = 'bunny', alt, preset, light, set, camera, tool, wetness, call = [], attributes: more, size = [640, 480], slot } = spec;
  for (const name of Object.keys(spec)) if (!knownParts.includes(name) && name !== '__keywords') throw new Stop(`docs: ${page.inputPath}: a figure has no "${name}"`);
  if (!id || !alt) throw new Stop(`docs: ${page.inputPath}: a figure needs an id and an alt`);
  const name = `${page.fileSlug}-${id}.webp`, folder = relative(dirname(page.url), '/pictures');
  wanted.set(name, { parts: [{ src, preset, light, set, camera, wetness, draw: spec.draw, size }], bytes: posterBytes });
  const image = `<img${attributes({ slot: 'poster', src: `${folder}/${name}`, width: size[0], height: size[1], alt, loading: 'lazy', decoding: 'async' })}>`;
  const calls = [...wetness === undefined ? [] : [['setWetness', wetness]], ...call];
  return `<wet-fur${attributes({
    id, slot, src, alt, preset, 'light-rig': light, tool, 'camera-controls': true, 'camera-orbit': camera?.join(' '), 'data-set': set, 'data-call': calls.length ? calls : undefined,
    style: size[0] * 3 === size[1] * 4 ? undefined : `aspect-ratio:${size.join('/')}`, ...more,
  })}>${image}</wet-fur>`;
}

export function figure(spec, caption, page, wanted) {
  return `<figure class="live">${liveElement(spec, page, wanted)}${controls(spec.id, spec.controls)}<figcaption>${caption}</figcaption></figure>`;
}

/** Still pictures side by side: lists of `alt` and `captions`, and of `src`, `set`, `wetness` and `camera` where those differ. */
export function stills({ id = 'stills', alt, captions, size = [320, 240], ...common }, caption, page, wanted) {
  const folder = relative(dirname(page.url), '/pictures');
  const listed = ['src', 'set', 'wetness', 'camera'];
  const of = (key, value, i) => (listed.includes(key) && Array.isArray(value) && !(key === 'camera' && typeof value[0] === 'number') ? value[i] : value);
  const images = alt.map((text, i) => {
    const name = `${page.fileSlug}-${id}-${i + 1}.webp`;
    wanted.set(name, { parts: [{ ...Object.fromEntries(Object.entries(common).filter(([key]) => key !== '__keywords').map(([key, value]) => [key, of(key, value, i)])), size }], bytes: 12000 });
    return `<figure><img${attributes({ src: `${folder}/${name}`, width: size[0], height: size[1], alt: text, loading: 'lazy' })}><figcaption>${escaped(captions[i])}</figcaption></figure>`;
  });
  return `<figure><div class="side-by-side strip">${images.join('')}</div><figcaption>${caption}</figcaption></figure>`;
}

// --- plots ---

const width = 640, height = 260, left = 44, bottom = 30, top = 12, right = 12;
const short = (x) => String(Number(x.toPrecision(3)));

/** Curves as an SVG, which stays where no script runs. @param {{ label: string, points: [number, number][] }[]} curves */
function drawing(curves, { x, from, to, alt }) {
  const ys = curves.flatMap(({ points }) => points.map(([, y]) => y)).filter(Number.isFinite);
  const low = Math.min(0, ...ys), high = Math.max(low + 1e-9, ...ys);
  const place = ([px, py]) => `${(left + (px - from) / (to - from) * (width - left - right)).toFixed(1)},${(height - bottom - (py - low) / (high - low) * (height - top - bottom)).toFixed(1)}`;
  const lines = curves.map(({ points }, i) => `<polyline class="curve curve-${i + 1}" points="${points.filter(([, y]) => Number.isFinite(y)).map(place).join(' ')}"/>`).join('');
  const text = (px, py, anchor, content) => `<text x="${px}" y="${py}" text-anchor="${anchor}">${escaped(content)}</text>`;
  return `<svg class="plot" viewBox="0 0 ${width} ${height}" role="img" aria-label="${escaped(alt)}"><path class="axes" d="M${left} ${top}V${height - bottom}H${width - right}"/>${lines}${
    text(left - 6, top + 8, 'end', short(high))}${text(left - 6, height - bottom, 'end', short(low))}${text(left, height - 10, 'middle', short(from))}${text(width - right, height - 10, 'end', short(to))}${text((left + width) / 2, height - 8, 'middle', x)}</svg>`;
}

/**
 * A plot of functions of core.equations. `spec.parameters` are numbers, or names of settings of the figure `spec.for`, of which `spec.still` has
 * the values without scripts. @param {object} equations of wet-fur/core
 */
export function plot(spec, caption, page, equations) {
  const { x, from, to, samples = 120, for: target, equations: list, parameters = {}, still = {}, alt, id, xLabel } = spec;
  if (!alt) throw new Stop(`docs: ${page.inputPath}: a plot needs an alt`);
  const valueOf = (name, at) => {
    if (Array.isArray(name)) return name.map((one) => valueOf(one, at));
    if (typeof name !== 'string') return name;
    if (name === x) return at;
    const value = typeof parameters[name] === 'number' ? parameters[name] : still[parameters[name]];
    if (value === undefined) throw new Stop(`docs: ${page.inputPath}: a plot knows no value of "${name}"`);
    return value;
  };
  const curves = list.map(({ label, f, args, part = 0, xy }) => {
    if (!equations[f]) throw new Stop(`docs: ${page.inputPath}: there is no equation "${f}"`);
    return { label, points: Array.from({ length: samples + 1 }, (_, i) => {
      const at = from + (to - from) * i / samples, y = equations[f](...args.map((name) => valueOf(name, at)));
      return xy ? [y[xy[0]], y[xy[1]]] : [at, Number(Array.isArray(y) ? y[part] : y)];
    }) };
  });
  const key = list.length > 1 ? `<p class="key">${list.map(({ label }, i) => `<span class="key-${i + 1}">${escaped(label)}</span>`).join(' ')}</p>` : '';
  const tag = attributes({ id, x, from, to, samples, 'x-label': xLabel, for: target, equations: list, parameters });
  const range = list.some(({ xy }) => xy) ? curves.flatMap(({ points }) => points.map(([px]) => px)) : [from, to];
  return `<figure class="plotted"><wet-fur-plot${tag}>${drawing(curves, { x: xLabel ?? x, from: Math.min(...range), to: Math.max(...range), alt })}${key}</wet-fur-plot><figcaption>${caption}</figcaption></figure>`;
}
