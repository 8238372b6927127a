// The bench pages, the built site beside them and the benches' own models (models.mjs). As a program it serves them
// until it is stopped, for benches that live elsewhere: node tests/bench/server.mjs [port]
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { basename, dirname, extname, join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { benchModel } from './models.mjs';

const here = dirname(fileURLToPath(import.meta.url)), dist = join(here, '../../dist');
const types = { '.html': 'text/html', '.js': 'text/javascript', '.mjs': 'text/javascript', '.wasm': 'application/wasm' };
const made = new Map();

async function fileAt(path) {
  if (path.startsWith('/bench/')) return readFile(join(here, path.slice(7)));
  if (path.startsWith('/models/') && !made.has(path))
    made.set(path, benchModel(basename(path, '.glb'), await readFile(join(dist, 'models/plain-bunny.glb'))));
  return made.get(path) ?? readFile(join(dist, path));
}

/** Its origin, and how to stop it. */
export async function serve(port = 0) {
  const server = createServer(async (request, response) => {
    const path = normalize(decodeURIComponent(request.url.split('?')[0]));
    try {
      const body = await fileAt(path);
      response.writeHead(200, { 'content-type': types[extname(path)] ?? 'application/octet-stream' }).end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((listening) => server.listen(port, '127.0.0.1', listening));
  return { origin: `http://127.0.0.1:${server.address().port}`, close: () => server.close() };
}

if (process.argv[1] === fileURLToPath(import.meta.url)) console.log((await serve(Number(process.argv[2] ?? 0))).origin);
