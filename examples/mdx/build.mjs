// What Docusaurus and others do with a page: MDX makes a component of it, React renders that to HTML on the server.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { evaluate } from '@mdx-js/mdx';
import { createElement } from 'react';
import { renderToString } from 'react-dom/server';
import * as runtime from 'react/jsx-runtime';
import { build } from 'vite';

const { default: Page } = await evaluate(readFileSync('page.mdx', 'utf8'), runtime);

mkdirSync('cache', { recursive: true });
writeFileSync('cache/index.html', `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>A furry figure in MDX</title>
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="icon" href="data:,">
<link rel="stylesheet" href="../page.css">
<script type="module" src="../client.js"></script>
</head>
<body>${renderToString(createElement(Page))}</body>
</html>
`);
await build({ root: 'cache', base: './', logLevel: 'warn', optimizeDeps: { exclude: ['wet-fur'] }, build: { outDir: '../dist', emptyOutDir: true } });
