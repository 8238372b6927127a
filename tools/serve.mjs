// A static server for dist/: node tools/serve.mjs [folder]. PORT names the port (default 8080, then the
// next free one), HOST the address to listen at (default 127.0.0.1). Sends the strictest policy that the
// package promises to run under, and nothing for caches to keep.
import { createReadStream, statSync } from 'node:fs';
import { realpath, stat } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, resolve, sep } from 'node:path';
import { pathToFileURL } from 'node:url';
import { Stop, command, root, say } from './process.mjs';
import { endings, readTables } from './tables.mjs';

const types = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript; charset=utf-8',
  '.mjs': 'text/javascript; charset=utf-8',
  '.css': 'text/css; charset=utf-8',
  '.json': 'application/json; charset=utf-8',
  '.txt': 'text/plain; charset=utf-8',
  '.md': 'text/markdown; charset=utf-8',
  '.ts': 'text/plain; charset=utf-8',
  '.wasm': 'application/wasm',
  ...Object.fromEntries(endings(readTables()).map(({ ending, mimeType }) => [ending, mimeType])),
  '.svg': 'image/svg+xml',
  '.ico': 'image/x-icon',
};

const headers = {
  'Cache-Control': 'no-store',
  'Content-Security-Policy': "script-src 'self' 'wasm-unsafe-eval'; require-trusted-types-for 'script'",
  'X-Content-Type-Options': 'nosniff',
};

/** The file that a request's path names inside `folder`, or undefined when it leads out of it or nowhere. */
async function fileFor(folder, url) {
  let path;
  try {
    path = decodeURIComponent(url.split(/[?#]/)[0]);
  } catch {
    return undefined;
  }
  if (path.includes('\0') || path.includes('\\')) return undefined;
  try {
    const file = join(folder, path);
    const found = await realpath((await stat(file)).isDirectory() ? join(file, 'index.html') : file);
    if (!found.startsWith(folder + sep)) return undefined;
    const { size } = await stat(found);
    return { path: found, size };
  } catch {
    return undefined;
  }
}

/**
 * Serves `folder`; gives { url, port, close() } once it listens. Port 0 is any free one;
 * `tryNext` moves on from a port that is taken.
 */
export async function serve({ folder, port = 0, host = '127.0.0.1', tryNext = false, extraHeaders = {} }) {
  const inside = await realpath(resolve(folder));
  const server = createServer(async (request, response) => {
    const plain = { ...headers, ...extraHeaders, 'Content-Type': 'text/plain; charset=utf-8' };
    if (request.method !== 'GET' && request.method !== 'HEAD') {
      response.writeHead(405, { ...plain, Allow: 'GET, HEAD' }).end('only GET and HEAD\n');
      return;
    }
    const path = request.url.split(/[?#]/)[0];
    const file = await fileFor(inside, request.url);
    if (!file) {
      response.writeHead(404, plain).end('not found\n');
      return;
    }
    // Without the slash the page's relative addresses would miss its folder.
    if (file.path.endsWith(`${sep}index.html`) && !path.endsWith('/') && !path.endsWith('.html')) {
      response.writeHead(308, { ...plain, Location: `${path.replace(/^\/+/, '/')}/` }).end();
      return;
    }
    const type = types[extname(file.path).toLowerCase()] ?? 'application/octet-stream';
    response.writeHead(200, { ...headers, ...extraHeaders, 'Content-Type': type, 'Content-Length': file.size });
    if (request.method === 'HEAD') response.end();
    else createReadStream(file.path).on('error', () => response.destroy()).pipe(response);
  });
  const bound = await listen(server, port, host, tryNext ? 50 : 1);
  const shown = host === '127.0.0.1' || host === '0.0.0.0' ? 'localhost' : host.includes(':') ? `[${host}]` : host;
  const close = () => new Promise((done) => {
    server.close(done);
    server.closeAllConnections();
  });
  return { url: `http://${shown}:${bound}/`, port: bound, close };
}

async function listen(server, port, host, tries) {
  for (let attempt = 0; ; attempt++) {
    try {
      await new Promise((done, fail) => {
        server.once('error', fail);
        server.listen(port + attempt, host, () => {
          server.off('error', fail);
          done();
        });
      });
      return server.address().port;
    } catch (error) {
      if (error.code !== 'EADDRINUSE' && error.code !== 'EACCES') throw error;
      if (attempt + 1 >= tries) throw new Stop(`port ${port + attempt} cannot be had (${error.code}); name another with PORT=`);
    }
  }
}

/** Serves a folder as the environment says (PORT, HOST) and prints the address. */
export async function serveHere(folder) {
  const given = process.env.PORT;
  if (given !== undefined && !/^\d{1,5}$/.test(given)) throw new Stop(`PORT=${given} is no port number`);
  const { url } = await serve({ folder, port: Number(given ?? 8080), host: process.env.HOST ?? '127.0.0.1', tryNext: given === undefined });
  say(`serving at ${url}`);
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  await command(async () => {
    const folder = process.argv[2] ?? join(root, 'dist');
    if (!statSync(folder, { throwIfNoEntry: false })?.isDirectory()) throw new Stop(`no folder ${folder}: npm run build makes dist/`);
    await serveHere(folder);
  });
}
