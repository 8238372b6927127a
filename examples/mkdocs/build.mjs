// What MkDocs does with a page, in JavaScript: Markdown with HTML in it, in a page with the scripts that mkdocs.yml names.
import { cpSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { fileURLToPath } from 'node:url';
import markdownIt from 'markdown-it';

const scripts = [...readFileSync('mkdocs.yml', 'utf8').matchAll(/path: (\S+\.js)/g)].map(([, path]) => path);
mkdirSync('site', { recursive: true });
writeFileSync('site/index.html', `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<title>Furry figures</title>
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="icon" href="wet-fur/icon.svg">
<link rel="stylesheet" href="page.css">
${scripts.map((path) => `<script type="module" src="${path}"></script>`).join('\n')}
</head>
<body>${markdownIt({ html: true }).render(readFileSync('docs/index.md', 'utf8'))}</body>
</html>
`);
cpSync('docs/page.css', 'site/page.css');
cpSync(dirname(fileURLToPath(import.meta.resolve('wet-fur'))), 'site/wet-fur', { recursive: true });
