// The program without a window says what a saved scene will be without, and saves it.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { buildFolder } from '../../tools/cmake.mjs';
import { furnished, incomplete, tetrahedron } from '../web/glb.mjs';

const program = join(buildFolder('native-release'), 'wet-fur-render');

/** What it prints to stderr when it saves a scene with these bytes as its model. */
function saving(bytes) {
  const scratch = mkdtempSync(join(tmpdir(), 'wet-fur-'));
  try {
    const model = join(scratch, 'model.gltf'), saved = join(scratch, 'saved.glb');
    writeFileSync(model, bytes);
    const { status, stderr } = spawnSync(program, [model, '--save-scene', saved], { encoding: 'utf8' });
    assert.equal(status, 0, stderr);
    assert.ok(existsSync(saved));
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
