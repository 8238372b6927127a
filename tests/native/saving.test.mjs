// The program without a window says what a saved scene will be without, and saves it.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import validator from 'gltf-validator';
import { buildFolder } from '../../tools/cmake.mjs';
import { furnished, incomplete, tetrahedron } from '../web/glb.mjs';

const program = join(buildFolder('native-release'), 'wet-fur-render');

/** What it prints to stderr when it saves a scene with these bytes as its model; `onSaved` gets the path of what is saved. */
function saving(bytes, more = [], onSaved = () => {}) {
  const scratch = mkdtempSync(join(tmpdir(), 'wet-fur-'));
  try {
    const model = join(scratch, 'model.gltf'), saved = join(scratch, 'saved.glb');
    writeFileSync(model, bytes);
    const { status, stderr } = spawnSync(program, [model, '--save-scene', saved, ...more], { encoding: 'utf8' });
    assert.equal(status, 0, stderr);
    assert.ok(existsSync(saved));
    onSaved(readFileSync(saved));
    return stderr.replaceAll(saved, 'saved.glb').trim().split('\n').filter(Boolean);
  } finally {
    rmSync(scratch, { recursive: true });
  }
}

test('what is left out is told, and the scene is saved', () => {
  assert.deepEqual(saving(incomplete), ['warning: saved.glb will be without the image file "gone.png", which stays beside it']);
});

test('what is saved whole is saved in silence', () => {
  for (const model of [tetrahedron().glb(), furnished]) assert.deepEqual(saving(model), []);
});

test('a document with fur, hair and water on it is sound glTF, once and when it is saved again', async () => {
  const files = [], keep = (bytes) => files.push(bytes);
  saving(furnished, ['--groom', 'length,0.5', '--hair', 'addScalp', '--hair', 'cover,1', '--hair', 'plant,20', '--wetness', '0.7', '--rain', '1', '--time', '0.2'], keep);
  saving(files[0], [], keep);
  const serious = async (bytes) => (await validator.validateBytes(new Uint8Array(bytes))).issues.messages.filter(({ severity }) => severity < 2);
  const before = await serious(furnished);
  assert.deepEqual(before.map(({ code }) => code), ['DATA_URI_GLB'], 'a warning of the file itself');
  for (const bytes of files) assert.deepEqual(await serious(bytes), before);
  assert.ok(Math.abs(files[1].length - files[0].length) < 0.02 * files[0].length, `${files.map(({ length }) => length)}`);
});
