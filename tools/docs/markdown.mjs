// What our Markdown has beside the usual: formulas between $ and $$ (KaTeX), coloured code (Shiki), headings that can be linked to, and
// links to other Markdown files, which lead to their pages.
import katex from 'katex';
import { createHighlighter } from 'shiki';
import { Stop } from '../process.mjs';

const themes = { light: 'github-light-high-contrast', dark: 'github-dark-high-contrast' };
// Comments on our background.
const colorReplacements = { 'github-light-high-contrast': { '#66707b': '#58616b' } };
const langs = ['cpp', 'glsl', 'js', 'ts', 'html', 'css', 'json', 'sh', 'text'];

/** How far a line of code is indented, for what goes on below it (docs.css); no further than a narrow page bears. */
const indented = {
  line(node, number) {
    const [spaces] = /^ */.exec(this.source.split('\n')[number - 1]);
    if (spaces) node.properties.style = `--indent:${Math.min(spaces.length, 10)}ch`;
  },
};

export async function makeHighlighter() {
  const shiki = await createHighlighter({ themes: Object.values(themes), langs });
  return (code, lang) => {
    if (lang && !langs.includes(lang)) throw new Stop(`docs: code in "${lang}", which is none of ${langs.join(', ')}`);
    return shiki.codeToHtml(code, { lang: lang || 'text', themes, defaultColor: 'light-dark()', colorReplacements, transformers: [indented] });
  };
}

/** Of several formulas in a row each stays whole where a narrow page breaks the row (docs.css). */
function breakable(text) {
  const [, row, tag = ''] = /^(.*?)(\\tag\{[^}]*\})?$/s.exec(text.trim()), parts = row.split('\\qquad');
  return parts.length > 1 ? `${parts.map((part) => `{${part.trim()}}`).join('\\qquad\\allowbreak ')}${tag}` : text;
}

/** A formula as HTML and MathML; a formula with an error stops the build. */
export function formula(text, displayMode = false) {
  try {
    return katex.renderToString(displayMode ? breakable(text) : text, { displayMode, throwOnError: true, strict: 'error', output: 'htmlAndMathml' });
  } catch (error) {
    throw new Stop(`docs: the formula ${text}: ${error.message}`);
  }
}

export const slugOf = (text) => text.toLowerCase().replace(/<[^>]*>|[^\w\s-]/g, '').trim().replace(/\s+/g, '-');

function inlineFormula(state, silent) {
  const { src, pos } = state;
  if (src[pos] !== '$' || src[pos + 1] === '$' || /\s/.test(src[pos + 1] ?? ' ')) return false;
  const end = src.indexOf('$', pos + 1);
  if (end < 0 || /\s/.test(src[end - 1])) return false;
  if (!silent) state.push('formula', '', 0).content = src.slice(pos + 1, end);
  state.pos = end + 1;
  return true;
}

function blockFormula(state, startLine, endLine, silent) {
  const lineOf = (line) => state.src.slice(state.bMarks[line] + state.tShift[line], state.eMarks[line]);
  if (!lineOf(startLine).startsWith('$$')) return false;
  let line = startLine, text = lineOf(line).slice(2);
  while (!text.trimEnd().endsWith('$$')) {
    if (++line >= endLine) return false;
    text += `\n${lineOf(line)}`;
  }
  if (silent) return true;
  const token = state.push('formula', '', 0);
  token.block = true;
  token.content = text.trimEnd().slice(0, -2).trim();
  state.line = line + 1;
  return true;
}

/** For Eleventy's amendLibrary(). @param {(code: string, lang: string) => string} highlight */
export function extendMarkdown(md, highlight) {
  md.set({ html: true, typographer: false });
  md.inline.ruler.after('escape', 'formula', inlineFormula);
  md.block.ruler.before('fence', 'formula', blockFormula, { alt: ['paragraph'] });
  md.renderer.rules.formula = (tokens, i) => (tokens[i].block ? `<div class="formula" tabindex="0" role="group" aria-label="Formula">${formula(tokens[i].content, true)}</div>\n` : formula(tokens[i].content));
  md.renderer.rules.fence = (tokens, i) => highlight(tokens[i].content.replace(/\n$/, ''), tokens[i].info.trim());
  md.renderer.rules.table_open = () => '<div class="table" tabindex="0" role="group" aria-label="Table"><table>\n';
  md.renderer.rules.table_close = () => '</table></div>\n';
  md.core.ruler.push('anchors', ({ tokens }) => {
    const seen = new Set();
    tokens.forEach((token, i) => {
      if (token.type !== 'heading_open' || token.tag === 'h1') return;
      const id = slugOf(tokens[i + 1].content);
      if (seen.has(id)) throw new Stop(`docs: two headings "${tokens[i + 1].content}" on one page`);
      seen.add(id);
      token.attrSet('id', id);
    });
  });
  md.core.ruler.push('pages', ({ tokens }) => {
    for (const token of tokens.flatMap(({ children }) => children ?? [])) {
      const href = token.type === 'link_open' && token.attrGet('href');
      if (href && !/^\w+:/.test(href)) token.attrSet('href', href.replace(/\.md(?=$|#)/, '.html'));
    }
  });
}
