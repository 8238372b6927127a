// What <wet-fur> shows besides the picture: poster, progress, messages. Built node by node and
// styled by a constructed sheet, which the strictest page policies let pass.

const css = `
:host { display: inline-block; position: relative; width: 300px; height: 150px; overflow: hidden; contain: content;
  background: var(--wet-fur-poster-color, transparent); }
:host([hidden]) { display: none; }
canvas { display: block; width: 100%; height: 100%; outline: none; user-select: none; -webkit-user-select: none;
  -webkit-tap-highlight-color: transparent; }
canvas:focus-visible:not([data-pointer-focus]) { outline: 3px solid var(--wet-fur-focus-ring, #3b82f6); outline-offset: -3px; }
.ring { position: absolute; inset: 0; width: 100%; height: 100%; pointer-events: none; }
.ring polygon { fill: none; stroke: #fffc; stroke-width: 1.5px; vector-effect: non-scaling-stroke; filter: drop-shadow(0 0 1px #000); }
.cover { position: absolute; inset: 0; display: grid; place-items: center; pointer-events: none; }
.cover[hidden] { display: none; }
.poster { grid-template: 100% / 100%; pointer-events: auto; overflow: hidden; }
.poster img { width: 100%; height: 100%; object-fit: cover; }
.poster:focus-visible { outline: 3px solid var(--wet-fur-focus-ring, #3b82f6); outline-offset: -3px; }
.cover [hidden] { display: none; }
.poster :is(img, .prompt), .poster ::slotted(*) { grid-area: 1 / 1; }
.poster:not([inert]) { cursor: pointer; }
.poster:not([hidden]) + .cover { box-sizing: border-box; place-items: end center; padding-bottom: min(10%, 56px); }
.prompt { position: relative; padding: 12px 22px 12px 18px; border-radius: 24px; font: 600 15px/20px system-ui, sans-serif;
  color: #23272e; background: #fffffff2; box-shadow: 0 2px 18px #0003; transition: transform 120ms; }
.prompt::before { content: ""; display: inline-block; margin-right: 10px; border: solid transparent; border-width: 6px 0 6px 10px; border-left-color: currentColor; }
.poster:hover .prompt { transform: scale(1.04); }
.progress { width: min(260px, 70%); display: grid; gap: 8px; font: 13px/1.3 system-ui, sans-serif; text-align: center;
  color: var(--wet-fur-text-color, #556); }
.track { height: 4px; border-radius: 2px; overflow: hidden; background: color-mix(in srgb, currentColor 18%, transparent); }
.bar { height: 100%; width: 100%; transform-origin: left; transform: scaleX(0); border-radius: 2px;
  background: var(--wet-fur-progress-color, currentColor); transition: transform 120ms linear; }
.growing { position: absolute; inset: auto 0 0; border-radius: 0; pointer-events: none; color: var(--wet-fur-text-color, #556); }
.growing[hidden] { display: none; }
.message { pointer-events: auto; box-sizing: border-box; max-width: min(32em, calc(100% - 32px)); max-height: calc(100% - 16px); overflow: auto;
  padding: 16px 20px; border-radius: 14px; font: 15px/1.45 system-ui, sans-serif; text-align: center;
  color: #23272e; background: #fffffff2; box-shadow: 0 2px 18px #0003; }
.message p { margin: 0; overflow-wrap: anywhere; }
.message button { margin-top: 12px; min-height: 44px; padding: 0 20px; border: 0; border-radius: 22px; font: inherit; font-weight: 600;
  color: #fff; background: #33404f; cursor: pointer; }
.message button:focus-visible { outline: 3px solid var(--wet-fur-focus-ring, #3b82f6); outline-offset: 2px; }
.status { position: absolute; width: 1px; height: 1px; overflow: hidden; clip-path: inset(50%); white-space: nowrap; }
@media (prefers-color-scheme: dark) { .message, .prompt { color: #eceff3; background: #20252df2; } .message button { background: #5b7086; }
  .progress { color: var(--wet-fur-text-color, #99a); } }
@media (forced-colors: active) { .track { outline: 1px solid CanvasText; } .bar { forced-color-adjust: none; background: Highlight; } .message, .prompt { border: 1px solid CanvasText; }
  .message button { border: 1px solid ButtonText; } }
@media (prefers-reduced-motion: reduce) { .bar, .prompt { transition: none; } }
`;

let sheet = null;
export function elementStyles() {
  if (!sheet) {
    sheet = new CSSStyleSheet();
    sheet.replaceSync(css);
  }
  return sheet;
}

function make(tag, attributes = {}, ...children) {
  const node = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  node.append(...children);
  return node;
}

const kilobytes = (bytes) => `${Math.round(bytes / 1024)}`;
const stageText = {
  program: (p) => `Loading the program${bytesText(p)}`,
  model: (p) => `Loading the model${bytesText(p)}`,
  editor: (p) => `Loading the editor${bytesText(p)}`,
  fur: () => 'Growing the fur',
};
function bytesText({ loaded, total }) {
  if (!loaded) return '';
  return total ? `: ${kilobytes(loaded)} of ${kilobytes(total)} KB` : `: ${kilobytes(loaded)} KB`;
}

/** Fills the shadow root; returns its parts and what shows and hides them. */
export function buildShadow(root) {
  const canvas = make('canvas', { part: 'canvas' });
  const image = make('img', { alt: '', hidden: '' });
  const posterSlot = make('slot', { name: 'poster' }, image);
  const prompt = make('slot', { name: 'interaction-prompt', hidden: '' }, make('div', { class: 'prompt', part: 'interaction-prompt' }, 'Show the model'));
  const poster = make('div', { class: 'cover poster', role: 'button', 'aria-label': 'Show the model' }, posterSlot, prompt);
  const bar = make('div', { class: 'bar' });
  const caption = make('div');
  const track = make('div', {
    class: 'track', part: 'progress-bar', role: 'progressbar', 'aria-label': 'Loading', 'aria-valuemin': '0', 'aria-valuemax': '100',
  }, bar);
  const progress = make('div', { class: 'cover', hidden: '' },
    make('slot', { name: 'progress-bar' }, make('div', { class: 'progress' }, track, caption)));
  const coatBar = make('div', { class: 'bar' });
  const growing = make('div', {
    class: 'track growing', part: 'coat-progress', role: 'progressbar', hidden: '',
  }, coatBar);
  const message = make('p');
  const fallback = make('slot', { name: 'fallback', hidden: '' });
  const reload = make('button', { part: 'reload-button', type: 'button' }, 'Try again');
  const notice = make('div', { class: 'cover', hidden: '' }, make('div', { class: 'message', role: 'alert' }, fallback, message, reload));
  const status = make('div', { class: 'status', role: 'status', 'aria-live': 'polite' });
  const svg = document.createElementNS('http://www.w3.org/2000/svg', 'svg');
  const ring = svg.appendChild(document.createElementNS(svg.namespaceURI, 'polygon'));
  for (const [name, value] of [['class', 'ring'], ['aria-hidden', 'true'], ['preserveAspectRatio', 'none']]) svg.setAttribute(name, value);
  root.append(canvas, svg, growing, poster, progress, notice, status);

  const parts = { canvas, ring, poster, reload, status };
  parts.showPoster = (url) => {
    image.toggleAttribute('hidden', !url);
    if (url) image.src = url;
  };
  // Program and model come side by side; what is said is about the one still on its way.
  let program = null;
  parts.showProgress = (detail) => {
    if (detail.stage === 'coat' || detail.stage === 'save') {
      growing.setAttribute('aria-label', detail.stage === 'save' ? 'Saving the scene' : 'Growing the coat');
      growing.hidden = detail.fraction >= 1;
      coatBar.style.transform = `scaleX(${detail.fraction})`;
      growing.setAttribute('aria-valuenow', String(Math.round(detail.fraction * 100)));
      return;
    }
    if (detail.stage === 'program') program = detail;
    const percent = Math.round(detail.fraction * 100);
    bar.style.transform = `scaleX(${detail.fraction})`;
    track.setAttribute('aria-valuenow', String(percent));
    const arrived = detail.stage === 'model' && detail.loaded === detail.total;
    const said = arrived && program?.loaded !== program?.total ? program : detail;
    caption.textContent = stageText[said.stage](said);
  };
  /** Whether the poster has gone with this. */
  parts.showState = ({ waiting, prompt: prompts, loading, message: text, unsupported, retry }) => {
    // There is nothing to turn to yet.
    parts.canvas.style.visibility = waiting ? 'hidden' : '';
    const dismissed = !poster.hidden && !waiting;
    // Whoever was on the poster goes on with what it stood for.
    if (dismissed && root.activeElement === poster) parts.canvas.focus({ preventScroll: true });
    poster.hidden = !waiting;
    prompt.hidden = !prompts;
    progress.hidden = !loading;
    notice.hidden = !text;
    message.textContent = text;
    fallback.hidden = !unsupported;
    reload.hidden = !retry;
    return dismissed;
  };
  return parts;
}
