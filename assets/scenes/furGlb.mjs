// A .glb with the extension WETFUR_fur (src/scene/WETFUR_fur.schema.json).
import { createRequire } from 'node:module';

// Not at the top: commands that install it import this file first.
const pngjs = () => createRequire(import.meta.url)('pngjs');

/** PackBits as src/scene/PackBits.h has it. */
export function packBits(bytes) {
  const out = [];
  const runAt = (i) => {
    let end = i + 1;
    while (end < bytes.length && end - i < 128 && bytes[end] === bytes[i]) ++end;
    return end - i;
  };
  for (let i = 0; i < bytes.length;) {
    const run = runAt(i);
    if (run > 1) {
      out.push(257 - run, bytes[i]);
      i += run;
      continue;
    }
    let end = i + 1;
    while (end < bytes.length && end - i < 128 && runAt(end) < 3) ++end;
    out.push(end - i - 1, ...bytes.subarray(i, end));
    i = end;
  }
  return Buffer.from(out);
}

const texels = (size, placeAt, at) => Array.from({ length: size * size }, (_, i) =>
  at(placeAt((i % size + 0.5) / size, (Math.floor(i / size) + 0.5) / size)));
const byte = (share) => Math.max(0, Math.min(255, Math.round(255 * share)));

/** Four planes of bytes, as the schema has them, of what `at(place)` gives: four numbers, 0..1 each. */
function planes(size, placeAt, at) {
  const all = texels(size, placeAt, (place) => at(place).map(byte));
  return packBits(Buffer.concat([0, 1, 2, 3].map((plane) => Buffer.from(all.map((texel) => texel[plane])))));
}
const groomOf = ({ length = 1, types = [] }) => [length, types[0] ?? 0, types[1] ?? 0, types[2] ?? 0];
const shapeOf = ({ curl = 0, frizz = 0, locks = 0 }) => [curl, frizz, locks, Math.max(curl, frizz, locks)];

/** A PNG of what `colour(place)` gives: [r, g, b] in sRGB, 0..1 each. */
function colourPicture(size, placeAt, colour) {
  const { PNG } = pngjs(), png = new PNG({ width: size, height: size });
  texels(size, placeAt, (place) => [...colour(place).map(byte), 255]).forEach((texel, i) => png.data.set(texel, 4 * i));
  return PNG.sync.write(png, { colorType: 2, deflateLevel: 9 });
}

const bufferOf = (array) => Buffer.from(array.buffer, array.byteOffset, array.byteLength);
const padded = (bytes, fill) => Buffer.concat([bytes, Buffer.alloc((4 - (bytes.length % 4)) % 4, fill)]);

function extentsOf(positions) {
  const axes = [0, 1, 2].map((k) => positions.filter((_, i) => i % 3 === k));
  return { min: axes.map((axis) => Math.min(...axis)), max: axes.map((axis) => Math.max(...axis)) };
}

/**
 * @param {{ mesh, placeAt }} body as meshOf() gives it
 * @param {{ name: string, state: object, groom?: Function, shape?: Function, colour?: Function, mapSize?: number }} scene
 *   `groom(place)` gives { length, types: [2nd, 3rd, 4th] }, `shape(place)` { curl, frizz, locks }, 0..1 each
 */
export function furGlb({ mesh, placeAt }, { name, state, groom, shape, colour, mapSize = 256 }) {
  const views = [], parts = [];
  let length = 0;
  const view = (bytes, extra = {}) => {
    views.push({ buffer: 0, byteOffset: length, byteLength: bytes.length, ...extra });
    parts.push(padded(bytes, 0));
    length += parts.at(-1).length;
    return views.length - 1;
  };
  const accessors = [];
  const accessor = (array, type, components, target, extra = {}) => {
    const componentType = array instanceof Float32Array ? 5126 : 5123;
    accessors.push({ bufferView: view(bufferOf(array), { target }), componentType, count: array.length / components, type, ...extra });
    return accessors.length - 1;
  };
  const positions = new Float32Array(mesh.positions);
  const attributes = {
    POSITION: accessor(positions, 'VEC3', 3, 34962, extentsOf(positions)),
    NORMAL: accessor(new Float32Array(mesh.normals), 'VEC3', 3, 34962),
    TEXCOORD_0: accessor(new Float32Array(mesh.uv), 'VEC2', 2, 34962),
  };
  const indices = accessor(new Uint16Array(mesh.indices), 'SCALAR', 1, 34963);

  const fur = { version: 1, state: { version: 1, ...state } };
  const map = (at) => view(planes(mapSize, placeAt, at));
  if (groom || shape) fur.groom = { size: mapSize, bufferView: map((place) => groomOf(groom?.(place) ?? {})), texCoord: 0 };
  if (shape) fur.groom.shape = map((place) => shapeOf(shape(place)));
  const image = colour && view(colourPicture(mapSize, placeAt, colour));
  const json = {
    asset: { version: '2.0', generator: 'wet-fur' },
    extensionsUsed: ['WETFUR_fur'],
    extensions: { WETFUR_fur: fur },
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0, name }],
    ...(colour && {
      materials: [{ pbrMetallicRoughness: { metallicFactor: 0, baseColorTexture: { index: 0 } } }],
      textures: [{ source: 0 }],
      images: [{ bufferView: image, mimeType: 'image/png' }],
    }),
    meshes: [{ name, primitives: [{ attributes, indices, ...(colour && { material: 0 }) }] }],
    accessors,
    bufferViews: views,
    buffers: [{ byteLength: length }],
  };
  const text = padded(Buffer.from(JSON.stringify(json)), 0x20), binary = Buffer.concat(parts);
  const words = (...values) => bufferOf(new Uint32Array(values));
  return Buffer.concat([words(0x46546c67, 2, 28 + text.length + binary.length), words(text.length, 0x4e4f534a), text,
    words(binary.length, 0x004e4942), binary]);
}
