// Every loop in every shader is counted by a whole number with a small bound: a loop that waits for a number with a point never
// ends where that number does not move, and then the GPU is reset.
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const folder = join(dirname(fileURLToPath(import.meta.url)), '../../shaders/es3');
const most = 256;

const withoutComments = (text) => text.replace(/\/\/.*|\/\*[\s\S]*?\*\//g, '');
const shaders = readdirSync(folder).filter((name) => /\.(glsl|vert|frag)$/.test(name))
  .map((name) => ({ name, text: withoutComments(readFileSync(join(folder, name), 'utf8')) }));
const shared = readdirSync(join(folder, 'shared')).map((name) => readFileSync(join(folder, 'shared', name), 'utf8'));
const everything = [...shared, ...shaders.map(({ text }) => text)].map(withoutComments).join('\n');

/** The most that a bound can be: a number, a constant, a condition, or what stepsTo() gives, which never exceeds its last argument. */
function largest(bound, text) {
  if (/^\d+$/.test(bound)) return Number(bound);
  const [name, minus = '0'] = bound.split(/\s*-\s*/);
  const constant = everything.match(new RegExp(`(?:#define ${name} |const int ${name} = )(\\d+)`));
  if (constant) return Number(constant[1]) - Number(minus);
  const local = text.match(new RegExp(`\\b${name} = (int|stepsTo)\\(([^;]*)\\);`)) ?? text.match(new RegExp(`\\b${name} = (int|stepsTo)\\((.*)\\)`));
  if (local?.[1] === 'int') return /[<>=&|]/.test(local[2]) ? 1 : Infinity;
  if (local?.[1] === 'stepsTo') {
    const limit = local[2].split(',').pop().trim();
    return Math.max(...[...text.matchAll(new RegExp(`\\b${limit} = (\\w+);`, 'g'))].map(([, value]) => largest(value, text)));
  }
  return Infinity;
}

/** The statement or block that begins there. */
function bodyAt(text, from) {
  if (text[from] !== '{') return text.slice(from, text.indexOf(';', from));
  let depth = 0, end = from;
  do depth += { '{': 1, '}': -1 }[text[end]] ?? 0; while (depth > 0 && ++end < text.length);
  return text.slice(from, end);
}

/** What is wrong with the loops of a shader. */
export function faultsIn(text) {
  const faults = [];
  if (/\b(while|do)\b/.test(text)) faults.push('a loop that is not counted');
  for (const { 0: loop, 1: head, index } of text.matchAll(/\bfor\s*\(([^{;]*;[^;]*;[^{]*?)\)\s*(?=[{\w])/g)) {
    const counted = head.match(/^int (\w+) = [^;]*; *\1 <(=?) ([\w -]+?)( && [^;]*)?; *(?:\+\+\1|\1 \+= (k\w+))$/);
    if (!counted || (counted[5] && !(largest(counted[5], text) <= most))) faults.push(`not counted by a whole number: ${loop}`);
    else if (!(largest(counted[3], text) + (counted[2] ? 1 : 0) <= most)) faults.push(`no bound of at most ${most}: ${loop}`);
    else if (new RegExp(`(?<!\\.)\\b${counted[1]} *([-+*/]?=)[^=]`).test(bodyAt(text, index + loop.length)))
      faults.push(`its count is changed inside: ${loop}`);
  }
  return faults;
}

test('every loop of every shader is counted by a whole number up to a small bound', () => {
  const loops = shaders.reduce((sum, { text }) => sum + [...text.matchAll(/\bfor\b/g)].length, 0);
  assert.ok(loops >= 10, `${loops} loops`);
  for (const { name, text } of shaders) assert.deepEqual(faultsIn(text), [], name);
});

test('loops that floats, great numbers or their own bodies decide are found', () => {
  const kinds = {
    'while (x < last) { x += stepSize; }': /not counted/,
    'for (float i = 0.0; i < 5.0; i += 0.5) {}': /not counted by a whole number/,
    'for (int i = 0; i < 100000; ++i) {}': /no bound/,
    'int n = int(x);\nfor (int i = 0; i < n; ++i) {}': /no bound/,
    'for (int i = 0; i < 8; ++i) {\n i = 0;\n  }': /changed inside/,
    'for (int i = 0; i < 8; i += kNowhere) {}': /not counted by a whole number/,
    'for (bool once = x > 0.0; once; once = false) {}': /not counted by a whole number/,
  };
  for (const [text, fault] of Object.entries(kinds)) assert.match(faultsIn(text).join(), fault, text);
  assert.deepEqual(faultsIn('int once = int(x > 0.0);\nfor (int i = 0; i < once; ++i) {}'), []);
});

test('no macro of a shader goes over several lines, which tools/short-names.mjs would join', () => {
  for (const { name, text } of shaders) assert.ok(!/\\$/m.test(text), name);
});
