// Long hair whose guides are made by code, as WETFUR_fur has it; what grows by steps of Dress.h is program.mjs'.
import { byte, packedPlanes } from './paint.mjs';
import { add, between, scaled, sub, unit } from './vectors.mjs';

/**
 * A guide that leaves the skin at `root` and falls: `nodes` places, `length` long in all. `start`: the way in which it leaves, `fall`: that in
 * which it goes then, `bend`: how soon, 0..1 a segment; it stays `gap(share of the way)` outside of the solid.
 */
export function falling({ root, start, fall, nodes, length, bend, gap }, at, surface) {
  const out = [root], step = length / (nodes - 1);
  let way = unit(start);
  for (let i = 1; i < nodes; ++i) {
    const share = i / (nodes - 1);
    way = unit(between(way, unit(typeof fall === 'function' ? fall(out[i - 1], share) : fall), bend));
    let p = add(out[i - 1], scaled(way, step));
    for (let round = 0; round < 6; ++round) {
      const inside = gap(share) - at(p);
      if (inside <= 0) break;
      const g = surface.gradient(p), size = Math.max(0.25, g[0] ** 2 + g[1] ** 2 + g[2] ** 2);
      p = add(p, scaled(g, inside / size));
      p = add(out[i - 1], scaled(unit(sub(p, out[i - 1])), step));
    }
    way = unit(sub(p, out[i - 1]));
    out.push(p);
  }
  return out;
}

/** How large a ball round p stays inside of the solid. */
export function roomAt(at, p) {
  const clear = (r) => directions.every((way) => at(add(p, scaled(way, r))) < 0);
  let low = 0, high = 8;
  for (let i = 0; i < 14; ++i) clear((low + high) / 2) ? (low = (low + high) / 2) : (high = (low + high) / 2);
  return low;
}
const directions = [-1, 0, 1].flatMap((x) => [-1, 0, 1].flatMap((y) => [-1, 0, 1].map((z) => [x, y, z]))).filter((way) => way.some((x) => x !== 0)).map((way) => unit(way));

/**
 * WETFUR_fur.hair. `scalps`: [{ name, values, grow(place): [density, width, length, rotation], guides: [[x, y, z], ...][], held? }], `held(i)`: that
 * guide does not swing; `bodies`: [{ joint, a, b, radius }] that hair stays out of; `placesOn(size, reach)` as in paint.mjs.
 */
const kSize = 512;
export function longHair(writer, { joint }, placesOn, { scalps, bodies }) {
  // In the gutters between charts hair would come from one that lies elsewhere.
  const places = placesOn(kSize, 2), nothing = [0, 0, 0, 0];
  const floats = (list) => writer.view(Buffer.from(new Float32Array(list).buffer));
  return {
    texCoord: 0,
    scalps: scalps.map(({ name, values, grow, guides, held = () => false }) => ({
      name, values,
      map: { size: kSize, bufferView: writer.view(packedPlanes(Array.from(places, (place) => { const here = place && grow(place); return (here?.[0] > 0 ? here : nothing).map(byte); }))) },
      guides: { nodes: guides[0].length, positions: floats(guides.flat(2)), flags: writer.view(Buffer.from(guides.map((_, i) => (held(i) ? 1 : 0)))) },
    })),
    bodies: floats(bodies.flatMap(({ a, b, radius }) => [...a, ...b, radius])),
    bones: bodies.map((body) => joint(body.joint)),
  };
}
