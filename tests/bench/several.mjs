// Several fur types, several materials, and saving, in WebAssembly in one browser, round by round, so that the machine's drift cancels:
// node tests/bench/several.mjs [--parts types,materials,saving] [--rounds 9] [--frames 2] [--size 800x600] [--shots folder].
//
// types      four coats of their own with four colour maps on a quarter of the bunny's skin each, by place, against each of them alone
// materials  a bear of six materials, three of them furry, against the same with one material that is bald where that one is bare
// saving     142 thousand triangles, four types, wet
import { mkdir } from 'node:fs/promises';
import { join } from 'node:path';
import { column, median, readOptions, timeInTurn, withBrowser } from './browser.mjs';

const options = readOptions({ parts: 'types,materials,saving', rounds: '9', frames: '2', size: '800x600', shots: '' });
const [width, height] = options.size.split('x');
const query = ({ settings = {}, ...values }) => new URLSearchParams({ page: 'several', mesh: 'plain-bunny', width, height, settings: JSON.stringify(settings), ...values }).toString();

async function timed(open, cases) {
  const tabs = {};
  for (const [name, values] of Object.entries(cases)) {
    tabs[name] = await open(query(values));
    if (options.shots) await tabs[name].screenshot({ path: join(options.shots, `${name.replaceAll(' ', '-')}.png`) });
  }
  const rounds = await timeInTurn(tabs, Number(options.rounds), Number(options.frames));
  for (const tab of Object.values(tabs)) await tab.close();
  const [first] = Object.keys(cases);
  for (const name of Object.keys(cases)) {
    const ratios = rounds.map((round) => round[first] / round[name]);
    console.log(`${name.padEnd(24)} ${column(median(rounds.map((round) => round[name])).toFixed(1), 8)} ms   first / this ${median(ratios).toFixed(2)} (${Math.min(...ratios).toFixed(2)} to ${Math.max(...ratios).toFixed(2)})`);
  }
}

const own = { 'type2.preset': 'rabbit', 'type3.preset': 'otter', 'type4.preset': 'shortCat' };

async function types(open) {
  for (const wetness of [undefined, 0.6]) {
    const wet = wetness ? { wetness } : {};
    console.log(wetness ? '\ntypes, wet' : 'types');
    await timed(open, {
      'four types, four maps': { settings: own, types: 'parts', maps: 4, ...wet }, 'type 1': wet, 'type 1 with a map': { maps: 1, ...wet },
      ...Object.fromEntries(Object.values(own).map((preset) => [preset, { settings: { preset }, ...wet }])),
    });
  }
}

async function materials(open) {
  console.log('\nmaterials');
  await timed(open, { 'six, three of them furry': { mesh: 'bear6' }, one: { mesh: 'bear1', bald: 1 } });
}

async function saving(open) {
  console.log('\nsaving');
  const tab = await open(query({ mesh: 'torus142k', settings: own, types: 'parts', wetness: 0.7, width: 320, height: 240 }));
  for (let i = 0; i < 5; ++i) {
    const { ms, bytes, steps } = await tab.evaluate(() => window.save());
    console.log(`${ms.toFixed(0)} ms; ${(bytes / 2 ** 20).toFixed(1)} MB; ${steps} steps of progress`);
  }
  await tab.close();
}

if (options.shots) await mkdir(options.shots, { recursive: true });
await withBrowser(async (open) => {
  console.log(`${options.size}: median of ${options.rounds} rounds, milliseconds a frame`);
  const parts = { types, materials, saving };
  for (const name of options.parts.split(',')) await parts[name](open);
});
