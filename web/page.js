// The demo page: one <wet-fur> over the window, its toolbar, files and links.
import './element.js';
import { Coats } from './coats.js';
import { howToPlace, Letters } from './letters.js';
import { makeLink, readLink } from './link.js';
import { Messages } from './messages.js';
import { acceptedFiles, modelNames, sceneNames, sortFiles } from './models.js';

const byId = (id) => document.getElementById(id);
const fur = byId('fur');
const bar = byId('bar');
const modelPicker = byId('model');
const messages = new Messages(byId('messages'));
const coats = new Coats(byId('coat'), byId('coats'), fur);
const toolButtons = [...document.querySelectorAll('[data-tool]')];
const waters = byId('waters');

const pressedWind = 0.6;

/** The live handle: tests and the curious reach everything through it. */
window.wetFur = fur;

// --- the address ---

function applyLink(link) {
  for (const text of link.warnings) {
    console.warn(`wet-fur: ${text}`);
    fur.warnings.push(text);
  }
  if (link.state) fur.setState(link.state);
  if (link.preset) fur.preset = link.preset;
  for (const [name, text] of link.settings) fur.fur.set(name, text);
  if (link.tool) setTool(link.tool);
  if (link.quality) fur.quality = link.quality;
  if (link.motion) fur.motion = link.motion;
  if (link.camera) fur.cameraOrbit = link.camera;
  if (link.dt) fur.fixedDt = link.dt;
  if (link.ui === false) bar.hidden = true;
  if (link.autoplay === false || link.frames !== undefined) fur.paused = true;
  showModelName(link.src ?? 'bunny');
}

async function openAsLinked() {
  const link = readLink(location.href);
  applyLink(link);
  fur.src = link.src ?? 'bunny';
  await new Promise((resolve) => fur.addEventListener('load', resolve, { once: true }));
  bar.inert = false;
  if (link.frames) fur.step(link.dt || 1 / 60, link.frames);
  if (link.editor) openEditor(true);
}

// --- what the buttons show ---

function setTool(tool) {
  fur.tool = tool;
  showButtons();
}

function showButtons() {
  for (const button of toolButtons) button.setAttribute('aria-pressed', String(button.dataset.tool === fur.tool));
  byId('water').setAttribute('aria-pressed', String(Boolean(waters.querySelector('[data-tool][aria-pressed=true]'))));
  coats.showChosen();
  byId('undo').disabled = !fur.canUndo;
  byId('redo').disabled = !fur.canRedo;
  byId('wind').setAttribute('aria-pressed', String(fur.wind > 0));
  byId('editor').setAttribute('aria-pressed', String(fur.editorOpen));
  document.body.classList.toggle('editing', fur.editorOpen);
}

function showModelName(name) {
  let own = modelPicker.querySelector('[data-own]');
  if (modelNames.includes(name)) {
    own?.remove();
  } else {
    own ??= modelPicker.appendChild(Object.assign(document.createElement('option'), { value: 'own' }));
    own.dataset.own = '';
    own.textContent = name.slice(name.lastIndexOf('/') + 1);
  }
  modelPicker.value = modelNames.includes(name) ? name : 'own';
}

// --- animations ---

const animationPicker = byId('animation');

const hold = byId('hold');
const speed = byId('speed');
const lessMotion = matchMedia('(prefers-reduced-motion: reduce)');
const icons = { Hold: 'M8.5 5.5v13M15.5 5.5v13', Play: 'M8 5.2v13.6l11-6.8z' };
let playedSpeed = 1;

function listAnimations() {
  const names = fur.animations;
  byId('player').hidden = names.length === 0;
  playedSpeed = 1;
  animationPicker.replaceChildren(...['No animation', ...names].map((name, i) => new Option(name || `Animation ${i}`, i)));
  showAnimation();
}

function showAnimation() {
  if (byId('player').hidden) return;
  const chosen = fur.animation <= fur.animations.length ? fur.animation : 0;
  animationPicker.value = chosen;
  hold.disabled = speed.disabled = chosen === 0;
  const now = fur.animationSpeed;
  if (now > 0) playedSpeed = now;
  const offer = isHeld() ? 'Play' : 'Hold';
  hold.querySelector('path').setAttribute('d', icons[offer]);
  hold.lastElementChild.textContent = offer;
  speed.value = now;
  speed.ariaValueText = `${Number(now.toFixed(2))} x`;
  speed.nextElementSibling.textContent = `Speed ${speed.ariaValueText}`;
}

function isHeld() {
  return fur.animationSpeed === 0 || fur.motion === 'reduced' || (fur.motion === 'auto' && lessMotion.matches);
}

function playAt(value) {
  if (value > 0) fur.motion = 'full';  // using the control asks for it, whatever the system's setting
  fur.animationSpeed = value;
}

// --- drying ---

const drying = byId('drying');
// Of soaked fur, in seconds, at the slider's ends; a rate of 1 would take it so long.
const [slowest, fastest, timeAtOne] = [3600, 10, 1.06];

function showDrying() {
  const seconds = timeAtOne / fur.dryRate;
  byId('stay-wet').setAttribute('aria-pressed', String(fur.stayWet));
  drying.disabled = fur.stayWet;
  drying.value = 100 * Math.log(slowest / seconds) / Math.log(slowest / fastest);
  drying.ariaValueText = seconds < 90 ? `Dries in ${Math.round(seconds)} s` : seconds < 2 * slowest ? `Dries in ${Math.round(seconds / 60)} min` : 'Hardly dries';
  drying.nextElementSibling.textContent = drying.ariaValueText;
}

function dryBySlider() {
  fur.dryRate = timeAtOne / slowest * (slowest / fastest) ** (drying.value / 100);
}

// --- models ---

/** What is on screen: a src that a link can name, or null for a file of the person's own. */
let shownSrc = null;

async function openFiles(files) {
  const { model, typeSet, image, others } = sortFiles(files);
  if (!model && !typeSet && !image && others.length > 0)
    messages.error(`${others[0].name}: not a .glb, .gltf, .obj, .fo or .fts file`);
  try {
    if (model) await fur.loadModel(model, { files: others });
    if (typeSet) await fur.loadTypeSet(typeSet);
    if (image) await fur.loadLengthMap(image);
  } catch {
    // The error event says it.
  }
}

function pickModel() {
  const src = modelPicker.value;
  if (src === 'own') return;
  if (src === fur.src) fur.reload();
  else fur.src = src;
}

function onError({ detail }) {
  if (!fur.loaded) return;  // the element says it in place of the picture
  messages.error(detail.message);
  showModelName(shownSrc ?? fur.modelName);
}

// --- buttons ---

function toggleWind() {
  const blows = fur.wind > 0;
  if (!blows) fur.motion = 'full';  // pressing the button asks for it, whatever the system's setting
  fur.wind = blows ? 0 : pressedWind;
}

function reset() {
  if (sceneNames.includes(shownSrc)) {
    fur.reload();
    return;
  }
  fur.setState('{"version":1}');
  fur.setWetness(0);
  if (fur.groomed) fur.groom('clear');
  fur.resetCamera();
}

function placeLetters(event) {
  event.preventDefault();
  const text = byId('letters').firstElementChild.value;
  waters.hidePopover?.();
  // As wide as most of the model.
  letters.show(text, { x: innerWidth / 2, y: innerHeight / 2, size: Math.min(0.25 * innerHeight, (0.75 * Math.min(innerWidth, innerHeight)) / text.length) });
  messages.note(howToPlace);
}

const letters = new Letters(byId('ghost'), (text, place) => fur.stamp(text, place), () => fur.focus());

function placeWaters() {
  const { left, right, top } = bar.getBoundingClientRect();
  waters.style.bottom = `${innerHeight - top + 8}px`;
  waters.style.left = `${(left + right) / 2}px`;
}

async function copyLink() {
  const link = makeLink(location.href, { src: shownSrc, state: fur.getState(), tool: fur.tool });
  try {
    await navigator.clipboard.writeText(link);
    const missing = [!shownSrc && 'the file itself', fur.groomed && 'the groom'].filter(Boolean).join(' and ');
    messages.note(missing ? `Link copied, without ${missing}` : 'Link copied');
  } catch {
    messages.copyable('Copy this link:', link);
  }
}

async function savePicture() {
  const url = URL.createObjectURL(await fur.toBlob());
  Object.assign(document.createElement('a'), { href: url, download: 'wet-fur.png' }).click();
  setTimeout(() => URL.revokeObjectURL(url), 10000);
}

async function openEditor(open) {
  const button = byId('editor');
  button.setAttribute('aria-busy', 'true');
  await (open ? fur.openEditor() : fur.closeEditor());
  button.removeAttribute('aria-busy');
  showButtons();
}

const onClick = (id, action) => byId(id).addEventListener('click', action);

function wireBar() {
  for (const button of toolButtons)
    button.addEventListener('click', () => setTool(fur.tool === button.dataset.tool ? 'none' : button.dataset.tool));
  onClick('wind', toggleWind);
  waters.addEventListener('beforetoggle', placeWaters);
  onClick('shake', () => fur.shake());
  onClick('soak', () => fur.setWetness(1));
  onClick('clear', () => fur.setWetness(0));
  onClick('stay-wet', () => { fur.stayWet = !fur.stayWet; });
  drying.addEventListener('input', dryBySlider);
  byId('letters').addEventListener('submit', placeLetters);
  onClick('undo', () => fur.undo());
  onClick('redo', () => fur.redo());
  onClick('reset', reset);
  onClick('link', copyLink);
  onClick('picture', savePicture);
  onClick('editor', () => openEditor(!fur.editorOpen));
  byId('file').accept = acceptedFiles;
  onClick('open', () => byId('file').click());
  byId('file').addEventListener('change', ({ target }) => {
    openFiles(target.files);
    target.value = '';
  });
  modelPicker.addEventListener('change', pickModel);
  animationPicker.addEventListener('change', () => { fur.animation = Number(animationPicker.value); });
  onClick('hold', () => playAt(isHeld() ? playedSpeed : 0));
  speed.addEventListener('input', () => playAt(Number(speed.value)));
  fur.addEventListener('load', listAnimations);
  fur.addEventListener('state-change', showAnimation);
  for (const type of ['load', 'state-change']) fur.addEventListener(type, showDrying);
  for (const type of ['state-change', 'stroke-end', 'wetness-change', 'load']) fur.addEventListener(type, showButtons);
  fur.addEventListener('error', onError);
  fur.addEventListener('load', ({ detail }) => {
    shownSrc = detail.src;
    showModelName(detail.src ?? detail.name);
  });
}

// --- files dropped on the page, keys that no control took ---

function wireDrop() {
  const hint = byId('drop-hint');
  let depth = 0;
  const hasFiles = (event) => event.dataTransfer?.types.includes('Files');
  const show = (by) => {
    depth = Math.max(0, depth + by);
    hint.hidden = depth === 0;
  };
  addEventListener('dragenter', (event) => { if (hasFiles(event)) show(1); });
  addEventListener('dragleave', (event) => { if (hasFiles(event)) show(-1); });
  addEventListener('dragover', (event) => { if (hasFiles(event)) event.preventDefault(); });
  addEventListener('drop', (event) => {
    event.preventDefault();
    show(-depth);
    openFiles(event.dataTransfer.files);
  });
}

function wireKeys() {
  addEventListener('keydown', (event) => {
    if (event.key === 'Escape' && !letters.hide() && !coats.close()) messages.dismissAll();
    if (event.defaultPrevented || event.target === fur || !(event.ctrlKey || event.metaKey)) return;
    if (event.target instanceof HTMLInputElement) return;
    const key = event.key.toLowerCase();
    if (key === 'z' ? (event.shiftKey ? fur.redo() : fur.undo()) : key === 'y' && fur.redo()) event.preventDefault();
  });
}

wireBar();
wireDrop();
wireKeys();
openAsLinked();
