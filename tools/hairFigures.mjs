// npm run hair [-- NAME ...]: docs/hair*.jpg, the heads with long hair and what figures of Halen and Wester (2007) show, side by side;
// all of them, or those of these names.
import { mkdirSync } from 'node:fs';
import { join } from 'node:path';
import { buildNative } from './build.mjs';
import { inline, photograph } from './photograph.mjs';
import { command, root, run } from './process.mjs';
import { needs, setUp } from './setup.mjs';

const size = { width: 270, height: 300 };  // drawn twice as large
const front = '0.5,0.1,2.5,0,0.2,0', behind = '2.4,0.15,2.7,0,0.1,0', side = '1.2,0.15,2.6,0,0.15,0';
const shadowSizes = [32, 64, 128, 256];

// Each picture: what it is called, the scene, the camera, and settings over the scene's.
const figures = {
  'hair': {
    columns: 3,
    pictures: [front, behind].flatMap((camera) => [['Short', 'hair-short', camera], ['To the shoulders', 'hair-shoulder', camera], ['Pony tail', 'hair-pony', camera]]),
  },
  // Figure 5.7.3.
  'hair-shadow': {
    columns: 3,
    pictures: [['Without', 'none'], ['Opacity maps', 'layers'], ['Depth', 'depth']].map(([label, shadows]) => [label, 'hair-shoulder', side, '--lightYaw', '0.1', '--shadows', shadows]),
  },
  // Figure 5.7.4.
  'hair-occlusion': {
    columns: 2,
    pictures: [['Without occlusion', '0'], ['With', '1']].map(([label, share]) => [label, 'hair-shoulder', '0.4,-0.1,2.3,0,0.1,0', '--lightIntensity', '0.1', '--ambient', '1.5', '--fillLight', '0', '--hairOcclusion', share]),
  },
  // Figure 5.8.2.
  'hair-light': {
    columns: 2,
    pictures: [['Marschner', 'marschner'], ['Kajiya and Kay', 'kajiya']].map(([label, model]) => [label, 'hair-shoulder', '2.4,0.15,2.1,0,0.25,0', '--lightYaw', '1.9', '--strandModel', model]),
  },
  // Figures 3.3 and 6.1.4.
  'hair-shadow-sizes': {
    columns: shadowSizes.length,
    pictures: [['Opacity maps', 'layers'], ['Depth', 'depth']].flatMap(([label, shadows]) =>
      shadowSizes.map((texels) => [`${label}, ${texels} x ${texels}`, 'hair-pony', behind, '--shadows', shadows, '--shadowSize', String(texels), '--lightYaw', '1.7'])),
  },
  // The three simulations that figure 6.1.1 times, in the same wind.
  'hair-motion': {
    columns: 3,
    pictures: [['Springs', 'spring'], ['Cascading spaces', 'cascade'], ['Interactive forest', 'forest']].map(([label, model]) =>
      [label, 'hair-shoulder', behind, '--hairModel', model, '--wind', '0.8', '--windYaw', '1.6', '--time', '3']),
  },
};

const page = ({ columns, pictures }) => `<!doctype html><style>
  body { margin: 0; padding: 8px; display: grid; grid-template-columns: repeat(${columns}, max-content); gap: 8px;
         font: 15px Karla, sans-serif; background: #f6f3ee; color: #2b2622; width: max-content }
  figure { margin: 0 } img { display: block } figcaption { padding: 4px 2px 0 }
</style>${pictures.map(({ label, file }) => `<figure><img width="${size.width}" src="${inline(file)}"><figcaption>${label}</figcaption></figure>`).join('')}`;

await command(async () => {
  setUp({ packages: [needs.headless, needs.browser], npm: true });
  const program = await buildNative('wet-fur-render'), folder = join(root, 'build/hair');
  mkdirSync(folder, { recursive: true });
  const names = process.argv.length > 2 ? process.argv.slice(2) : Object.keys(figures);
  for (const name of names) {
    const { columns, pictures } = figures[name];
    const drawn = pictures.map(([label, scene, camera, ...options], i) => {
      const file = join(folder, `${name}-${i}.png`);
      run(program, [scene, '-o', file, '--size', `${2 * size.width}x${2 * size.height}`, '--camera', camera, ...options], { quiet: true });
      return { label, file };
    });
    await photograph(page({ columns, pictures: drawn }), join(root, `docs/${name}.jpg`));
  }
});
