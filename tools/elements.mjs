// What HTML, editors and frameworks are told of our elements: attributes, slots, parts and CSS variables stand here, settings and tools come
// from the tables, members and events from the typings. It makes custom-elements.json and types/attributes.d.ts.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import ts from 'typescript';

const attribute = (name, type, description) => ({ name, type, description });
const text = 'string', number = 'number', truth = 'boolean', json = 'json';
const oneOf = (...values) => values.map((value) => `'${value}'`).join(' | ');

const kebab = (name) => name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`);
const camel = (name) => name.replace(/-([a-z])/g, (_, letter) => letter.toUpperCase());

/** Settings that are attributes of <wet-fur>, by the names of their fields; `view` and others are choices. */
const settingAttributes = ['wind', 'dryRate', 'brushRadius', 'brushFlow', 'exposure', 'seed', 'view', 'refine', 'behaviour'];

const typeOfField = ({ macro, options }) => (options ? oneOf(...options.split('|')) : macro === 'FUR_BOOL' ? oneOf('true', 'false', '0', '1') : number);

const variables = (...rows) => rows.map(([name, description]) => ({ name, description }));
const focusRing = ['--wet-fur-focus-ring', 'Colour of the ring round what has the focus.'];
const companionVariables = variables(
  ['--wet-fur-companion-accent', 'Colour of what is chosen, of the first curve and of sliders.'], ['--wet-fur-companion-line', 'Colour of borders and grid lines.'],
  ['--wet-fur-companion-background', 'Colour behind buttons and pictures.'], ['--wet-fur-companion-radius', 'Roundness of corners.'], focusRing);
const part = (name, description) => ({ name, description });
const errorPart = part('error', 'What is wrong with the tag, or went wrong.');
const figureOf = attribute('for', text, 'The id of the <wet-fur> that this is about; without it, the nearest one.');
const labelOf = attribute('label', text, 'What it is called; what is tied to a setting by default as the settings table has it.');
const setting = attribute('setting', text, 'The name of a setting, "wetness", "preset" or "tool".');

/** @param {ReturnType<typeof import('./tables.mjs').readTables>} tables */
export function elementsOf({ fields, presets, tools }) {
  const names = (rows) => oneOf(...rows.map(({ name }) => name));
  const ofSettings = settingAttributes.map((name) => fields.find((field) => field.name === name))
    .map((field) => attribute(kebab(field.name), typeOfField(field), `${field.tooltip}.`));
  return [
    {
      tag: 'wet-fur', name: 'WetFurElement', module: 'element.js', description: 'A furry model that can be turned, touched and wetted.',
      attributes: [
        attribute('src', text, '"otter", "pony", "bunny", "sphere", "torus", "plane", the name of a scene, or the address of a model.'),
        attribute('alt', text, 'What the picture shows, in words.'),
        attribute('poster', text, 'The address of a picture that is shown until the model is there.'),
        attribute('loading', oneOf('auto', 'lazy', 'eager'), '"eager": at once; else as soon as it comes near the window.'),
        attribute('reveal', oneOf('auto', 'interaction', 'manual'), '"interaction": nothing is loaded before the poster is pressed; "manual": before dismissPoster().'),
        attribute('interaction-prompt', oneOf('auto', 'none'), 'Whether the poster of reveal="interaction" shows that it can be pressed.'),
        attribute('preset', names(presets), 'A coat by its name.'),
        attribute('wetness', number, 'How wet the first model is when it comes, 0 to 1; set later it wets what is shown. Without it the model is as its file has it.'),
        attribute('tool', names(tools.filter(({ program }) => program !== 'Editor')), 'What a press or a drag on the model does.'),
        attribute('camera-controls', truth, 'A person can turn the view, zoom and move.'),
        attribute('camera-orbit', text, '"yaw pitch distance", angles in radians or with "deg", the distance in bounding radii of the model.'),
        attribute('camera-target', text, '"x y z": where the camera looks, in bounding radii of the model.'),
        attribute('field-of-view', text, 'Of the picture\'s height, in degrees, 10 to 90; "auto" is 34.'),
        attribute('auto-rotate', truth, 'The camera turns round the model while nobody touches it.'),
        attribute('quality', oneOf('auto', 'low', 'medium', 'high'), '"auto" draws moving pictures with less where they would not hold the frame budget.'),
        attribute('frame-budget', number, 'Milliseconds from one moving picture to the next, 4 to 1000.'),
        attribute('background', text, 'One colour for the whole background, "#rrggbb".'),
        attribute('fixed-dt', number, 'Seconds that every frame advances, whatever the clock says; 0: the clock.'),
        attribute('paused', truth, 'Time stands still; step() advances it.'),
        attribute('wheel', oneOf('page', 'focus', 'zoom'), 'Whether the wheel scrolls the page always, until the picture has the focus, or never.'),
        attribute('touch-action', text, 'A CSS touch-action; without it the page scrolls by touch until the picture has the focus.'),
        attribute('motion', oneOf('auto', 'full', 'reduced'), 'Less motion when the person\'s system asks for that, never, or always.'),
        attribute('editor', truth, 'Opens the panel with every setting.'),
        attribute('light-rig', oneOf('daylight', 'studio', 'sunset', 'overcast', 'backlit', 'night'), 'A light by its name.'),
        ...ofSettings,
      ],
      slots: [['poster', 'Shown until the model is there.'], ['progress-bar', 'In place of the bar that shows loading.'], ['interaction-prompt', 'In place of the cue on the poster.'],
        ['fallback', 'Shown where the browser cannot draw it.']],
      parts: [part('canvas', 'The picture.'), part('progress-bar', 'The bar that shows loading.'), part('coat-progress', 'The bar of a coat that grows.'),
        part('interaction-prompt', 'The cue on the poster.'), part('reload-button', '"Try again".')],
      variables: variables(['--wet-fur-poster-color', 'Behind poster and picture.'], ['--wet-fur-progress-color', 'Of the bar that shows loading.'],
        ['--wet-fur-text-color', 'Of the text beside that bar.'], focusRing),
    },
    {
      tag: 'wet-fur-slider', name: 'WetFurSliderElement', module: 'companions.js', description: 'A range for a number of a figure.',
      attributes: [figureOf, setting, labelOf, attribute('min', number, 'Default: of the settings table.'), attribute('max', number, 'Default: of the settings table.'),
        attribute('step', number, 'Default: a hundredth of the range, rounded.'), attribute('unit', text, 'Behind the number; "%" and "rad" (shown in degrees) convert it.'),
        attribute('value', number, 'What it begins with; it is set in the figure, too.')],
      events: [['input', 'Event', 'While it moves.'], ['change', 'Event', 'When it has been moved.']],
      parts: [part('label', 'Its name.'), part('value', 'The number.'), part('input', 'The range.'), errorPart],
    },
    {
      tag: 'wet-fur-choice', name: 'WetFurChoiceElement', module: 'companions.js', description: 'One of several values of a figure; a tick for what is on or off, a colour for colours.',
      attributes: [figureOf, setting, attribute('method', text, 'In place of a setting: what is called with the value.'), labelOf,
        attribute('values', text, 'Separated by commas, each with a label if need be: "final=Picture, skin". Default: of the settings table.')],
      events: [['change', 'Event', 'When another value has been chosen.']],
      parts: [part('label', 'Its name.'), part('button', 'Each of up to four values.'), part('input', 'The list, tick or colour.'), errorPart],
    },
    {
      tag: 'wet-fur-button', name: 'WetFurButtonElement', module: 'companions.js', description: 'Calls a method of a figure, once that shows a model.',
      attributes: [figureOf, attribute('method', text, 'Its name.'), attribute('args', json, 'Its arguments, a list.'), labelOf],
      slots: [['', 'What stands on it.']], parts: [part('button', 'The button.'), errorPart],
    },
    {
      tag: 'wet-fur-readout', name: 'WetFurReadoutElement', module: 'companions.js', description: 'A value of a figure as text.',
      attributes: [figureOf, attribute('value', text, 'A setting, "wetness", a member of stats such as "frameTime", "action", "state" or "modelName".'), labelOf,
        attribute('digits', number, 'Behind the point.'), attribute('unit', text, 'Behind the number.')],
      parts: [part('label', 'Its name.'), part('value', 'The value.'), errorPart],
    },
    {
      tag: 'wet-fur-compare', name: 'WetFurCompareElement', module: 'companions.js', description: 'Before and after, with a divider: two figures or pictures inside it, or two states of the figure that `for` names.',
      attributes: [attribute('for', text, 'The id of the <wet-fur> whose two states are shown; without it the two figures inside are.'), attribute('before', json, 'Of the first state: any settings, `wetness`, 0 to 1, and `cameraOrbit`.'), attribute('after', json, 'The same of the second state.'),
        attribute('before-label', text, 'A caption.'), attribute('after-label', text, 'A caption.'), attribute('position', number, 'Percent of the width that shows what was before.'), labelOf],
      events: [['divide', 'CustomEvent<{ position: number }>', 'A person moved the divider.'], ['picture-change', 'CustomEvent<null>', 'There are new pictures of the two states.']],
      slots: [['before', 'The first figure; without names the first two children are taken.'], ['after', 'The second figure.']],
      parts: [part('frame', 'Both pictures.'), part('before', 'One side.'), part('after', 'The other side.'), part('divider', 'The line between them.'), part('caption', 'A label.'), errorPart],
    },
    {
      tag: 'wet-fur-steps', name: 'WetFurStepsElement', module: 'companions.js',
      description: 'Steps of a text that a figure follows: children with data-set=\'{"view": "layers"}\' and data-call=\'[["shake"]]\'. The current one has aria-current="step".',
      attributes: [figureOf, labelOf],
      events: [['step-change', 'CustomEvent<{ index: number }>', 'Another step is read now, from 0; -1 before the first.']],
      slots: [['', 'The steps.'], ['figure', 'The figure, which stays in view beside them.']],
      parts: [part('frame', 'All of it.'), part('figure', 'What stays in view.'), part('steps', 'The text.'), errorPart],
    },
    {
      tag: 'wet-fur-plot', name: 'WetFurPlotElement', module: 'companions.js', description: 'Curves of functions of core.equations, with parameters of a figure and of sliders.',
      attributes: [figureOf, attribute('equations', json, '[{ "label", "f": name of the function, "args": [names and numbers], "part": of several results, "xy": [0, 1] for curves in the plane }].'),
        attribute('parameters', json, '{ name: number, name of a setting, or "#id" of a slider }.'), attribute('x', text, 'The name of what goes from `from` to `to`; "x".'),
        attribute('from', number, 'Default: 0.'), attribute('to', number, 'Default: 1.'), attribute('samples', number, '2 to 2001; default: 101.'),
        attribute('low', number, 'Where the other axis begins at the latest.'), attribute('high', number, 'Where it ends at the earliest.'),
        attribute('x-label', text, 'Under the axis.'), attribute('y-label', text, 'Beside the axis.'), labelOf],
      parts: [part('frame', 'All of it.'), part('plot', 'The drawing.'), part('legend', 'Names of the curves.'), part('values', 'The table of values.'), errorPart],
    },
  ].map((element) => ({ events: [], slots: [], variables: companionVariables, ...element }));
}

// --- what the typings say ---

/** Public members and events of the classes and interfaces of a folder of typings, by the names of those. */
function readTypings(folder) {
  const files = ['index', 'element', 'companions', 'tables'].map((name) => ts.createSourceFile(name, readFileSync(join(folder, `${name}.d.ts`), 'utf8'), ts.ScriptTarget.ES2022, true));
  const all = new Map();
  for (const file of files) {
    for (const node of file.statements) {
      if (!ts.isClassDeclaration(node) && !ts.isInterfaceDeclaration(node)) continue;
      const known = all.get(node.name.text) ?? { members: [], parents: [] };
      known.members.push(...node.members.map((member) => memberOf(member, file)).filter(Boolean));
      known.parents.push(...(node.heritageClauses ?? []).flatMap(({ types }) => types.map(({ expression }) => expression.getText(file))));
      all.set(node.name.text, known);
    }
  }
  return all;
}

function memberOf(member, file) {
  const name = member.name && (ts.isStringLiteral(member.name) ? member.name.text : member.name.getText(file));
  if (!name || name === 'addEventListener' || ts.isSetAccessor(member)) return null;
  const description = ts.getJSDocCommentsAndTags(member).map((doc) => (typeof doc.comment === 'string' ? doc.comment : '')).join(' ').replace(/\s+/g, ' ').trim();
  const common = { name, ...description && { description } };
  const typeText = (node) => ({ text: node.getText(file).replace(/\s+/g, ' ') });
  if (ts.isMethodDeclaration(member) || ts.isMethodSignature(member)) {
    const parameters = member.parameters.map((one) => ({ name: one.name.getText(file), type: typeText(one.type), ...one.questionToken && { optional: true } }));
    return { kind: 'method', ...common, parameters, return: { type: typeText(member.type) } };
  }
  const readonly = ts.isGetAccessor(member) || member.modifiers?.some(({ kind }) => kind === ts.SyntaxKind.ReadonlyKeyword);
  return { kind: 'field', ...common, type: typeText(member.type), ...readonly && !ts.isGetAccessor(member) && { readonly: true } };
}

function membersOf(typings, name) {
  const { members = [], parents = [] } = typings.get(name) ?? {};
  return [...members, ...parents.filter((parent) => parent !== 'HTMLElement' && parent !== 'FurSettings').flatMap((parent) => membersOf(typings, parent))];
}

// --- what is made of it ---

/** custom-elements.json, after the Custom Elements Manifest, version 1. @param {string} folder of the typings */
export function manifestOf(elements, folder) {
  const typings = readTypings(folder);
  const events = membersOf(typings, 'WetFurElementEventMap').map(({ name, type, description }) => ({ name, type, ...description && { description } }));
  const declarationOf = (element) => {
    const members = membersOf(typings, element.name);
    const fieldName = (name) => (members.some((member) => member.name === camel(name)) ? { fieldName: camel(name) } : {});
    return {
      kind: 'class', customElement: true, name: element.name, tagName: element.tag, description: element.description,
      superclass: { name: 'HTMLElement' },
      attributes: element.attributes.map(({ name, type, description }) => ({ name, type: { text: type === json ? text : type }, description, ...fieldName(name) })),
      members,
      events: element.tag === 'wet-fur' ? events : element.events.map(([name, type, description]) => ({ name, type: { text: type }, description })),
      slots: element.slots.map(([name, description]) => ({ name, description })),
      cssParts: element.parts, cssProperties: element.variables,
    };
  };
  const modules = [...new Set(elements.map(({ module }) => module))].map((path) => {
    const here = elements.filter(({ module }) => module === path);
    return {
      kind: 'javascript-module', path, declarations: here.map(declarationOf),
      exports: here.flatMap(({ name, tag }) => [
        { kind: 'js', name, declaration: { name, module: path } }, { kind: 'custom-element-definition', name: tag, declaration: { name, module: path } },
      ]),
    };
  });
  return { schemaVersion: '1.0.0', readme: 'README.md', modules };
}

/** types/attributes.d.ts: of each tag, for JSX and templates. */
export function attributesText(elements) {
  const types = { [number]: 'number | string', [truth]: "boolean | ''", [json]: 'string', [text]: 'string' };
  const member = ({ name, type, description }) => `    /** ${description.replaceAll('*/', '* /')} */\n    '${name}'?: ${types[type] ?? type};\n`;
  return `// Made by tools/elements.mjs.

/** Attributes of our elements, by their tags. */
export interface WetFurTags {
${elements.map(({ tag, description, attributes }) => `  /** ${description} */\n  '${tag}': {\n${attributes.map(member).join('')}  };\n`).join('')}}
`;
}
