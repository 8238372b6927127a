// Bytes of a scene packed for a link: deflated, as base64url. They come from a stranger: what is unpacked is bounded.

/** Of what unpacks. */
export const mostUnpacked = 4 * 1024 * 1024;

const piped = (bytes, through) => new Blob([bytes]).stream().pipeThrough(through);

export function toBase64Url(bytes) {
  return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join('')).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
}

export function fromBase64Url(text) {
  return Uint8Array.from(atob(text.replaceAll('-', '+').replaceAll('_', '/')), (c) => c.charCodeAt(0));
}

/** @param {BlobPart} content @returns {Promise<string>} */
export async function deflated(content) {
  return toBase64Url(new Uint8Array(await new Response(piped(content, new CompressionStream('deflate-raw'))).arrayBuffer()));
}

/** The way back, as far as `most` bytes: a RangeError beyond. @returns {Promise<Blob>} */
export async function inflated(text, most) {
  const parts = [];
  let size = 0;
  for (const reader = piped(fromBase64Url(text), new DecompressionStream('deflate-raw')).getReader(); ;) {
    const { done, value } = await reader.read();
    if (done) return new Blob(parts);
    size += value.byteLength;
    if (size > most) {
      reader.cancel().catch(() => {});
      throw new RangeError(`it unfolds to more than ${most} bytes`);
    }
    parts.push(value);
  }
}

export const sameBytes = (a, b) => a.length === b.length && a.every((byte, i) => byte === b[i]);

/** The first bytes of all numbers of four bytes, then the second, and so on: what is alike comes together. */
function planesOf(bytes, back) {
  const words = bytes.length >> 2, out = new Uint8Array(bytes);
  for (let i = 0; i < 4 * words; ++i) {
    const plane = (i & 3) * words + (i >> 2);
    if (back) out[i] = bytes[plane];
    else out[plane] = bytes[i];
  }
  return out;
}

const whiskerBytes = 52, combSteps = 512;

/** A groom (app/stages/GroomSaving.cpp) whose comb has fewer digits: steps of a radian's 512th. */
function roundedGroom(bytes) {
  const out = new Uint8Array(bytes), head = new Uint32Array(out.buffer, 0, 4), [, size, whiskers, maps] = head;
  const mapCount = [0, 1, 2, 3].filter((map) => maps >> map & 1).length;
  const comb = new Float32Array(out.buffer, 16 + mapCount * 4 * size * size).subarray(0, -whiskers * whiskerBytes / 4 || undefined);
  comb.forEach((angle, i) => { comb[i] = Math.round(angle * combSteps) / combSteps; });
  return out;
}

/** A groom for a link, see packBytes(). */
export const packGroom = (bytes) => packBytes(roundedGroom(bytes));

/** @param {Uint8Array} bytes of groom or hair (furapp.js) @returns {Promise<string | null>} null: too much, or the browser cannot */
export async function packBytes(bytes) {
  if (!globalThis.CompressionStream || bytes.byteLength > mostUnpacked) return null;
  return deflated(planesOf(bytes, false));
}

/** The way back. Throws for what packBytes() did not make. */
export async function unpackBytes(text) {
  return planesOf(new Uint8Array(await (await inflated(text, mostUnpacked)).arrayBuffer()), true);
}
