// The tables of the reference, made of what the program itself is made of: the settings table, the tables of tools and edits, the typings,
// the element, the schema of the file format. What has no description stops the build.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import ts from 'typescript';
import { WetFurElement } from '../../web/element.js';
import { elementsOf } from '../elements.mjs';
import { root, Stop } from '../process.mjs';
import { fieldRow, readTables, typingsText, withEndings } from '../tables.mjs';
import { attributes, escaped } from './figures.mjs';
import { settingPicture, viewPicture } from './samples.mjs';

const read = (file) => readFileSync(join(root, file), 'utf8');

/** Text of ours with `code` in it as HTML. */
const prose = (text) => escaped(text).replace(/`([^`]+)`/g, '<code>$1</code>').replace(/\*\*([^*]+)\*\*/g, '<strong>$1</strong>');
const table = (head, rows, caption) => `<div class="table" tabindex="0" role="group" aria-label="${escaped(caption)}"><table><thead><tr>${head.map((cell) => `<th scope="col">${cell}</th>`).join('')}</tr></thead><tbody>${
  rows.map((row) => `<tr>${row.map((cell) => `<td>${cell}</td>`).join('')}</tr>`).join('')}</tbody></table></div>`;
const code = (text) => `<code>${escaped(text)}</code>`;

/** Rows of a Markdown table below a heading of a file: cells as text. */
function tableBelow(file, heading) {
  const text = read(file), at = text.indexOf(`\n${heading}\n`);
  if (at < 0) throw new Stop(`docs: ${file} has no heading "${heading}"`);
  const lines = text.slice(at).split('\n'), first = lines.findIndex((line) => line.startsWith('| ---'));
  const rows = [];
  for (const line of lines.slice(first + 1)) {
    if (!line.startsWith('|')) break;
    rows.push(line.slice(1, -1).split('|').map((cell) => cell.trim()));
  }
  return rows;
}

// --- settings ---

const kebab = (name) => name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
const shortNumber = (x) => String(Number(Number(x).toPrecision(6)));

function rangeOf(field) {
  if (field.type === 'choice') return `${field.options.map((option) => (option === field.default ? `<strong>${escaped(option)}</strong>` : escaped(option))).join(' · ')}`;
  if (field.type === 'bool') return `true or false, default <strong>${field.default}</strong>`;
  if (field.type === 'color') return `a colour, default <strong>${field.default}</strong>`;
  const unit = field.unit ? ` ${escaped(field.unit)}` : '';
  return `${shortNumber(field.min)} to ${shortNumber(field.max)}${unit}, default <strong>${shortNumber(field.default)}</strong>${field.type === 'int' ? ', whole numbers' : ''}`;
}

function settingHtml(field, picture) {
  const notes = [
    WetFurElement.observedAttributes.includes(kebab(field.name)) && `attribute ${code(kebab(field.name))}`,
    field.ofType && `each type has its own: ${code(`type2.${field.name}`)}`, field.coat && !field.ofType && 'presets set it',
  ].filter(Boolean);
  const image = picture ? `<img${attributes({ ...picture.size, src: picture.src, alt: picture.alt, loading: 'lazy' })}>` : '';
  return `<section class="setting"><h3 id="${field.name}">${code(field.name)} ${escaped(field.label)}</h3><p>${escaped(field.tooltip)}.</p><p class="range">${rangeOf(field)}</p>${
    notes.length ? `<p class="range">${notes.join(' · ')}</p>` : ''}${image}</section>`;
}

const groupId = (group) => group.toLowerCase().replaceAll(' ', '-');

function settingsHtml(fields, pictureOf) {
  const groups = [...new Set(fields.map(({ group }) => group))];
  return groups.map((group) => `<h2 id="group-${groupId(group)}">${escaped(group)}</h2>${fields.filter((field) => field.group === group).map((field) => settingHtml(field, pictureOf(field))).join('')}`).join('');
}

// --- typings ---

/** What a file of typings exports: { name, kind, doc, text, members: [{ name, text, doc }] }. */
function exportsOf(text) {
  const file = ts.createSourceFile('a.d.ts', text, ts.ScriptTarget.Latest, true);
  const docOf = (node) => (ts.getJSDocCommentsAndTags(node).map(({ comment }) => (typeof comment === 'string' ? comment : ts.getTextOfJSDocComment(comment) ?? '')).join(' ')).replace(/\s*\n\s*/g, ' ').trim();
  const lineComment = (node) => /\/\/ (.*)$/m.exec(text.slice(node.end, text.indexOf('\n', node.end)))?.[1] ?? '';
  const plain = (node) => node.getText(file).replace(/\s*\n\s*/g, ' ').replace(/;$/, '');
  const members = (node) => (node.members ?? []).filter((one) => one.name || ts.isCallSignatureDeclaration(one)).map((one) => ({ name: one.name?.getText(file) ?? '', text: plain(one), doc: docOf(one) || lineComment(one) }));
  return file.statements.filter((node) => node.modifiers?.some(({ kind }) => kind === ts.SyntaxKind.ExportKeyword) && node.name).map((node) => ({
    name: node.name.getText(file), doc: docOf(node), members: ts.isInterfaceDeclaration(node) || ts.isClassDeclaration(node) ? members(node) : [],
    kind: ts.isInterfaceDeclaration(node) ? 'interface' : ts.isClassDeclaration(node) ? 'class' : ts.isFunctionDeclaration(node) ? 'function' : 'type',
    extended: node.heritageClauses?.map((clause) => clause.getText(file)).join(' ') ?? '', text: plain(node).replace(/^export (declare )?/, ''),
  }));
}

const memberHtml = ({ text, doc }, id) => `<div class="member"><h3${id ? ` id="${escaped(id)}"` : ''}>${escaped(text)}</h3>${doc ? `<p>${prose(doc)}</p>` : ''}</div>`;

function typingsHtml(text, names) {
  const all = exportsOf(text);
  return names.map((name) => {
    const one = all.find((candidate) => candidate.name === name);
    if (!one) throw new Stop(`docs: the typings have no ${name}`);
    if (one.members.length === 0) return memberHtml(one, one.name);
    const extended = one.extended ? `<p>${code(one.extended)}</p>` : '';
    return `${one.doc ? `<p>${prose(one.doc)}</p>` : ''}${extended}${one.members.map((member, i) => memberHtml(member, one.members.findIndex(({ name: other }) => other === member.name) === i && `${one.name}-${member.name.replace(/\W/g, '')}`)).join('')}`;
  }).join('');
}

// --- our elements ---

const valuesText = (type) => (/^'/.test(type) ? type.split(' | ').map((one) => code(one.slice(1, -1))).join(' ') : escaped(type));
const elementParts = {
  attributes: ({ attributes: rows }) => table(['attribute', 'values', 'what it does'], rows.map(({ name, type, description }) => [code(name), valuesText(type), prose(description)]), 'Attributes'),
  events: ({ events }) => table(['event', 'type', 'when'], events.map(([name, type, description]) => [code(name), code(type), prose(description)]), 'Events'),
  slots: ({ slots }) => table(['slot', 'what stands there'], slots.map(([name, description]) => [name ? code(name) : 'without a name', prose(description)]), 'Slots'),
  parts: ({ parts }) => table(['part', 'what it is'], parts.map(({ name, description }) => [code(name), prose(description)]), 'Parts'),
  variables: ({ variables }) => table(['variable', 'what it colours'], variables.map(({ name, description }) => [code(name), prose(description)]), 'CSS variables'),
};
const elementHtml = (element, parts) => parts.filter((name) => element[name]?.length > 0).map((name) => elementParts[name](element)).join('');

// --- errors ---

const errorTexts = {
  'webgl-unavailable': ['The browser or its graphics driver gives no WebGL2 context: it is old, WebGL is switched off, or the driver is on a block list.', 'Show something else in the slot `fallback`. `isSupported()` tells before.'],
  'wasm-blocked': ['WebAssembly is missing or switched off, or the page’s policy forbids it.', 'Allow `\'wasm-unsafe-eval\'` in `script-src`.'],
  'wasm-load': ['The program could not be fetched or compiled, often because the server answers with a page instead of it.', 'See whether `wet-fur.wasm` lies beside the scripts; `configure({ wasmUrl })` says where it is if not. `reload()` tries again.'],
  'out-of-memory': ['There is no memory for the model, its textures or a picture of that size.', 'Fewer `layers`, a smaller `tileSize`, a smaller picture.'],
  'program-failed': ['The program stopped at a fault of its own. The other figures went on in a fresh one; this one made that fail as well.', '`reload()` tries once more. A model or file that does it again is worth a report.'],
  'bad-file': ['The bytes are not what they claim to be. The message names the place.', 'Open the file in another program, or with the Khronos validator, and save it anew.'],
  'too-large': ['The file is sound but over a limit, which the message names.', 'Fewer triangles, smaller pictures.'],
  'unsupported-version': ['The file is of a newer version of `WETFUR_fur`, or requires a glTF extension that is not read.', 'Use a newer wet-fur, or save the model without that extension.'],
  network: ['A file could not be fetched: no such address, no connection, or another site does not allow it (CORS).', 'Look at the address in the message. `reload()` tries again.'],
};

function errorsHtml(typings) {
  const [, union] = /type FurErrorCode =([^;]+);/.exec(typings) ?? [];
  const codes = [...(union ?? '').matchAll(/'([\w-]+)'/g)].map(([, name]) => name);
  const missing = codes.filter((name) => !errorTexts[name]);
  if (codes.length === 0 || missing.length > 0) throw new Stop(`docs: the error codes ${missing.join(', ')} have no description in tools/docs/reference.mjs`);
  return table(['code', 'cause', 'cure'], codes.map((name) => [`<code id="${name}">${name}</code>`, ...errorTexts[name].map(prose)]), 'Errors');
}

// --- the file format ---

function schemaRows(schema, path = '', required = []) {
  return Object.entries(schema.properties ?? {}).flatMap(([name, one]) => {
    if (name === 'extensions' || name === 'extras') return [];
    const at = path ? `${path}.${name}` : name, items = one.items ?? {};
    const type = one.enum ? one.enum.map((value) => JSON.stringify(value)).join(' or ') : one.type === 'array' ? `array of ${items.type ?? 'values'}` : one.type ?? '';
    const range = one.minimum !== undefined ? `, ${one.minimum}${one.maximum !== undefined ? ` to ${one.maximum}` : ' or more'}` : '';
    const note = required.includes(name) ? ', required' : '';
    return [[code(at), escaped(type + range + note), prose(one.description ?? '')], ...schemaRows(one, at, one.required ?? []), ...items.properties ? schemaRows(items, `${at}[]`, items.required ?? []) : []];
  });
}

// --- all of it, as shortcodes ---

/** @param {{ core: object, block: (html: string) => string, wanted: Map<string, object>, markdown: object }} tools */
export function addReference(config, { core, block, wanted }) {
  const tables = readTables(), fields = core.settingsTable;
  const typings = (name) => withEndings(name === 'tables' ? typingsText(tables) : read(`web/types/${name}.d.ts`), tables);
  const named = (rows, cells, head, caption) => table(head, rows.map(cells), caption);
  const generators = {
    settings: () => settingsHtml(fields, (field) => settingPicture(field, wanted)),
    hairValues: () => settingsHtml(tables.hairFields.map(fieldRow).map((field) => ({ ...field, ...field.options && { options: field.options.split('|') }, name: `hair-${field.name}`, group: `Long hair: ${field.group.toLowerCase()}` })), () => undefined).replaceAll('<code>hair-', '<code>'),
    views: () => tableBelow('src/render/README.md', '## Views').flatMap(([names, what]) => names.split(',').map((name) => name.trim().replaceAll('`', '')).map((name) => {
      const picture = viewPicture(name, wanted), field = fields.find((one) => one.name === 'view');
      if (!field.options.includes(name)) throw new Stop(`docs: src/render/README.md tells of a view ${name} that there is not`);
      return `<section class="setting"><h3 id="${name}">${code(name)}</h3><p>${prose(what[0].toUpperCase() + what.slice(1))}.</p>${picture ? `<img${attributes({ ...picture.size, src: picture.src, alt: picture.alt, loading: 'lazy' })}>` : ''}</section>`;
    })).join(''),
    hairViews: () => table(['hair view', 'shows'], tableBelow('src/render/README.md', '## Long hair').map(([name, what]) => [prose(name), prose(what)]), 'Hair views'),
    tools: () => named(tables.tools, ({ name, tooltip, program }) => [code(name), `${escaped(tooltip)}${program === 'Editor' ? ' (while the editor is open)' : ''}`], ['tool', 'what it does'], 'Tools'),
    presets: () => named(tables.presets, ({ name, tooltip, values }) => [code(name), escaped(tooltip), values.split(/\s+/).filter(Boolean).map(code).join(' ')], ['preset', 'what it is', 'its values'], 'Presets'),
    groomEdits: () => named(tables.groomEdits, ({ name, doc }) => [code(name), escaped(doc)], ['edit', 'what it does'], 'Edits of the groom'),
    hairEdits: () => named(tables.hairEdits, ({ name, doc }) => [code(name), escaped(doc)], ['edit', 'what it does'], 'Edits of hair'),
    pictureUses: () => named(tables.pictureUses, ({ name, doc }) => [code(name), escaped(doc)], ['use', 'what it means'], 'What a picture can mean'),
    formats: () => table(['endings', 'what', 'MIME type', 'written as'], [
      ...tables.modelFormats.map(({ endings, mimeType, savedAs }) => [code(endings), 'model', code(mimeType), savedAs || '–']),
      ...tables.otherFormats.map(({ endings, kind, mimeType, savedAs }) => [code(endings), kind.toLowerCase(), code(mimeType), savedAs || '–']),
    ], 'File formats'),
    typings: (file, ...names) => typingsHtml(typings(file), names),
    errors: () => errorsHtml(typings('index')),
    schema: () => {
      const schema = JSON.parse(read('src/scene/WETFUR_fur.schema.json'));
      return `<p>${prose(schema.description)}</p>${table(['property', 'type', 'meaning'], schemaRows(schema, '', schema.required), 'Properties of WETFUR_fur')}`;
    },
    element: (tag, ...parts) => {
      const element = elementsOf(tables).find((one) => one.tag === tag);
      if (!element) throw new Stop(`docs: there is no element ${tag}`);
      return elementHtml(element, parts.length ? parts : ['attributes', 'events', 'slots', 'parts']);
    },
  };
  config.addShortcode('reference', (name, ...given) => {
    if (!generators[name]) throw new Stop(`docs: there is no table "${name}"`);
    return block(generators[name](...given.filter((one) => typeof one === 'string')));
  });
}
