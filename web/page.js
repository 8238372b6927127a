// The demo page: one <wet-fur> over the window, its toolbar, files and links.
import './element.js';
import { Coats } from './coats.js';
import { download, downloadScene, listed } from './download.js';
import { makeLink, readLink } from './link.js';
import { Messages } from './messages.js';
import { acceptedFiles, modelNames, sceneNames, sortFiles } from './models.js';
import { packStrokes } from './strokes.js';
import { Visit } from './visit.js';

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
  await new Visit(fur, link, messages).open(applyLink);
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
  byId('water').setAttribute('aria-pressed', String(Boolean(waters.querySelector('[aria-pressed=true]'))));
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

function stamp(event) {
  event.preventDefault();
  const text = byId('letters').firstElementChild.value;
  // As wide as most of the model.
  fur.stamp(text, { size: Math.min(0.25 * innerHeight, (0.75 * Math.min(innerWidth, innerHeight)) / text.length) });
  waters.hidePopover?.();
}

function placeWaters() {
  const { left, right, top } = bar.getBoundingClientRect();
  waters.style.bottom = `${innerHeight - top + 8}px`;
  waters.style.left = `${(left + right) / 2}px`;
}

async function copyLink() {
  // A scene may bring water that is gone now; on other models water that has dried is nothing to paint again.
  const wet = fur.meanWetness > 0, recorded = fur.recordedStrokes;
  const strokes = shownSrc && (wet || sceneNames.includes(shownSrc)) ? await packStrokes(recorded) : null;
  const link = makeLink(location.href, { src: shownSrc, state: fur.getState(), tool: fur.tool, strokes });
  const lacksWater = wet && (shownSrc ? recorded !== '[]' && !link.includes('&strokes=') : true);
  const missing = [
    !shownSrc && 'the file itself', fur.groomed && 'the groom', fur.fur.coatGiven && "the file's coat",
    lacksWater && (shownSrc ? 'the water, of which there is too much for a link' : 'the water'),
  ].filter(Boolean);
  try {
    await navigator.clipboard.writeText(link);
    messages.note(missing.length > 0 ? `Link copied, without ${listed(missing)}` : 'Link copied');
  } catch {
    messages.copyable('Copy this link:', link);
  }
}

async function savePicture() {
  download(await fur.toBlob(), 'wet-fur.png');
}

async function saveScene() {
  if (fur.editorOpen) return fur.fur.saveByPanel();
  try {
    messages.note(await downloadScene(fur));
  } catch (error) {
    messages.error(`The scene was not saved: ${error.message}`);
  }
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
  onClick('clear', () => fur.setWetness(0));
  byId('letters').addEventListener('submit', stamp);
  onClick('undo', () => fur.undo());
  onClick('redo', () => fur.redo());
  onClick('reset', () => fur.reset());
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
    if (event.key === 'Escape' && !coats.close()) messages.dismissAll();
    const isCommand = (event.ctrlKey || event.metaKey) && !event.altKey && !event.shiftKey;
    if (isCommand && event.key.toLowerCase() === 's' && !event.defaultPrevented) {
      event.preventDefault();
      saveScene();
    }
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
