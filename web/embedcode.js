// The tag that shows what the demo page shows now.
import { animalNames, sceneNames } from './models.js';

const attributeOf = { wind: 'wind', dryRate: 'dry-rate', brushRadius: 'brush-radius', brushFlow: 'brush-flow', exposure: 'exposure', seed: 'seed', view: 'view', behaviour: 'behaviour' };

const escape = (text) => String(text).replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;');

/**
 * @param {string} pageUrl beside which element.js lies
 * @param {{ src: string | null, name: string, state: string, startState: string, preset: string, coatFields: string[], tool: string,
 *   orbit: string, alt: string }} seen `src` is null for a file of the person's own, which is called `name`;
 *   `startState`: what a scene brought by itself; `preset` and what it decides about: '' when the coat is no preset's
 * @returns {string} HTML
 */
export function embedCode(pageUrl, { src, name, state, startState, preset, coatFields, tool, orbit, alt }) {
  const settings = { ...JSON.parse(state).settings };
  const brought = [...animalNames, ...sceneNames].includes(src) ? JSON.parse(startState).settings ?? {} : {};
  for (const [field, value] of Object.entries(settings)) {
    if ((preset && coatFields.includes(field)) || JSON.stringify(value) === JSON.stringify(brought[field])) delete settings[field];
  }
  const isName = src && !/[./]/.test(src);
  const attributes = { src: src ? (isName ? src : new URL(src, pageUrl).href) : name, alt, 'camera-orbit': orbit.replaceAll(',', ' ') };
  if (preset) attributes.preset = preset;
  if (tool !== 'none') attributes.tool = tool;
  for (const [field, attribute] of Object.entries(attributeOf)) {
    if (settings[field] === undefined) continue;
    attributes[attribute] = settings[field];
    delete settings[field];
  }
  const written = Object.entries(attributes).map(([attribute, value]) => `${attribute}="${escape(value)}"`);
  const lines = [`<script type="module" src="${escape(new URL('element.js', pageUrl).href)}"></script>`,
    `<wet-fur ${written.join(' ')} camera-controls></wet-fur>`];
  // Every other setting is a property.
  if (Object.keys(settings).length > 0)
    lines.push(`<script type="module">Object.assign(document.querySelector('wet-fur').settings, ${JSON.stringify(settings).replaceAll('<', '\\u003c')})</script>`);
  return lines.join('\n');
}
