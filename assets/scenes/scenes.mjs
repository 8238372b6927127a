// The scenes that ship: what the papers' figures show, each with a coat, a look and a camera of its own.
import { statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { furGlb } from './furGlb.mjs';
import { hairstyles } from './hairstyles.mjs';
import { meshOf, rod, sphere } from './shapes.mjs';

const clamp = (x) => Math.max(0, Math.min(1, x));
const smooth = (low, high, x) => ((t) => t * t * (3 - 2 * t))(clamp((x - low) / (high - low)));
const mix = (a, b, k) => a.map((x, i) => x + (b[i] - x) * k);

// --- Bilbao 2019, section 4: "Show Example" draws five spheres, each with a texture of its own ---

const stack = [[-0.68, -0.3, 0], [0, -0.3, 0], [0.68, -0.3, 0], [-0.34, 0.29, 0], [0.34, 0.29, 0]];
const patches = ([x, y, z]) => smooth(-0.25, 0.25, Math.sin(14 * x + 2 * Math.sin(9 * y)) + Math.sin(13 * y + 8 * z));
const fiveCoats = {
  name: 'five-coats',
  body: () => meshOf(stack.flatMap((centre, part) => sphere({ centre, radius: 0.31, part })), 0.3),
  mapSize: 512,
  // The first four are the fur types. The fifth is curled into tight locks all over, shorter and piebald, so that of the first type
  // nothing is seen in it.
  groom: ({ part }) => ({ length: part === 4 ? 0.75 : 1, types: [1, 2, 3].map((type) => Number(type === part)) }),
  shape: ({ part }) => (part === 4 ? { curl: 0.9, frizz: 0.25, locks: 0.9 } : {}),
  colour: (place) => (place.part === 4 ? mix([0.28, 0.2, 0.17], [1, 0.97, 0.9], patches(place.position)) : [1, 1, 1]),
  settings: {
    type2: 'chinchilla', type3: 'thickNylon', type4: 'shortCat', density: 0.95, thickness: 0.3, curl: 0.15, furLength: 0.08,
    repeat: 8, layers: 32, undercoat: 0.6, undercoatLength: 0.6, rootColor: '#8a8078', tipColor: '#f0dfc4', skinColor: '#8a6f66',
    variance: 0.4, gravity: 0.15,
  },
  camera: { yaw: 0.15, pitch: 0.12, distance: 3.1 },
};

// --- Sheppard 2004 ---

// What the papers' figures show is drawn as they draw it.
const classic = { technique: 'shells', lie: 0 };

// Figure 3.1: 8, 16 and 32 shells.
const shells = (layers) => ({
  name: `shells-${layers}`,
  body: () => meshOf(sphere({ cells: 16 })),
  settings: {
    ...classic, layers, density: 0.6, thickness: 0.55, lengthVariation: 0.2, curl: 0.35, furLength: 0.22, repeat: 3, gravity: 0.35,
    rootColor: '#4a3424', tipColor: '#d8b483', skinColor: '#7d5a4a', variance: 0.4, fins: false,
  },
  camera: { yaw: 0.35, pitch: 0.3, distance: 3.6 },
});

// Figures 3.2 and 3.3: fins at every edge stand out where one looks on them from above, and they are needed at the
// outline only.
const fins = (name, finEdges) => ({
  name,
  body: () => meshOf(sphere({ cells: 6 })),
  settings: {
    ...classic, finEdges, view: 'fins', density: 0.6, thickness: 0.5, furLength: 0.16, repeat: 3, layers: 16, gravity: 0,
    rootColor: '#4a3424', tipColor: '#e0bd8e', skinColor: '#a08070',
  },
  camera: { yaw: 0.35, pitch: 0.28, distance: 4.2 },
});

// Figure 3.7: fur that fades towards bald skin grows sparser and shorter, by existence and dominance.
const fading = {
  name: 'fading',
  body: () => meshOf(rod({ half: 0.75, radius: 0.4 })),
  groom: ({ position: [x] }) => ({ types: [smooth(-0.8, 0.8, x)] }),
  settings: {
    ...classic, type2: 'bald', density: 0.7, thickness: 0.5, lengthVariation: 0.1, curl: 0.2, furLength: 0.13, repeat: 4, layers: 32, gravity: 0.2,
    rootColor: '#4d3a2c', tipColor: '#d9b98f', skinColor: '#c09a86',
  },
  camera: { yaw: 0.1, pitch: 0.3, distance: 3.1 },
};

// Figure 6.2: the same coat without and with variance from strand to strand.
const variance = {
  name: 'variance',
  body: () => meshOf([-0.6, 0.6].flatMap((x, part) => sphere({ centre: [x, 0, 0], radius: 0.42, part })), 0.3),
  groom: ({ part }) => ({ types: [part] }),
  settings: {
    ...classic, type2: 'rabbit', density: 0.95, thickness: 0.3, curl: 0.15, furLength: 0.11, repeat: 5, undercoat: 0.6, undercoatLength: 0.6,
    rootColor: '#57524f', tipColor: '#b89c78', skinColor: '#8a6f66', variance: 0, specular: 0.3, gravity: 0.15, layers: 32,
  },
  camera: { yaw: 0, pitch: 0.2, distance: 3.2 },
};

// Figure 6.3: one fur type runs into another over a curved body, which Sheppard's own program could not yet do.
const interpolation = {
  name: 'interpolation',
  body: () => meshOf(rod({ half: 0.7, radius: 0.45 })),
  groom: ({ position: [x] }) => ({ types: [clamp(smooth(-0.85, 0.05, x) - smooth(0.15, 0.95, x)), smooth(0.15, 0.95, x)] }),
  settings: {
    ...classic, type2: 'wool', type3: 'otter', density: 1, thickness: 0.28, lengthVariation: 0.2, curl: 0.05, furLength: 0.08, repeat: 6,
    undercoat: 0.3, rootColor: '#8a5a30', tipColor: '#dd9850', skinColor: '#a4735c', specular: 0.5, layers: 32,
  },
  camera: { yaw: 0.15, pitch: 0.2, distance: 3 },
};

// --- Silva et al. 2010: drops on a body, { from, way, radius, wetness } each, where the way first meets it ---

// Chance, 0..1 (mulberry32): the same drops in every build.
function chanceFrom(seed) {
  return () => {
    seed = (seed + 0x6d2b79f5) | 0;
    let t = Math.imul(seed ^ (seed >>> 15), 1 | seed);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  };
}
const onSphere = (chance) => {
  const z = 2 * chance() - 1, angle = 2 * Math.PI * chance(), r = Math.sqrt(1 - z * z);
  return [r * Math.cos(angle), r * Math.sin(angle), z];
};
const plus = (a, b, k) => a.map((x, i) => x + k * b[i]);
const dot = (a, b) => a.reduce((sum, x, i) => sum + x * b[i], 0);

// All over a body, where `takes(target)`: towards points within it from outside.
function soaking(count, drop, takes = () => true, chance = chanceFrom(5)) {
  const drops = [];
  while (drops.length < count) {
    const target = onSphere(chance).map((x) => x * 0.75 * Math.cbrt(chance())), out = onSphere(chance);
    if (!takes(target)) continue;
    const size = drop.radius * (0.7 + 0.6 * chance());
    drops.push({ ...drop, radius: size, from: plus(target, out, 2.5), way: out.map((x) => -x) });
  }
  return drops;
}

// The eye's axes: to its right, up, and towards it.
function axesOf({ yaw, pitch }) {
  const back = [Math.sin(yaw) * Math.cos(pitch), Math.sin(pitch), Math.cos(yaw) * Math.cos(pitch)], right = [Math.cos(yaw), 0, -Math.sin(yaw)];
  const up = [back[1] * right[2] - back[2] * right[1], back[2] * right[0] - back[0] * right[2], back[0] * right[1] - back[1] * right[0]];
  return { right, up, back };
}

// Figure 1b: soaking. 1a is the bunny as it comes.
const bunnyView = { yaw: 0.35, pitch: 0.2, distance: 2.9 };
const bunnyCoat = { ...classic, furLength: 0.11, dryRate: 0, gravity: 0.45, layers: 32 };
const wetBunny = { name: 'wet-bunny', shape: 'bunny', drops: () => soaking(6000, { radius: 0.05, wetness: 0.78 }), settings: bunnyCoat, camera: bunnyView };

// Figure 6a and b: half of it wet.
const { right, up, back } = axesOf(bunnyView);
const halfWet = {
  name: 'half-wet', shape: 'bunny',
  drops: () => soaking(2600, { radius: 0.05, wetness: 0.8 }, (at) => dot(at, right) > 0.04),
  settings: bunnyCoat, camera: { ...bunnyView, distance: 3.1 },
};

// Figure 6c: letters stamped as clumps. Strokes in a square of one unit each.
const letters = {
  W: [[[0, 1], [0.25, 0], [0.5, 0.7], [0.75, 0], [1, 1]]],
  E: [[[0.85, 1], [0.1, 1], [0.1, 0], [0.85, 0]], [[0.1, 0.5], [0.7, 0.5]]],
  T: [[[0, 1], [1, 1]], [[0.5, 1], [0.5, 0]]],
};
/** Drops along the strokes of a word, each a radius and a bit from the one before: so that each makes a clump of its own. */
function stamped(word, { corner, size, radius, wetness }) {
  const drops = [];
  [...word].forEach((letter, i) => letters[letter].forEach((stroke) => stroke.slice(1).forEach((end, k) => {
    const start = stroke[k], way = [end[0] - start[0], end[1] - start[1]], length = Math.hypot(...way) * size, count = Math.ceil(length / (1.1 * radius));
    for (let j = 0; j <= count; ++j) {
      const x = corner[0] + size * (1.25 * i + start[0] + (way[0] * j) / count), y = corner[1] + size * (start[1] + (way[1] * j) / count);
      drops.push({ from: plus(plus(back.map((b) => 2.5 * b), right, x), up, y), way: back.map((b) => -b), radius, wetness });
    }
  })));
  return drops;
}
const wetLetters = {
  name: 'wet-letters', shape: 'bunny',
  drops: () => stamped('WET', { corner: [-0.34, -0.24], size: 0.23, radius: 0.034, wetness: 0.85 }),
  settings: { ...bunnyCoat, furLength: 0.055, gravity: 0.1 }, camera: { ...bunnyView, distance: 2, target: [0.1, -0.1, 0] },
};

// Figure 4: the shape factor w, 0 and 1.
const shaped = (name, clumpShape) => ({
  name, shape: 'sphere',
  drops: () => Array.from({ length: 130 }, (_, i) => {
    const y = 1 - (2 * i + 1) / 130, angle = i * Math.PI * (3 - Math.sqrt(5)), r = Math.sqrt(1 - y * y), out = [r * Math.cos(angle), y, r * Math.sin(angle)];
    return { from: out.map((x) => 2 * x), way: out.map((x) => -x), radius: 0.2, wetness: 0.8 };
  }),
  settings: { ...classic, clumpShape, furLength: 0.3, repeat: 3, layers: 48, gravity: 0, dryRate: 0, density: 0.9 },
  camera: { yaw: 0.3, pitch: 0.25, distance: 4 },
});

// Figure 5: the tile before and after, side by side.
const wetTile = {
  name: 'wet-tile', shape: 'plane',
  drops: () => Array.from({ length: 50 }, (_, i) => {
    const row = Math.floor(i / 5), x = 0.07 + 0.14 * (i % 5) - (row % 2 ? 0 : 0.035), z = -0.63 + 0.14 * row;
    return { from: [x, 1, z], way: [0, -1, 0], radius: 0.085, wetness: 0.82 };
  }),
  settings: { ...classic, furLength: 0.16, repeat: 3, gravity: 0, dryRate: 0, ground: false },
  camera: { yaw: 0, pitch: 1.0, distance: 2.6 },
};

export const scenes = [
  fiveCoats, shells(8), shells(16), shells(32), fins('fins-everywhere', 'all'), fins('fins-outline', 'outline'), fading, variance, interpolation,
  wetBunny, halfWet, wetLetters, shaped('wet-straight', 0), shaped('wet-bent', 1), wetTile,
  ...hairstyles,
];

const stateOf = ({ settings, camera }) => ({ version: 1, settings, camera: { target: [0, 0, 0], ...camera } });

/** What wet-fur-make-assets reads as WATER. */
export function waterBytes(scene) {
  const drops = scene.drops(), text = JSON.stringify(stateOf(scene)), bytes = new DataView(new ArrayBuffer(4 + 32 * drops.length));
  bytes.setUint32(0, drops.length, true);
  drops.forEach(({ from, way, radius, wetness }, i) => [...from, ...way, radius, wetness].forEach((x, k) => bytes.setFloat32(4 + 32 * i + 4 * k, x, true)));
  return Buffer.concat([Buffer.from(bytes.buffer), Buffer.from(text.padEnd(Math.ceil(text.length / 4) * 4))]);
}

/** What it reads as HAIR. */
export const hairText = (scene) => [JSON.stringify(stateOf(scene)), ...scene.steps()].join('\n');

/** Writes every dry scene as `folder`/name.glb, unless they are newer than what they are made of. */
export function makeScenes(folder) {
  const dry = scenes.filter(({ body }) => body), files = dry.map(({ name }) => join(folder, `${name}.glb`));
  const changed = (file) => statSync(file, { throwIfNoEntry: false })?.mtimeMs ?? 0;
  const sources = ['scenes', 'shapes', 'furGlb'].map((name) => fileURLToPath(new URL(`${name}.mjs`, import.meta.url)));
  if (Math.min(...files.map(changed)) > Math.max(...sources.map(changed))) return;
  for (const [i, scene] of dry.entries()) writeFileSync(files[i], furGlb(scene.body(), { ...scene, state: stateOf(scene) }));
}
