// Brings what a command needs onto the machine: Debian packages through apt, npm packages from the
// lock file, Dear ImGui's sources. Looks first, in the file system only, so that it costs next to
// nothing when all is there; says what it installs; asks nothing.
import { existsSync, readFileSync, readdirSync, statSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { fetchImgui } from './imgui.mjs';
import { Stop, root, run, say, which } from './process.mjs';

const headerFolders = ['/usr/include', '/usr/local/include', '/opt/homebrew/include', ...(process.env.CPATH ?? '').split(':')];

function libraryFolders() {
  const folders = ['/usr/lib', '/usr/lib64', '/usr/local/lib', '/opt/homebrew/lib'];
  for (const entry of existsSync('/usr/lib') ? readdirSync('/usr/lib') : []) {
    if (entry.includes('-linux-gnu')) folders.push(`/usr/lib/${entry}`);
  }
  return folders;
}

/** The font that cmake/EditorFont.cmake puts into the editor. */
export const editorFont = '/usr/share/fonts/truetype/karla/Karla-Regular.otf';

const program = (...names) => () => names.some((name) => which(name));
const header = (name) => () => headerFolders.some((folder) => folder && existsSync(join(folder, name)));
const library = (...names) => () => libraryFolders().some((folder) => names.some((name) => existsSync(join(folder, name))));
const both = (one, other) => () => one() && other();

// Debian's name of a package, and how to see that what it brings is there, wherever it came from.
const probes = {
  'cmake': program('cmake'),
  'ninja-build': program('ninja'),
  'g++': program('g++', 'c++'),
  'xz-utils': program('xz'),
  'emscripten': () => Boolean(activeEmcc()),
  'libglm-dev': header('glm/glm.hpp'),
  'libtinygltf-dev': header('tiny_gltf.h'),
  'nlohmann-json3-dev': header('nlohmann/json.hpp'),
  'libstb-dev': header('stb/stb_rect_pack.h'),
  'libegl-dev': header('EGL/egl.h'),
  'libgles-dev': both(header('GLES3/gl3.h'), library('libGLESv2.so')),
  'libglfw3-dev': header('GLFW/glfw3.h'),
  'libegl-mesa0': library('libEGL_mesa.so.0', 'libEGL_nvidia.so.0'),
  'libgl1-mesa-dri': library('dri/swrast_dri.so', 'dri/libdril_dri.so'),
  'libgtest-dev': header('gtest/gtest.h'),
  'googletest': () => existsSync('/usr/src/googletest/googletest/src/gtest-all.cc'),
  // Optional: elsewhere the editor does with Dear ImGui's own font.
  'fonts-karla': () => existsSync(editorFont) || !which('apt-get'),
  'chromium': () => Boolean(chromiumPath()),
};

const headers = ['libglm-dev', 'libstb-dev'];
const testHeaders = ['libtinygltf-dev', 'nlohmann-json3-dev'];
const native = ['cmake', 'ninja-build', 'g++', ...headers];
const gles = ['libegl-dev', 'libgles-dev', 'libegl-mesa0', 'libgl1-mesa-dri'];

/** What each kind of work needs; a command adds up the ones it does. */
export const needs = {
  web: ['cmake', 'ninja-build', 'emscripten', 'fonts-karla', ...headers],
  native: [...native, 'libegl-dev', 'libgles-dev', 'libglfw3-dev', 'fonts-karla'],
  headless: [...native, ...gles],
  nativeTests: [...native, ...gles, 'libgtest-dev', ...testHeaders],
  wasmTests: ['googletest', ...testHeaders],
  browser: ['chromium'],
};

/** emcc of an active emsdk, else the one on PATH. */
export function activeEmcc() {
  const own = process.env.EMSDK && join(process.env.EMSDK, 'upstream/emscripten/emcc');
  return own && existsSync(own) ? own : which('emcc');
}

/** A Chromium that page tests can drive: FUR_CHROMIUM, else what is on PATH. */
export function chromiumPath() {
  if (process.env.FUR_CHROMIUM) return process.env.FUR_CHROMIUM;
  for (const name of ['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable']) {
    const path = which(name);
    if (path) return path;
  }
  return undefined;
}

export const imguiFolder = process.env.FUR_IMGUI_DIR ?? join(root, 'build/third_party/imgui');

/**
 * Makes the machine ready. `packages`: lists from `needs`; `npm`, `imgui`: whether those are needed.
 */
export function setUp({ packages = [], npm = false, imgui = false }) {
  const needsImgui = imgui && !existsSync(join(imguiFolder, 'imgui.h'));
  const wanted = new Set(packages.flat());
  if (needsImgui) wanted.add('xz-utils');
  installPackages([...wanted].filter((name) => !probes[name]()));
  if (needsImgui) {
    if (process.env.FUR_IMGUI_DIR) throw new Stop(`FUR_IMGUI_DIR=${imguiFolder} holds no imgui.h`);
    fetchImgui(imguiFolder);
  }
  if (npm) installNpmPackages();
}

function installPackages(missing) {
  if (missing.length === 0) return;
  if (!which('apt-get')) {
    throw new Stop(
      `missing here: ${missing.join(', ')} (Debian's package names). There is no apt on this system: ` +
        'install what corresponds with its own package manager, then run this again.');
  }
  const install = ['apt-get', 'install', '-y', '--no-install-recommends', ...missing];
  const asRoot = process.getuid() === 0 ? [] : ['sudo', '-n'];
  if (asRoot.length > 0 && !canSudo()) {
    throw new Stop(`missing here: ${missing.join(', ')}. Run: sudo ${install.join(' ')}`);
  }
  say(`installing Debian packages: ${missing.join(' ')}`);
  const env = ['env', 'DEBIAN_FRONTEND=noninteractive'];
  const privileged = (args) => {
    const [name, ...rest] = [...asRoot, ...env, ...args];
    run(name, rest, { quiet: true });
  };
  try {
    privileged(['apt-get', 'update']);
  } catch (error) {
    // One stale third-party source must not stand in the way of what the other lists have.
    say(`apt-get update did not succeed (${error.message}); trying with the lists that are there`);
  }
  privileged(install);
  const absent = missing.filter((name) => !probes[name]());
  if (absent.length > 0) throw new Stop(`installed, but not found afterwards: ${absent.join(', ')}`);
}

function canSudo() {
  if (!which('sudo')) return false;
  try {
    run('sudo', ['-n', 'true'], { quiet: true });
    return true;
  } catch {
    return false;
  }
}

function installNpmPackages() {
  const lock = join(root, 'package-lock.json');
  // npm writes this file last, so an interrupted install is noticed.
  const installed = join(root, 'node_modules/.package-lock.json');
  if (existsSync(installed) && statSync(installed).mtimeMs >= statSync(lock).mtimeMs) return;
  const names = Object.keys(JSON.parse(readFileSync(join(root, 'package.json'), 'utf8')).devDependencies);
  say(`installing npm packages: ${names.join(' ')}`);
  const npm = process.env.npm_execpath ?? join(dirname(process.execPath), 'npm');
  const [name, ...first] = npm.endsWith('.js') ? [process.execPath, npm] : [npm];
  run(name, [...first, 'ci', '--ignore-scripts'], { quiet: true });
}
