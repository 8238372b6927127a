// Small pictures for the reference: what the two ends of a setting look like, and each view. They lie in docs/pictures as the others do; of
// a setting that is new there is none until `npm run docs` has drawn it.
import { existsSync } from 'node:fs';
import { fileOf } from './pictures.mjs';

const size = [180, 135], samples = 8, bytes = 6500;
const ball = { src: 'sphere', camera: [0.35, 0.3, 3], set: { furLength: 0.16, repeat: 3 } };
const hair = { src: 'hair-shoulder' };
const bunny = { src: 'bunny', camera: [0.35, 0.2, 3.4] };
const whisker = { ...ball, draw: ['--whisker', '90,60,120,20', '--whisker', '70,70,20,60'] };
const on = (set, base = ball) => ({ ...base, set: { ...base.set, ...set } });

/** What does not show in a still picture, and needs none. */
const none = new Set([
  'seed', 'brushRadius', 'brushFlow', 'dryRate', 'stayWet', 'groomStrength', 'brushFalloff', 'mirror', 'paintColor', 'cutLength', 'brushErases', 'scalpMap', 'groomType', 'whiskerSpread',
  'whiskerStiffness', 'hairTransparency', 'hairModel', 'gust', 'breath', 'behaviour', 'animation', 'animationSpeed', 'inertia', 'cameraMode', 'tileSize', 'hairVolume', 'turbulence', 'textureAmount',
  'lightFollowsCamera', 'bendCurve', 'skyColor', 'groundColor', 'printedMask',
]);
/** Where it shows best; `ends` in place of those of its range. */
const scenes = {
  ...Object.fromEntries(['lockSize', 'roll', 'stray', 'tipBreak'].map((name) => [name, on({ clump: 1, furLength: 0.25, repeat: 2 })])),
  undercoatLength: on({ undercoat: 1, density: 0.4 }), ...Object.fromEntries(['combX', 'combY', 'combZ'].map((name) => [name, on({ combStrength: 0.8, combX: 0, combY: 0, combZ: 0 })])),
  furMapping: bunny, layers: on({ technique: 'shells' }), repeat: ball, furLength: { ...ball, ends: [0.02, 0.4], camera: [0.35, 0.3, 4.2] }, finEdges: { src: 'fins-outline' }, fins: on({ technique: 'shells', layers: 12 }),
  shells: { src: 'fins-outline', set: { view: 'final' } }, skin: on({ density: 0.2 }),
  printedLobe: on({ technique: 'shells', specular: 1.5 }), printedClumps: { ...on({ technique: 'shells' }, bunny), wetness: 0.7 }, printedLight: { ...on({ technique: 'shells' }, bunny), wetness: 0.7 },
  rimColor: on({ rimLight: 2.5, lightIntensity: 0.5 }), skinColor: on({ density: 0.15 }), strandModel: hair, shadowSize: on({ shadows: 'layers', lightPitch: 0.5 }, hair), shadows: on({ lightPitch: 0.5 }, bunny),
  ...Object.fromEntries(['clumpShape', 'wetDarkening', 'wetGloss', 'clumpSize'].map((name) => [name, { ...on({ furLength: 0.14 }, bunny), wetness: 0.65 }])),
  rain: { ...bunny, draw: ['--time', '3'] }, type2: { src: 'interpolation', ends: ['bald', 'persian'] }, type3: { src: 'interpolation', ends: ['bald', 'persian'] }, type4: { src: 'five-coats', ends: ['bald', 'wool'] },
  ...Object.fromEntries(['whiskerLength', 'whiskerWidth', 'whiskerHairs', 'whiskerColor'].map((name) => [name, whisker])),
  hairDetail: { ...hair, ends: ['strips', 'strands'] }, hairOcclusion: hair, hairView: { ...hair, ends: ['guides', 'influence'] },
  ...Object.fromEntries(['wind', 'gravity', 'windYaw'].map((name) => [name, on({ furLength: 0.3, lie: 0, ...name === 'windYaw' ? { wind: 0.7 } : {} })])), stiffness: on({ gravity: 0.8, furLength: 0.3, lie: 0 }),
  ballSize: { ...on({ furLength: 0.25 }), draw: ['--hold', 'ball,0.5'] }, ground: bunny, refine: { ...ball, ends: [false, true] }, view: { ...ball, ends: ['final', 'exploded'] }, viewLayer: on({ view: 'layer' }),
  exposure: { ...ball, ends: [0.4, 2] }, lightIntensity: { ...ball, ends: [0, 2] }, ambient: { ...ball, ends: [0, 1.2] }, technique: on({ layers: 16 }, bunny),
};

function endsOf({ type, name, min, max, options, default: standard }) {
  if (scenes[name]?.ends) return scenes[name].ends;
  if (type === 'bool') return [false, true];
  if (type === 'color') return [standard, '#c0392b'];
  return type === 'choice' ? [options[0], options.at(-1)] : [min, max];
}

/** The image for a page below reference/; undefined while it has not been drawn. */
function image(name, picture, alt, wanted) {
  wanted.set(name, picture);
  if (!existsSync(fileOf(name))) return undefined;
  return { src: `../pictures/${name}`, alt, size: { width: picture.parts.length * size[0] + 2 * (picture.parts.length - 1), height: size[1] } };
}

export function settingPicture(field, wanted) {
  if (none.has(field.name)) return undefined;
  const { ends: _, ...scene } = scenes[field.name] ?? ball, ends = endsOf(field);
  const parts = ends.map((value) => ({ ...scene, set: { ...scene.set, [field.name]: value }, size, samples: field.name === 'refine' && value === false ? 1 : samples }));
  return image(`setting-${field.name}.webp`, { parts, bytes }, `${field.label}: ${ends.join(' and ')}`, wanted);
}

export function viewPicture(view, wanted) {
  const scene = { wetness: { ...bunny, wetness: 0.6 }, clumps: { ...bunny, wetness: 0.6 }, types: { src: 'interpolation' }, dominance: { src: 'interpolation' }, forces: on({ wind: 0.4, lie: 0 }) }[view] ?? bunny;
  // What is counted is what a moving picture costs: samples after the first take shorter steps.
  const counts = view === 'overdraw' || view === 'steps';
  return image(`view-${view}.webp`, { parts: [{ ...scene, set: { ...scene.set, view }, size: [240, 180], samples: counts ? 1 : samples }], bytes }, `The view ${view}`, wanted);
}
