// What wet-fur-make-assets does for a mesh: it cuts it into the charts of an atlas and dresses it with whiskers and long hair.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { readGlb } from './glb.mjs';

/** A mesh as the program reads it. */
export function meshBytes({ positions, normals = [], cells }) {
  const bytes = new DataView(new ArrayBuffer(8 + 12 * (positions.length + cells.length + normals.length)));
  bytes.setUint32(0, positions.length, true);
  bytes.setUint32(4, cells.length, true);
  let at = 8;
  for (const value of positions.flat()) bytes.setFloat32(at, value, true), (at += 4);
  for (const value of cells.flat()) bytes.setUint32(at, value, true), (at += 4);
  for (const value of normals.flat()) bytes.setFloat32(at, value, true), (at += 4);
  return bytes;
}

/** The command line of a program that may be a .js file, run by this same Node. */
export const commandOf = (program) => (/\.(c|m)?js$/.test(program) ? [process.execPath, program] : [program]);

/** What takes places to the unit sphere, in which programs have models, and back; `size`: for lengths. */
export function fitOf(positions) {
  const low = [0, 1, 2].map((k) => positions.reduce((least, p) => Math.min(least, p[k]), Infinity));
  const high = [0, 1, 2].map((k) => positions.reduce((most, p) => Math.max(most, p[k]), -Infinity));
  const centre = low.map((x, k) => 0.5 * (x + high[k]));
  const radius = Math.sqrt(positions.reduce((most, p) => Math.max(most, p.reduce((sum, x, k) => sum + (x - centre[k]) ** 2, 0)), 0));
  return { radius, of: (p) => p.map((x, k) => (x - centre[k]) / radius), back: (p) => p.map((x, k) => x * radius + centre[k]), size: (x) => x / radius };
}

/**
 * { atlas: [u, v] for each corner of each cell, in order, glb }; `steps` as assets/Dress.h has them, in the unit sphere, and `glb`, which has what
 * they made.
 */
export function laidOut(program, { positions, normals, cells }, steps = []) {
  const scratch = mkdtempSync(join(tmpdir(), 'wet-fur-'));
  try {
    const [mesh, made, hair] = ['mesh', 'made.glb', 'hair'].map((name) => join(scratch, name)), [command, ...before] = commandOf(program);
    writeFileSync(mesh, meshBytes({ positions, normals, cells }));
    writeFileSync(hair, ['{"version":1}', ...steps].join('\n'));
    execFileSync(command, [...before, mesh, made, '--hair', hair], { stdio: ['ignore', 'ignore', 'inherit'] });
    const glb = readGlb(readFileSync(made)), { attributes, indices } = glb.json.meshes[0].primitives[0];
    const corners = glb.numbers(indices), uv = glb.numbers(attributes.TEXCOORD_0);
    if (corners.length !== 3 * cells.length) throw new Error(`the mesh has ${cells.length} triangles, of which ${corners.length / 3} have a place in the atlas`);
    return { atlas: corners.map((v) => [uv[2 * v], uv[2 * v + 1]]), glb };
  } finally {
    rmSync(scratch, { recursive: true });
  }
}

const floatsMapped = (bytes, stride, each) => {
  const out = Buffer.from(bytes);
  for (let at = 0; at + stride <= out.length; at += stride) each(out, at);
  return out;
};
const moved = (out, at, back) => back([0, 4, 8].map((k) => out.readFloatLE(at + k))).forEach((x, k) => out.writeFloatLE(x, at + 4 * k));

/** What laidOut() made of whiskers and hair, for WETFUR_fur of another file, in the space of the model. */
export function wornOf(glb, writer, fit) {
  const { whiskers, hair } = glb.json.extensions?.WETFUR_fur ?? {}, out = {};
  if (whiskers) out.whiskers = { bufferView: writer.view(floatsMapped(glb.view(whiskers.bufferView), 52, (bytes, at) => moved(bytes, at, fit.back))) };
  if (!hair) return out;
  const copied = (i) => writer.view(glb.view(i)), places = (i) => writer.view(floatsMapped(glb.view(i), 12, (bytes, at) => moved(bytes, at, fit.back)));
  out.hair = { ...hair, texCoord: 0, scalps: hair.scalps.map((scalp) => ({
    ...scalp, map: { ...scalp.map, bufferView: copied(scalp.map.bufferView) },
    ...scalp.guides && { guides: { ...scalp.guides, positions: places(scalp.guides.positions), flags: copied(scalp.guides.flags),
      ...scalp.guides.wetness !== undefined && { wetness: copied(scalp.guides.wetness) } } },
  })) };
  if (hair.bodies !== undefined) out.hair.bodies = writer.view(floatsMapped(glb.view(hair.bodies), 28, (bytes, at) => {
    moved(bytes, at, fit.back), moved(bytes, at + 12, fit.back);
    bytes.writeFloatLE(bytes.readFloatLE(at + 24) * fit.radius, at + 24);
  }));
  return out;
}
