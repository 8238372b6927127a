// Pieces of sources that the pages quote are found by name, and their absence is an error.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { excerpt } from '../../tools/docs/excerpts.mjs';
import { formula } from '../../tools/docs/markdown.mjs';

const sources = {
  'a.cpp': `float twice(float x);  // declared
// Doubles it: f(x) = 2 x.
float twice(float x) {
  // A brace in a comment } and in "a text }".
  return twice2(x, "}");
}
struct Pair {
  int a, b;
};
  void Water::soak(int n) const {
    if (n) soak(n - 1);
  }
constexpr float kFirst = 1;
constexpr float kLast = 2;
`,
};
const quote = (...what) => excerpt('a.cpp', ...what.concat(Array(2 - what.length).fill(undefined)), (name) => {
  if (!(name in sources)) throw new Error('no such file');
  return sources[name];
});

test('a function is quoted where it is defined, from its comment to its last brace', () => {
  assert.equal(quote('twice'), '// Doubles it: f(x) = 2 x.\nfloat twice(float x) {\n  // A brace in a comment } and in "a text }".\n  return twice2(x, "}");\n}');
});

test('a method stands without its indent, and a type with its members', () => {
  assert.equal(quote('soak'), 'void Water::soak(int n) const {\n  if (n) soak(n - 1);\n}');
  assert.equal(quote('Pair'), 'struct Pair {\n  int a, b;\n};');
});

test('lines are quoted from one that a pattern matches to one that another does', () => {
  assert.equal(quote('/kFirst/', '/kLast/'), 'constexpr float kFirst = 1;\nconstexpr float kLast = 2;');
  assert.equal(quote('/kFirst/'), 'constexpr float kFirst = 1;');
});

test('what is not there is an error that names it', () => {
  assert.throws(() => quote('thrice'), /a\.cpp defines no thrice/);
  assert.throws(() => quote('/kNever/'), /has nothing from \/kNever\//);
  assert.throws(() => quote('/kFirst/', '/kNever/'), /to \/kNever\//);
  assert.throws(() => excerpt('b.cpp', 'twice', undefined, () => { throw new Error('gone'); }), /no file b\.cpp/);
});

test('a formula with an error is none', () => {
  assert.match(formula('a^2'), /<math/);
  assert.throws(() => formula('\\frac{a}'), /\\frac\{a\}/);
  assert.throws(() => formula('\\nonsense'), /nonsense/);
});
