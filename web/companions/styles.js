// How companions look: native controls in the page's own font and colours, light and dark as the page's color-scheme says. A constructed
// sheet, which the strictest page policies let pass.

const css = `
:host { display: block; box-sizing: border-box; font: inherit; color: inherit; margin-block: 0.5em;
  --accent: var(--wet-fur-companion-accent, light-dark(#2f6ab8, #8ab8f2));
  --line: var(--wet-fur-companion-line, light-dark(#0000003d, #ffffff45));
  --back: var(--wet-fur-companion-background, light-dark(#0000000a, #ffffff12));
  --radius: var(--wet-fur-companion-radius, 0.5em); }
:host([hidden]) { display: none; }
:host(wet-fur-button), :host(wet-fur-readout) { display: inline-block; margin: 0.15em; }
[hidden] { display: none !important; }
*, ::before, ::after { box-sizing: border-box; }
:focus-visible { outline: 3px solid var(--wet-fur-focus-ring, var(--accent)); outline-offset: 2px; }
:disabled { opacity: 0.55; }
[part=error] { margin: 0.25em 0; padding: 0.4em 0.7em; border-inline-start: 4px solid; color: light-dark(#a3261c, #ffb0a6); overflow-wrap: anywhere; }
[part=label] { font-weight: 600; overflow-wrap: anywhere; }
[part=value] { direction: ltr; unicode-bidi: isolate; font-variant-numeric: tabular-nums; white-space: nowrap; }
.row { display: flex; flex-wrap: wrap; justify-content: space-between; align-items: center; gap: 0 1em; }
input, select, button { font: inherit; color: inherit; }
input[type=range] { display: block; width: 100%; height: 2em; margin: 0; accent-color: var(--accent); }
input[type=color] { width: 3.5em; height: 2.2em; padding: 0.15em; border: 1px solid var(--line); border-radius: var(--radius); background: none; }
select, button, .pick span { min-height: 2.4em; padding: 0.3em 0.9em; border: 1px solid var(--line); border-radius: var(--radius); background: var(--back); }
select { max-width: 100%; background: light-dark(#fff, #23272e); }
button { cursor: pointer; }
button:not(:disabled):hover, .pick:hover span { border-color: var(--accent); }
button[aria-busy=true] { opacity: 0.7; cursor: progress; }
fieldset { min-width: 0; margin: 0; padding: 0; border: 0; }
legend { padding: 0; margin-block-end: 0.3em; }
.picks { display: flex; flex-wrap: wrap; gap: 0.35em; }
.pick { position: relative; cursor: pointer; }
.pick input { position: absolute; inset: 0; width: 100%; height: 100%; margin: 0; opacity: 0; cursor: inherit; }
.pick span { display: inline-grid; place-content: center; }
.pick input:checked + span { border-color: var(--accent); box-shadow: inset 0 0 0 1px var(--accent); font-weight: 600; }
.pick input:focus-visible + span { outline: 3px solid var(--wet-fur-focus-ring, var(--accent)); outline-offset: 2px; }
.check { display: inline-flex; align-items: center; gap: 0.5em; min-height: 2em; }
.check input { width: 1.25em; height: 1.25em; margin: 0; accent-color: var(--accent); }

.compare { position: relative; display: grid; overflow: hidden; border-radius: var(--radius); background: var(--back); isolation: isolate; }
.compare > .side { grid-area: 1 / 1; min-width: 0; }
.compare canvas { display: block; width: 100%; height: auto; }
.compare ::slotted(*) { display: block !important; width: 100% !important; max-width: none !important; margin: 0 !important; }
.side > [part=caption] { position: absolute; inset-block-end: 0.5em; max-width: 45%; padding: 0.15em 0.6em; border-radius: var(--radius); color: #fff; background: #000a;
  font-size: 0.85em; pointer-events: none; }
.before > [part=caption] { inset-inline-start: 0.5em; }
.after > [part=caption] { inset-inline-end: 0.5em; }
[part=divider] { position: absolute; inset-block: 0; inset-inline-start: var(--at); width: 44px; margin-inline-start: -22px; cursor: ew-resize; touch-action: pan-y; }
[part=divider]::before { content: ""; position: absolute; inset-block: 0; inset-inline-start: 50%; width: 3px; margin-inline-start: -1.5px; background: #fff; box-shadow: 0 0 4px #000b; }
[part=divider]::after { content: "\\2194"; position: absolute; inset-block-start: 50%; inset-inline-start: 50%; width: 40px; height: 40px; margin: -20px; margin-inline: -20px;
  display: grid; place-content: center; border-radius: 50%; font: 20px/1 system-ui, sans-serif; color: #23272e; background: #fff; box-shadow: 0 1px 8px #0008; }
[part=divider]:focus-visible { outline: none; }
[part=divider]:focus-visible::after { outline: 3px solid var(--wet-fur-focus-ring, var(--accent)); outline-offset: 2px; }
.unmade { min-height: 12em; }

.steps { container-type: inline-size; }
.layout { display: grid; gap: 0 2em; }
.beside { position: sticky; inset-block-start: 0; align-self: start; z-index: 1; }
.steps:not(.drives) .beside { display: none; }
@container (min-width: 44em) { .drives > .layout { grid-template-columns: minmax(0, 1fr) minmax(0, 1fr); } .beside { inset-block-start: 1em; } }
.steps ::slotted([aria-current=step]) { border-inline-start-color: var(--accent) !important; }
.steps ::slotted(section) { padding-inline-start: 1em; border-inline-start: 4px solid transparent; }
.drives ::slotted(section) { padding-block: 8vh; }

[part=plot] { display: block; width: 100%; height: auto; direction: ltr; overflow: visible; font-size: 12px; fill: currentColor; }
.plot .grid { stroke: var(--line); stroke-width: 1; }
.plot .axis { stroke: currentColor; stroke-width: 1.5; }
.plot .curve { fill: none; stroke-width: 2.5; stroke-linejoin: round; }
.legend { display: flex; flex-wrap: wrap; gap: 0.2em 1.4em; margin: 0.3em 0; padding: 0; list-style: none; }
.legend svg { display: inline-block; width: 2.2em; height: 0.7em; margin-inline-end: 0.45em; vertical-align: 0.1em; }
.c0 { stroke: var(--accent); } .c1 { stroke: light-dark(#b4490f, #f5a66f); stroke-dasharray: 7 4; } .c2 { stroke: light-dark(#1d7a3f, #7fd6a0); stroke-dasharray: 2 4; }
.c3 { stroke: light-dark(#83349b, #d9a2ea); stroke-dasharray: 9 3 2 3; } .c4 { stroke: currentColor; stroke-dasharray: 14 5; }
details { margin-block: 0.3em; }
table { border-collapse: collapse; font-variant-numeric: tabular-nums; font-size: 0.9em; }
.scroll { overflow-x: auto; }
th, td { padding: 0.15em 0.7em; border-block-end: 1px solid var(--line); text-align: end; font-weight: inherit; }
thead th { font-weight: 600; }

@media (forced-colors: active) {
  .pick input:checked + span { border: 2px solid Highlight; outline: 1px solid Highlight; }
  [part=divider]::before, [part=divider]::after { background: CanvasText; color: Canvas; forced-color-adjust: none; }
  .plot .curve, .legend .curve, .plot .axis { stroke: CanvasText; }
  .plot .grid { stroke: GrayText; }
  .steps ::slotted(section) { border-inline-start-color: Canvas; }
  .steps ::slotted([aria-current=step]) { border-inline-start-color: Highlight !important; }
}
@media print {
  input[type=range], button, details:not([open]) { display: none; }
  .beside { position: static; }
  .drives ::slotted(section) { padding-block: 0; }
  .compare, .plot { break-inside: avoid; }
  [part=divider]::after { display: none; }
}
`;

let made = null;
export function sheet() {
  if (!made) {
    made = new CSSStyleSheet();
    made.replaceSync(css);
  }
  return made;
}
