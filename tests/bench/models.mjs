// Meshes that only benches need, as .glb: bunny4, bunny16, bunny64 (the bunny with that many times its triangles) and
// torus142k (Silva et al. 2010, table 1, has a model of 142 thousand triangles), tentacle20k (20 thousand vertices on a skin that waves),
// bear6 and bear1 (tests/fixtures/bear.mjs with six materials and with one).
import { bear } from '../fixtures/bear.mjs';

/** { positions, normals, uvs, indices } of a .glb as the project's own exporter writes it, and back. */
function read(bytes) {
  const jsonLength = bytes.readUInt32LE(12), start = 28 + jsonLength;
  const gltf = JSON.parse(bytes.subarray(20, 20 + jsonLength).toString());
  const array = (index, Type, width) => {
    const { bufferView, count } = gltf.accessors[index], { byteOffset = 0 } = gltf.bufferViews[bufferView];
    const from = bytes.byteOffset + start + byteOffset;
    return Array.from(new Type(bytes.buffer.slice(from, from + count * width * 4)));
  };
  const { attributes, indices } = gltf.meshes[0].primitives[0];
  return {
    positions: array(attributes.POSITION, Float32Array, 3), normals: array(attributes.NORMAL, Float32Array, 3),
    uvs: array(attributes.TEXCOORD_0, Float32Array, 2), indices: array(indices, Uint32Array, 1),
  };
}

function write({ positions, normals, uvs, indices }) {
  const parts = [[positions, Float32Array, 'VEC3', 3], [normals, Float32Array, 'VEC3', 3], [uvs, Float32Array, 'VEC2', 2],
    [indices, Uint32Array, 'SCALAR', 1]];
  const range = (pick) => [0, 1, 2].map((k) => positions.reduce((m, x, i) => (i % 3 === k ? pick(m, x) : m), pick(Infinity, -Infinity) * -1));
  return pack({
    asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, NORMAL: 1, TEXCOORD_0: 2 }, indices: 3 }] }],
    accessors: parts.map(([values, Type, type, width], i) => ({
      bufferView: i, componentType: Type === Float32Array ? 5126 : 5125, count: values.length / width, type,
      ...(i === 0 && { min: range(Math.min), max: range(Math.max) }),
    })),
  }, parts.map(([values, Type]) => Buffer.from(Type.from(values).buffer)));
}

/** A .glb of the JSON and, one a buffer view, what its accessors have. */
function pack(gltf, buffers) {
  let at = 0;
  gltf.bufferViews = buffers.map(({ length }) => ({ buffer: 0, byteOffset: (at += length) - length, byteLength: length }));
  gltf.buffers = [{ byteLength: at }];
  let json = JSON.stringify(gltf);
  json += ' '.repeat(-json.length & 3);
  const head = Buffer.alloc(20), binary = Buffer.alloc(8);
  [0x46546c67, 2, 28 + json.length + at, json.length, 0x4e4f534a].forEach((word, i) => head.writeUInt32LE(word, 4 * i));
  [at, 0x004e4942].forEach((word, i) => binary.writeUInt32LE(word, 4 * i));
  return Buffer.concat([head, Buffer.from(json), binary, ...buffers]);
}

/** Every triangle in four, by the middles of its edges. */
function subdivided({ positions, normals, uvs, indices }) {
  const out = { positions: [...positions], normals: [...normals], uvs: [...uvs], indices: [] };
  const middles = new Map();
  const middle = (a, b) => {
    const key = a < b ? `${a} ${b}` : `${b} ${a}`;
    if (!middles.has(key)) {
      middles.set(key, out.positions.length / 3);
      for (const [name, width] of [['positions', 3], ['normals', 3], ['uvs', 2]])
        for (let k = 0; k < width; ++k) out[name].push((out[name][width * a + k] + out[name][width * b + k]) / 2);
    }
    return middles.get(key);
  };
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = indices.slice(i, i + 3), ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    out.indices.push(a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca);
  }
  return out;
}

function torus(around, across) {
  const out = { positions: [], normals: [], uvs: [], indices: [] };
  for (let i = 0; i <= around; ++i)
    for (let j = 0; j <= across; ++j) {
      // The last ring is the first one to the bit, so that the seam closes.
      const u = (2 * Math.PI * (i % around)) / around, v = (2 * Math.PI * (j % across)) / across, r = 0.7 + 0.3 * Math.cos(v);
      out.positions.push(r * Math.sin(u), 0.3 * Math.sin(v), r * Math.cos(u));
      out.normals.push(Math.cos(v) * Math.sin(u), Math.sin(v), Math.cos(v) * Math.cos(u));
      out.uvs.push(i / around, j / across);
      const a = i * (across + 1) + j, b = a + across + 1;
      if (i < around && j < across) out.indices.push(a, b, a + 1, b, b + 1, a + 1);
    }
  return out;
}

/** A tube along y on eight joints that wave it for two seconds, as .glb: (along + 1) * (around + 1) vertices. */
export function tentacle(around, along) {
  const joints = 8, positions = [], normals = [], hanging = [], weights = [], indices = [];
  for (let j = 0; j <= along; ++j)
    for (let i = 0; i <= around; ++i) {
      const a = (2 * Math.PI * (i % around)) / around, y = j / along;
      const radius = 0.14 * Math.sqrt(1 - 0.9 * y) * (j === 0 ? 0.02 : 1);
      positions.push(radius * Math.sin(a), y, radius * Math.cos(a));
      normals.push(Math.sin(a), 0.1, Math.cos(a));
      const at = y * (joints - 1), first = Math.min(Math.floor(at), joints - 2);
      hanging.push(first, first + 1, 0, 0);
      weights.push(1 - (at - first), at - first, 0, 0);
      const v = j * (around + 1) + i, w = v + around + 1;
      if (i < around && j < along) indices.push(v, v + 1, w, v + 1, w + 1, w);
    }
  const times = [], turns = [];
  for (let k = 0; k <= 32; ++k) {
    times.push(k / 16);
    const half = 0.22 * Math.sin((2 * Math.PI * k) / 32), side = 0.1 * Math.cos((2 * Math.PI * k) / 32);
    turns.push(side, 0, Math.sin(half), Math.sqrt(1 - side * side - Math.sin(half) ** 2));
  }
  const binds = [];
  for (let j = 0; j < joints; ++j) binds.push(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -j / (joints - 1), 0, 1);
  const parts = [[positions, Float32Array, 'VEC3', 3], [normals, Float32Array, 'VEC3', 3], [hanging, Uint8Array, 'VEC4', 4],
    [weights, Float32Array, 'VEC4', 4], [indices, Uint32Array, 'SCALAR', 1], [binds, Float32Array, 'MAT4', 16],
    [times, Float32Array, 'SCALAR', 1], [turns, Float32Array, 'VEC4', 4]];
  const types = new Map([[Float32Array, 5126], [Uint8Array, 5121], [Uint32Array, 5125]]);
  const nodes = [{ mesh: 0, skin: 0 }];
  for (let j = 0; j < joints; ++j) nodes.push({ translation: [0, j ? 1 / (joints - 1) : 0, 0], ...(j + 1 < joints && { children: [j + 2] }) });
  return pack({
    asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0, 1] }], nodes,
    meshes: [{ primitives: [{ attributes: { POSITION: 0, NORMAL: 1, JOINTS_0: 2, WEIGHTS_0: 3 }, indices: 4 }] }],
    skins: [{ inverseBindMatrices: 5, joints: nodes.slice(1).map((_, j) => j + 1) }],
    animations: [{ name: 'wave', samplers: [{ input: 6, output: 7 }],
      channels: nodes.slice(2).map((_, j) => ({ sampler: 0, target: { path: 'rotation', node: j + 2 } })) }],
    accessors: parts.map(([values, Type, type, width], i) => ({ bufferView: i, componentType: types.get(Type), count: values.length / width, type })),
  }, parts.map(([values, Type]) => Buffer.from(Type.from(values).buffer)));
}

/** undefined when there is none of that name. `bunny`: the bytes of bunny.glb. */
export function benchModel(name, bunny) {
  if (name === 'tentacle20k') return tentacle(125, 159);
  if (name === 'bear6') return bear({ apart: true });
  if (name === 'bear1') return bear({ apart: true, one: true });
  if (name === 'torus142k') return write(torus(377, 188));
  const times = { bunny4: 1, bunny16: 2, bunny64: 3 }[name];
  if (!times) return undefined;
  let mesh = read(bunny);
  for (let i = 0; i < times; ++i) mesh = subdivided(mesh);
  return write(mesh);
}
