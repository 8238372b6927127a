// npm run animal -- otter [out.glb]: makes an animal anew, by default where it is committed (tools/assets/README.md).
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { animals } from './assets/animals.mjs';
import { build, buildFolder } from './cmake.mjs';
import { Stop, command, root, say } from './process.mjs';
import { needs, setUp } from './setup.mjs';

await command(async () => {
  const [name, out = join(root, `assets/${name}.glb`)] = process.argv.slice(2), animal = animals.find((one) => one.name === name);
  if (!animal) throw new Stop(`npm run animal -- ${animals.map((one) => one.name).join(' | ')}`);
  // FUR_MAKE_ASSETS: a program that is there already.
  const program = process.env.FUR_MAKE_ASSETS ?? join(buildFolder('native-release'), 'wet-fur-make-assets');
  if (!process.env.FUR_MAKE_ASSETS) {
    setUp({ packages: [needs.native], npm: true });
    await build('native-release', ['wet-fur-make-assets']);
  }
  const { file, triangles } = animal.file(program);
  writeFileSync(out, file);
  say(`${out}: ${triangles} triangles, ${file.length} bytes`);
});
