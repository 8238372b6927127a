// The tables of src/ (Tools.inc and others) for JavaScript: read here as the preprocessor reads them there, and made into a
// module, typings and the buttons of the page. Data and text go in and come out, so that tests can add a row.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { root, Stop } from './process.mjs';

/** What web/ imports as '#tables' (package.json). */
const moduleFile = join(root, 'build/generated/tables.js');
/** What web/companions imports as '#settings': a module of its own, as the viewer has the same from its program. */
const settingsFile = join(root, 'build/generated/settings.js');

const tables = {
  tools: {
    file: 'src/app/tools/Tools.inc', macro: 'FUR_TOOL',
    columns: ['id', 'name', 'program', 'worksOn', 'drag', 'held', 'reach', 'label', 'inverseLabel', 'row', 'place', 'icon', 'keyText', 'tooltip'],
  },
  methods: { file: 'web/Methods.inc', macro: 'FUR_METHOD', columns: ['name', 'result', 'parameters', 'arguments', 'offered', 'doc'] },
  queries: { file: 'web/Methods.inc', macro: 'FUR_QUERY', columns: ['name', 'result', 'offered', 'doc'] },
  modelFormats: { file: 'src/scene/Formats.inc', macro: 'FUR_MODEL_FORMAT', columns: ['id', 'endings', 'mimeType', 'savedAs', 'reader'] },
  otherFormats: { file: 'src/scene/Formats.inc', macro: 'FUR_FORMAT', columns: ['id', 'kind', 'endings', 'mimeType', 'savedAs'] },
  platformCommands: { file: 'src/app/editor/PlatformCommands.inc', macro: 'FUR_PLATFORM_COMMAND', columns: ['id', 'where', 'doc'] },
  presets: { file: 'assets/Presets.inc', macro: 'FUR_PRESET', columns: ['name', 'label', 'tooltip', 'values'] },
  hairEdits: { file: 'src/app/tools/HairEdits.inc', macro: 'FUR_HAIR_EDIT', columns: ['id', 'name', 'doc'] },
  pictureUses: { file: 'src/app/tools/PictureUses.inc', macro: 'FUR_PICTURE_USE', columns: ['id', 'name', 'label', 'doc'] },
  groomEdits: { file: 'src/app/tools/GroomEdits.inc', macro: 'FUR_GROOM_EDIT', columns: ['id', 'name', 'masked', 'doc'] },
};

const fieldsFile = 'src/settings/Fields.inc', hairFieldsFile = 'src/hair/HairFields.inc';
const fieldColumns = {
  FUR_FLOAT: ['name', 'label', 'group', 'default', 'min', 'max', 'unit', 'tooltip'],
  FUR_INT: ['name', 'label', 'group', 'default', 'min', 'max', 'unit', 'tooltip'],
  FUR_BOOL: ['name', 'label', 'group', 'default', 'tooltip'],
  FUR_COLOR: ['name', 'label', 'group', 'default', 'tooltip'],
  FUR_CHOICE: ['name', 'label', 'group', 'default', 'options', 'tooltip'],
};

/** The arguments of a macro's call, split at commas that stand in no string and no parentheses; strings without quotes. */
function splitArguments(text) {
  const out = [];
  let depth = 0, from = 0;
  for (const { 0: token, index } of text.matchAll(/"(?:\\.|[^"\\])*"|[(),]/g)) {
    if (token === '(') ++depth;
    else if (token === ')') --depth;
    else if (token === ',' && depth === 0) {
      out.push(text.slice(from, index));
      from = index + 1;
    }
  }
  out.push(text.slice(from));
  return out.map((part) => part.trim()).map((part) => (part.startsWith('"') ? JSON.parse(part) : part));
}

/** Rows of a table as objects. @param {string} text of the file @param {{ macro: string, columns: string[] }} table */
export function rowsOf(text, { macro, columns }) {
  const code = text.replace(/^\s*\/\/.*$/gm, '').replace(/"\s*\n\s*"/g, '');
  const call = new RegExp(`^${macro}\\s*\\(((?:"(?:\\\\.|[^"\\\\])*"|\\([^()]*\\)|[^"()])*)\\)`, 'gm');
  return [...code.matchAll(call)].map(([whole, given]) => {
    const values = splitArguments(given);
    if (values.length !== columns.length) throw new Stop(`${whole}: ${values.length} columns of ${columns.length}`);
    return Object.fromEntries(columns.map((column, i) => [column, values[i]]));
  });
}

/** The settings in their order, each with its macro. */
function fieldsOf(text) {
  const plain = text.replace(/, k[A-Z]\w*( \| k[A-Z]\w*)*\)$/gm, ')');
  return [...plain.matchAll(/^(FUR_[A-Z]+) *\(.*$/gm)].flatMap(([line, macro]) => {
    if (!fieldColumns[macro]) throw new Stop(`${fieldsFile}: ${macro} is no kind of setting`);
    return rowsOf(line, { macro, columns: fieldColumns[macro] }).map((row) => ({ ...row, macro }));
  });
}

/** @param {(file: string) => string} read the text of a file of the tree */
export function readTables(read = (file) => readFileSync(join(root, file), 'utf8')) {
  return { ...Object.fromEntries(Object.entries(tables).map(([name, table]) => [name, rowsOf(read(table.file), table)])), fields: fieldsOf(read(fieldsFile)), hairFields: fieldsOf(read(hairFieldsFile)) };
}

/** Rows of { ending, kind, mimeType }, in the order of the table. */
export function endings({ modelFormats, otherFormats }) {
  const formats = [...modelFormats.map((format) => ({ ...format, kind: 'Model' })), ...otherFormats];
  return formats.flatMap(({ endings: all, kind, mimeType }) => all.split(' ').map((ending) => ({ ending, kind, mimeType })));
}

/** A text with the endings of models and coats in place of {models}, {coats} and {hair}. */
export function withEndings(text, tables) {
  const listed = (kind) => new Intl.ListFormat('en-GB', { type: 'disjunction' }).format(endings(tables).filter((one) => one.kind === kind).map(({ ending }) => ending));
  return text.replaceAll('{models}', listed('Model')).replaceAll('{coats}', listed('Coat')).replaceAll('{hair}', listed('Hair'));
}

/** The module '#tables': what the scripts of web/ need of them, and no more. */
export function moduleText(all) {
  const { tools, methods, queries } = all;
  const constant = (name, value) => `export const ${name} = ${JSON.stringify(value)};\n`;
  // Names by the kinds of their results.
  const names = (rows) => Object.fromEntries([...new Set(rows.map(({ result }) => result))].map((kind) => [kind, rows.filter(({ result }) => result === kind).map(({ name }) => name)]));
  return `// Made by tools/tables.mjs.\n${
    constant('toolNames', tools.map(({ name }) => name))}${
    constant('keyTexts', Object.fromEntries(tools.filter(({ keyText }) => keyText).map(({ name, keyText }) => [name, keyText])))}${
    constant('kindOfEnding', Object.fromEntries(endings(all).filter(({ kind }) => kind !== 'Picture').map(({ ending, kind }) => [ending, kind])))}${
    constant('pictureUses', all.pictureUses.map(({ name, label, doc }) => ({ name, label, doc })))}${
    constant('methods', names(methods))}${
    constant('queries', names(queries))}${
    constant('elementMethods', names(forElements(methods)))}${
    constant('elementQueries', names(forElements(queries)))}`;
}

const kindsOfFields = { FUR_FLOAT: 'float', FUR_INT: 'int', FUR_BOOL: 'bool', FUR_COLOR: 'color', FUR_CHOICE: 'choice' };
const numberOf = (text) => Number(text.replace(/f$/, ''));

/** A default as scripts have it. */
function defaultOf({ macro, default: text, options }) {
  if (macro === 'FUR_BOOL') return text === 'true';
  if (macro === 'FUR_COLOR') return `#${Number(text).toString(16).padStart(6, '0')}`;
  return macro === 'FUR_CHOICE' ? options.split('|')[Number(text)] : numberOf(text);
}

/** A row of Fields.inc or HairFields.inc as the settings table of the program has it, but for the options, which are as they stand there. */
export const fieldRow = ({ macro, ...field }) => ({
  ...field, type: kindsOfFields[macro], default: defaultOf({ macro, ...field }), ...field.min && { min: numberOf(field.min), max: numberOf(field.max) },
});

/** The module '#settings': label, range, unit and choices of each setting, presets and tools by their labels. */
export function settingsText({ fields, presets, tools }) {
  // JSON has none of what a row lacks.
  const rows = fields.map(fieldRow).map(({ name, label, type, default: standard, min, max, unit, options }) => [name, { label, type, default: standard, min, max, unit: unit || undefined, options }]);
  const labels = (all) => Object.fromEntries(all.map(({ name, label }) => [name, label]));
  return `// Made by tools/tables.mjs.\nexport const fields = ${JSON.stringify(Object.fromEntries(rows))};\n`
    + `export const labelsOfPresets = ${JSON.stringify(labels(presets))};\n`
    + `export const labelsOfTools = ${JSON.stringify(labels(tools.filter(({ program }) => program !== 'Editor')))};\n`;
}

const forElements = (rows) => rows.filter(({ offered }) => offered === 'Element');

const union = (rows) => rows.map(({ name }) => `\n  | '${name}'`).join('');
const list = (rows, textOf) => rows.map((row) => ` * - '${row.name}': ${textOf(row)}\n`).join('');

const typesOfResults = { Nothing: 'void', Done: 'void', Truth: 'boolean', Number: 'number', Text: 'string', Hash: 'string', Lines: 'readonly string[]' };
const typesOfParameters = { 'const char*': 'string', float: 'number', int: 'number', bool: 'boolean' };

/** "(float u, bool on)" is "u: number, on: boolean". */
function typedParameters(parameters) {
  return parameters.slice(1, -1).split(',').filter(Boolean).map((parameter) => {
    const [, type, name] = /^\s*(.*\S)\s*?\s(\w+)\s*$/.exec(parameter);
    if (!typesOfParameters[type]) throw new Stop(`${parameters}: ${type} has no type in JavaScript`);
    return `${name}: ${typesOfParameters[type]}`;
  }).join(', ');
}

function member({ name, result, parameters, doc }) {
  const type = typesOfResults[result];
  if (!type) throw new Stop(`${name}: ${result} has no type in JavaScript`);
  return `${doc && `  /** ${doc} */\n`}  ${parameters ? `${name}(${typedParameters(parameters)})` : `readonly ${name}`}: ${type};\n`;
}

const typesOfFields = { FUR_FLOAT: 'number', FUR_INT: 'number', FUR_BOOL: 'boolean', FUR_COLOR: 'Color' };
/** A choice has a type of its own; those of coats share one. */
const choiceType = ({ name }) => (/^type\d$/.test(name) ? 'FurType' : name[0].toUpperCase() + name.slice(1));
const choices = (fields) => [...new Map(fields.filter(({ options }) => options).map((field) => [choiceType(field), field.options]))]
  .map(([type, options]) => `export type ${type} = ${options.split('|').map((option) => `'${option}'`).join(' | ')};\n`).join('');
const fieldMember = (field) => `  /** ${field.tooltip}. */\n  ${field.name}: ${typesOfFields[field.macro] ?? choiceType(field)};\n`;

/** types/tables.d.ts. */
export function typingsText({ tools, groomEdits, hairEdits, pictureUses, methods, queries, fields, hairFields, presets }) {
  return `// Made by tools/tables.mjs.

/** "#rrggbb", sRGB. */
export type Color = string;
${choices([...fields, ...hairFields])}
/** Everything a person can change. Out-of-range values are clamped with a warning. */
export interface FurSettings {
${fields.map(fieldMember).join('')}}

/** The numbers of one scalp's long hair. */
export interface HairValues {
${hairFields.map(fieldMember).join('')}}

export type PresetName =${union(presets)};

/**
 * What a drag on the model does.
${list(tools, ({ tooltip, program }) => tooltip + (program === 'Editor' ? ' (while the editor is open)' : ''))} */
export type Tool =${union(tools)};

/**
 * What WetFurApi.groom() does all over the model.
${list(groomEdits, ({ doc }) => doc)} */
export type GroomEdit =${union(groomEdits)};

/**
 * What WetFurApi.hair() does to long hair.
${list(hairEdits, ({ doc }) => doc)} */
export type HairEdit =${union(hairEdits)};

/**
 * What a picture can mean in WetFurApi.loadPicture().
${list(pictureUses, ({ doc }) => doc)} */
export type PictureUse =${union(pictureUses)};

/** What WetFurApi passes on to the program as it is. */
export interface WetFurMethods {
${forElements(queries).map(member).join('')}
${forElements(methods).map(member).join('')}}
`;
}

function toolButton({ name, label, tooltip, place, icon }, drawingOf) {
  const drawing = place === 'start' || place === 'bar' ? `\n      ${drawingOf(icon)}<span>${label}</span>` : label;
  return `<button type="button" data-tool="${name}"${place === 'edits' ? ' data-place="edits"' : ''} aria-pressed="false" title="${tooltip}">${drawing}</button>`;
}

/** The page with a button of every tool that has a place on it. @param {(icon: string) => string} drawingOf the svg of an icon */
export function pageText(html, tables, drawingOf) {
  const { tools } = tables;
  const places = new Set();
  const filled = withEndings(html, tables).replace(/^( *)<!-- tools: (\w+) -->$/gm, (_, indent, place) => {
    places.add(place);
    return tools.filter((tool) => tool.place === place).map((tool) => indent + toolButton(tool, drawingOf)).join('\n');
  });
  for (const { name, place } of tools) if (place && !places.has(place)) throw new Stop(`${name}: the page has no place "${place}"`);
  return filled;
}

/** The svg of web/icons as it stands in the page, whose style colours it. */
export function drawingOf(icon) {
  const text = readFileSync(join(root, 'web/icons', `${icon}.svg`), 'utf8').trim();
  return text.replace(/<svg[^>]*>/, '<svg viewBox="0 0 24 24" aria-hidden="true">');
}

/** Brings '#tables' and '#settings' up to date, and returns the tables. */
export function makeTables() {
  const all = readTables();
  mkdirSync(join(moduleFile, '..'), { recursive: true });
  writeFileSync(moduleFile, moduleText(all));
  writeFileSync(settingsFile, settingsText(all));
  return all;
}
