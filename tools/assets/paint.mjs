// Maps over the atlas of a mesh, painted by place: what a texel gets is a function of what lies there.
import { createRequire } from 'node:module';
import { add, scaled, unit } from './vectors.mjs';

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

/** The first `count` bytes of what packBits() has packed. */
export function unpackBits(packed, count) {
  const out = [];
  for (let i = 0; i < packed.length && out.length < count;) {
    const head = packed[i++];
    if (head < 128) {
      out.push(...packed.subarray(i, i + head + 1));
      i += head + 1;
    } else if (head > 128) {
      for (let k = 257 - head; k > 0; --k) out.push(packed[i]);
      ++i;
    }
  }
  return out.slice(0, count);
}

/** Four planes, as WETFUR_fur.schema.json has them, of texels of four bytes. */
export const packedPlanes = (texels) => packBits(Buffer.concat([0, 1, 2, 3].map((plane) => Buffer.from(texels.map((texel) => texel[plane])))));
export const byte = (share) => Math.max(0, Math.min(255, Math.round(255 * share)));

/** A PNG of size * size colours [r, g, b] in sRGB, 0..1 each. */
export function pictureOf(size, colours) {
  const { PNG } = pngjs(), png = new PNG({ width: size, height: size });
  colours.forEach((colour, i) => png.data.set([...colour.map(byte), 255], 4 * i));
  return PNG.sync.write(png, { colorType: 2, deflateLevel: 9 });
}

/** '#rrggbb' as [r, g, b], 0..1. */
export const hex = (text) => [1, 3, 5].map((i) => parseInt(text.slice(i, i + 2), 16) / 255);

/** The same as glTF's baseColorFactor has it: linear, and opaque. */
export const factorOf = (text) => [...hex(text).map((c) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)), 1];

/**
 * For each texel of a square map what lies there: { position, normal, part }, beyond the borders of charts what lies nearest, up to `reach`
 * texels away. `vertices`: { position, normal, uv }; `triangles`: { corners: [3 vertices], part }.
 */
export function placesOn(size, vertices, triangles, reach = Infinity) {
  const places = new Array(size * size), small = [];
  for (const { corners, part } of triangles) {
    const [a, b, c] = corners.map((v) => vertices[v]), [p, q, r] = [a, b, c].map(({ uv }) => uv.map((x) => x * size - 0.5));
    const area = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
    if (Math.abs(area) < 1e-9) continue;
    const low = [0, 1].map((k) => Math.max(0, Math.ceil(Math.min(p[k], q[k], r[k]) - 0.01))), high = [0, 1].map((k) => Math.min(size - 1, Math.floor(Math.max(p[k], q[k], r[k]) + 0.01)));
    const of = (key, u, v) => add(add(scaled(a[key], 1 - u - v), scaled(b[key], u)), scaled(c[key], v));
    const placeAt = (u, v) => ({ position: of('position', u, v), normal: unit(of('normal', u, v)), part });
    let found = false;
    for (let y = low[1]; y <= high[1]; ++y) for (let x = low[0]; x <= high[0]; ++x) {
      const u = ((x - p[0]) * (r[1] - p[1]) - (y - p[1]) * (r[0] - p[0])) / area, v = ((q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0])) / area;
      if (u < -1e-3 || v < -1e-3 || u + v > 1.001) continue;
      places[x + size * y] = placeAt(u, v);
      found = true;
    }
    if (!found) small.push([Math.round((p[0] + q[0] + r[0]) / 3), Math.round((p[1] + q[1] + r[1]) / 3), placeAt(1 / 3, 1 / 3)]);
  }
  // Triangles between the middles of texels have the one that is nearest.
  for (const [x, y, place] of small) if (x >= 0 && y >= 0 && x < size && y < size) places[x + size * y] ??= place;
  return spread(places, size, reach);
}

// Texels without a place take that of a neighbour that has one, so many times.
function spread(places, size, reach) {
  let front = [...places.keys()].filter((i) => places[i]);
  for (let round = 0; round < reach && front.length; ++round) {
    const next = [];
    for (const i of front) {
      const x = i % size, y = (i - x) / size;
      for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
        const j = i + dx + size * dy;
        if (x + dx < 0 || x + dx >= size || y + dy < 0 || y + dy >= size || places[j]) continue;
        places[j] = places[i];
        next.push(j);
      }
    }
    front = next;
  }
  return places;
}
