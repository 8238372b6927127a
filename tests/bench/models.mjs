// Meshes that only benches need, as .glb: bunny4, bunny16, bunny64 (the bunny with that many times its triangles) and
// torus142k (Silva et al. 2010, table 1, has a model of 142 thousand triangles).

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
  const buffers = parts.map(([values, Type]) => Buffer.from(Type.from(values).buffer));
  const range = (pick) => [0, 1, 2].map((k) => positions.reduce((m, x, i) => (i % 3 === k ? pick(m, x) : m), pick(Infinity, -Infinity) * -1));
  let at = 0;
  const gltf = {
    asset: { version: '2.0' }, scene: 0, scenes: [{ nodes: [0] }], nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, NORMAL: 1, TEXCOORD_0: 2 }, indices: 3 }] }],
    accessors: parts.map(([values, Type, type, width], i) => ({
      bufferView: i, componentType: Type === Float32Array ? 5126 : 5125, count: values.length / width, type,
      ...(i === 0 && { min: range(Math.min), max: range(Math.max) }),
    })),
    bufferViews: buffers.map(({ length }) => ({ buffer: 0, byteOffset: (at += length) - length, byteLength: length })),
    buffers: [{ byteLength: at }],
  };
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

/** undefined when there is none of that name. `bunny`: the bytes of bunny.glb. */
export function benchModel(name, bunny) {
  if (name === 'torus142k') return write(torus(377, 188));
  const times = { bunny4: 1, bunny16: 2, bunny64: 3 }[name];
  if (!times) return undefined;
  let mesh = read(bunny);
  for (let i = 0; i < times; ++i) mesh = subdivided(mesh);
  return write(mesh);
}
