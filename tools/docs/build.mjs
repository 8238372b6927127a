// dist/docs: the pages of docs/ as plain HTML, by Eleventy. Formulas, coloured code, still plots and the tables of the reference are made
// here; in the reader's browser only the live figures need scripts.
import { cpSync, existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join, relative, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import Eleventy from '@11ty/eleventy';
import { root, say, Stop } from '../process.mjs';
import { excerpt, languageOf } from './excerpts.mjs';
import { controls, escaped, figure, liveElement, plot, stills } from './figures.mjs';
import { extendMarkdown, formula, makeHighlighter } from './markdown.mjs';
import { fileOf, wantedFile } from './pictures.mjs';
import { addReference } from './reference.mjs';
import { layerPng, strandTablePng } from './tile.mjs';

const source = join(root, 'docs');

/** A marker that Markdown lets through, and what takes its place: blank lines in code would end a block of HTML. */
class Blocks {
  #kept = [];
  keep(html) { return `<!-- block ${this.#kept.push(html) - 1} -->`; }
  fill(text) { return text.replace(/<!-- block (\d+) -->/g, (_, index) => this.fill(this.#kept[index])); }
}

/** The headings of the second order of a page, for its list of contents. */
const contentsOf = (html) => [...html.matchAll(/<h2 id="([^"]+)"[^>]*>(.*?)<\/h2>/gs)].map(([, id, text]) => ({ id, text: text.replace(/<[^>]+>/g, '') }));

/** The tutorials, by their numbers. */
function numbered(api) {
  return api.getAll().filter(({ data }) => data.order).sort((a, b) => a.data.order - b.data.order);
}

async function configure(config, { core, wanted, site }) {
  const highlight = await makeHighlighter(), blocks = new Blocks();
  const markdown = {};
  config.amendLibrary('md', (md) => {
    markdown.md = md;
    extendMarkdown(md, highlight);
  });
  const block = (html) => `\n\n${blocks.keep(html)}\n\n`;
  const inline = (text) => markdown.md.renderInline(text.trim());
  config.setTemplateFormats(['md']);
  config.setUseTemplateCache(false);  // else the layout of an earlier build in this run, with that one's markers, lists the contents of these pages
  config.setFrontMatterParsingOptions({ excerpt: false });
  config.addGlobalData('layout', 'page.njk');
  config.addGlobalData('permalink', () => (data) => `${data.page.filePathStem}.html`);
  config.addGlobalData('companions', existsSync(join(site, 'companions.js')));
  config.addCollection('tutorials', numbered);
  config.addFilter('contents', (content) => contentsOf(blocks.fill(content)));
  config.addFilter('upwards', (url) => '../'.repeat(url.split('/').length - 2) || './');
  config.addFilter('beside', (list, url, step) => list[list.findIndex((one) => one.url === url) + step]);
  config.addPairedShortcode('figure', function (caption, spec) { return block(figure(spec, inline(caption), this.page, wanted)); });
  config.addShortcode('live', function (spec) { return liveElement(spec, this.page, wanted); });
  config.addShortcode('controls', (id, ...list) => block(controls(id, list)));
  config.addPairedShortcode('compare', function (caption, before, after) {
    const two = [{ ...before, slot: 'before' }, { ...after, slot: 'after' }].map((spec) => liveElement(spec, this.page, wanted)).join('');
    return block(`<figure class="compared"><wet-fur-compare>${two}</wet-fur-compare><figcaption>${inline(caption)}</figcaption></figure>`);
  });
  config.addPairedShortcode('plot', function (caption, spec) { return block(plot(spec, inline(caption), this.page, core.equations)); });
  config.addShortcode('tutorials', function () {
    const items = this.ctx.collections.tutorials.map(({ data, url, fileSlug }) =>
      `<li><img src="pictures/${fileSlug}-${data.picture}.webp" alt="" width="160" height="120"><a href="${url.slice(1)}">${data.order}. ${escaped(data.title)}</a><p>${escaped(data.description)}</p></li>`);
    return block(`<ul class="tutorials">${items.join('')}</ul>`);
  });
  config.addPairedShortcode('stills', function (caption, spec) { return block(stills(spec, inline(caption), this.page, wanted)); });
  config.addPairedShortcode('tile', function (caption, { id, alt, show, parameters, side = 128 }) {
    const fur = core.generateFur(parameters), folder = join(site, 'docs/pictures');
    mkdirSync(folder, { recursive: true });
    const images = show.map((one, i) => {
      const { layer, caption: text, ...look } = typeof one === 'number' ? { layer: one, caption: `Layer ${one} of ${fur.layers}` } : one, name = `${this.page.fileSlug}-${id}-${i + 1}.png`;
      writeFileSync(join(folder, name), layerPng(fur, layer - 1, { side, ...look }));
      return `<figure><img src="../pictures/${name}" width="${side}" height="${side}" alt="${escaped(`${alt}: ${text}`)}" loading="lazy"><figcaption>${escaped(text)}</figcaption></figure>`;
    });
    return block(`<figure><div class="side-by-side strip">${images.join('')}</div><figcaption>${inline(caption)}</figcaption></figure>`);
  });
  config.addPairedShortcode('strandTables', function (caption, { id, captions, alt, side = 128 }) {
    const folder = join(site, 'docs/pictures');
    mkdirSync(folder, { recursive: true });
    const images = ['M', 'N'].map((which, i) => {
      const name = `${this.page.fileSlug}-${id}-${i + 1}.png`;
      writeFileSync(join(folder, name), strandTablePng(core.equations, which, { side }));
      return `<figure><img src="../pictures/${name}" width="${side}" height="${side}" alt="${escaped(alt[i])}" loading="lazy"><figcaption>${inline(captions[i])}</figcaption></figure>`;
    });
    return block(`<figure><div class="side-by-side strip tables">${images.join('')}</div><figcaption>${inline(caption)}</figcaption></figure>`);
  });
  config.addShortcode('code', (file, what, to) => {
    const text = excerpt(file, what, typeof to === 'string' ? to : undefined);
    return block(`<figure class="code"><figcaption>${escaped(file)}</figcaption>${highlight(text, languageOf(file))}</figure>`);
  });
  addReference(config, { core, block, formula, wanted, highlight, markdown });
  config.addTransform('blocks', (content) => blocks.fill(content));
}

/**
 * Writes the pages into `site`/docs; `site` is dist/ as far as it is put together. Gives the pictures that the pages show, by their file
 * names.
 */
export async function buildDocs(site) {
  const output = join(site, 'docs'), wanted = new Map();
  const { loadCore } = await import(pathToFileURL(resolve(site, 'core.js')));
  const core = await loadCore();
  rmSync(output, { recursive: true, force: true });
  const eleventy = new Eleventy(relative('', source), relative('', output), {
    quietMode: true, configPath: relative('', join(root, 'tools/docs/eleventy.mjs')), source: 'script',
    config: async (config) => {
      config.setQuietMode(true);
      config.benchmarks.config.setMinimumThresholdMs(1e9);  // it would warn of each build
      config.setUseGitIgnore(false);
      config.setIncludesDirectory('_includes');
      await configure(config, { core, wanted, site });
    },
  });
  eleventy.disableLogger();
  try {
    await eleventy.write();
  } catch (error) {
    const causes = [];
    for (let one = error; one; one = one.originalError ?? one.cause) causes.push(one);
    throw causes.find((one) => one instanceof Stop) ?? error;
  }
  copyFiles(output);
  await buildThree(output);
  const there = [...wanted.keys()].filter((name) => existsSync(fileOf(name))), missing = [...wanted.keys()].filter((name) => !existsSync(fileOf(name)));
  if (missing.length > 0) say(`docs/pictures lacks ${missing.join(', ')}: npm run docs draws them`);
  mkdirSync(join(output, 'pictures'), { recursive: true });
  writeFileSync(wantedFile, JSON.stringify([...wanted]));
  for (const name of there) cpSync(fileOf(name), join(output, 'pictures', name));
  return wanted;
}

/** The page that draws our fur with three.js, whose code becomes part of its script. */
async function buildThree(output) {
  const { build } = await import('esbuild');
  const folder = join(output, 'three');
  await build({
    absWorkingDir: join(source, 'three'), entryPoints: ['page.js'], outdir: folder, bundle: true, format: 'esm', target: 'es2022', minify: true, legalComments: 'eof', logLevel: 'warning',
    external: ['../../core.js'],
  });
  cpSync(join(source, 'three/index.html'), join(folder, 'index.html'));
  // As they are written, for readers.
  for (const name of ['page.js', 'shaders.js']) cpSync(join(source, 'three', name), join(folder, 'source', name));
}

/** Style, script, and of KaTeX what its formulas need. */
function copyFiles(output) {
  for (const name of ['docs.css', 'figures.js']) cpSync(join(source, name), join(output, name));
  const katex = join(root, 'node_modules/katex/dist'), folder = join(output, 'katex');
  cpSync(join(katex, 'katex.min.css'), join(folder, 'katex.min.css'));
  const used = ['AMS-Regular', 'Main-Regular', 'Main-Italic', 'Main-Bold', 'Math-Italic', 'Size1-Regular', 'Size2-Regular', 'Size3-Regular', 'Size4-Regular', 'Caligraphic-Regular'];
  for (const name of used) cpSync(join(katex, `fonts/KaTeX_${name}.woff2`), join(folder, `fonts/KaTeX_${name}.woff2`));
  const css = readFileSync(join(folder, 'katex.min.css'), 'utf8');
  if (!css.includes('fonts/KaTeX_Main-Regular.woff2')) throw new Stop('docs: the fonts of KaTeX are not where its style looks for them');
}
