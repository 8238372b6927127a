// The scenes that ship: what the papers' figures show, each with a coat, a look and a camera of its own. Silva et al.
// need none: their figures are the bunny and water.
import { statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { furGlb } from './furGlb.mjs';
import { facets, meshOf, rod, sphere } from './shapes.mjs';

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
  // The first four are the fur types, of full length; the fifth is the first again, shorter and piebald.
  groom: ({ part }) => ({ length: part === 4 ? 0.5 : 1, types: [1, 2, 3].map((type) => Number(type === part)) }),
  colour: (place) => (place.part === 4 ? mix([0.28, 0.2, 0.17], [1, 0.97, 0.9], patches(place.position)) : [1, 1, 1]),
  settings: {
    type2: 'chinchilla', type3: 'thickNylon', type4: 'shortCat', density: 0.95, thickness: 0.3, curl: 0.15, furLength: 0.08,
    repeat: 8, layers: 32, undercoat: 0.6, undercoatLength: 0.6, rootColor: '#8a8078', tipColor: '#f0dfc4', skinColor: '#8a6f66',
    variance: 0.4, gravity: 0.15,
  },
  camera: { yaw: 0.15, pitch: 0.12, distance: 3.1 },
};

// --- Sheppard 2004 ---

// Figure 3.1: 8, 16 and 32 shells.
const shells = (layers) => ({
  name: `shells-${layers}`,
  body: () => meshOf(sphere({ cells: 16 })),
  settings: {
    layers, density: 0.6, thickness: 0.55, lengthVariation: 0.2, curl: 0.35, furLength: 0.22, repeat: 3, gravity: 0.35,
    rootColor: '#4a3424', tipColor: '#d8b483', skinColor: '#7d5a4a', variance: 0.4, fins: false,
  },
  camera: { yaw: 0.35, pitch: 0.3, distance: 3.6 },
});

// Figures 3.2 and 3.3: fins at every edge stand out where one looks on them from above, and they are needed at the
// outline only. Facets that do not meet have borders all round, and a border is an outline from everywhere.
const fins = (name, gap) => ({
  name,
  body: () => meshOf(facets({ gap })),
  settings: {
    view: 'fins', density: 0.6, thickness: 0.5, furLength: 0.16, repeat: 3, layers: 16, gravity: 0, rootColor: '#4a3424',
    tipColor: '#e0bd8e', skinColor: '#a08070',
  },
  camera: { yaw: 0.35, pitch: 0.28, distance: 4.2 },
});

// Figure 3.7: fur that fades towards bald skin grows sparser and shorter, by existence and dominance.
const fading = {
  name: 'fading',
  body: () => meshOf(rod({ half: 0.75, radius: 0.4 })),
  groom: ({ position: [x] }) => ({ types: [smooth(-0.8, 0.8, x)] }),
  settings: {
    type2: 'bald', density: 0.7, thickness: 0.5, lengthVariation: 0.1, curl: 0.2, furLength: 0.13, repeat: 4, layers: 32, gravity: 0.2,
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
    type2: 'rabbit', density: 0.95, thickness: 0.3, curl: 0.15, furLength: 0.11, repeat: 5, undercoat: 0.6, undercoatLength: 0.6,
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
    type2: 'wool', type3: 'otter', density: 1, thickness: 0.28, lengthVariation: 0.2, curl: 0.05, furLength: 0.08, repeat: 6,
    undercoat: 0.3, rootColor: '#8a5a30', tipColor: '#dd9850', skinColor: '#a4735c', specular: 0.5, layers: 32,
  },
  camera: { yaw: 0.15, pitch: 0.2, distance: 3 },
};

export const scenes = [
  fiveCoats, shells(8), shells(16), shells(32), fins('fins-everywhere', 0.02), fins('fins-outline', 0), fading, variance, interpolation,
];

/** Writes every scene as `folder`/name.glb, unless they are newer than what they are made of. */
export function makeScenes(folder) {
  const files = scenes.map(({ name }) => join(folder, `${name}.glb`));
  const changed = (file) => statSync(file, { throwIfNoEntry: false })?.mtimeMs ?? 0;
  const sources = ['scenes', 'shapes', 'furGlb'].map((name) => fileURLToPath(new URL(`${name}.mjs`, import.meta.url)));
  if (Math.min(...files.map(changed)) > Math.max(...sources.map(changed))) return;
  for (const [i, { name, body, groom, colour, mapSize, settings, camera }] of scenes.entries())
    writeFileSync(files[i], furGlb(body(), { name, groom, colour, mapSize, state: { settings, camera: { target: [0, 0, 0], ...camera } } }));
}
