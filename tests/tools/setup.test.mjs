import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { sourceEntries } from '../../tools/imgui.mjs';
import { fromCopyright } from '../../tools/notices.mjs';
import { root } from '../../tools/process.mjs';

test('source entries keep addresses, keys and options, and only the release\'s own suites', () => {
  const { stanzas, lines } = sourceEntries([
    ['debian.sources', 'Types: deb\n# a remark\nURIs: http://one.example/debian\nSuites: bookworm bookworm-updates\nComponents: main\n' +
      'Signed-By: /keys/debian.gpg\n\nTypes: deb\nURIs: http://two.example/security\nSuites: bookworm-security\nComponents: main\n\n' +
      'Types: deb\nEnabled: no\nURIs: http://off.example\nSuites: bookworm\nComponents: main\n'],
    ['other.list', '# deb http://no.example x main\ndeb [arch=amd64 signed-by=/keys/a.gpg] http://three.example/debian bookworm main contrib # why\n' +
      'deb http://vendor.example/apt cloud main\n'],
  ], 'bookworm');
  assert.equal(stanzas.length, 1);
  assert.match(stanzas[0], /^Types: deb-src$/m);
  assert.match(stanzas[0], /^URIs: http:\/\/one\.example\/debian$/m);
  assert.match(stanzas[0], /^Signed-By: \/keys\/debian\.gpg$/m);
  assert.deepEqual(lines, ['deb-src [ signed-by=/keys/a.gpg] http://three.example/debian bookworm main contrib']);
});

test('an apt source with an embedded key keeps it', () => {
  const { stanzas } = sourceEntries([['a.sources', 'Types: deb deb-src\nURIs: http://one.example\nSuites: trixie\nComponents: main\nSigned-By:\n -----BEGIN-----\n .\n abc\n']], 'trixie');
  assert.match(stanzas[0], /Signed-By:\n -----BEGIN-----\n \.\n abc$/);
});

test('without apt a command names what is missing and stops with one line', (t) => {
  const empty = mkdtempSync(join(tmpdir(), 'wet-fur-path-'));
  t.after(() => rmSync(empty, { recursive: true }));
  const script = `
    import { setUp } from ${JSON.stringify(join(root, 'tools/setup.mjs'))};
    import { command } from ${JSON.stringify(join(root, 'tools/process.mjs'))};
    await command(() => setUp({ packages: [['cmake', 'ninja-build']] }));`;
  const { status, stderr } = spawnSync(process.execPath, ['--input-type=module', '-e', script], { encoding: 'utf8', env: { PATH: empty } });
  assert.equal(status, 1);
  assert.match(stderr, /^wet-fur: missing here: cmake, ninja-build .*no apt on this system.*\n$/);
});

test('a licence is read out of a Debian copyright file with the copyrights of its stanza', () => {
  const text = 'Format: x\n\nFiles: debian/*\nCopyright: 1 Packager\nLicense: GPL\n\nFiles: *\nCopyright: 2 One\n 3 Two\nLicense: Expat\n\n' +
    'License: Expat\n Permission is granted.\n .\n As is.\n';
  assert.equal(fromCopyright(text), 'Copyright 2 One\nCopyright 3 Two\n\nPermission is granted.\n\nAs is.');
  assert.throws(() => fromCopyright(text, 'none/*'), /no stanza/);
});
