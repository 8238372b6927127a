// Configures and builds a preset.
import { existsSync, mkdirSync, readFileSync, realpathSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { Stop, jobs, root, run, runGathering, say } from './process.mjs';
import { activeEmcc, imguiFolder } from './setup.mjs';

export const buildFolder = (preset) => join(root, 'build', preset);

// What a configured folder depends on beyond its own files. When the compiler or the tree's place has
// changed the folder is made anew; when something optional has come or gone it is configured again.
function surroundings(preset, tests) {
  const emcc = preset.startsWith('web') ? activeEmcc() : undefined;
  return {
    place: root,
    tests,
    compiler: emcc ? `${realpathSync(emcc)} ${statSync(realpathSync(emcc)).mtimeMs}` : '',
    optional: [join(imguiFolder, 'imgui.h'), '/usr/include/GLFW/glfw3.h', '/usr/include/EGL/egl.h', '/usr/include/GLES3/gl3.h',
      '/usr/include/gtest/gtest.h', '/usr/src/googletest'].map((path) => [path, existsSync(path)]),
  };
}

function configure(preset, tests) {
  const folder = buildFolder(preset);
  const record = join(folder, 'wet-fur-surroundings.json');
  const before = existsSync(record) ? JSON.parse(readFileSync(record, 'utf8')) : undefined;
  // A folder that has had tests keeps them.
  const now = surroundings(preset, tests || Boolean(before?.tests));
  if (JSON.stringify(before) === JSON.stringify(now) && existsSync(join(folder, 'build.ninja'))) return;
  if (before && (before.place !== now.place || before.compiler !== now.compiler)) {
    rmSync(folder, { recursive: true, force: true });
  }
  say(`configuring ${preset}`);
  rmSync(record, { force: true });
  run('cmake', ['--preset', preset, `-DFUR_IMGUI_DIR=${imguiFolder}`, `-DFUR_TESTS=${now.tests ? 'ON' : 'OFF'}`], { quiet: true });
  mkdirSync(folder, { recursive: true });
  writeFileSync(record, JSON.stringify(now));
}

/**
 * Builds targets of a preset; nothing to do takes a fraction of a second. `keepGoing`: past what cannot be built; `aside`: while
 * something else goes first, which is then told only when it fails.
 */
export async function build(preset, targets, { keepGoing = false, aside = false } = {}) {
  configure(preset, targets.some((name) => name.endsWith('-tests')));
  say(`building ${targets.join(', ')} (${preset})`);
  const args = ['--build', '--preset', preset, '--parallel', String(jobs), '--target', ...targets, ...keepGoing ? ['--', '-k', '0'] : []];
  if (!aside) return run('cmake', args);
  const { status, output } = await runGathering('cmake', args, { aside });
  if (status === 0) return output;
  process.stderr.write(output);
  throw new Stop(`cmake ${args.join(' ')}: exit ${status}`);
}
