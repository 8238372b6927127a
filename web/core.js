/**
 * Fur, water and models without a picture, in browsers and Node:
 * `const core = await loadCore(); core.generateFur({ density: 0.8 })`.
 */
import { FurError } from './errors.js';
import { readableField } from './field.js';
import { instantiateProgram, setGlue } from './runtime.js';

export { FurError };

setGlue('core', () => import('./wet-fur-core.mjs'));

/** What generateFur takes, in the order in which CoreBindings.cpp reads it. */
const furDefaults = {
  size: 256, layers: 16, seed: 1,
  density: 0.85, thickness: 0.35, taper: 0.5, lengthVariation: 0.35, length: 1, curl: 0.25,
  wave: 0, coil: 0, frizz: 0, clump: 0, lockSize: 0.3, roll: 0, stray: 0.1, tipBreak: 0,
  undercoat: 0, undercoatLength: 0.45,
};

/** name: [index in CoreBindings.cpp, stored type, share of a stored unit (0: as it is)] */
const channels = {
  coverage: [0, Uint8Array, 0],
  dominance: [1, Uint8Array, 0],
  variance: [2, Uint8Array, 0],
  tangent: [3, Int8Array, 1 / 127],
  offset: [4, Int16Array, 1 / 64],
  strandId: [5, Uint16Array, 0],
};
const finChannels = { coverage: [6, Uint8Array, 0], dominance: [9, Uint8Array, 0], variance: [7, Uint8Array, 0], tangent: [8, Int8Array, 1 / 127] };

function scaled(stored, scale) {
  const out = new Float32Array(stored.length);
  for (let i = 0; i < out.length; ++i) out[i] = stored[i] * scale;
  return out;
}

function readChannels(program, volume, table) {
  const out = {};
  for (const [name, [index, Type, scale]] of Object.entries(table)) {
    const length = program.call('fur_volumeChannelBytes', volume, index) / Type.BYTES_PER_ELEMENT;
    const stored = program.array(Type, program.call('fur_volumeChannel', volume, index), length);
    out[name] = scale ? scaled(stored, scale) : stored;
  }
  return out;
}

function generateFur(program, parameters = {}) {
  const unknown = Object.keys(parameters).filter((name) => !(name in furDefaults));
  if (unknown.length) throw new TypeError(`generateFur: unknown parameter ${unknown.join(', ')}`);
  const p = { ...furDefaults, ...parameters };
  const volume = program.callOrThrow('fur_generate', Float64Array.from(Object.keys(furDefaults), (name) => p[name]));
  const [size, layers, strandCount, density, weight, rows] = program.numbers(program.call('fur_volumeInfo', volume), 6);
  const out = {
    size, layers, strandCount, density, weight,
    ...readChannels(program, volume, channels),
    fin: { rows, columns: size, ...readChannels(program, volume, finChannels) },
  };
  program.call('fur_volumeFree', volume);
  return out;
}

/** A wetness mask in the plane of the texture; dispose() gives its memory back. */
class WetnessMask {
  #program;
  #mask;

  constructor(program, size) {
    this.#program = program;
    this.#mask = program.callOrThrow('fur_maskCreate', size);
  }

  #call(name, ...args) {
    if (!this.#mask) throw new TypeError('this wetness mask was disposed of');
    return this.#program.call(name, this.#mask, ...args);
  }

  get size() { return this.#call('fur_maskSize'); }
  /** A copy: 4 floats a texel, row by row: clump centre u, v, clump radius, wetness. */
  get data() { return this.#program.array(Float32Array, this.#call('fur_maskTexels'), this.size * this.size * 4); }
  get meanWetness() { return this.#call('fur_maskMean'); }

  addDroplet({ u, v, radius = 0.05, wetness = 0.5 }) { this.#call('fur_maskAddDroplet', u, v, radius, wetness); }
  dryAt({ u, v, radius = 0.05, amount = 0.5 }) { this.#call('fur_maskDryAt', u, v, radius, amount); }
  dry(seconds, { rate = 0.002 } = {}) { this.#call('fur_maskDry', seconds, rate); }
  clear() { this.#call('fur_maskClear'); }
  at(u, v) {
    const [centreU, centreV, radius, wetness] = this.#program.numbers(this.#call('fur_maskAt', u, v), 4);
    return { centreU, centreV, radius, wetness };
  }
  hash() { return this.#program.text(this.#call('fur_maskHash')); }
  dispose() {
    if (this.#mask) this.#call('fur_maskFree');
    this.#mask = 0;
  }
}

function toBytes(bytes) {
  if (bytes instanceof ArrayBuffer) return new Uint8Array(bytes);
  if (ArrayBuffer.isView(bytes)) return new Uint8Array(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  throw new TypeError('expected an ArrayBuffer or a typed array');
}

function importModel(program, bytes, { name = 'model', files = {} } = {}) {
  program.call('fur_clearStagedFiles');
  for (const [fileName, content] of Object.entries(files)) {
    const staged = toBytes(content);
    program.callOrThrow('fur_stageFile', fileName, staged, staged.byteLength);
  }
  const given = toBytes(bytes);
  const model = program.callOrThrow('fur_importModel', given, given.byteLength, name);
  const info = program.numbers(program.call('fur_modelInfo', model), 9);
  const warnings = program.lines(program.call('fur_modelWarnings', model));
  const image = imageOf(program, model);
  program.call('fur_modelFree', model);
  return {
    vertexCount: info[0],
    triangleCount: info[1],
    hasTexcoords: info[2] !== 0,
    bounds: { low: info.slice(3, 6), high: info.slice(6, 9) },
    image,
    warnings,
  };
}

function imageOf(program, model) {
  const mimeType = program.text(program.call('fur_modelImageType', model));
  if (!mimeType) return null;
  const [byteLength, width, height] = program.numbers(program.call('fur_modelImageInfo', model), 3);
  return { mimeType, width, height, bytes: program.array(Uint8Array, program.call('fur_modelImageBytes', model), byteLength) };
}

function decodeImage(program, bytes) {
  const given = toBytes(bytes);
  const image = program.callOrThrow('fur_decodeImage', given, given.byteLength);
  const width = program.call('fur_imageWidth', image), height = program.call('fur_imageHeight', image);
  const data = program.array(Uint8ClampedArray, program.call('fur_imagePixels', image), 4 * width * height);
  program.call('fur_imageFree', image);
  return { width, height, data };
}

function equationsOf(program) {
  const number = (name) => (...args) => program.call(name, ...args.flat());
  const truth = (name) => (...args) => program.call(name, ...args.flat()) !== 0;
  const vector = (name) => (...args) => program.numbers(program.call(name, ...args.flat()), 3);
  const pair = (name) => (...args) => program.numbers(program.call(name, ...args), 2);
  return Object.freeze({
    clumpProfile: number('fur_eqClumpProfile'),
    clumpShift: number('fur_eqClumpShift'),
    clumpDisplacement: number('fur_eqClumpDisplacement'),
    finOpacity: number('fur_eqFinOpacity'),
    printedLight: ({ color, specular, nDotL, cosine, p, h, rho, sigmaOcc, sigmaWet, sigmaSpec }) =>
      program.call('fur_eqPrintedLight', color, specular, nDotL, cosine, p, h, rho, sigmaOcc, sigmaWet, sigmaSpec),
    wetSpecularExponent: number('fur_eqWetSpecularExponent'),
    occlusionFactor: number('fur_eqOcclusionFactor'),
    wetDarkening: number('fur_eqWetDarkening'),
    strandThinning: (s, taper = 0.5) => program.call('fur_eqStrandThinning', s, taper),
    strandRadius: number('fur_eqStrandRadius'),
    strandCount: (density, thickness, size = 256) => program.call('fur_eqStrandCount', density, thickness, size),
    strandExists: truth('fur_eqStrandExists'),
    furShadow: number('fur_eqFurShadow'),
    windBend: pair('fur_eqWindBend'),
    arcBend: pair('fur_eqArcBend'),
    kajiyaDiffuse: number('fur_eqKajiyaDiffuse'),
    kajiyaSpecular: number('fur_eqKajiyaSpecular'),
    marschnerM: number('fur_eqMarschnerM'),
    marschnerN: number('fur_eqMarschnerN'),
    transmittance: number('fur_eqTransmittance'),
    opacityLookup: (layers, z, dz) => program.call('fur_eqOpacityLookup', Float64Array.from(layers), layers.length, z, dz),
    verletStep: vector('fur_eqVerletStep'),
    springStiffness: number('fur_eqSpringStiffness'),
    tiltStiffness: number('fur_eqTiltStiffness'),
  });
}

/** Loads the program (once a call; each has memory of its own). */
export async function loadCore() {
  const program = await instantiateProgram('core');
  return Object.freeze({
    generateFur: (parameters) => generateFur(program, parameters),
    createWetnessMask: (size = 256) => new WetnessMask(program, size),
    importModel: (bytes, options) => importModel(program, bytes, options),
    decodeImage: (bytes) => decodeImage(program, bytes),
    equations: equationsOf(program),
    settingsTable: JSON.parse(program.text(program.call('fur_settingsTable'))).map(readableField),
  });
}
