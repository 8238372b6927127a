// Writes and reads .glb files.
const { max, min } = Math;

const bufferOf = (array) => Buffer.from(array.buffer, array.byteOffset, array.byteLength);
const padded = (bytes, fill) => Buffer.concat([bytes, Buffer.alloc((4 - (bytes.length % 4)) % 4, fill)]);
const words = (...values) => bufferOf(new Uint32Array(values));
const componentTypes = new Map([[Int8Array, 5120], [Uint8Array, 5121], [Int16Array, 5122], [Uint16Array, 5123], [Uint32Array, 5125], [Float32Array, 5126]]);
const widths = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4, MAT4: 16 };
const kVertices = 34962, kIndices = 34963;

export class GlbWriter {
  json = { asset: { version: '2.0', generator: 'wet-fur' }, accessors: [], bufferViews: [] };
  #parts = [];
  #length = 0;

  view(bytes, extra = {}) {
    this.json.bufferViews.push({ buffer: 0, byteOffset: this.#length, byteLength: bytes.length, ...extra });
    this.#parts.push(padded(bytes, 0));
    this.#length += this.#parts.at(-1).length;
    return this.json.bufferViews.length - 1;
  }

  accessor(array, type, { target, normalized = false, extents = false } = {}) {
    const width = widths[type], count = array.length / width;
    const each = (of) => Array.from({ length: width }, (_, k) => {
      let out = array[k];
      for (let i = k; i < array.length; i += width) out = of(out, array[i]);
      return out;
    });
    this.json.accessors.push({
      bufferView: this.view(bufferOf(array), target && { target }), componentType: componentTypes.get(array.constructor), count, type,
      ...normalized && { normalized }, ...extents && { min: each(min), max: each(max) },
    });
    return this.json.accessors.length - 1;
  }

  bytes() {
    const json = { ...this.json, buffers: [{ byteLength: this.#length }] };
    for (const key of ['accessors', 'bufferViews']) if (!json[key].length) delete json[key];
    const text = padded(Buffer.from(JSON.stringify(json)), 0x20), binary = Buffer.concat(this.#parts);
    return Buffer.concat([words(0x46546c67, 2, 28 + text.length + binary.length), words(text.length, 0x4e4f534a), text, words(binary.length, 0x004e4942), binary]);
  }
}

/** { json, view(i) }: what is in a .glb. */
export function readGlb(bytes) {
  const length = bytes.readUInt32LE(12), json = JSON.parse(bytes.subarray(20, 20 + length)), from = 28 + length;
  const view = (i) => {
    const { byteOffset = 0, byteLength } = json.bufferViews[i];
    return bytes.subarray(from + byteOffset, from + byteOffset + byteLength);
  };
  const kinds = new Map([...componentTypes].map(([array, type]) => [type, array]));
  /** The numbers of an accessor without a stride; normalized ones as they are stored. */
  const numbers = (i) => {
    const { bufferView, componentType, count, type, byteOffset = 0 } = json.accessors[i], Kind = kinds.get(componentType);
    const part = Buffer.from(view(bufferView).subarray(byteOffset, byteOffset + count * widths[type] * Kind.BYTES_PER_ELEMENT));
    return [...new Kind(part.buffer, part.byteOffset, count * widths[type])];
  };
  return { json, view, numbers };
}

/** As many bits of the fraction as are seen, so that files pack. */
const rounded = (list, step) => new Float32Array(list.map((x) => Math.round(x / step) * step));

/**
 * A model with fur, rigged if there is a `rig`. `parts`: [{ material, vertices: [{ position, normal, uv, uv1?, joints?, weights? (four bytes), comb? }], indices }];
 * `materials`: [{ name, ... as glTF has them }], whose baseColorTexture.index is one of `pictures` (PNG files); `animations` as motion.mjs makes
 * them; `fur(writer)`: WETFUR_fur without `bare`.
 */
export function animalGlb({ name, parts, materials, pictures, rig, animations, fur, bare }) {
  const out = new GlbWriter(), { json } = out;
  const joints = rig?.joints ?? [];
  const children = (parent) => joints.flatMap((joint, i) => (joint.parent === parent ? [i] : []));
  json.nodes = joints.map((joint, i) => ({ name: joint.name, translation: joint.offset.map((x) => Math.fround(x)), ...children(i).length && { children: children(i) } }));
  json.nodes.push({ name, mesh: 0, ...rig && { skin: 0 } });
  json.scene = 0;
  json.scenes = [{ name, nodes: [...children(-1), joints.length] }];
  const binds = joints.flatMap(({ at }) => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -at[0], -at[1], -at[2], 1]);
  if (rig) json.skins = [{ joints: joints.map((_, i) => i), skeleton: children(-1)[0], inverseBindMatrices: out.accessor(new Float32Array(binds), 'MAT4') }];
  json.materials = materials;
  json.images = pictures.map((png) => ({ mimeType: 'image/png', bufferView: out.view(png) }));
  json.samplers = [{ magFilter: 9729, minFilter: 9987, wrapS: 33071, wrapT: 33071 }];
  json.textures = pictures.map((_, source) => ({ source, sampler: 0 }));
  json.meshes = [{ name, primitives: parts.map((part) => primitive(out, part)) }];
  if (animations.length) json.animations = animations.map((one) => animationJson(out, one));
  json.extensionsUsed = ['WETFUR_fur'];
  json.extensions = { WETFUR_fur: { version: 1, ...fur(out), bare } };
  return out.bytes();
}

function primitive(out, { material, vertices, indices }) {
  const all = (of) => vertices.flatMap(of), target = kVertices, first = vertices[0];
  return {
    material,
    attributes: {
      POSITION: out.accessor(new Float32Array(all((v) => v.position)), 'VEC3', { target, extents: true }),
      NORMAL: out.accessor(rounded(all((v) => v.normal), 2 ** -9), 'VEC3', { target }),
      TEXCOORD_0: out.accessor(new Uint16Array(all((v) => v.uv.map((x) => Math.round(65535 * x)))), 'VEC2', { target, normalized: true }),
      ...first.uv1 && { TEXCOORD_1: out.accessor(new Float32Array(all((v) => v.uv1)), 'VEC2', { target }) },
      ...first.joints && {
        JOINTS_0: out.accessor(new Uint8Array(all((v) => v.joints)), 'VEC4', { target }),
        WEIGHTS_0: out.accessor(new Uint8Array(all((v) => v.weights)), 'VEC4', { target, normalized: true }),
      },
      ...first.comb && { _WETFUR_COMB: out.accessor(rounded(all((v) => v.comb), 2 ** -7), 'VEC3', { target }) },
    },
    indices: out.accessor(new (vertices.length < 65536 ? Uint16Array : Uint32Array)(indices), 'SCALAR', { target: kIndices }),
  };
}

function animationJson(out, { name, times, tracks }) {
  const input = out.accessor(new Float32Array(times), 'SCALAR', { extents: true });
  const short = (x) => Math.round(32767 * x);
  const output = ({ path, values }) => (path === 'rotation' ? out.accessor(new Int16Array(values.flat().map(short)), 'VEC4', { normalized: true })
    : out.accessor(new Float32Array(values.flat()), 'VEC3'));
  return {
    name,
    samplers: tracks.map((track) => ({ input, output: output(track), interpolation: 'LINEAR' })),
    channels: tracks.map(({ joint, path }, sampler) => ({ sampler, target: { node: joint, path } })),
  };
}
