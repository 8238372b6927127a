// PORT=8080 node server.mjs: the page, and the files of the package below /wet-fur/.
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { page } from './page.mjs';

const folderOfPackage = fileURLToPath(new URL('.', import.meta.resolve('wet-fur')));
const types = { '.js': 'text/javascript', '.mjs': 'text/javascript', '.wasm': 'application/wasm', '.css': 'text/css', '.svg': 'image/svg+xml', '.glb': 'model/gltf-binary' };

async function answer(path) {
  if (path === '/') return [page(), 'text/html; charset=utf-8'];
  if (path === '/page.css') return [await readFile(new URL('page.css', import.meta.url)), 'text/css'];
  const [, name] = /^\/wet-fur\/(.+)$/.exec(path) ?? [];
  const file = name && normalize(name);
  if (!file || file.startsWith('..') || !types[extname(file)]) throw new Error('not found');
  return [await readFile(join(folderOfPackage, file)), types[extname(file)]];
}

const server = createServer(async (request, response) => {
  try {
    const [body, type] = await answer(new URL(request.url, 'http://localhost').pathname);
    response.writeHead(200, { 'Content-Type': type }).end(body);
  } catch {
    response.writeHead(404, { 'Content-Type': 'text/plain' }).end('not found');
  }
});
server.listen(Number(process.env.PORT ?? 8080), '127.0.0.1', () => console.log(`http://localhost:${server.address().port}/`));
