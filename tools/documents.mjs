// node tools/documents.mjs FOLDER: all .gltf and .glb below it are opened, saved with fur on them, validated by Khronos' validator and
// compared with what they were, and the saved ones once more. Files that are not valid themselves are left out; what is lost,
// what is refused and why is told of each, and at last how many there were. The exit status is 1 where anything is lost or not valid.
import { readFileSync, readdirSync, mkdtempSync, rmSync } from 'node:fs';
import { spawnSync } from 'node:child_process';
import { tmpdir } from 'node:os';
import { basename, dirname, join, relative, resolve } from 'node:path';
import validator from 'gltf-validator';
import { buildNative } from './build.mjs';
import { Stop, command } from './process.mjs';

const kOwn = 'WETFUR_fur';
const onIt = ['--groom', 'vary,0.5', '--wetness', '0.5'];

const isGlb = (bytes) => bytes.subarray(0, 4).toString('latin1') === 'glTF';

/** { json, binary } of a .glb or .gltf. */
function parts(bytes) {
  if (!isGlb(bytes)) return { json: JSON.parse(bytes.toString()), binary: null };
  const length = bytes.readUInt32LE(12), next = 20 + length;
  const binary = next + 8 <= bytes.length ? bytes.subarray(next + 8, next + 8 + bytes.readUInt32LE(next)) : null;
  return { json: JSON.parse(bytes.subarray(20, next).toString()), binary };
}

/** What a URI beside the file at `path`, or in itself, leads to; undefined: nothing. */
function fetched(uri, path) {
  const data = /^data:[^,]*?(;base64)?,(.*)$/s.exec(uri);
  if (data) return data[1] ? Buffer.from(data[2], 'base64') : Buffer.from(decodeURIComponent(data[2]), 'latin1');
  try {
    return readFileSync(join(dirname(path), decodeURIComponent(uri)));
  } catch {
    return undefined;
  }
}

function document(path) {
  const { json, binary } = parts(readFileSync(path));
  const buffers = (json.buffers ?? []).map(({ uri }) => (uri === undefined ? binary : fetched(uri, path)));
  const view = (index) => {
    const { buffer, byteOffset = 0, byteLength } = json.bufferViews[index];
    return buffers[buffer]?.subarray(byteOffset, byteOffset + byteLength);
  };
  const image = ({ uri, bufferView }) => (uri === undefined ? view(bufferView) : fetched(uri, path));
  return { json, view, image };
}

// The members that saving may change, as it says itself (src/scene/export/ExportDocument.cpp): where bytes lie, not what they are.
const mayMove = /^\/(buffers\/\d+(\/(uri|byteLength|name))?|images\/\d+\/uri)$/;

/** Where what came before is not there any more as it was: paths. What has been added is not told. */
function lostBelow(before, after, path = '') {
  if (mayMove.test(path)) return [];
  const isTree = (value) => typeof value === 'object' && value !== null;
  if (!isTree(before)) return Object.is(before, after) ? [] : [path];
  if (!isTree(after) || Array.isArray(before) !== Array.isArray(after)) return [path];
  return Object.entries(before).flatMap(([key, value]) => (key === kOwn ? [] : !(key in after) && !mayMove.test(`${path}/${key}`) ? [`${path}/${key}`] : lostBelow(value, after[key], `${path}/${key}`)));
}

/** The same of bytes: of views and images. */
function lostBytes(before, after) {
  const same = (a, b) => a === undefined || a === null || (b && Buffer.compare(a, b) === 0);
  const ours = ({ name }) => name === kOwn;
  const views = (before.json.bufferViews ?? []).flatMap((view, i) => (ours(view) || same(before.view(i), after.view(i)) ? [] : [`the bytes of /bufferViews/${i}`]));
  const images = (before.json.images ?? []).flatMap((image, i) => (same(before.image(image), after.image(after.json.images[i])) ? [] : [`the bytes of /images/${i}`]));
  return [...views, ...images];
}

async function problemsOf(path) {
  const { issues } = await validator.validateBytes(new Uint8Array(readFileSync(path)), {
    uri: basename(path), maxIssues: 0, externalResourceFunction: async (uri) => {
      const bytes = fetched(uri, path);
      if (!bytes) throw new Error('not there');
      return new Uint8Array(bytes);
    },
  });
  return issues.messages.filter(({ severity }) => severity < 2).map(({ severity, code, pointer }) => ({ severity, code, pointer }));
}
const errorsOf = (problems) => problems.filter(({ severity }) => severity === 0);

/** What is wrong with `saved`, which was opened from `path`. */
async function wrongWith(path, before, saved) {
  // Data in the text of a .gltf stay there: in a .glb that is valid, too, and only larger than need be.
  const known = new Set(['DATA_URI_GLB', ...before.map(({ code }) => code)]);
  const added = (await problemsOf(saved)).filter(({ code }) => !known.has(code)).map(({ code, pointer }) => `${code} at ${pointer}`);
  const [was, is] = [document(path), document(saved)];
  return [...added, ...lostBelow(was.json, is.json), ...lostBytes(was, is)];
}

const keysOf = (json) => {
  const found = new Set(json.extensionsUsed ?? []);
  const look = (value, name) => {
    if (Array.isArray(value)) return value.forEach((one) => look(one, name));
    if (typeof value !== 'object' || value === null) return;
    for (const [key, below] of Object.entries(value)) {
      if (['skin', 'targets', 'sparse', 'matrix', 'camera', 'weights', 'extras', 'animations'].includes(key)) found.add(key);
      if (key === 'texCoord' && below > 0) found.add('texCoord');
      if (name === 'primitives' && key === 'mode' && below !== 4) found.add('mode');
      look(below, key);
    }
  };
  look(json, '');
  return found;
};

await command(async () => {
  const [folder] = process.argv.slice(2);
  if (!folder) throw new Stop('node tools/documents.mjs FOLDER');
  const root = resolve(process.env.INIT_CWD ?? '', folder);
  const files = readdirSync(root, { recursive: true }).filter((name) => /\.gl(tf|b)$/i.test(name)).sort();
  const program = await buildNative('wet-fur-render'), scratch = mkdtempSync(join(tmpdir(), 'wet-fur-documents-'));
  const counts = { found: files.length, 'not valid themselves': 0, refused: 0, 'saved whole': 0, lacking: 0 }, features = new Map(), reasons = new Map();
  try {
    for (const name of files) {
      const path = join(root, name);
      let before;
      try {
        before = await problemsOf(path);
      } catch (error) {
        before = [{ severity: 0, code: String(error), pointer: '' }];
      }
      if (errorsOf(before).length) {
        ++counts['not valid themselves'];
        continue;
      }
      const saved = [1, 2].map((i) => join(scratch, `saved${i}.glb`));
      const save = (from, to, more) => spawnSync(program, [from, '--save-scene', to, ...more], { encoding: 'utf8', timeout: 300000 });
      const first = save(path, saved[0], onIt);
      if (first.status !== 0) {
        const why = first.error ? String(first.error.code) : first.stderr.trim().split('\n').at(-1).replaceAll(path, '').replaceAll(basename(path), '');
        ++counts.refused;
        reasons.set(why, [...reasons.get(why) ?? [], name]);
        continue;
      }
      const wrong = await wrongWith(path, before, saved[0]);
      const second = save(saved[0], saved[1], []);
      wrong.push(...second.status === 0 ? (await wrongWith(saved[0], before, saved[1])).map((one) => `saved again: ${one}`) : [`cannot be opened again: ${second.stderr.trim()}`]);
      ++counts[wrong.length ? 'lacking' : 'saved whole'];
      for (const feature of keysOf(document(path).json)) features.set(feature, (features.get(feature) ?? 0) + 1);
      if (wrong.length) console.log(`${name}\n${wrong.slice(0, 8).map((one) => `  ${one}`).join('\n')}`);
    }
  } finally {
    rmSync(scratch, { recursive: true, force: true });
  }
  for (const [why, names] of reasons) console.log(`refused: ${why}: ${names.map((name) => relative(root, join(root, name))).join(', ')}`);
  console.log(`with ${[...features].sort().map(([feature, count]) => `${feature} ${count}`).join(', ')}`);
  console.log(Object.entries(counts).map(([what, count]) => `${count} ${what}`).join(', '));
  if (counts.lacking) process.exitCode = 1;
});
