// Gives the shaders of a web build short names, which the download feels: node tools/short-names.mjs ShaderSources.h
// rewrites what cmake/EmbedShaders.cmake wrote. Global names are renamed alike in all files, so that stages, blocks and
// includes still fit, members of structures likewise; names inside a function begin anew in each. What C++ asks for by name
// stays: samplers, blocks, and what variants define. So does what is somewhere a swizzle.
import { readFileSync, writeFileSync } from 'node:fs';

const word = /(?<![\w.#"])[A-Za-z_]\w*/g;
const letters = [...'abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ'];

const file = process.argv[2], header = readFileSync(file, 'utf8');
const stages = [...header.matchAll(/R"glsl\(([\s\S]*?)\)glsl"/g)].map((found) => found[1]);
const all = stages.join('\n');
const matches = (text, pattern) => new Set([...text.matchAll(pattern)].map((found) => found[1]));

const structs = matches(all, /struct (\w+)/g);
const types = [...structs, 'float|int|bool|void|vec[234]|mat[234]|ivec[234]'].join('|');
const another = new RegExp(`^(?:${types}|in|out|inout|const|flat)$`);

// Of structures: what stands behind a dot and has a type, and is no swizzle.
const bodies = [...matches(all, /struct \w+\s*\{([^}]*)\}/g)].join('');
const members = new Set([...matches(all, /\.([A-Za-z_]\w*)/g)].filter((name) => new RegExp(`\\b${name}\\b`).test(bodies) && !/^[xyzw]+$|^[rgba]+$/.test(name)));
const kept = new Set([...[...matches(all, /\.([A-Za-z_]\w*)/g)].filter((name) => !members.has(name)), ...matches(all, /sampler\w+ (\w+)/g), ...matches(all, /FUR_BLOCK\((\w+)\)/g),
  ...matches(all, /(?:#ifdef|#ifndef) (\w+)/g), ...matches(all, /defined\((\w+)\)/g), 'main', 'FUR_BLOCK']);

/** What a text declares, also after commas: "float a=f(b,c),d". */
function declared(text) {
  const names = new Set();
  for (const { index } of text.matchAll(new RegExp(`(?<!\\w)(?:${types}) (?=[A-Za-z_])`, 'g'))) {
    let depth = 0, expects = true;
    const from = text.indexOf(' ', index) + 1;
    for (const [token] of text.slice(from).matchAll(/[A-Za-z_]\w*|[^\s]/g)) {
      if (expects && another.test(token)) break;  // of a function's parameters the next
      if (expects && /^[A-Za-z_]/.test(token)) names.add(token), (expects = false);
      else if ('([{'.includes(token)) depth++;
      else if (')]}'.includes(token) && --depth < 0) break;
      else if (token === ';') break;
      else if (token === ',' && depth === 0) expects = true;
    }
  }
  return names;
}

/** Functions, from their names to the ends of their bodies; all else is outside. */
function functionsOf(text) {
  const spans = [];
  for (const found of text.matchAll(new RegExp(`^(?:${types}) \\w+(?=\\([^;]*?\\)\\{)`, 'gm'))) {
    let depth = 0, end = text.indexOf('{', found.index);
    for (; end < text.length; end++) if (text[end] === '{') depth++; else if (text[end] === '}' && --depth === 0) break;
    spans.push([found.index + found[0].length, end + 1]);
  }
  return spans;
}

let outside = '';
for (const text of stages) {
  let at = 0;
  for (const [from, to] of functionsOf(text)) (outside += `${text.slice(at, from)};`), (at = to);
  outside += `${text.slice(at)}\n`;
}
const macros = matches(all, /#define (FUR_\w+)/g);
const globals = [...declared(outside), ...macros, ...structs, ...members].filter((name) => !kept.has(name));
const taken = new Set([...all.match(word), ...kept]);
const count = (name) => all.split(new RegExp(`(?<![\\w#"])${name}(?!\\w)`)).length;
const pairs = letters.flatMap((a) => [...letters, ...'0123456789'].map((b) => a + b)).filter((name) => !/^(if|do|in)$/.test(name));
const short = [...letters.slice(26), ...pairs].filter((name) => !taken.has(name));
const global = new Map([...new Set(globals)].sort((a, b) => count(b) - count(a)).map((name, i) => [name, short[i]]));

function shorten(text) {
  let result = '', at = 0;
  const rename = (part, local = new Map()) => part
    .replace(/(?<!"[\w/]*)\.([A-Za-z_]\w*)/g, (behind, name) => (members.has(name) && global.has(name) ? `.${global.get(name)}` : behind))
    .replace(word, (name) => local.get(name) ?? global.get(name) ?? name);
  for (const [from, to] of functionsOf(text)) {
    const body = text.slice(from, to);
    const own = [...declared(body)].filter((name) => !kept.has(name) && !global.has(name));
    const both = own.find((name) => new RegExp(`(?<![\\w.])${name}\\(`).test(body));
    if (both) throw new Error(`${both} is a variable and a function in: ${body.slice(0, 80)}`);
    // No local hides a macro.
    const seen = new Set(body.match(word)), foreign = new Set([...seen, ...macros].map((name) => global.get(name)));
    const free = [...letters, ...pairs].filter((letter) => (!seen.has(letter) || own.includes(letter)) && !foreign.has(letter));
    const local = new Map(own.map((name, i) => [name, free[i]]));
    result += rename(text.slice(at, from)) + rename(body, local);
    at = to;
  }
  return result + rename(text.slice(at));
}

/** Numbers without the zeros that they do not need, and no line ends but round what the preprocessor reads. */
const squeeze = (text) => text.replace(/(?<![\w.])(\d+)\.0(?![\w.])/g, '$1.').replace(/(?<![\w.])0(\.\d)/g, '$1')
  .replace(/([;{},])\n(?!#|$)/g, '$1');

/** Without the macros that only C++ asks for. */
const used = (text) => text.replace(/^#define (FUR_\w+) .*\n/gm, (line, name) => (count(name) > 2 ? line : ''));

const included = [...matches(header, /#include "(.*?)"/g)];
writeFileSync(file, header.replace(/(R"glsl\()([\s\S]*?)(\)glsl")/g, (_, open, text, close) => open + squeeze(shorten(used(text))) + close)
  .replace(/"([\w/]+\.(?:glsl|h))"/g, (quoted, name) => (included.includes(name) ? `"${letters[included.indexOf(name)]}"` : quoted)));
