// What long hair takes, in WebAssembly in one browser, round by round, so that the machine's drift cancels:
// node tests/bench/hair.mjs [--parts near,far,uploads,planting] [--rounds 9] [--frames 4] [--size 800x600] [--aa 1] [--shots folder].
//
// near   hair on a bare model, lit and shadowed, against the same geometry drawn plain (PLAIN in hair.frag); `own`: the same less
//        what the frame takes without hair. Once as it stands still, once as it swings: then its points and shadows are drawn
//        anew each frame, plain without shadows.
// far    a coat's frame with hair 40 pixels high against that without
// then   bytes uploaded, and how long changed values take to be seen: how long planting takes (fewer wisps: what else there is).
import { mkdir } from 'node:fs/promises';
import { join } from 'node:path';
import { column, median, readOptions, timeInTurn, withBrowser } from './browser.mjs';

const options = readOptions({ parts: 'near,far,uploads,planting', rounds: '9', frames: '4', size: '800x600', aa: '1', shots: '' });
const [width, height] = options.size.split('x');
const hair = { guides: 60, guideLength: 0.6, wisps: 600, strands: 33, strandWidth: 0.004 };
const bare = { furLength: 0, ground: false };
const storm = { wind: 0.6, gust: 0.6, turbulence: 0.5 };

const query = (values) => new URLSearchParams({
  page: 'hair', mesh: 'plain-bunny', width, height, aa: options.aa,
  ...Object.fromEntries(Object.entries(values).map(([name, value]) => [name, typeof value === 'object' ? JSON.stringify(value) : value])),
}).toString();

async function timed(open, cases, title) {
  const tabs = {};
  for (const [name, values] of Object.entries(cases)) {
    tabs[name] = await open(query(values));
    if (options.shots) await tabs[name].screenshot({ path: join(options.shots, `${title}-${name}.png`.replaceAll(' ', '-')) });
  }
  const rounds = await timeInTurn(tabs, Number(options.rounds), Number(options.frames));
  for (const tab of Object.values(tabs)) await tab.close();
  return (what) => median(rounds.map(what));
}

const row = (...cells) => console.log(cells.map((cell, i) => (i ? column(cell, 10) : cell.padEnd(20))).join(' '));
const ms = (value) => value.toFixed(1), ratio = (value) => value.toFixed(2);

async function near(open) {
  row('near', 'without', 'plain', 'shaded', 'ratio', 'own');
  for (const [motion, dt] of [['still', 0], ['swinging', 1 / 60]])
    for (const hairDetail of ['strips', 'strands']) {
      const settings = { ...bare, ...dt && storm, hairDetail };
      const cases = { without: { settings, dt }, plain: { settings, dt, hair, plain: 1 }, hair: { settings, dt, hair } };
      const of = await timed(open, cases, `${hairDetail} ${motion}`);
      row(`${hairDetail}, ${motion}`, ms(of((r) => r.without)), ms(of((r) => r.plain)), ms(of((r) => r.hair)),
        ratio(of((r) => r.hair / r.plain)), ratio(of((r) => (r.hair - r.without) / (r.plain - r.without))));
    }
}

async function far(open) {
  console.log();
  row('far', 'without', 'with', 'ratio');
  for (const [motion, dt] of [['still', 0], ['swinging', 1 / 60]]) {
    // From as far and as wide as it goes.
    const settings = { fieldOfView: 85, ...dt && storm }, distance = 20;
    const of = await timed(open, { without: { settings, dt, distance }, hair: { settings, dt, distance, hair } }, `far ${motion}`);
    row(motion, ms(of((r) => r.without)), ms(of((r) => r.hair)), ratio(of((r) => r.hair / r.without)));
  }
}

async function uploads(open) {
  const bytes = async (values) => {
    const tab = await open(query(values)), uploaded = await tab.evaluate(() => window.uploaded());
    await tab.close();
    return uploaded;
  };
  const still = await bytes({ settings: bare, hair }), swinging = await bytes({ settings: { ...bare, ...storm }, hair, dt: 1 / 60 });
  const without = await bytes({ settings: { ...bare, ...storm }, dt: 1 / 60 }), asleep = await bytes({ settings: bare });
  console.log(`\nbytes a frame for hair of ${hair.guides} x 8 nodes: ${swinging - without} as it swings, ${still - asleep} asleep`);
}

async function planting(open) {
  const tab = await open(query({ settings: bare, hair }));
  const best = (name, value, other) => tab.evaluate(([n, v, o]) => {
    let least = Infinity;
    for (let i = 0; i < 5; ++i) window.regrow(n, o), (least = Math.min(least, window.regrow(n, v)));
    return least;
  }, [name, value, other]);
  for (const wisps of [10, 600, 1000, 4000]) console.log(`${wisps} wisps, ${wisps * hair.strands} strands: seen after ${ms(await best('wisps', wisps, 0))} ms`);
  await tab.close();
}

if (options.shots) await mkdir(options.shots, { recursive: true });
await withBrowser(async (open) => {
  console.log(`long hair, ${options.size}: median of ${options.rounds} rounds, milliseconds a frame`);
  const parts = { near, far, uploads, planting };
  for (const name of options.parts.split(',')) await parts[name](open);
});
