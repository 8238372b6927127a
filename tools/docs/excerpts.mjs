// Pieces of the tree's own sources, found by name when the pages are built, so that pages cannot go stale: what is not found is an error.
import { readFileSync } from 'node:fs';
import { extname, join } from 'node:path';
import { root, Stop } from '../process.mjs';

/** The languages of Shiki by the endings of files. */
const languages = { '.cpp': 'cpp', '.h': 'cpp', '.inc': 'cpp', '.glsl': 'glsl', '.vert': 'glsl', '.frag': 'glsl', '.js': 'js', '.mjs': 'js', '.ts': 'ts', '.html': 'html', '.css': 'css', '.json': 'json' };
export const languageOf = (file) => languages[extname(file)] ?? 'text';

/** The index after the bracket that closes the one at `open`; texts and comments are passed over. */
function closing(text, open) {
  const pairs = { '(': ')', '{': '}', '[': ']' }, waiting = [];
  const token = /\/\/[^\n]*|\/\*[\s\S]*?\*\/|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+'|`(?:\\.|[^`\\])*`|[(){}[\]]/g;
  token.lastIndex = open;
  for (let found = token.exec(text); found; found = token.exec(text)) {
    const [mark] = found;
    if (pairs[mark]) waiting.push(pairs[mark]);
    else if (mark === waiting.at(-1)) waiting.pop();
    if (waiting.length === 0) return token.lastIndex;
  }
  return -1;
}

/** From the comment right above the line of `index`, or from that line. */
function startWithComment(text, index) {
  let start = text.lastIndexOf('\n', index - 1) + 1;
  for (;;) {
    const before = text.lastIndexOf('\n', start - 2) + 1;
    if (start === 0 || !/^\s*(\/\/|\*|\/\*)/.test(text.slice(before, start))) return start;
    start = before;
  }
}

/** Where the function, struct or method of that name is defined: [from, to), or undefined. */
function definition(text, name) {
  const escaped = name.replace(/[$.*+?^()[\]{}|\\]/g, '\\$&');
  for (const { index, 0: found } of text.matchAll(new RegExp(`\\b${escaped}\\s*\\(`, 'g'))) {
    const parameters = closing(text, index + found.length - 1);
    const body = /^[\s\w:>\-&*]*\{|^\s*=>\s*/.exec(text.slice(parameters));
    const line = text.slice(text.lastIndexOf('\n', index - 1) + 1, index);
    // A call stands within something; a definition has at most a type, or a class, before its name.
    if (parameters < 0 || !body || /[=(,!?.]|return|if |while |\/\//.test(line.replace(/::/g, ''))) continue;
    if (body[0].includes('{')) return [startWithComment(text, index), closing(text, parameters + body[0].length - 1)];
  }
  const type = new RegExp(`\\b(?:struct|class)\\s+${escaped}\\b[^;{]*\\{`).exec(text);
  if (!type) return undefined;
  return [startWithComment(text, type.index), closing(text, type.index + type[0].length - 1) + 1];
}

/** The lines from the first that `from` matches to the first after it that `to` matches, both included. */
function region(text, from, to) {
  const lines = text.split('\n'), first = lines.findIndex((line) => from.test(line));
  if (first < 0) return undefined;
  const length = to ? lines.slice(first).findIndex((line, i) => (i > 0 || !from.test(line) || from.source === to.source) && to.test(line)) : 0;
  return length < 0 ? undefined : lines.slice(first, first + length + 1).join('\n');
}

const withoutIndent = (text) => {
  const lines = text.replace(/\s+$/, '').split('\n');
  const indent = Math.min(...lines.filter((line) => line.trim()).map((line) => /^ */.exec(line)[0].length));
  return lines.map((line) => line.slice(indent)).join('\n');
};

const pattern = (text) => (/^\/.*\/$/.test(text) ? new RegExp(text.slice(1, -1)) : undefined);

/**
 * The text of `file` that `what` names: a function or type that is defined there, or, between slashes, a regular expression for its
 * first line, and `to` one for its last.
 */
export function excerpt(file, what, to, read = (name) => readFileSync(join(root, name), 'utf8')) {
  let text;
  try {
    text = read(file);
  } catch {
    throw new Stop(`docs: there is no file ${file} to quote`);
  }
  const from = pattern(what);
  if (from) {
    const found = region(text, from, to && pattern(to));
    if (found === undefined) throw new Stop(`docs: ${file} has nothing from ${what}${to ? ` to ${to}` : ''}`);
    return withoutIndent(found);
  }
  const place = definition(text, what);
  if (!place || place[1] <= 0) throw new Stop(`docs: ${file} defines no ${what}`);
  return withoutIndent(text.slice(...place));
}
