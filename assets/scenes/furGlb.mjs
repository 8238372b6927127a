// A .glb with the extension WETFUR_fur (src/scene/WETFUR_fur.schema.json).
import { GlbWriter } from '../../tools/assets/glb.mjs';
import { byte, packedPlanes, pictureOf } from '../../tools/assets/paint.mjs';

const texels = (size, placeAt, at) => Array.from({ length: size * size }, (_, i) =>
  at(placeAt((i % size + 0.5) / size, (Math.floor(i / size) + 0.5) / size)));

/** Four planes of bytes of what `at(place)` gives: four numbers, 0..1 each. */
const planes = (size, placeAt, at) => packedPlanes(texels(size, placeAt, (place) => at(place).map(byte)));
const groomOf = ({ length = 1, types = [] }) => [length, types[0] ?? 0, types[1] ?? 0, types[2] ?? 0];
const shapeOf = ({ curl = 0, frizz = 0, locks = 0 }) => [curl, frizz, locks, Math.max(curl, frizz, locks)];

/**
 * @param {{ mesh, placeAt }} body as meshOf() gives it
 * @param {{ name: string, state: object, groom?: Function, shape?: Function, colour?: Function, mapSize?: number }} scene
 *   `groom(place)` gives { length, types: [2nd, 3rd, 4th] }, `shape(place)` { curl, frizz, locks }, 0..1 each
 */
export function furGlb({ mesh, placeAt }, { name, state, groom, shape, colour, mapSize = 256 }) {
  const out = new GlbWriter(), target = 34962;
  const attributes = {
    POSITION: out.accessor(new Float32Array(mesh.positions), 'VEC3', { target, extents: true }),
    NORMAL: out.accessor(new Float32Array(mesh.normals), 'VEC3', { target }),
    TEXCOORD_0: out.accessor(new Float32Array(mesh.uv), 'VEC2', { target }),
  };
  const indices = out.accessor(new Uint16Array(mesh.indices), 'SCALAR', { target: 34963 });

  const fur = { version: 1, state: { version: 1, ...state } };
  const map = (at) => out.view(planes(mapSize, placeAt, at));
  if (groom || shape) fur.groom = { size: mapSize, bufferView: map((place) => groomOf(groom?.(place) ?? {})), texCoord: 0 };
  if (shape) fur.groom.shape = map((place) => shapeOf(shape(place)));
  const image = colour && out.view(pictureOf(mapSize, texels(mapSize, placeAt, colour)));
  Object.assign(out.json, {
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
  });
  return out.bytes();
}
