// The program without a window draws every golden scene as its picture shows it.
import assert from 'node:assert/strict';
import { availableParallelism } from 'node:os';
import { test } from 'node:test';
import { drawNatively, judge, scenes } from './golden.mjs';

test('the program without a window', { concurrency: availableParallelism() }, async (suite) => {
  await Promise.all(scenes.map((scene) => suite.test(`draws ${scene.name} as its picture does`, { timeout: 600000 }, async (t) => {
    const { text, wrong } = judge(scene, await drawNatively(scene), 'native');
    t.diagnostic(text);
    assert.equal(wrong, '');
  })));
});
