// The heads with long hair, at rest: strands as the program without a window writes them.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { models } from '../../tools/build.mjs';
import { buildFolder } from '../../tools/cmake.mjs';

const program = join(buildFolder('native-release'), 'wet-fur-render');
const threes = (bytes) => {
  const numbers = new Float32Array(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
  return Array.from({ length: numbers.length / 3 }, (_, i) => [...numbers.subarray(3 * i, 3 * i + 3)]);
};

/** The model's vertices, and the spheres that hair does not enter. */
function headOf(name) {
  const file = readFileSync(join(models, `${name}.glb`)), jsonLength = file.readUInt32LE(12);
  const json = JSON.parse(file.subarray(20, 20 + jsonLength)), binary = file.subarray(28 + jsonLength);
  const view = (i) => ((v) => binary.subarray(v.byteOffset ?? 0, (v.byteOffset ?? 0) + v.byteLength))(json.bufferViews[i]);
  const bodies = view(json.extensions.WETFUR_fur.hair.bodies);
  return {
    vertices: threes(view(json.accessors[json.meshes[0].primitives[0].attributes.POSITION].bufferView)),
    spheres: Array.from({ length: bodies.length / 28 }, (_, i) => [0, 4, 8, 24].map((at) => bodies.readFloatLE(28 * i + at))),
  };
}

/** Middle lines of the wisps of the scalp that was made last, each from root to tip. */
function wispsOf(name) {
  const scratch = mkdtempSync(join(tmpdir(), 'wet-fur-'));
  try {
    const file = join(scratch, 'out.hair');
    const { status, stderr } = spawnSync(program, [name, '--hair-value', 'strands=1', '--hair-value', 'wisps=400', '--save-hair', file], { encoding: 'utf8' });
    assert.equal(status, 0, stderr);
    assert.equal(stderr, '');
    const bytes = readFileSync(file), count = bytes.readUInt32LE(4), each = bytes.readUInt32LE(16) + 1;
    assert.equal(bytes.readUInt32LE(12) & 1, 0, 'all have as many points');
    // Files have z up.
    const points = threes(bytes.subarray(128, 128 + 12 * count * each)).map(([x, y, z]) => [x, z, -y]);
    return Array.from({ length: count }, (_, i) => points.slice(each * i, each * (i + 1)));
  } finally {
    rmSync(scratch, { recursive: true });
  }
}

const distance = (a, b) => Math.hypot(...a.map((x, k) => x - b[k]));

for (const name of ['hair-short', 'hair-shoulder', 'hair-pony']) {
  test(`${name}: hair stays out of skull, face, neck and shoulders at rest`, () => {
    const { spheres } = headOf(name), wisps = wispsOf(name);
    assert.equal(spheres.length, 29);
    assert.ok(wisps.length >= 100);
    for (const wisp of wisps)
      // The first nodes stand in the skin, and a wisp runs straight between three guides.
      for (const point of wisp.slice(Math.ceil(0.3 * wisp.length)))
        for (const [x, y, z, radius] of spheres) assert.ok(distance(point, [x, y, z]) > radius - 0.04, `${point} in ${[x, y, z, radius]}`);
    if (name === 'hair-pony') return;
    for (const vertex of headOf(name).vertices.filter(([, y, z]) => y > 0.75 && z < 0.1))
      assert.ok(Math.min(...wisps.map(([root]) => distance(root, vertex))) < 0.14, `no hair grows near ${vertex}`);
  });
}
