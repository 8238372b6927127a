// The still pictures of the pages. What a figure shows before it is live, without scripts and in print, lies in docs/pictures and is part of
// the tree, so that pages are built without a native program; inputs.json says of what each is made, and those for which that has changed
// are drawn anew.
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { webpOf, withTab } from '../photograph.mjs';
import { root, run, say } from '../process.mjs';

export const pictures = join(root, 'docs/pictures');
const inputsFile = join(pictures, 'inputs.json');
export const drawn = join(root, 'build/docs-pictures');  // as PNG, by what they are made of

const optionsOf = (values) => Object.entries(values).flatMap(([name, value]) => [`--${name}`, typeof value === 'boolean' ? String(Number(value)) : String(value)]);

/**
 * What `npm run render` draws for a picture. @param {{ src?: string, preset?: string, light?: string, set?: object, camera?: number[],
 * wetness?: number, draw?: string[], size?: [number, number], samples?: number }} spec
 */
export function renderArguments({ src = 'bunny', preset, light, set = {}, camera, wetness, draw = [], size = [640, 480], samples = 8 }) {
  return [
    src, '--size', size.join('x'), '--samples', String(samples), ...preset ? ['--preset', preset] : [], ...light ? ['--light', light] : [],
    ...camera ? ['--camera', camera.join(',')] : [], ...optionsOf(set), ...wetness === undefined ? [] : ['--wetness', String(wetness)], ...draw,
  ];
}

/**
 * What a picture is made of, as 16 hexadecimal digits: its settings, and the files of animals in it.
 * @param {{ parts: object[], bytes?: number }} picture
 */
export function hashOf({ parts, bytes }) {
  const hash = createHash('sha256').update(JSON.stringify([parts.map(renderArguments), bytes]));
  for (const file of new Set(parts.map(({ src }) => join(root, `assets/${src}.glb`)))) if (existsSync(file)) hash.update(readFileSync(file));
  return hash.digest('hex').slice(0, 16);
}

const readInputs = () => (existsSync(inputsFile) ? JSON.parse(readFileSync(inputsFile, 'utf8')) : {});

/** What the pages that were built last show, for tests. */
export const wantedFile = join(root, 'build/docs-pictures.json');

/** Where a picture lies, or is to lie. */
export const fileOf = (name) => join(pictures, name);

/** Those of `wanted` (a Map of file names) that are not there, or made of something else. */
export function outdated(wanted) {
  const inputs = readInputs();
  return [...wanted].filter(([name, picture]) => inputs[name] !== hashOf(picture) || !existsSync(fileOf(name)));
}

/** Draws, or takes from build/docs-pictures what was drawn before, those of `wanted` that are outdated, and takes away what no page shows any more. Gives how many it drew. */
export async function drawPictures(wanted, program) {
  mkdirSync(pictures, { recursive: true });
  mkdirSync(drawn, { recursive: true });
  const inputs = readInputs(), due = outdated(wanted);
  const write = () => writeFileSync(inputsFile, `${JSON.stringify(Object.fromEntries(Object.entries(inputs).sort()), null, 1)}\n`);
  if (due.length > 0) {
    await withTab(async (tab) => {
      for (const [name, picture] of due) {
        const files = picture.parts.map((part) => {
          const file = join(drawn, `${hashOf({ parts: [part] })}.png`);
          if (!existsSync(file)) run(program, [...renderArguments(part), '-o', file], { quiet: true });
          return file;
        });
        const bytes = await webpOf(tab, files, { quality: 0.86, most: picture.bytes });
        writeFileSync(fileOf(name), bytes);
        say(`${name}: ${bytes.length} bytes`);
        inputs[name] = hashOf(picture);
        write();
      }
    });
  }
  for (const name of readdirSync(pictures).filter((file) => file.endsWith('.webp') && !wanted.has(file))) {
    rmSync(join(pictures, name));
    delete inputs[name];
  }
  write();
  return due.length;
}
