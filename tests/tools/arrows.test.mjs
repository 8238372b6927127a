import assert from 'node:assert/strict';
import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { arrows, checkTree, violationsIn } from '../../tools/check-arrows.mjs';

const whats = (path, text) => violationsIn(path, text).map(({ line, what }) => `${line} ${what}`);

test('an include along an arrow passes, one against it is named with its line and what is allowed', () => {
  assert.deepEqual(whats('src/dynamics/A.cpp', '#include "geometry/Mesh.h"\n#include "dynamics/B.h"\n#include <vector>\n'), []);
  const [found] = violationsIn('src/dynamics/A.cpp', '#include <vector>\n#include "furgen/FurVolume.h"\n');
  assert.equal(found.line, 2);
  assert.match(found.what, /furgen\/FurVolume\.h/);
  assert.deepEqual(found.allowed, ['core', 'geometry', 'settings']);
});

test('an arrow may lead to one header alone', () => {
  assert.deepEqual(whats('src/wet/A.cpp', '#include "shared/Wet.h"'), []);
  assert.equal(whats('src/wet/A.cpp', '#include "shared/Blocks.h"').length, 1);
});

test('core uses nothing, and no pure module sees gl, render or app', () => {
  for (const name of ['geometry', 'settings', 'scene', 'gl', 'app']) {
    assert.equal(whats('src/core/A.h', `#include "${name}/X.h"`).length, 1, name);
  }
  for (const pure of ['geometry', 'settings', 'furgen', 'wet', 'dynamics', 'hair', 'scene', 'truth']) {
    for (const name of ['gl', 'render', 'editor', 'app']) {
      assert.equal(whats(`src/${pure}/A.h`, `#include "${name}/X.h"`).length, 1, `${pure} -> ${name}`);
    }
  }
});

test('OpenGL headers and calls stay in src/gl', () => {
  assert.deepEqual(whats('src/gl/A.cpp', '#include <GLES3/gl3.h>\nvoid f() { glFlush(); }'), []);
  assert.equal(whats('src/render/A.cpp', '#include <GLES3/gl3.h>').length, 1);
  assert.equal(whats('src/render/A.cpp', 'void f() { glFlush(); }').length, 1);
  assert.deepEqual(whats('src/render/A.cpp', '// glFlush() waits\nconst char* text = "glFlush()"; gl::flush(); object.glow();'), []);
});

test('the viewer never reaches Dear ImGui, the editor part does', () => {
  assert.equal(whats('src/app/App.cpp', '#include <imgui.h>').length, 1);
  assert.equal(whats('src/app/App.cpp', '#include "app/editor/Panel.h"').length, 1);
  assert.deepEqual(whats('src/app/editor/Panel.cpp', '#include <imgui.h>\n#include "app/App.h"\n#include "editor/Panels.h"'), []);
  assert.equal(whats('web/Bindings.cpp', '#include "app/editor/Panel.h"').length, 1);
});

test('render may use scene but not its importers', () => {
  assert.deepEqual(whats('src/render/A.cpp', '#include "scene/Model.h"'), []);
  assert.equal(whats('src/render/A.cpp', '#include "scene/import/Gltf.h"').length, 1);
});

test('render sees plain outputs of wet, dynamics and hair, and never a solver', () => {
  assert.deepEqual(whats('src/render/A.cpp', '#include "wet/Drop.h"\n#include "wet/MaskTexels.h"\n#include "wet/Puddles.h"'), []);
  for (const solver of ['wet/Water.h', 'wet/WetnessMask.h', 'wet/SurfaceWetting.h', 'dynamics/BendField.h', 'hair/StrandShading.h']) {
    assert.equal(whats('src/render/passes/drop/A.cpp', `#include "${solver}"`).length, 1, solver);
  }
});

test('a path that climbs out of its folder is no way round', () => {
  assert.equal(whats('src/core/A.cpp', '#include "../render/Renderer.h"').length, 1);
});

test('__EMSCRIPTEN__ is for web/ and one file of src/gl', () => {
  assert.equal(whats('src/app/A.cpp', '#ifdef __EMSCRIPTEN__').length, 1);
  assert.deepEqual(whats('web/A.cpp', '#ifdef __EMSCRIPTEN__'), []);
  assert.deepEqual(whats('src/app/A.cpp', '// __EMSCRIPTEN__'), []);
});

test('a tree is checked file by file, and a second __EMSCRIPTEN__ in src/gl is found', (t) => {
  const tree = mkdtempSync(join(tmpdir(), 'wet fur arrows '));
  t.after(() => rmSync(tree, { recursive: true }));
  const put = (path, text) => {
    mkdirSync(dirname(join(tree, path)), { recursive: true });
    writeFileSync(join(tree, path), text);
  };
  put('src/core/Math.h', '#pragma once\n');
  put('src/gl/Api.h', '#ifdef __EMSCRIPTEN__\n#endif\n');
  assert.deepEqual(checkTree(tree), []);
  put('src/gl/Other.cpp', '#ifdef __EMSCRIPTEN__\n#endif\n');
  put('src/dynamics/deep/Bad.cpp', '\n#include "app/App.h"\n');
  const lines = checkTree(tree);
  assert.equal(lines.length, 2);
  assert.match(lines[0], /^src\/dynamics\/deep\/Bad\.cpp:2: includes app\/App\.h; src\/dynamics may use: core, geometry, settings$/);
});

test('every module of src has its arrows', async () => {
  const { readdirSync } = await import('node:fs');
  const { root } = await import('../../tools/process.mjs');
  for (const entry of readdirSync(join(root, 'src'))) assert.ok(arrows[`src/${entry}`], entry);
});
