// <wet-fur-plot x="h" from="0" to="1" equations='[{"label": "f(h)", "f": "clumpProfile", "args": ["h", "w", "layers"]}]'
// parameters='{"w": "wetness", "layers": 16}'>: curves of functions of core.equations (wet-fur/core, fetched when a plot comes near the window).
// A parameter is a number, a value of the figure by its name, or "#id" of a slider or an input.
import { Companion, make, MarkupError } from './companion.js';
import { checkEquations, curvesOf, ticksOf } from './curves.js';
import { digitsOf, fieldOf, textOf, valueIn, words } from './values.js';

const height = 240, edge = { left: 46, right: 14, top: 12, bottom: 40 };
const colours = 5, rowsOfTable = 11;

let core = null;
/** One for all plots; asked for again after a failure. */
const theCore = () => (core ??= import('../core.js').then(({ loadCore }) => loadCore()).catch((error) => {
  core = null;
  throw error;
}));

function svg(tag, attributes, ...children) {
  const node = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

export class WetFurPlotElement extends Companion {
  static observedAttributes = [...Companion.observedAttributes, 'x', 'from', 'to', 'samples', 'equations', 'parameters', 'x-label', 'y-label', 'low', 'high'];
  static events = [...Companion.events, 'wetness-change'];
  static shadow = {};

  #drawing = svg('svg', { part: 'plot', role: 'img' });
  #legend = make('ul', { class: 'legend', part: 'legend' });
  #table = make('table');
  #details = make('details', { part: 'values' }, make('summary', {}, 'Values'), make('div', { class: 'scroll', tabindex: '0', role: 'region', 'aria-label': 'Values' }, this.#table));
  #frame = make('div', { class: 'plot', part: 'frame' }, this.#drawing, this.#legend, this.#details);
  #sizes = new ResizeObserver(() => this.#draw());
  #near = new IntersectionObserver((entries) => { if (entries.at(-1).isIntersecting) this.#load(); }, { rootMargin: '200px' });
  #onInput = (event) => { if (this.#inputs.includes(`#${event.target.id}`)) this.refreshSafely(); };
  #core = null;
  #asked = null;
  #curves = [];

  constructor() {
    super();
    this.#details.addEventListener('toggle', () => this.#fillTable());
  }

  get alone() { return !this.#asked?.settings; }

  connectedCallback() {
    super.connectedCallback();
    this.#near.observe(this);
    this.#sizes.observe(this.#frame);
    document.addEventListener('input', this.#onInput);
  }
  removed() {
    this.#near.disconnect();
    this.#sizes.disconnect();
    document.removeEventListener('input', this.#onInput);
  }

  get #inputs() { return this.#asked?.inputs ?? []; }

  build() {
    this.#asked = null;
    this.show(this.#frame);
    const x = this.getAttribute('x') ?? 'x';
    const from = this.number('from', 0), to = this.number('to', 1), samples = Math.round(this.number('samples', 101));
    if (!(from < to)) throw new MarkupError(`from ${from} is not less than to ${to}.`);
    if (!(samples >= 2 && samples <= 2001)) throw new MarkupError(`samples ${samples} is not 2 to 2001.`);
    const equations = this.json('equations', null), parameters = this.json('parameters', {});
    checkEquations(equations, [x, ...Object.keys(parameters)]);
    const named = Object.values(parameters).filter((one) => typeof one === 'string');
    const strange = named.find((one) => !one.startsWith('#') && !fieldOf(one));
    if (strange !== undefined) throw new MarkupError(`There is no setting “${strange}”.`);
    this.#asked = {
      x, from, to, samples, equations, parameters, low: this.number('low'), high: this.number('high'),
      inputs: named.filter((one) => one.startsWith('#')), settings: named.some((one) => !one.startsWith('#')),
    };
  }

  async #load() {
    this.#near.disconnect();
    try {
      this.#core = await theCore();
      this.tell('core', '');
      this.refreshSafely();
    } catch (error) {
      this.tell('core', `The equations could not be loaded: ${error.message}`);
    }
  }

  /** What the parameters are now; the table's defaults while a figure is not there. */
  #values() {
    const valueOf = (one) => {
      if (typeof one !== 'string') return one;
      if (!one.startsWith('#')) return Number((this.figure ? valueIn(this.figure, one) : undefined) ?? fieldOf(one).default);
      const input = this.getRootNode().getElementById?.(one.slice(1));
      if (!input) throw new MarkupError(`There is no slider “${one}” on this page.`);
      return Number(input.value);
    };
    return Object.fromEntries(Object.entries(this.#asked.parameters).map(([name, one]) => [name, valueOf(one)]));
  }

  refresh() {
    if (!this.#core || !this.#asked) return;
    const parameters = this.#values();
    this.#curves = curvesOf(this.#core, this.#asked.equations, { ...this.#asked, parameters });
    this.#draw();
    this.#fillTable();
  }

  #text(value) { return textOf(value, { digits: Number.isInteger(value) ? 0 : Math.min(4, Math.max(0, 2 - Math.floor(Math.log10(Math.abs(value))))) }, this.language); }

  #draw() {
    const width = Math.round(this.#frame.clientWidth);
    if (!width || this.#curves.length === 0) return;
    const all = this.#curves.flatMap(({ points }) => points).filter((point) => point.every(Number.isFinite));
    if (all.length === 0) return this.tell('curve', 'The curve has no finite value.');
    this.tell('curve', '');
    const { low, high, x } = this.#asked;
    const plane = this.#asked.equations.some(({ xy }) => xy);
    const spread = (values, least, most) => [least ?? Math.min(...values), most ?? Math.max(...values)];
    const ranged = ([from, to]) => (to - from > 1e-9 ? ticksOf(from, to) : ticksOf(from - 0.5, to + 0.5));
    const ticksX = plane ? ranged(spread(all.map(([one]) => one))) : ranged([this.#asked.from, this.#asked.to]);
    const ticksY = ranged(spread(all.map(([, one]) => one), low, high));
    const scale = (ticks, a, b) => (value) => a + ((b - a) * (value - ticks[0])) / (ticks.at(-1) - ticks[0]);
    const toX = scale(ticksX, edge.left, width - edge.right), toY = scale(ticksY, height - edge.bottom, edge.top);
    const text = (content, attributes) => svg('text', attributes, content);
    const numeral = (ticks) => (tick) => textOf(tick, { digits: digitsOf(ticks[1] - ticks[0]) }, this.language);
    const [numeralX, numeralY] = [numeral(ticksX), numeral(ticksY)];
    const grid = [
      ...ticksX.map((tick) => svg('line', { class: 'grid', x1: toX(tick), x2: toX(tick), y1: edge.top, y2: height - edge.bottom })),
      ...ticksY.map((tick) => svg('line', { class: 'grid', x1: edge.left, x2: width - edge.right, y1: toY(tick), y2: toY(tick) })),
    ];
    const axes = svg('path', { class: 'axis', fill: 'none', d: `M${edge.left} ${edge.top}V${height - edge.bottom}H${width - edge.right}` });
    const numbers = [
      ...ticksX.map((tick) => text(numeralX(tick), { x: toX(tick), y: height - edge.bottom + 16, 'text-anchor': 'middle' })),
      ...ticksY.map((tick) => text(numeralY(tick), { x: edge.left - 7, y: toY(tick) + 4, 'text-anchor': 'end' })),
    ];
    const names = [text(this.getAttribute('x-label') ?? (plane ? '' : x), { x: (edge.left + width - edge.right) / 2, y: height - 5, 'text-anchor': 'middle', 'font-style': 'italic' })];
    const yName = this.getAttribute('y-label');
    if (yName) names.push(text(yName, { transform: `translate(11 ${(edge.top + height - edge.bottom) / 2}) rotate(-90)`, 'text-anchor': 'middle', 'font-style': 'italic' }));
    const curves = this.#curves.map(({ points }, i) => svg('path', { class: `curve c${i % colours}`, d: pathOf(points, toX, toY) }));
    this.#drawing.setAttribute('viewBox', `0 0 ${width} ${height}`);
    this.#drawing.setAttribute('aria-label', this.#description());
    this.#drawing.replaceChildren(...grid, axes, ...numbers, ...names, ...curves);
    this.#showLegend();
  }

  #showLegend() {
    this.#legend.hidden = this.#curves.length < 2 && !this.#asked.equations[0].label;
    this.#legend.replaceChildren(...this.#curves.map(({ label }, i) => make('li', {},
      svg('svg', { viewBox: '0 0 22 7', 'aria-hidden': 'true' }, svg('path', { class: `curve c${i % colours}`, d: 'M0 3.5H22' })), label)));
  }

  /** For who cannot see it; the table has the numbers. */
  #description() {
    const { x, from, to } = this.#asked;
    const told = this.#curves.map(({ label, points }) => `${label} goes from ${this.#text(points[0][1])} to ${this.#text(points.at(-1)[1])}`);
    const parameters = Object.entries(this.#values()).map(([name, value]) => `${name} is ${Array.isArray(value) ? value.join(', ') : this.#text(value)}`);
    return [this.label || `Curves over ${words(x)}`, `${x} from ${this.#text(from)} to ${this.#text(to)}: ${told.join(', ')}`, ...parameters.length ? [`where ${parameters.join(', ')}`] : []].join('. ');
  }

  #fillTable() {
    if (!this.#details.open || this.#curves.length === 0) return;
    const plane = this.#asked.equations.map(({ xy }) => Boolean(xy));
    const { x, from, to, samples } = this.#asked;
    const rows = Math.min(rowsOfTable, samples);
    const heads = [x, ...this.#curves.map(({ label }) => label)].map((name) => make('th', { scope: 'col' }, name));
    const body = Array.from({ length: rows }, (_, row) => {
      const at = Math.round((row * (samples - 1)) / (rows - 1));
      const cells = this.#curves.map(({ points }, i) => make('td', {}, plane[i] ? points[at].map((one) => this.#text(one)).join('; ') : this.#text(points[at][1])));
      return make('tr', {}, make('th', { scope: 'row' }, this.#text(from + ((to - from) * at) / (samples - 1))), ...cells);
    });
    this.#table.replaceChildren(make('thead', {}, make('tr', {}, ...heads)), make('tbody', {}, ...body));
  }
}

/** With gaps where there is no value. */
function pathOf(points, toX, toY) {
  let pen = 'M';
  return points.map(([x, y]) => {
    if (!Number.isFinite(x) || !Number.isFinite(y)) {
      pen = 'M';
      return '';
    }
    const here = `${pen}${toX(x).toFixed(1)} ${toY(y).toFixed(1)}`;
    pen = 'L';
    return here;
  }).join('');
}
