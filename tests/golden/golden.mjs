// Scenes with the picture that each is to give: NAME.json, told in README.md beside it, and NAME.png.
import { spawn } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { PNG } from 'pngjs';
import { solid } from './solids.mjs';

const folder = dirname(fileURLToPath(import.meta.url));
const root = join(folder, '../..');
export const program = join(root, 'build/native-release/wet-fur-render');
/** Where pictures go that are not what they should be, and how far each was from what it should be. */
export const failedFolder = join(root, 'build/golden/failed');
const measuredFile = ({ name }, by) => join(root, 'build/golden/measured', `${name}-${by}.json`);
export const size = { width: 224, height: 168 };

/** Every scene: what its JSON holds, its name, where its picture lies. */
export const scenes = readdirSync(folder).filter((file) => file.endsWith('.json')).sort().map((file) => {
  const name = basename(file, '.json');
  const scene = JSON.parse(readFileSync(join(folder, file), 'utf8'));
  return { name, picture: join(folder, `${name}.png`), ...scene, settings: { breath: 0, lie: 0, ...scene.settings } };
});
/** What the scene's model is, when this folder makes it: the text of an .obj file. */
export const solidOf = (scene) => scene.solid && solid(scene.solid);
export const mapFile = (scene) => scene.lengthMap && join(folder, scene.lengthMap);

// Seconds: over half a second the fur settles at once.
export const settling = 0.6;
// Water runs meanwhile; and for so long after that, until the fur has followed it.
export const running = ({ model = '', wetness, splashes = [] }) => (wetness || splashes.length || /wet/.test(model) ? 1 : 0);

function argumentsFor({ model, preset, settings = {}, camera, samples = 0, groom = [], wetness, splashes = [], seconds, ...scene }, output) {
  const runs = running({ model, wetness, splashes });
  const option = (name, value) => (value === undefined ? [] : [`--${name}`, String(value)]);
  return [
    model, '-o', output, '--size', `${size.width}x${size.height}`, '--multisampling', String(samples),
    ...option('preset', preset), ...option('camera', camera), ...option('length-map', mapFile(scene)), ...option('wetness', wetness),
    ...groom.flatMap((step) => option('groom', step.join())), ...splashes.flatMap((at) => option('splash', at.join())),
    ...option('time', (runs ? settling + runs : 0) + (seconds ?? 0)), ...Object.entries(settings).flatMap(([name, value]) => option(name, value)),
  ];
}

/** The picture by the program without a window. Rejects when it fails or warns. */
export async function drawNatively(scene) {
  const scratch = mkdtempSync(join(tmpdir(), 'wet-fur-'));
  try {
    const output = join(scratch, 'picture.png');
    const model = scene.solid ? join(scratch, `${scene.solid}.obj`) : scene.model;
    if (scene.solid) writeFileSync(model, solidOf(scene));
    const child = spawn(program, argumentsFor({ ...scene, model }, output), { stdio: ['ignore', 'ignore', 'pipe'] });
    let complaints = '';
    child.stderr.on('data', (text) => { complaints += text; });
    const status = await new Promise((resolve, reject) => child.on('error', reject).on('close', resolve));
    if (status !== 0 || complaints) throw new Error(`${scene.name}: ${complaints || `exit ${status}`}`);
    return PNG.sync.read(readFileSync(output));
  } finally {
    rmSync(scratch, { recursive: true });
  }
}

export const readPicture = (scene) => PNG.sync.read(readFileSync(scene.picture));
export function writePicture(file, picture) {
  mkdirSync(dirname(file), { recursive: true });
  writeFileSync(file, PNG.sync.write(picture, { colorType: 2, deflateLevel: 9 }));
}

const blockSide = 8;
const otherPixel = 12, otherBlock = 4;  // of 255

// Means of a channel over the blocks; a block cut off by an edge is as large as what is left of it.
function blockMeans({ width, height, data }) {
  const columns = Math.ceil(width / blockSide), rows = Math.ceil(height / blockSide);
  const sums = new Float64Array(columns * rows * 3), counts = new Float64Array(columns * rows);
  for (let y = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x) {
      const block = Math.floor(y / blockSide) * columns + Math.floor(x / blockSide);
      ++counts[block];
      for (let k = 0; k < 3; ++k) sums[3 * block + k] += data[4 * (y * width + x) + k];
    }
  }
  return sums.map((sum, i) => sum / counts[Math.floor(i / 3)]);
}

/**
 * How far two pictures of one size are apart:
 *   shade   of 255: mean over blocks of 8 x 8 pixels of how far their mean colours are apart (the greatest of the
 *           channels). Blind to grain: a strand beside where it was does not count, a light that has changed does
 *   blocks  share of those blocks that are over 4 of 255 apart: what has changed in one place only
 *   pixels  share of pixels in which a channel is over 12 of 255 apart: other strands of the same mean colour
 */
export function distance(a, b) {
  if (a.width !== b.width || a.height !== b.height) throw new Error(`${a.width}x${a.height} is not ${b.width}x${b.height}`);
  const [means, others] = [blockMeans(a), blockMeans(b)];
  let sum = 0, far = 0, pixels = 0;
  for (let i = 0; i < means.length; i += 3) {
    const apart = Math.max(...[0, 1, 2].map((k) => Math.abs(means[i + k] - others[i + k])));
    sum += apart;
    far += apart > otherBlock;
  }
  for (let i = 0; i < a.data.length; i += 4)
    pixels += [0, 1, 2].some((k) => Math.abs(a.data[i + k] - b.data[i + k]) > otherPixel);
  const blocks = means.length / 3;
  return { shade: sum / blocks, blocks: far / blocks, pixels: pixels / (a.width * a.height) };
}

/** The measures that are over the scene's tolerance, as text; '' for none. */
export const excess = (scene, measured) => Object.entries(scene.tolerance)
  .filter(([name, most]) => !(measured[name] <= most))
  .map(([name, most]) => `${name} ${measured[name].toPrecision(3)}, ${most} may be`).join('; ');

export const inWords = ({ shade, blocks, pixels }) =>
  `shade ${shade.toFixed(3)}, blocks ${(100 * blocks).toFixed(2)} %, pixels ${(100 * pixels).toFixed(2)} %`;

/** The verdict on a picture; one that fails is kept to be looked at. @returns {{ text: string, wrong: string }} */
export function judge(scene, drawn, by) {
  const measured = distance(readPicture(scene), drawn), wrong = excess(scene, measured);
  mkdirSync(dirname(measuredFile(scene, by)), { recursive: true });
  writeFileSync(measuredFile(scene, by), JSON.stringify(measured));
  if (!wrong) return { text: inWords(measured), wrong };
  const file = join(failedFolder, `${scene.name}-${by}.png`);
  writePicture(file, drawn);
  return { text: inWords(measured), wrong: `${wrong} (${scene.guards}) The picture is in ${file}` };
}

// Never less than what roundings in a few pixels make.
const least = { shade: 0.1, blocks: 0.003, pixels: 0.002 };

/** Twice what the page's picture was apart when it was last judged, written into the scene's file. */
export function renewTolerance({ name }) {
  const file = join(folder, `${name}.json`), json = JSON.parse(readFileSync(file, 'utf8'));
  const measured = JSON.parse(readFileSync(measuredFile({ name }, 'web'), 'utf8'));
  const rounded = (value, step) => Number((Math.ceil(value / step) * step).toFixed(4));
  json.measured = Object.fromEntries(Object.entries(measured).map(([key, value]) => [key, Number(value.toFixed(4))]));
  json.tolerance = Object.fromEntries(Object.entries(measured)
    .map(([key, value]) => [key, Math.max(least[key], rounded(2 * value, key === 'shade' ? 0.05 : 0.001))]));
  writeFileSync(file, `${JSON.stringify(json, null, 2)}\n`);
}
