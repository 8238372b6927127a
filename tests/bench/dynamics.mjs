// What a frame of moving fur costs the processor in WebAssembly, on one thread: node tests/bench/dynamics.mjs
// [--rounds 400]. The program's whole tick on a torus of 142 thousand triangles, without a picture: median and best of
// the rounds, in milliseconds.
import { FurApp } from '../../web/furapp.js';
import { benchModel } from './models.mjs';
import { start } from './programs.mjs';

const rounds = process.argv[2] === '--rounds' ? Number(process.argv[3]) : 400;
const program = await start('viewer');
const app = new FurApp(program);
app.loadModel(benchModel('torus142k'), 'torus142k.glb', new Map());
app.resize(800, 600, 1);
const mouse = (phase, x, y, extra = {}) => app.pointer(phase, { pointerType: 'mouse', pointerId: 1, buttons: 1, ...extra }, x, y);

function time(settings, { wetness = 0, each = () => {}, tool = 'none' } = {}) {
  for (const [name, value] of Object.entries({ wind: 0, gust: 0, turbulence: 0, dryRate: 0, breath: 0, lie: 0, animationSpeed: 1, ...settings })) app.setSetting(name, value);
  app.tool = tool;
  app.setWetness(wetness);
  for (let i = 0; i < 300; ++i) app.tick(1 / 60);
  const times = [];
  for (let i = 0; i < rounds; ++i) {
    each(i);
    const begun = performance.now();
    app.tick(1 / 60);
    times.push(performance.now() - begun);
  }
  mouse('up', 0, 0, { buttons: 0 });
  times.sort((a, b) => a - b);
  return { median: +times[rounds >> 1].toFixed(3), best: +times[0].toFixed(3) };
}

// A place on the model's near side, with room to move.
let y = 599;
while (!app.pick(400, y)) --y;
const path = (i) => [400 + 60 * Math.sin(i / 9), y - 40 + 10 * Math.cos(i / 7)];
const dragged = (i) => mouse(i ? 'move' : 'down', ...path(i), { buttons: 2 });
const stroked = (i) => mouse(i ? 'move' : 'down', ...path(i));
const storm = { wind: 0.6, gust: 0.6, turbulence: 0.5 };
const about = () => { const { vertices, triangles } = app.stats; return `${vertices} vertices, ${triangles} triangles`; };
console.log(`torus142k: ${about()}`);
console.table({
  'still': time({}),
  'gusts and eddies': time(storm),
  'dragged about': time({}, { each: dragged }),
  'dragged about in gusts and eddies': time(storm, { each: dragged }),
  'the same, soaked': time(storm, { each: dragged, wetness: 1 }),
  'stroked': time({}, { each: stroked, tool: 'pet' }),
  'stroked in gusts and eddies': time(storm, { each: stroked, tool: 'pet' }),
});
app.loadModel(benchModel('tentacle20k'), 'tentacle20k.glb', new Map());
console.log(`tentacle20k: ${about()}`);
console.table({
  'waves': time({ animation: 1 }),
  'waves in gusts and eddies': time({ ...storm, animation: 1 }),
  'held': time({ animation: 1, animationSpeed: 0 }),
});
process.exit(0);
