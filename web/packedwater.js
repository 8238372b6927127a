// Water for a link: where the fur is wet, to which clumps it belongs and what stands on it, without what falls and hangs in long hair.
// Coarser where that is what fits. Works on the bytes of FurApp.water, whose beginning is the layout, the number of texels, four floats of each (clump
// centre, radius, wetness), the number of texels with a film, and those (WaterStage::save()).
import { deflated, inflated } from './packed.js';

/** Texels along the packed mask, the best first. */
export const waterSizes = [256, 128, 64];
const headBytes = 4, planes = 5;
// Steps of a clump's centre in the atlas, of a factor 2 of its radius (from 1 / 512 on), of wetness 1, and of the square root
// of a film as deep.
const centreSteps = 512, radiusSteps = 8, wetnessSteps = 32, filmSteps = 16;
/** Of what unpacks: a mask of the best size in which no two texels share a clump. */
export const mostUnpackedWater = headBytes + waterSizes[0] ** 2 * (planes + 4);

const maskSide = (water) => Math.sqrt(new DataView(water.buffer, water.byteOffset).getUint32(4, true));
const texelsOf = (water, side) => new Float32Array(water.slice(8, 8 + 16 * side * side).buffer);
/** Where its number of texels stands, and that. */
function filmOf(water, side) {
  const at = 8 + 16 * side * side, count = new DataView(water.buffer, water.byteOffset).getUint32(at, true);
  return { at, count, film: new Float32Array(water.slice(at + 4, at + 4 + 4 * count).buffer) };
}
const byte = (value) => Math.min(255, Math.max(1, Math.round(value)));

/** @param {Uint8Array} water @param {number} size one of waterSizes @returns {Promise<string | null>} null: the browser cannot */
export async function packWater(water, size) {
  if (!globalThis.CompressionStream) return null;
  const side = maskSide(water), texels = texelsOf(water, side), { film } = filmOf(water, side), step = side / size;
  const count = size * size, out = Array.from({ length: planes }, () => new Uint8Array(count));
  const clumps = new Map(), centres = [];
  for (let i = 0; i < count; ++i) {
    const x = Math.floor((i % size + 0.5) * step), y = Math.floor((Math.floor(i / size) + 0.5) * step);
    const [u, v, radius, wetness] = texels.subarray(4 * (y * side + x));
    out[4][i] = Math.min(255, Math.round(Math.sqrt(film[y * side + x] ?? 0) * filmSteps));
    if (!(wetness > 0)) continue;
    const centre = [u, v].map((at) => Math.round(at * centreSteps));
    const key = centre.join();
    if (!clumps.has(key)) {
      clumps.set(key, clumps.size + 1);
      centres.push(...centre);
    }
    const clump = Math.min(clumps.get(key), 0xffff);
    [clump & 255, clump >> 8, byte(radiusSteps * Math.log2(radius * 512)), byte(wetness * wetnessSteps)].forEach((value, k) => { out[k][i] = value; });
  }
  const most = Math.min(clumps.size, 0xffff);
  const table = new DataView(new ArrayBuffer(4 * most));
  // The low bytes of all centres, then the high ones: what is alike comes together.
  for (let i = 0; i < 2 * most; ++i) {
    table.setUint8(i, centres[i] & 255);
    table.setUint8(2 * most + i, centres[i] >> 8 & 255);
  }
  const head = Uint8Array.of(1, Math.log2(size), most & 255, most >> 8);
  return deflated(new Blob([head, table, ...out]));
}

/** FurApp.water with this in place of what is in `water`. Throws for what packWater() did not make. */
export async function unpackWater(text, water) {
  const bytes = new Uint8Array(await (await inflated(text, mostUnpackedWater)).arrayBuffer());
  const [version, log, low, high] = bytes, size = 2 ** log, count = size * size, most = low + 256 * high;
  const at = headBytes + 4 * most;
  if (version !== 1 || !waterSizes.includes(size) || bytes.length !== at + planes * count) throw new RangeError('it is no water');
  const centre = (k) => (bytes[headBytes + k] | bytes[headBytes + 2 * most + k] << 8) << 16 >> 16;
  const side = maskSide(water), texels = new Float32Array(4 * side * side), film = new Float32Array(side * side), step = size / side;
  for (let i = 0; i < side * side; ++i) {
    const from = Math.floor(Math.floor(i / side) * step) * size + Math.floor(i % side * step);
    const [clumpLow, clumpHigh, radius, wetness, depth] = Array.from({ length: planes }, (_, k) => bytes[at + k * count + from]);
    film[i] = (depth / filmSteps) ** 2;
    const clump = clumpLow + 256 * clumpHigh;
    if (clump > most) throw new RangeError('it has no such clump');
    if (clump === 0) continue;
    texels.set([centre(2 * clump - 2) / centreSteps, centre(2 * clump - 1) / centreSteps, 2 ** (radius / radiusSteps) / 512, wetness / wetnessSteps], 4 * i);
  }
  const former = filmOf(water, side);
  const parts = [water.subarray(0, 8), texels, Uint32Array.of(film.length), film, water.subarray(former.at + 4 + 4 * former.count)];
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}
