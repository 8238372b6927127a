// A row that is added to a table of src/ is found wherever its rows are used.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { cpSync, existsSync, mkdtempSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { root } from '../../tools/process.mjs';
import { drawingOf, endings, moduleText, pageText, readTables, rowsOf, typingsText, withEndings } from '../../tools/tables.mjs';

const textOf = (file) => readFileSync(join(root, file), 'utf8');
const dummies = {
  'src/app/tools/Tools.inc': 'FUR_TOOL(Hammer, "hammer", Viewer, Water, Paint, Repeats, 1.0f, "Hit", "Mend", "touch", "waters", "", "hits, once", "Hammer: (hit) it")\n',
  'web/Methods.inc': 'FUR_METHOD(strike, Number, (float u, bool hard), ({u, 0}, hard), Element, "How it rang.")\nFUR_QUERY(dented, Truth, Element, "")\n'
    + 'FUR_METHOD(wobble, Nothing, (), (), Program, "")\n',
  'src/scene/Formats.inc': 'FUR_MODEL_FORMAT(Clay, ".clay .pot", "model/clay", "pot", readClay)\nFUR_FORMAT(Tin, Coat, ".tin", "image/tin", "foil")\n',
  'src/settings/Fields.inc': 'FUR_CHOICE(weather, "Weather", "Water", 0, "fair|foul", "What it is like (\\"outside\\")", kFrequent)\n',
  'assets/Presets.inc': 'FUR_PRESET("yak", "Yak", "Very long",\n           "furLength=0.4 "\n           "wave=1")\n',
  'src/app/tools/GroomEdits.inc': 'FUR_GROOM_EDIT(Shave, "shave", Kept, "value: how close, all over")\n',
};
const withDummies = readTables((file) => textOf(file) + (dummies[file] ?? ''));
const importText = (text) => import(`data:text/javascript,${encodeURIComponent(text)}`);

/** What C++ makes of the tables with the dummies: the output of `program`. */
function fromCpp(program, ...sources) {
  const folder = mkdtempSync(join(tmpdir(), 'wet-fur-tables-'));
  try {
    for (const [file, row] of Object.entries(dummies)) {
      const copy = join(folder, file);
      mkdirSync(dirname(copy), { recursive: true });
      writeFileSync(copy, textOf(file) + row);
    }
    writeFileSync(join(folder, 'dummies.inc'), dummies['web/Methods.inc']);
    writeFileSync(join(folder, 'main.cpp'), program);
    // Beside the copies, so that quoted includes find those first.
    for (const source of sources) cpSync(join(root, source), join(folder, source));
    const compiler = process.env.CXX || 'c++';
    execFileSync(compiler, ['-std=c++20', '-I', folder, '-I', join(folder, 'src'), '-I', join(root, 'src'), join(folder, 'main.cpp'),
      ...sources.map((source) => join(folder, source)), '-o', join(folder, 'main')], { stdio: ['ignore', 'inherit', 'inherit'] });
    return execFileSync(join(folder, 'main'), { encoding: 'utf8' }).split('\n').filter(Boolean);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

test('rows are read as the preprocessor reads them', () => {
  const table = { macro: 'FUR_X', columns: ['id', 'text', 'parameters'] };
  assert.deepEqual(rowsOf('// FUR_X(no, row)\nFUR_X(One, "a, (b) \\"c\\"", (int a, float b))\n  \nFUR_X (Two,\n   "", ())\n', table), [
    { id: 'One', text: 'a, (b) "c"', parameters: '(int a, float b)' },
    { id: 'Two', text: '', parameters: '()' },
  ]);
  assert.throws(() => rowsOf('FUR_X(One, "two")', table), /2 columns of 3/);
});

test('every row of the files is read', () => {
  const { tools, groomEdits, methods, queries, modelFormats, otherFormats } = readTables();
  const rowsIn = (file) => textOf(file).match(/^FUR_\w+ *\(/gm).length;
  assert.equal(tools.length, rowsIn('src/app/tools/Tools.inc'));
  assert.equal(groomEdits.length, rowsIn('src/app/tools/GroomEdits.inc'));
  assert.equal(modelFormats.length + otherFormats.length, rowsIn('src/scene/Formats.inc'));
  assert.equal(methods.length + queries.length, rowsIn('web/Methods.inc'));
  assert.equal(readTables().fields.length, rowsIn('src/settings/Fields.inc'));
  assert.equal(readTables().presets.length, rowsIn('assets/Presets.inc'));
});

test('a new tool is an option of the element, and keys and typings know it', async () => {
  const { toolNames, keyTexts } = await importText(moduleText(withDummies));
  assert.equal(toolNames.at(-1), 'hammer');
  assert.equal(keyTexts.hammer, 'hits, once');
  assert.match(typingsText(withDummies), /export type Tool =[^;]*\| 'hammer';/);
  assert.match(typingsText(withDummies), /'hammer': Hammer: \(hit\) it/);
});

test('a new tool has its button on the page, where the table puts it', () => {
  const page = pageText(textOf('web/index.html'), withDummies, drawingOf);
  const menu = /<div class="panel" id="waters"[\s\S]*?<\/div>/.exec(page)[0];
  assert.match(menu, /<button type="button" data-tool="hammer" aria-pressed="false" title="Hammer: \(hit\) it">Hit<\/button>/);
  const misplaced = { ...withDummies, tools: [{ name: 'hammer', place: 'roof' }] };
  assert.throws(() => pageText(textOf('web/index.html'), misplaced, drawingOf), /no place "roof"/);
});

test('every tool of the bar has a drawing', () => {
  for (const { icon, place, name } of readTables().tools)
    if (place === 'start' || place === 'bar') assert.ok(existsSync(join(root, `web/icons/${icon}.svg`)), name);
});

test('a new setting and a new coat are in the typings', () => {
  const typings = typingsText(withDummies);
  assert.match(typings, /export type Weather = 'fair' \| 'foul';/);
  assert.match(typings, /\/\*\* What it is like \("outside"\)\. \*\/\n {2}weather: Weather;\n/);
  assert.match(typings, /export type PresetName =[^;]*\| 'yak';/);
  assert.deepEqual(withDummies.presets.at(-1).values, 'furLength=0.4 wave=1');
});

test('a new edit of the groom is in the typings', () => {
  assert.match(typingsText(withDummies), /export type GroomEdit =[^;]*\| 'shave';/);
});

test('a new method is one of the program, of the element and of the typings', async () => {
  const { methods, queries, elementMethods, elementQueries } = await importText(moduleText(withDummies));
  assert.deepEqual([methods.Number.at(-1), methods.Nothing.at(-1), queries.Truth.at(-1)], ['strike', 'wobble', 'dented']);
  assert.deepEqual([elementMethods.Number.at(-1), elementMethods.Nothing.includes('wobble'), elementQueries.Truth.at(-1)], ['strike', false, 'dented']);
  const typings = typingsText(withDummies);
  assert.match(typings, /  \/\*\* How it rang\. \*\/\n  strike\(u: number, hard: boolean\): number;\n/);
  assert.match(typings, /\n  readonly dented: boolean;\n/);
  assert.doesNotMatch(typings, /wobble/);
  const odd = { ...withDummies, methods: [{ name: 'odd', result: 'Nothing', parameters: '(void* p)', offered: 'Element', doc: '' }] };
  assert.throws(() => typingsText(odd), /void\* has no type/);
});

test('a new method is called by its name, with its arguments, across the border', () => {
  const binding = textOf('web/AppBindings.cpp');
  const macros = binding.slice(binding.indexOf('namespace crossing'), binding.indexOf('// --- life ---'));
  const lines = fromCpp(`
    #include <cstdint>
    #include <cstdio>
    #include <string>
    #define FUR_EXPORT extern "C"
    struct Place { float x, y; };
    struct App {
      float strike(Place at, bool hard) { return hard ? at.x : at.y; }
      bool dented() { return true; }
      void wobble() { std::printf("wobbled\\n"); }
    };
    template <class Work> auto guarded(Work work) { return work(); }
    ${macros.replace('"web/Methods.inc"', '"dummies.inc"')}
    int main() {
      App app;
      std::printf("%g %g %d\\n", double(fur_strike(&app, 7, true)), double(fur_strike(&app, 7, false)), fur_dented(&app));
      fur_wobble(&app);
    }`);
  assert.deepEqual(lines, ['7 0 1', 'wobbled']);
});

test('what the element offers are methods and getters of both of its classes', () => {
  const { methods, queries } = readTables();
  const written = textOf('web/host.js') + textOf('web/furapp.js') + textOf('web/types/index.d.ts');
  for (const { name } of [...methods, ...queries].filter(({ offered }) => offered === 'Element'))
    assert.doesNotMatch(written, new RegExp(`^ {2}(get |set |async |readonly )?${name}\\b *[(:]`, 'm'), `${name} stands in the table, and by hand`);
});

test('a new format is read where files are opened or dropped, and said to be', async () => {
  const { kindOfEnding } = await importText(moduleText(withDummies));
  assert.deepEqual([kindOfEnding['.clay'], kindOfEnding['.pot'], kindOfEnding['.tin']], ['Model', 'Model', 'Coat']);
  const page = pageText(textOf('web/index.html'), withDummies, drawingOf);
  assert.match(page, /Drop a \.glb, [^<]*\.clay or \.pot model [^<]*, or a coat as [^<]*\.fts or \.tin</);
  assert.match(withEndings(textOf('web/types/index.d.ts'), withDummies), /the address of a \.glb, [^*]*\.clay or \.pot\./);
  assert.deepEqual(endings(withDummies).find(({ ending }) => ending === '.pot'), { ending: '.pot', kind: 'Model', mimeType: 'model/clay' });
});

test('endings stand in the table alone', () => {
  for (const file of ['web/index.html', 'web/page.js', 'web/types/index.d.ts', 'web/types/core.d.ts', 'native/Files.cpp', 'src/scene/import/ImportModel.cpp', 'tools/serve.mjs'])
    assert.doesNotMatch(textOf(file).replace(/['"`(]?models\/[^'"`]*/g, ''), /'\.(glb|obj|fts)'|"\.(glb|obj|fts)"|\.glb, \.gltf/, file);
});

test('C++ knows a new format by its endings, and which reader it has', () => {
  const lines = fromCpp(`
    #include <cstdio>
    #include "scene/Formats.h"
    using namespace fur::scene;
    ${[...new Set(readTables().modelFormats.map(({ reader }) => `void ${reader}() {}`))].join('\n')}
    void readClay() { std::printf("clay is read\\n"); }
    void (*readerOf(Format format))() {
      switch (format) {
    #define FUR_MODEL_FORMAT(id, endings, mime, savedAs, reader) case Format::id: return reader;
    #define FUR_FORMAT(id, ...) case Format::id: return nullptr;
    #include "scene/Formats.inc"
      }
      return nullptr;
    }
    int main() {
      std::printf("%d %d %d\\n", isNamedAs(FileKind::Model, "a.b.POT"), isNamedAs(FileKind::Coat, "a.tin"), isNamedAs(FileKind::Coat, "a.fo"));
      std::printf("%s\\n%s\\n", endingsOf(FileKind::Model).c_str(), saveLabel(Format::Clay).c_str());
      readerOf(*formatNamed("x.clay"))();
    }`, 'src/scene/Formats.cpp');
  const models = endings(readTables()).filter(({ kind }) => kind === 'Model').map(({ ending }) => ending);
  assert.deepEqual(lines, ['1 1 0', `${models.join(', ')}, .clay and .pot`, 'Save pot (.clay)', 'clay is read']);
});

test('the editor of the page has an action for each command that it may be asked, and no other', () => {
  const actions = /#actions = \{([\s\S]*?)\n  \};/.exec(textOf('web/editor.js'))[1];
  const named = [...actions.matchAll(/^    (\w+): /gm)].map(([, name]) => name).sort();
  assert.deepEqual(named, readTables().platformCommands.filter(({ where }) => where === 'Everywhere').map(({ id }) => id).sort());
});

test('C++ knows a new tool and a new edit by their names, and what they do', () => {
  const lines = fromCpp(`
    #include <cstdio>
    #include "app/tools/GroomEdits.h"
    #include "app/tools/Tools.h"
    using namespace fur::app;
    int main() {
      const Tool tool = *toolNamed("hammer");
      std::printf("%d %d %d %s %s\\n", worksOnWater(tool), repeats(tool), tool == Tool::Hammer, wordsOf(tool).label, wordsOf(tool).row);
      std::printf("%d\\n", keepsMasked(*groomEditNamed("shave")));
    }`, 'src/app/tools/Tools.cpp', 'src/app/tools/GroomEdits.cpp');
  assert.deepEqual(lines, ['1 1 1 Hit touch', '1']);
});
