// Holds the includes of our C++ to the allowed arrows between modules:
// node tools/check-arrows.mjs [root] [--stamp file]. Prints file:line and what is allowed there, and
// fails when anything is not. Looks at direct includes, gl* calls and __EMSCRIPTEN__; tests are exempt.
import { readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join, relative, sep } from 'node:path';
import { pathToFileURL } from 'node:url';
import { root as ownRoot } from './process.mjs';

const fields = ['core', 'geometry', 'settings'];
const pure = [...fields, 'furgen', 'groom', 'wet', 'dynamics', 'hair', 'scene'];
const wiring = ['app/tools', 'app/commands', 'app/stages'];
const importers = ['scene/import', 'scene/export'];

// Zone (the longest folder that holds a file) -> what it may include beyond itself. `imgui`, `gles`,
// `egl`, `glfw`, `emscripten` stand for headers of others, `gltf` for those that only tests use; `shared`
// for the shader contract. What ends in `.h` is that header alone.
export const arrows = {
  'src/core': [],
  'src/geometry': ['core'],
  'src/settings': ['core', 'assets/Presets.inc'],
  'src/furgen': fields,
  // A comb is a rest of its bends, and whiskers lean by its law.
  'src/groom': [...fields, 'dynamics'],
  'src/wet': [...fields, 'shared/Wet.h'],
  'src/dynamics': fields,
  // Scalps are maps as a groom's are; of dynamics the wind and four numbers at a time.
  'src/hair': [...fields, 'groom', 'dynamics/Wind.h', 'dynamics/Lanes.h'],
  'src/scene': [...pure, ...importers],
  // The reference renderer reads the very numbers that the shaders are given, and no more of render.
  'src/truth': [...fields, 'furgen', 'dynamics', 'hair', 'wet/Clump.h', 'wet/MaskTexels.h', 'shared'],
  'src/gl': ['core', 'gles', 'emscripten'],
  // Of wet and hair only what a picture is made of: never a solver.
  'src/render': [...fields, 'furgen', 'groom', 'scene', 'wet/Drop.h', 'wet/MaskTexels.h', 'wet/Puddles.h', 'hair/HairView.h', 'hair/Marschner.h', 'hair/HairValues.h', 'hair/MemberStrands.h', 'hair/Wisps.h', 'gl', 'shared'],
  // The table of tools, which the panel reads as well as the app.
  'src/app/tools': ['core'],
  'src/app/commands': [...fields, 'groom', 'wet', 'app/tools'],
  // A stage knows no renderer and no GL.
  'src/app/stages': [...pure, 'app/tools', 'app/commands'],
  'src/editor': ['core', 'settings', 'scene', 'hair/Body.h', 'hair/HairFields.h', 'hair/HairValues.h', 'app/tools', 'imgui'],
  'src/app': [...pure, ...importers, 'gl', 'render', ...wiring],
  'src/app/editor': [...pure, ...importers, 'gl', 'render', 'editor', 'app', ...wiring, 'imgui'],
  // wet-fur/core offers the pure modules by themselves, without an app around them.
  'web': ['app', ...pure, 'emscripten'],
  'web/core': [...pure, 'emscripten', 'web'],
  'web/editor': ['app', 'app/editor', 'core', 'imgui', 'emscripten', 'web'],
  // App speaks in scene's terms (files, encoded images) and in names of settings; the platform's context
  // and framebuffer are handed to it by gl.
  'native': ['app', 'core', 'scene'],
  'native/headless': ['app', 'core', 'settings', 'scene', 'gl', 'egl', 'native'],
  'native/compare': ['app', ...pure, 'gl', 'render', 'truth', 'native', 'native/headless'],
  'native/window': ['app', 'app/editor', 'core', 'settings', 'scene', 'gl', 'imgui', 'glfw', 'native'],
  // Models with long hair are dressed by the stages that programs have.
  assets: [...pure, ...importers, ...wiring],
};

const outside = [
  [/^imgui|^imconfig/, 'imgui'],
  [/^(GLES[23]|GL|KHR)\//, 'gles'],
  [/^EGL\//, 'egl'],
  [/^GLFW\//, 'glfw'],
  [/^emscripten/, 'emscripten'],
  [/^tiny_gltf|^nlohmann\//, 'gltf'],
];

const zoneOf = (path) => Object.keys(arrows).filter((zone) => path.startsWith(`${zone}/`)).sort((a, b) => b.length - a.length)[0];

// The name under which arrows list a file of ours that is included as "name".
function targetOf(included, names) {
  if (included === 'render/ShaderSources.h') return 'render';
  const parts = included.split('/').slice(0, -1);
  for (let length = parts.length; length > 0; length--) {
    const folder = parts.slice(0, length).join('/');
    if (names.has(folder)) return folder;
  }
  return undefined;
}

const ownNames = new Set(['shared', ...importers, ...Object.keys(arrows).map((zone) => zone.replace(/^src\//, ''))]);

// Comments and strings blanked, line breaks kept. Include lines are read from the raw text.
function codeOnly(text) {
  return text.replace(/\/\/[^\n]*|\/\*[\s\S]*?\*\/|R"(\w*)\([\s\S]*?\)\1"|"(?:\\.|[^"\\\n])*"/g, (match) => match.replace(/[^\n]/g, ' '));
}

/** Violations in one file's text, as { line, what, allowed }. `path` is relative to the root, with slashes. */
export function violationsIn(path, text) {
  const zone = zoneOf(path);
  if (!zone) return [];
  const allowed = arrows[zone];
  const own = zone.replace(/^src\//, '');
  const found = [];
  text.split('\n').forEach((line, index) => {
    const match = /^\s*#\s*include\s*[<"]([^>"]+)[>"]/.exec(line);
    if (!match) return;
    const included = match[1];
    const target = included.startsWith('..') ? included : outside.find(([pattern]) => pattern.test(included))?.[1] ?? targetOf(included, ownNames);
    if (target === undefined || target === own || allowed.includes(target) || allowed.includes(included)) return;
    found.push({ line: index + 1, what: `includes ${included}`, allowed });
  });
  codeOnly(text).split('\n').forEach((line, index) => {
    const call = /(?<![\w.>:])(gl(?!TF)[A-Z]\w*)\s*\(/.exec(line);
    if (call && zone !== 'src/gl') found.push({ line: index + 1, what: `calls ${call[1]}, which only src/gl may`, allowed });
    if (/\b__EMSCRIPTEN__\b/.test(line) && !zone.startsWith('web') && zone !== 'src/gl') {
      found.push({ line: index + 1, what: 'asks for __EMSCRIPTEN__, which only web/ and one file of src/gl may', allowed });
    }
  });
  return found;
}

function sourcesBelow(folder) {
  let entries;
  try {
    entries = readdirSync(folder, { withFileTypes: true });
  } catch {
    return [];
  }
  return entries.flatMap((entry) => {
    const path = join(folder, entry.name);
    if (entry.isDirectory()) return sourcesBelow(path);
    return /\.(cpp|h|inc)$/.test(entry.name) ? [path] : [];
  });
}

/** All violations below `root`, as lines of text. */
export function checkTree(root) {
  const lines = [];
  const asking = [];
  for (const file of ['src', 'web', 'native', 'assets'].flatMap((folder) => sourcesBelow(join(root, folder)))) {
    const path = relative(root, file).split(sep).join('/');
    const text = readFileSync(file, 'utf8');
    for (const { line, what, allowed } of violationsIn(path, text)) {
      lines.push(`${path}:${line}: ${what}; ${zoneOf(path)} may use: ${allowed.join(', ') || 'nothing'}`);
    }
    if (path.startsWith('src/gl/') && /\b__EMSCRIPTEN__\b/.test(codeOnly(text))) asking.push(path);
  }
  if (asking.length > 1) lines.push(`${asking.slice(1).join(', ')}: __EMSCRIPTEN__ is for one file of src/gl, and ${asking[0]} has it`);
  return lines;
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  const args = process.argv.slice(2);
  const stamp = args.includes('--stamp') ? args.splice(args.indexOf('--stamp'), 2)[1] : undefined;
  const lines = checkTree(args[0] ?? ownRoot);
  for (const line of lines) console.error(line);
  if (lines.length > 0) process.exitCode = 1;
  else if (stamp) writeFileSync(stamp, '');
  else console.log('module arrows: every include is allowed');
}
