/** The stages of a block without the command: records in memory, jobs in this thread, as a page may have them. */

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { runBlock } from '../../pkg/block/index.js';
import { jobs } from '../../pkg/block/jobs.js';
import '../../pkg/node.js';
import { photographed } from './blocks.js';
import { folder, json } from './command.js';

/** @typedef {import('../../pkg/block/index.js').Step} Step @typedef {import('../../pkg/block/index.js').Pool} Pool */

const BLOCK = photographed();
const SOURCES = readdirSync(BLOCK.photos)
  .sort()
  .map((name) => ({ name, bytes: async () => new Uint8Array(readFileSync(join(BLOCK.photos, name))) }));
const OPTIONS = { settings: { features: { multiscale: { number: 1200 } } } };

/** @type {Pool} */
const HERE = { size: 2, run: async (name, input, transfer) => jobs[name](structuredClone(input, { transfer: /** @type {ArrayBuffer[]} */ (transfer) })) };

function memory() {
  /** @type {Map<string, Uint8Array>} */
  const records = new Map();
  return {
    records,
    get: async (/** @type {string} */ key) => records.get(key) ?? null,
    put: async (/** @type {string} */ key, /** @type {Uint8Array} */ record) => void records.set(key, record),
  };
}

test('without the command the same project comes out', async () => {
  const out = folder();
  json(...BLOCK.call, '--out', out);
  const run = await runBlock(SOURCES, OPTIONS, { pool: HERE, store: memory() });
  assert.equal(run.project(), readFileSync(join(out, 'project.tiepoint'), 'utf8'));
});

test('an aborted run rejects with the reason, and goes on where it stood', async () => {
  const store = memory();
  const abort = new AbortController();
  const reason = new Error('enough');
  const progress = (/** @type {Step} */ { stage, done }) => {
    if (stage === 'pairs' && done === 4) abort.abort(reason);
  };
  await assert.rejects(runBlock(SOURCES, OPTIONS, { pool: HERE, store, progress, signal: abort.signal }), reason);
  const kept = store.records.size;
  assert.ok(kept >= 10 && kept < 21, `${kept}`);
  /** @type {Step[]} */
  const steps = [];
  await runBlock(SOURCES, OPTIONS, { pool: HERE, store, progress: (step) => steps.push(step) });
  const last = (/** @type {string} */ stage) => steps.filter((step) => step.stage === stage).at(-1);
  assert.deepEqual([last('images')?.found, last('pairs')?.found], [6, kept - 6]);
  for (const stage of ['images', 'pairs', 'points', 'orientation']) {
    const own = steps.filter((step) => step.stage === stage);
    assert.ok(
      own.every((step, i) => step.done === i && step.total === own.length - 1),
      stage,
    );
  }
  assert.equal(last('pairs')?.secondsLeft, 0);
  // The first job of each worker says nothing of the next ones.
  const hasty = steps.filter(
    ({ stage, done, found, total, secondsLeft }) => stage === 'pairs' && done - found < 2 * HERE.size && done < total && secondsLeft !== undefined,
  );
  assert.deepEqual(hasty, []);
});

test('a pair whose worker breaks down is told as failed, and tried again the next time', async () => {
  const store = memory();
  let calls = 0;
  /** @type {Pool} */
  const weak = {
    size: 1,
    run: (name, input, transfer) => {
      if (JSON.parse(input.task).kind === 'pair' && ++calls === 3) return Promise.reject(Object.assign(new Error('unreachable'), { name: 'RuntimeError' }));
      return HERE.run(name, input, transfer);
    },
  };
  const first = await runBlock(SOURCES, OPTIONS, { pool: weak, store });
  const failed = first.overview().pairs.filter(({ outcome }) => outcome.kind === 'failed');
  assert.deepEqual(
    failed.map(({ outcome }) => outcome),
    [{ kind: 'failed', failure: { kind: 'out_of_memory', message: 'unreachable' } }],
  );
  const second = await runBlock(SOURCES, OPTIONS, { pool: HERE, store });
  assert.ok(second.overview().pairs.every(({ outcome }) => outcome.kind !== 'failed'));
});

test('features where the distortion has no inverse are left out of their pairs alone', async () => {
  const cameras = { text: JSON.stringify({ cameras: [{ focal_px: 300, radial: [-0.9, 0, 0] }] }), name: 'cameras.json' };
  const run = await runBlock(SOURCES, { ...OPTIONS, cameras }, { pool: HERE, store: memory() });
  const { pairs } = run.overview();
  const reasons = pairs.map(({ reason }) => reason);
  assert.ok(
    reasons.every((reason) => !reason.includes('inverse')),
    reasons.join('\n'),
  );
  assert.ok(
    pairs.some(({ geometry }) => geometry !== null),
    reasons.join('\n'),
  );
});

test('options outside their range end the run, and name themselves', async () => {
  const refused = (/** @type {any} */ settings, /** @type {RegExp} */ pattern) =>
    assert.rejects(
      runBlock(SOURCES, { settings }, { pool: HERE, store: memory() }),
      (/** @type {any} */ error) => error.name === 'TiepointError' && error.usage && pattern.test(error.message),
    );
  await refused({ pairs: { least_matches: 1 } }, /pairs\.least_matches is 1; allowed/);
  await refused({ features: { multiscale: { contrast: -1 } } }, /multiscale\.contrast is -1; allowed/);
  await refused({ nearest: { ratio: NaN } }, /NaN/);
  await refused({ pears: {} }, /unknown field `pears`/);
});

test('two images of one name, and a single image, are refused', async () => {
  const [one] = SOURCES;
  assert.ok(one);
  const surroundings = { pool: HERE, store: memory() };
  await assert.rejects(runBlock([one, one], OPTIONS, surroundings), /images of the block: got two with the name photo_00000\.png; allowed: each name once/);
  await assert.rejects(runBlock([one], OPTIONS, surroundings), /images of the block: got 1 that could be read, of 1; allowed: two or more/);
  await assert.rejects(runBlock([], OPTIONS, surroundings), /got 0 that could be read, of 0/);
  const broken = { ...one, name: 'a\nb.png' };
  await assert.rejects(runBlock([broken, one], OPTIONS, surroundings), /the name "a\\nb\.png", which holds a control character; allowed: names without them/);
});
