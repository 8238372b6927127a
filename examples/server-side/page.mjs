// The page, as a server renders it. What a browser would import can be imported here as well: it touches no DOM and registers nothing.
import { WetFurElement } from 'wet-fur/element';
import 'wet-fur/companions';
import { loadCore } from 'wet-fur/core';

const core = await loadCore();
const attributes = new Set(WetFurElement.observedAttributes);

const escape = (text) => String(text).replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;');

/** A tag, of attributes that the element knows. */
function figure(given) {
  const unknown = Object.keys(given).filter((name) => name !== 'id' && !attributes.has(name));
  if (unknown.length > 0) throw new TypeError(`<wet-fur> has no attribute ${unknown.join(', ')}`);
  const written = Object.entries(given).map(([name, value]) => (value === true ? name : `${name}="${escape(value)}"`));
  return `<wet-fur ${written.join(' ')}></wet-fur>`;
}

export function page() {
  const { density, thickness } = Object.fromEntries(core.settingsTable.map(({ name, default: value }) => [name, value]));
  const strands = core.equations.strandCount(density, thickness);
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>A furry figure from a server</title>
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="icon" href="/wet-fur/icon.svg">
<link rel="stylesheet" href="/page.css">
<script type="module" src="/wet-fur/element.js"></script>
<script type="module" src="/wet-fur/companions.js"></script>
</head>
<body>
<h1>A furry figure from a server</h1>
${figure({ id: 'fig', src: 'torus', alt: 'A furry ring. Click to wet its fur.', tool: 'droplet', 'camera-controls': true })}
<wet-fur-slider for="fig" setting="curl"></wet-fur-slider>
<p>Its coat tries for <b>${Math.round(strands)}</b> strands a tile.</p>
</body>
</html>
`;
}
