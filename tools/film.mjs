// npm run film: docs/otter-turn.webp, the animated picture at the top of the README: the otter turns once, gets wet and dries again. Frames
// are drawn by the native program; the browser packs each as WebP, and here they become one file.
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { buildNative } from './build.mjs';
import { webpOf, withTab } from './photograph.mjs';
import { command, root, run, say } from './process.mjs';
import { needs, setUp } from './setup.mjs';

const frames = 36, size = [480, 360], milliseconds = 110, quality = 0.6;

const bytes24 = (x) => [x & 255, (x >> 8) & 255, (x >> 16) & 255];
function chunk(name, ...parts) {
  const body = Buffer.concat(parts.map((part) => Buffer.from(part))), head = Buffer.alloc(8);
  head.write(name, 0, 'latin1');
  head.writeUInt32LE(body.length, 4);
  return Buffer.concat([head, body, Buffer.alloc(body.length % 2)]);
}

/** The chunk with the picture of a still WebP without alpha. */
function pictureOf(webp) {
  for (let at = 12; at < webp.length;) {
    const length = webp.readUInt32LE(at + 4);
    if (webp.toString('latin1', at, at + 3) === 'VP8' && webp[at + 3] !== 0x58) return webp.subarray(at, at + 8 + length + length % 2);
    at += 8 + length + length % 2;
  }
  throw new Error('a WebP without a picture');
}

/** Still WebP files as one that is shown over and over (the container of RFC 9649). */
export function animated(stills, [width, height], duration) {
  const canvas = [...bytes24(width - 1), ...bytes24(height - 1)];
  const all = Buffer.concat([
    Buffer.from('WEBP', 'latin1'), chunk('VP8X', [2, 0, 0, 0], canvas), chunk('ANIM', [255, 255, 255, 255, 0, 0]),
    ...stills.map((still) => chunk('ANMF', [0, 0, 0, 0, 0, 0], canvas, bytes24(duration), [2], pictureOf(still))),
  ]);
  const head = Buffer.alloc(8);
  head.write('RIFF', 0, 'latin1');
  head.writeUInt32LE(all.length, 4);
  return Buffer.concat([head, all]);
}

/** @param {string} program wet-fur-render */
export async function film(program) {
  const folder = join(root, 'build/film');
  mkdirSync(folder, { recursive: true });
  await withTab(async (tab) => {
    const stills = [];
    for (let i = 0; i < frames; ++i) {
      const turn = i / frames, file = join(folder, `${i}.png`);
      // Wet from a sixth of the turn to a half, dry again at its end.
      const wet = Math.max(0, Math.min((turn - 0.12) / 0.22, 1, (0.95 - turn) / 0.3)) * 0.78;
      run(program, ['otter', '-o', file, '--size', size.join('x'), '--samples', '8', '--behaviour', 'none', '--camera', [0.5 + 2 * Math.PI * turn, 0.16, 2.65].join(','), ...wet > 0 ? ['--wetness', wet.toFixed(3)] : []], { quiet: true });
      stills.push(await webpOf(tab, [file], { quality, alpha: false }));
    }
    const bytes = animated(stills, size, milliseconds);
    writeFileSync(join(root, 'docs/otter-turn.webp'), bytes);
    say(`docs/otter-turn.webp: ${bytes.length} bytes`);
  });
}

if (process.argv[1]?.endsWith('film.mjs')) {
  await command(async () => {
    setUp({ packages: [needs.headless, needs.browser], npm: true });
    await film(await buildNative('wet-fur-render'));
  });
}
