// Models made by hand: a good triangle, and every way to be wrong that the page must survive.

const bufferOf = (...arrays) => Buffer.concat(arrays.map((array) => Buffer.from(array.buffer)));

export function glb(json, binary = Buffer.alloc(0), { jsonLength, length } = {}) {
  const pad = (bytes, fill) => Buffer.concat([bytes, Buffer.alloc((4 - (bytes.length % 4)) % 4, fill)]);
  const text = pad(Buffer.from(JSON.stringify(json)), 0x20);
  const data = pad(binary, 0);
  const header = Buffer.alloc(12);
  header.write('glTF', 0);
  header.writeUInt32LE(2, 4);
  header.writeUInt32LE(length ?? 12 + 8 + text.length + 8 + data.length, 8);
  const chunk = (size, type) => {
    const bytes = Buffer.alloc(8);
    bytes.writeUInt32LE(size, 0);
    bytes.writeUInt32LE(type, 4);
    return bytes;
  };
  return Buffer.concat([header, chunk(jsonLength ?? text.length, 0x4e4f534a), text, chunk(data.length, 0x004e4942), data]);
}

/** A tetrahedron; `change(json)` spoils it. */
export function tetrahedron({ change = () => {}, positions, indices, uri } = {}) {
  const p = new Float32Array(positions ?? [0, 1, 0, -1, -1, 1, 1, -1, 1, 0, -1, -1]);
  const i = new Uint16Array(indices ?? [0, 1, 2, 0, 2, 3, 0, 3, 1, 1, 3, 2]);
  const binary = bufferOf(p, i);
  const json = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: p.length / 3, type: 'VEC3', min: [-1, -1, -1], max: [1, 1, 1] },
      { bufferView: 1, componentType: 5123, count: i.length, type: 'SCALAR' },
    ],
    bufferViews: [
      { buffer: 0, byteOffset: 0, byteLength: p.byteLength },
      { buffer: 0, byteOffset: p.byteLength, byteLength: i.byteLength },
    ],
    buffers: [{ byteLength: binary.length, ...(uri ? { uri } : {}) }],
  };
  change(json, binary);
  return { json, binary, glb: () => glb(json, binary) };
}

/** A .gltf whose image did not come along. */
export const incomplete = (() => {
  const { json, binary } = tetrahedron({ change: (made) => { made.images = [{ uri: 'gone.png' }]; } });
  json.buffers[0].uri = `data:;base64,${binary.toString('base64')}`;
  return Buffer.from(JSON.stringify(json));
})();

/** A model with much that is not fur. */
export const furnished = tetrahedron({
  change: (json) => {
    json.materials = [{}, { extensions: { KHR_materials_clearcoat: {} } }];
    json.meshes[0].primitives[0].material = 0;
    json.nodes.push({ camera: 0, extras: { whole: 1, part: 0.5, none: null } });
    json.scenes[0].nodes.push(1);
    json.cameras = [{ type: 'perspective', name: 'front', perspective: { yfov: 1, znear: 1 } }];
    json.skins = [{ joints: [1] }];
    json.animations = [{ name: 'walk', channels: [{ sampler: 0, target: { node: 1, path: 'translation' } }], samplers: [{ input: 2, output: 3 }] }];
    const moving = bufferOf(new Float32Array([0, 1, 0, 0, 0, 0, 1, 0]));
    json.accessors.push({ bufferView: 2, componentType: 5126, count: 2, type: 'SCALAR', min: [0], max: [1] },
      { bufferView: 2, byteOffset: 8, componentType: 5126, count: 2, type: 'VEC3' });
    json.bufferViews.push({ buffer: 1, byteLength: moving.length });
    json.buffers.push({ byteLength: moving.length, uri: `data:application/octet-stream;base64,${moving.toString('base64')}` });
    json.extensionsUsed = ['KHR_lights_punctual', 'KHR_materials_clearcoat', 'EXT_unheard_of'];
    json.extensions = { KHR_lights_punctual: { lights: [{ type: 'point' }] }, EXT_unheard_of: { deep: [1, 1.5] } };
    json.extras = { by: 'somebody' };
  },
}).glb();

/** A PNG that says it is `side` pixels a side and ends after its header. */
export function pngHeader(side) {
  const bytes = Buffer.alloc(33);
  bytes.set([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0, 0, 0, 13]);
  bytes.write('IHDR', 12);
  bytes.writeUInt32BE(side, 16);
  bytes.writeUInt32BE(side, 20);
  bytes.set([8, 6, 0, 0, 0], 24);
  return bytes;
}

/** A model with that PNG as its colour. */
export function withImage(png) {
  const image = `data:image/png;base64,${png.toString('base64')}`;
  return tetrahedron({
    change: (json) => {
      json.images = [{ uri: image }];
      json.textures = [{ source: 0 }];
      json.materials = [{ pbrMetallicRoughness: { baseColorTexture: { index: 0 } } }];
      json.meshes[0].primitives[0].material = 0;
    },
  }).glb();
}

/** name: bytes, for every bad input that must leave the old scene. */
export const badModels = {
  'a truncated GLB': tetrahedron().glb().subarray(0, 150),
  'a wrong magic': Buffer.concat([Buffer.from('glTG'), tetrahedron().glb().subarray(4)]),
  'a JSON chunk that claims 100 MB': glb({}, Buffer.alloc(0), { jsonLength: 100 << 20, length: (100 << 20) + 20 }),
  'an accessor past its buffer': tetrahedron({ change: (json) => { json.accessors[0].count = 4000; } }).glb(),
  'an index past the vertex count': tetrahedron({ indices: [0, 1, 2, 0, 2, 900] }).glb(),
  'no triangles': tetrahedron({ change: (json) => { json.meshes[0].primitives[0].mode = 0; } }).glb(),
  'NaN positions': tetrahedron({ positions: [NaN, 1, 0, -1, -1, 1, 1, -1, 1, 0, -1, -1] }).glb(),
  'a missing external buffer': tetrahedron({ uri: 'away.bin' }).glb(),
};
export const hugeImage = withImage(pngHeader(20000));
