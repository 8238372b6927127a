// wet-fur/core: fur, water and models without a picture, in browsers and Node.
import type { SettingsField } from './index.js';

export { FurError } from './index.js';

export interface FurParameters {
  /** Texels a side, a power of two, 64..1024. */
  size?: number;
  /** 4..128 */
  layers?: number;
  /** The same seed gives the same bytes on every platform. */
  seed?: number;
  // All of these are 0..1.
  density?: number;
  thickness?: number;
  /** 0 blunt, 0.5 Sheppard's thinning, 1 a needle. */
  taper?: number;
  lengthVariation?: number;
  /** Of the longest strand, in volume heights. */
  length?: number;
  curl?: number;
  /** Long waves that neighbours share. */
  wave?: number;
  /** Loops in three dimensions: from about a third up they fold back on themselves. */
  coil?: number;
  frizz?: number;
  /** Binds strands into locks. */
  clump?: number;
  lockSize?: number;
  roll?: number;
  stray?: number;
  tipBreak?: number;
  undercoat?: number;
  undercoatLength?: number;
}

/** Layer-major, size * size texels a layer, layer 0 at the skin. */
export interface FurVolume {
  size: number;
  layers: number;
  strandCount: number;
  density: number;
  weight: number;
  /** 0..255 */
  coverage: Uint8Array;
  /** 128..255 for 0.5..1 */
  dominance: Uint8Array;
  variance: Uint8Array;
  /** 3 a texel: unit root-to-tip tangent, z up. */
  tangent: Float32Array;
  /** 2 a texel, in texels back to the strand's root. */
  offset: Float32Array;
  /** From 1; 0 where the layer has no strand. */
  strandId: Uint16Array;
  /** Strands seen from the side, row 0 at the root. */
  fin: { rows: number; columns: number; coverage: Uint8Array; dominance: Uint8Array; variance: Uint8Array; tangent: Float32Array };
}

export interface WetnessMask {
  readonly size: number;
  /** A copy: 4 a texel: clump centre u, v, clump radius, wetness. */
  readonly data: Float32Array;
  readonly meanWetness: number;
  addDroplet(droplet: { u: number; v: number; radius?: number; wetness?: number }): void;
  dryAt(brush: { u: number; v: number; radius?: number; amount?: number }): void;
  /** `rate` (default 0.002, as the setting `dryRate`): wetness that half-wet fur loses in a second. */
  dry(seconds: number, options?: { rate?: number }): void;
  clear(): void;
  at(u: number, v: number): { centreU: number; centreV: number; radius: number; wetness: number };
  hash(): string;
  dispose(): void;
}

export type Vector = readonly [number, number, number];

/** Angles in radians, vectors as arrays of 3. */
export interface Equations {
  clumpProfile(h: number, w: number, layers: number): number;
  clumpShift(h: number, w: number, layers: number, rho: number): number;
  /** f(h) rho: Silva Eq. 1 as printed, p - c in radii of the clump. */
  clumpDisplacement(h: number, w: number, layers: number, rho: number): number;
  /** Of Sheppard's fins: facing = (n1.v)(n2.v), across = N.v of the fin (Eq. 3.1 and 3.2). */
  finOpacity(facing: number, across: number): number;
  /** Silva Eq. 2, 3 and 5 under a light of 1; cosine = sin(T,L) sin(T,V) - (T.L)(T.V). */
  printedLight(values: {
    color: number; specular: number; nDotL: number; cosine: number; p: number; h: number; rho: number;
    sigmaOcc: number; sigmaWet: number; sigmaSpec: number;
  }): number;
  wetSpecularExponent(p: number, rho: number, sigmaSpec: number): number;
  occlusionFactor(h: number, sigmaOcc: number): number;
  wetDarkening(rho: number, sigmaWet: number): number;
  /** Relative to the nominal radius; Sheppard Eq. 3.6 at taper 0.5 (the default). */
  strandThinning(s: number, taper?: number): number;
  /** Mean nominal radius of a strand, texels. */
  strandRadius(thickness: number): number;
  /** How many guard hairs are tried for in a tile (Sheppard Eq. 4.1). */
  strandCount(density: number, thickness: number, size?: number): number;
  strandExists(h: number, presence: number, dominance: number): boolean;
  furShadow(h: number, density: number, nDotL: number): number;
  /** [along, across] */
  windBend(force: number, t: number): [number, number];
  arcBend(theta: number, t: number): [number, number];
  kajiyaDiffuse(T: Vector, L: Vector): number;
  kajiyaSpecular(T: Vector, L: Vector, V: Vector, p: number): number;
  /** A normal distribution of thetaH round alpha; its integral is 1. */
  marschnerM(thetaH: number, alpha: number, beta: number): number;
  /** p: 0 R, 1 TT, 2 TRT. Per radian of phiD; absorption per strand radius. */
  marschnerN(p: number, thetaD: number, phiD: number, eta: number, absorption: number): number;
  /** exp(-k sigma) */
  transmittance(k: number, sigma: number): number;
  /** sigma(z) from the opacity before each layer, layer i at i dz. */
  opacityLookup(layerOpacities: ArrayLike<number>, z: number, dz: number): number;
  /** p + damping (p - pPrev) + dt^2 acceleration: damping is the share of its velocity that is kept, 1 is undamped (Halen & Wester 4.1). */
  verletStep(p: Vector, pPrev: Vector, acceleration: Vector, damping: number, dt: number): [number, number, number];
  /** k / (L c)^a at the distance L from the root; a: 1, 2 or 3. */
  springStiffness(k: number, L: number, c: number, a: number): number;
  /** ((z.z_h + 1) / 2) (k - alpha) + alpha: of a spring on a head that is tilted. */
  tiltStiffness(k: number, alpha: number, zDotZh: number): number;
}

export interface ImportedModel {
  vertexCount: number;
  triangleCount: number;
  hasTexcoords: boolean;
  /** In the file's units. */
  bounds: { low: [number, number, number]; high: [number, number, number] };
  /** Its base colour image, for decodeImage(). */
  image: { mimeType: string; width: number; height: number; bytes: Uint8Array } | null;
  warnings: string[];
}

export interface Core {
  generateFur(parameters?: FurParameters): FurVolume;
  createWetnessMask(size?: number): WetnessMask;
  /**
   * A {models}; the ending of `name` tells the last two apart, without one their content.
   * Throws a FurError. `files`: buffers and images beside a .gltf, by the name it uses.
   */
  importModel(
    bytes: ArrayBuffer | ArrayBufferView,
    options?: { name?: string; files?: Record<string, ArrayBuffer | ArrayBufferView> }): ImportedModel;
  /** The pixels of a PNG or JPEG, RGBA from the top, as ImageData has them. Throws a FurError. */
  decodeImage(bytes: ArrayBuffer | ArrayBufferView): { width: number; height: number; data: Uint8ClampedArray };
  readonly equations: Equations;
  readonly settingsTable: readonly SettingsField[];
}

export function loadCore(): Promise<Core>;
