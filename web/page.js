// The demo page: one <wet-fur> over the window, its toolbar, files and links.
import './element.js';
import { wireActs } from './acts.js';
import { wireBrush } from './brush.js';
import { captions } from './captions.js';
import { coatFields, Coats } from './coats.js';
import { download, downloadScene, listed } from './download.js';
import { embedCode } from './embedcode.js';
import { howToPlace, Letters } from './letters.js';
import { makeLink, readLink } from './link.js';
import { Messages } from './messages.js';
import { acceptedFiles, firstModel, modelNames, readEndings, sceneNames, sortFiles } from './models.js';
import { packBytes, packGroom, sameBytes } from './packed.js';
import { packWater, waterSizes } from './packedwater.js';
import { packStrokes } from './strokes.js';
import { Toolbar } from './toolbar.js';
import { asksForScene, modelOf, Visit } from './visit.js';
import { welcome } from './welcome.js';

const byId = (id) => document.getElementById(id);
const fur = byId('fur');
const bar = byId('bar');
const modelPicker = byId('model');
const messages = new Messages(byId('messages'));
const either = (words) => new Intl.ListFormat('en-GB', { type: 'disjunction' }).format(words);
const coats = new Coats(byId('coats'), fur, (text) => messages.error(text));
const toolButtons = [...document.querySelectorAll('[data-tool]')];
const waters = byId('waters');
const grooms = byId('grooms');
const toolbar = new Toolbar(bar, [...document.querySelectorAll('.panel')]);

const pressedWind = 0.6;
/** Behind the model, where the person likes it dark and nothing else is asked for. */
const backdrop = matchMedia('(prefers-color-scheme: dark)').matches ? { backgroundTop: '#39434e', backgroundBottom: '#17191c' } : {};

/** The live handle: tests and the curious reach everything through it. */
window.wetFur = fur;

// --- the address ---

/** `ofBefore`: it is for a scene that has a backdrop already. */
function applyLink(link, ofBefore = false) {
  for (const text of link.warnings) {
    console.warn(`wet-fur: ${text}`);
    fur.warnings.push(text);
  }
  if (link.state) fur.setState(link.state);
  else if (!ofBefore) for (const [name, color] of Object.entries(backdrop)) fur.fur.set(name, color);
  if (link.preset) fur.preset = link.preset;
  // Settings beside the light rig stay over it.
  if (link.light) fur.lightRig = link.light;
  for (const [name, text] of link.settings) fur.fur.set(name, text);
  if (link.wetness !== undefined) fur.fur.set('wetness', link.wetness);
  if (link.tool) setTool(link.tool);
  if (link.quality) fur.quality = link.quality;
  if (link.motion) fur.motion = link.motion;
  if (link.camera) fur.cameraOrbit = link.camera;
  if (link.dt) fur.fixedDt = link.dt;
  if (link.ui === false) bar.hidden = true;
  if (link.autoplay === false || link.frames !== undefined) fur.paused = true;
  showModelName(modelOf(link));
}

const mostTold = 3;

/** What `work` warns of, in one message that begins with `what`. */
async function tellWarnings(what, work, already = []) {
  const told = [...already];
  const note = ({ detail }) => told.push(detail.message);
  fur.addEventListener('warning', note);
  try {
    return await work();
  } finally {
    fur.removeEventListener('warning', note);
    const more = told.length - mostTold;
    if (told.length > 0) messages.tell(`${what}: ${told.slice(0, mostTold).join('; ')}${more > 0 ? `; and ${more} more, which are in the console` : ''}`);
  }
}

async function openAsLinked() {
  const link = readLink(location.href);
  if (modelOf(link) !== firstModel) fur.querySelector('[slot=poster]').remove();  // of another model
  const visit = new Visit(fur, link, messages);
  await (asksForScene(link) ? tellWarnings('Not all of the link could be used', () => visit.open(applyLink), link.warnings) : visit.open(applyLink));
  bar.inert = false;
  if (visit.isFirst) welcome(fur, byId('hint'));
  if (link.frames) fur.step(link.dt || 1 / 60, link.frames);
  if (link.editor) openEditor(true);
}

// --- what the buttons show ---

function setTool(tool) {
  fur.tool = tool;
  showButtons();
}

/** A button that opens a menu of tools says which of them is in hand. */
function nameToolOf(opener, menu) {
  const name = opener.dataset.name ??= opener.textContent.trim();
  const inHand = menu.querySelector('[data-tool][aria-pressed=true]')?.textContent.trim();
  opener.setAttribute('aria-pressed', String(Boolean(inHand)));
  opener.setAttribute('aria-label', inHand ? `${name}: ${inHand}` : name);
  opener.querySelector('span').textContent = inHand ?? name;
}

function showButtons() {
  for (const button of toolButtons) button.setAttribute('aria-pressed', String(button.dataset.tool === fur.tool));
  nameToolOf(byId('water'), waters);
  nameToolOf(byId('groom'), grooms);
  byId('groom-type').value = fur.groomType;
  coats.showChosen();
  toolbar.enable([[byId('undo'), fur.canUndo], [byId('redo'), fur.canRedo]]);
  byId('wind').setAttribute('aria-pressed', String(fur.wind > 0));
  byId('editor').setAttribute('aria-pressed', String(fur.editorOpen));
  document.body.classList.toggle('editing', fur.editorOpen);
  toolbar.refresh();
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
  byId('caption').textContent = captions[name] ?? '';
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
  byId('player').hidden = names.length === 0 || fur.actions.length > 0;  // those of animals are in a menu
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

function dryingText(seconds) {
  if (fur.stayWet) return 'Stays wet';
  if (seconds >= 2 * slowest) return 'Hardly dries';
  return seconds < 90 ? `Dries in ${Math.round(seconds)} s` : `Dries in ${Math.round(seconds / 60)} min`;
}

function showDrying() {
  const seconds = timeAtOne / fur.dryRate;
  byId('stay-wet').setAttribute('aria-pressed', String(fur.stayWet));
  drying.disabled = fur.stayWet;
  drying.value = 100 * Math.log(slowest / seconds) / Math.log(slowest / fastest);
  drying.ariaValueText = dryingText(seconds);
  drying.nextElementSibling.textContent = drying.ariaValueText;
}

function dryBySlider() {
  fur.dryRate = timeAtOne / slowest * (slowest / fastest) ** (drying.value / 100);
}

// --- models ---

/** What is on screen: a src that a link can name, or null for a file of the person's own. */
let shownSrc = null;
let startState = '{}';

async function openFiles(files) {
  const { model, typeSet, hair, image, others } = sortFiles(files);
  if (!model && !typeSet && !hair && !image && others.length > 0)
    messages.error(`${others[0].name}: not a ${either(readEndings)} file`);
  try {
    if (model) await fur.loadModel(model, { files: others });
    if (typeSet) await fur.loadTypeSet(typeSet);
    if (hair) await fur.loadHair(hair);
    if (image) await tellWarnings(image.name, () => fur.loadPicture(image));
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

function placeLetters(event) {
  event.preventDefault();
  const text = byId('letters').firstElementChild.value;
  waters.hidePopover?.();
  const { left, top, right, bottom } = covered, box = fur.getBoundingClientRect();
  const free = { left, top, width: innerWidth - left - right, height: innerHeight - top - bottom };
  letters.show(text, free, (x, y) => fur.pick({ x: x - box.left, y: y - box.top }));
  hint = messages.offer(howToPlace(matchMedia('(hover: none)').matches), 'Leave', () => letters.hide());
}

let hint;
const letters = new Letters(byId('ghost'), (text, place) => fur.stamp(text, place), () => {
  hint.remove();
  fur.focus();
});

/** What lies over the picture at its edges. */
let covered = { left: 0, top: 0, right: 0, bottom: 0 };

function frame(sides) {
  covered = sides;
  fur.setPadding(sides);
}

/** What fur types and skin have from files: pictures, and type sets. */
const filesOfCoat = (settings = {}) => Object.keys(settings).filter((name) => /\.(picture|typeSet)$/.test(name));

/** Whoever gets it has a backdrop of their own, and no files. */
function stateToShare() {
  const state = JSON.parse(fur.getState());
  for (const name of filesOfCoat(state.settings)) delete state.settings[name];
  for (const [name, color] of Object.entries(backdrop)) if (state.settings?.[name] === color) delete state.settings[name];
  return JSON.stringify(state);
}

/** What neither a link nor an embed code can carry. */
function notCarried() {
  const files = filesOfCoat(JSON.parse(fur.getState()).settings);
  const has = (kind) => files.some((name) => name.endsWith(kind));
  return [!shownSrc && 'the file itself', has('typeSet') && "the file's coat", has('picture') && 'the pictures of its coat'].filter(Boolean);
}
/** What lies on the model that is shown, but for water; packed for a link. */
async function packedParts() {
  const parts = {}, missing = [];
  const add = async (part, has, pack, what) => {
    const now = fur.fur.document[part], before = fur.fur.cameWith?.[part];
    if (!has || (before && sameBytes(now, before))) return;  // the model brings it
    parts[part] = shownSrc ? await pack(now) : null;
    missing.push([part, what]);
  };
  await add('groom', fur.groomed, packGroom, 'the groom');
  await add('hair', fur.haired, packBytes, 'the long hair');
  return { parts, missingFrom: (link) => missing.filter(([part]) => !link.includes(`&${part}=`)).map(([, what]) => what) };
}

/** A link with strokes of water, which paint it again, or where those do not fit with the water itself, as finely as fits. */
async function linkWith(parts) {
  // A scene may bring water that is gone now; on other models water that has dried is nothing to paint again.
  const wet = fur.meanWetness > 0, recorded = fur.recordedStrokes, given = fur.fur.cameWith?.water;
  // An animal does not hold still for strokes that are painted again.
  const strokes = shownSrc && !given && fur.actions.length === 0 && (wet || sceneNames.includes(shownSrc)) ? await packStrokes(recorded) : null;
  const linkOf = (more) => makeLink(location.href, { src: shownSrc, state: stateToShare(), tool: fur.tool, ...parts, ...more });
  const link = linkOf({ strokes });
  if (!wet || link.includes('&strokes=') || (recorded === '[]' && !given && sceneNames.includes(shownSrc))) return { link };
  for (const size of shownSrc ? waterSizes : []) {
    const better = linkOf({ water: await packWater(fur.fur.document.water, size) });
    if (better.includes('&water=')) return { link: better, lost: size < waterSizes[0] && 'the finer water' };
  }
  return { link, lost: shownSrc ? 'the water, of which there is too much for a link' : 'the water' };
}

async function copyLink() {
  const { parts, missingFrom } = await packedParts();
  const { link, lost } = await linkWith(parts);
  const missing = [...notCarried(), ...missingFrom(link)];
  if (lost) missing.push(lost);
  try {
    await navigator.clipboard.writeText(link);
    if (missing.length === 0) messages.note('Link copied');
    else messages.offer(`Link copied, without ${listed(missing)}`, 'Save all as a file', saveScene);
  } catch {
    messages.copyable('Copy this link:', link);
  }
}

async function copyEmbedCode() {
  const code = embedCode(location.href, {
    src: shownSrc, name: fur.modelName, state: stateToShare(), startState, preset: fur.preset, coatFields: coatFields(fur.settingsTable),
    tool: fur.tool, orbit: fur.cameraOrbitText, alt: fur.alt,
  });
  const copied = await navigator.clipboard.writeText(code).then(() => true, () => false);
  const missing = [...notCarried(), ...(await packedParts()).missingFrom(code)];
  if (fur.meanWetness > 0) missing.push('the water');
  const without = missing.length > 0 ? `, without ${listed(missing)}` : '', beside = shownSrc ? '' : '; put your file beside the page';
  messages.copyable(`${copied ? 'Embed code copied' : 'Copy this embed code'}${without}${beside}:`, code);
}

function toggleFullscreen() {
  const toggled = document.fullscreenElement ? document.exitFullscreen() : document.documentElement.requestFullscreen();
  toggled.catch((error) => messages.error(`Full screen was refused: ${error.message}`));
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

/** Of the bar and its menus; some are the editor's. */
async function pressTool(button) {
  const { tool, place } = button.dataset;
  if (place === 'edits') {
    grooms.hidePopover();
    await openEditor(true);
  }
  const putDown = fur.tool === tool;
  setTool(putDown ? 'none' : tool);
  if (putDown) messages.note('No tool: a drag turns the view');
  // Fingers see no tooltips.
  else if (waters.contains(button)) messages.note(button.title);
}

/** Markings all over (app/tools/GroomEdits.inc), in the colour beside them. */
const markCoat = (pattern) => fur.groom(pattern, undefined, undefined, { color: byId('pattern-color').value });

function wireBar() {
  for (const button of toolButtons) button.addEventListener('click', () => pressTool(button));
  byId('groom-type').addEventListener('change', ({ target }) => {
    fur.groomType = target.value;
    setTool('type');
  });
  for (const button of grooms.querySelectorAll('[data-pattern]')) button.addEventListener('click', () => markCoat(button.dataset.pattern));
  onClick('wind', toggleWind);
  onClick('shake', () => fur.shake());
  onClick('soak', () => fur.setWetness(1));
  onClick('clear', () => fur.setWetness(0));
  onClick('stay-wet', () => { fur.stayWet = !fur.stayWet; });
  drying.addEventListener('input', dryBySlider);
  byId('letters').addEventListener('submit', placeLetters);
  onClick('undo', () => fur.undo());
  onClick('redo', () => fur.redo());
  onClick('reset', () => fur.reset(backdrop));
  onClick('link', copyLink);
  onClick('embed', copyEmbedCode);
  onClick('picture', savePicture);
  byId('sharing').addEventListener('click', ({ target }) => { if (target.closest('button')) byId('sharing').hidePopover(); });
  onClick('fullscreen', toggleFullscreen);
  byId('fullscreen').hidden = !document.fullscreenEnabled;
  document.addEventListener('fullscreenchange', () => byId('fullscreen').setAttribute('aria-pressed', String(Boolean(document.fullscreenElement))));
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
    startState = fur.getState();
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
    if (event.key === 'Escape' && !letters.hide() && !document.querySelector(':popover-open')) messages.dismissAll();
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
wireBrush(byId('brushing'), fur);
wireActs(byId('act'), byId('acts'), fur);
toolbar.watch([byId('caption')], frame);
wireDrop();
wireKeys();
openAsLinked();
