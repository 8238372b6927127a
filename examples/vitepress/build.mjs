// What VitePress does with a page, by the packages that it does it with: markdown-it makes a template of it, Vue renders that to HTML, Vite
// builds the page.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import markdownIt from 'markdown-it';
import { build } from 'vite';
import { createSSRApp } from 'vue';
import { renderToString } from 'vue/server-renderer';
import config from './.vitepress/config.mjs';

const template = markdownIt({ html: true }).render(readFileSync('index.md', 'utf8'));
const app = createSSRApp({ template });
Object.assign(app.config.compilerOptions, config.vue.template.compilerOptions);
const html = await renderToString(app);

mkdirSync('.vitepress/cache', { recursive: true });
writeFileSync('.vitepress/cache/index.html', `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>${config.title}</title>
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="icon" href="data:,">
<link rel="stylesheet" href="../../page.css">
<script type="module" src="../theme/index.js"></script>
</head>
<body>${html}</body>
</html>
`);
await build({ ...config.vite, root: '.vitepress/cache', base: './', logLevel: 'warn', build: { outDir: '../../dist', emptyOutDir: true } });
