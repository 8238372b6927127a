import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { request } from 'node:http';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { serve } from '../../tools/serve.mjs';

let scratch, server;

before(async () => {
  scratch = mkdtempSync(join(tmpdir(), 'wet fur serve '));
  mkdirSync(join(scratch, 'site/sub'), { recursive: true });
  writeFileSync(join(scratch, 'secret.txt'), 'secret');
  writeFileSync(join(scratch, 'site/index.html'), '<p>hello');
  writeFileSync(join(scratch, 'site/sub/index.html'), '<p>sub');
  writeFileSync(join(scratch, 'site/a b.wasm'), 'wasm');
  writeFileSync(join(scratch, 'site/bunny.glb'), 'glb');
  symlinkSync(join(scratch, 'secret.txt'), join(scratch, 'site/link.txt'));
  server = await serve({ folder: join(scratch, 'site') });
});
after(async () => {
  await server.close();
  rmSync(scratch, { recursive: true });
});

// Node's fetch tidies "..", so the request is made by hand.
const get = (path, method = 'GET') => new Promise((done, fail) => {
  request({ port: server.port, host: '127.0.0.1', path, method }, (response) => {
    let body = '';
    response.on('data', (part) => (body += part)).on('end', () => done({ status: response.statusCode, headers: response.headers, body }));
  }).on('error', fail).end();
});

test('files come with their type, the policy and nothing to cache', async () => {
  const page = await get('/');
  assert.equal(page.status, 200);
  assert.equal(page.body, '<p>hello');
  assert.match(page.headers['content-type'], /^text\/html/);
  assert.equal(page.headers['cache-control'], 'no-store');
  assert.equal(page.headers['content-security-policy'], "script-src 'self' 'wasm-unsafe-eval'; require-trusted-types-for 'script'");
  assert.equal((await get('/a%20b.wasm?x=1')).headers['content-type'], 'application/wasm');
  assert.equal((await get('/bunny.glb')).headers['content-type'], 'model/gltf-binary');
});

test('nothing outside the folder is given away', async () => {
  for (const path of ['/../secret.txt', '/%2e%2e/secret.txt', '/sub/../../secret.txt', '/..%2fsecret.txt', '/%2e%2e%5csecret.txt', '/link.txt', '//secret.txt']) {
    const { status, body } = await get(path);
    assert.equal(status, 404, path);
    assert.doesNotMatch(body, /secret/);
  }
});

test('what cannot be is refused without a crash', async () => {
  assert.equal((await get('/nothing')).status, 404);
  assert.equal((await get('/%zz')).status, 404);
  assert.equal((await get('/a%00b')).status, 404);
  assert.equal((await get('/', 'POST')).status, 405);
  assert.equal((await get('/', 'HEAD')).body, '');
});

test('a folder without its slash is sent on to the one with it, on this host', async () => {
  const { status, headers } = await get('/sub');
  assert.equal(status, 308);
  assert.equal(headers.location, '/sub/');
  assert.equal((await get('/sub/')).body, '<p>sub');
});

test('a taken port is refused, or passed over when the next one will do', async () => {
  await assert.rejects(serve({ folder: scratch, port: server.port }), /PORT=/);
  const next = await serve({ folder: scratch, port: server.port, tryNext: true });
  assert.ok(next.port > server.port);
  await next.close();
});
