// THIRD-PARTY-NOTICES.txt: whose work the built files hold, with the licence texts as they lie beside the
// sources on this machine (Debian's copyright files, licence files, header comments).
import { existsSync, readFileSync, realpathSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { Stop, root } from './process.mjs';
import { activeEmcc, editorFont, imguiFolder } from './setup.mjs';

/**
 * From a Debian copyright file (DEP 5): the stanza whose Files field names `files` exactly among its
 * patterns, and the texts of the licences that it names ("A or B" names both), unless a `licence` is given.
 */
export function fromCopyright(text, files = '*', licence = undefined) {
  const stanzas = text.replaceAll('\r', '').split(/\n(?:[ \t]*\n)+/);
  const field = (stanza, name) => new RegExp(`^${name}:((?:.*)(?:\\n[ \\t].*)*)`, 'm').exec(stanza)?.[1];
  const stanza = stanzas.find((one) => (field(one, 'Files') ?? '').split(/\s+/).includes(files));
  if (!stanza) throw new Stop(`no stanza for ${files} in a copyright file`);
  const [named, ...inline] = field(stanza, 'License').trim().split('\n');
  const plain = (lines) => lines.map((line) => line.replace(/^ ?/, '').replace(/^\.$/, '')).join('\n').trimEnd();
  const copyright = field(stanza, 'Copyright').split('\n').map((line) => line.trim()).filter(Boolean);
  const texts = inline.length > 0 ? [plain(inline)] : (licence ? [licence] : named.split(/ (?:or|and) /)).map((name) => {
    const own = stanzas.find((one) => !/^Files:/m.test(one) && field(one, 'License')?.split('\n')[0].trim() === name);
    if (!own) throw new Stop(`no text of the licence ${name} in a copyright file`);
    return plain(field(own, 'License').split('\n').slice(1));
  });
  return [...copyright.map((line) => `Copyright ${line}`), '', ...texts].join('\n');
}

// The first of the given readers that finds its text here.
function firstOf(...readers) {
  for (const reader of readers) {
    const text = reader();
    if (text) return text;
  }
  return undefined;
}

const debian = (name, ...what) => () => {
  const path = `/usr/share/doc/${name}/copyright`;
  return existsSync(path) ? fromCopyright(readFileSync(path, 'utf8'), ...what) : undefined;
};

const file = (path) => () => (existsSync(path) ? readFileSync(path, 'utf8').trimEnd() : undefined);

// The first comment of a header that speaks of its copyright or licence.
const headerComment = (name) => () => {
  const path = ['/usr/include', '/usr/local/include', '/opt/homebrew/include'].map((one) => join(one, name)).find(existsSync);
  if (!path) return undefined;
  const comments = readFileSync(path, 'utf8').match(/\/\*[\s\S]*?\*\/|(?:^[ \t]*\/\/.*\n)+/gm) ?? [];
  return comments.find((one) => /copyright|public domain/i.test(one) && /permission|licen/i.test(one));
};

/** The whole text. A part whose licence cannot be found stops the build: dist/ must not go without. */
export function notices() {
  const emscripten = dirname(realpathSync(activeEmcc()));
  const system = join(emscripten, 'system/lib');
  const parts = [
    ['OpenGL Mathematics (GLM)', firstOf(debian('libglm-dev'), headerComment('glm/glm.hpp'), headerComment('glm/detail/setup.hpp'))],
    ['stb (stb_rect_pack.h, stb_image_write.h)', firstOf(debian('libstb-dev'), headerComment('stb/stb_rect_pack.h'))],
    ['Dear ImGui (the editor only), with stb_rect_pack, stb_textedit and stb_truetype (public domain)', firstOf(file(join(imguiFolder, 'LICENSE.txt')))],
    ['Emscripten, its JavaScript and system libraries', firstOf(file(join(emscripten, 'LICENSE')), debian('emscripten'))],
    ['musl (C library)', firstOf(file(join(system, 'libc/musl/COPYRIGHT')), debian('emscripten', 'system/lib/libc/musl/*'))],
    ['libc++, libc++abi, libunwind, compiler-rt (LLVM)', firstOf(file(join(system, 'libcxx/LICENSE.TXT')), debian('emscripten', 'system/lib/libcxx/*'))],
    ['Stanford bunny (models/bunny.glb)', bunnyNotice()],
    ['KaTeX, its style and fonts (docs/katex)', firstOf(file(join(root, 'node_modules/katex/LICENSE')))],
    ['three.js (docs/three)', firstOf(file(join(root, 'node_modules/three/LICENSE')))],
  ];
  if (existsSync(editorFont)) parts.push(['Karla (font of the editor)', firstOf(debian('fonts-karla'))]);
  const missing = parts.filter(([, text]) => !text).map(([name]) => name);
  if (missing.length > 0) throw new Stop(`no licence text found on this machine for: ${missing.join('; ')}`);
  const rule = '='.repeat(78);
  return `wet-fur is under the MIT licence (see LICENSE). The files here also hold work of others:\n\n${parts
    .map(([name, text]) => `${rule}\n${name}\n${rule}\n\n${text}\n`).join('\n')}`;
}

function bunnyNotice() {
  const folder = join(root, 'node_modules/bunny');
  if (!existsSync(folder)) return undefined;
  const { license, version } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  return `From the npm package bunny ${version} (${license}), with normals and an atlas added.\n` +
    'The bunny is part of the Stanford 3D scanning repository (Stanford Computer Graphics Laboratory).';
}
