/** The stages of a block without the command: records in memory, jobs in this thread, as a page may have them. */

import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { errorOf, plainError, runBlock } from '../../pkg/block/index.js';
import { jobs } from '../../pkg/block/jobs.js';
import { BlockOnOrthophoto, BlockScene, grey_png, message, OrthophotoReference } from '../../pkg/node.js';
import { photographed } from './blocks.js';
import { folder, json } from './command.js';

/** @typedef {import('../../pkg/block/index.js').Step} Step @typedef {import('../../pkg/block/index.js').Pool} Pool */

const BLOCK = photographed();
const SOURCES = readdirSync(BLOCK.photos)
  .sort()
  .map((name) => ({ name, bytes: async () => new Uint8Array(readFileSync(join(BLOCK.photos, name))) }));
const OPTIONS = { settings: { features: { multiscale: { number: 1200 } } } };

/** @type {Pool} */
const HERE = { size: 2, run: async (name, input, transfer) => jobs[name](structuredClone(input, { transfer })) };

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
  const cameras = { text: JSON.stringify({ cameras: [{ focal_px: 300, radial: [-0.25, 0, 0] }] }), name: 'cameras.json' };
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
  await refused({ pears: {} }, /pears: unknown field; allowed: /);
});

test('options, images, pool and store that are none are refused by their names, before anything is read', async () => {
  const surroundings = { pool: HERE, store: memory() };
  const read = async () => assert.fail('an image was read');
  const images = [
    { name: 'a.png', bytes: read },
    { name: 'b.png', bytes: read },
  ];
  const refused = (/** @type {any} */ sources, /** @type {any} */ options, /** @type {any} */ around, /** @type {RegExp} */ pattern) =>
    assert.rejects(
      runBlock(sources, options, around),
      (/** @type {any} */ error) =>
        error.name === 'TiepointError' && error.usage && pattern.test(error.message) && error.message === message('error', error.error),
    );
  await refused(images, { setting: {} }, surroundings, /^options: setting: unknown field; allowed: settings, cameras, gps, /);
  await refused(images, { gps: 'no' }, surroundings, /^gps is no; allowed: use, ignore$/);
  await refused(images, { positions: ['a,8,50'] }, surroundings, /^positions is \[1\]; allowed: string$/);
  await refused(images, { cameras: '{}' }, surroundings, /^cameras is \{\}; allowed: \{ name, text \}$/);
  await refused(images, { masks: ['a.png'] }, surroundings, /^masks\[0\] is a\.png; allowed/);
  await refused(['a.png', 'b.png'], {}, surroundings, /^images\[0\] is a\.png; allowed: \{ name, bytes \}$/);
  await refused(images, { cameras: { name: 'cameras.json', text: Buffer.from('{}') } }, surroundings, /^cameras\.text is Uint8Array; allowed: string$/);
  await refused(images, { cameras: { name: 'cameras.json' } }, surroundings, /^cameras\.text is absent; allowed: string$/);
  await refused([{ name: 5, bytes: read }], {}, surroundings, /^images\[0\]\.name is 5 \(number\); allowed: string$/);
  await refused([{ name: 'a.png', bytes: new Uint8Array(2) }], {}, surroundings, /^images\[0\]\.bytes is Uint8Array; allowed: function$/);
  await refused(images, { geoid: { name: 'geoid.tif', bytes: 'geoid' } }, surroundings, /^geoid\.bytes is geoid \(string\); allowed: function$/);
  await refused(images, {}, { pool: HERE, store: new Map() }, /^store is Map; allowed: \{ get, put \}$/);
  for (const size of [NaN, 0, 1.5, 257, '2'])
    await refused(images, {}, { ...surroundings, pool: { ...HERE, size } }, new RegExp(`^pool\\.size is ${size}; allowed: whole numbers from 1 to 256$`));
  await refused(images, {}, { pool: HERE }, /^store is absent; allowed/);
  await refused(images, {}, undefined, /^surroundings is absent; allowed/);
});

test('an image that a worker refuses is skipped and listed, whatever way the refusal took between workers', async () => {
  const broken = { name: 'broken.png', bytes: async () => new Uint8Array([1, 2, 3]) };
  const sources = [...SOURCES.slice(0, 2), broken];
  /** @param {(thrown: unknown) => unknown} carry @returns {Pool} */
  const across = (carry) => ({
    size: 2,
    run: async (name, input, transfer) => {
      try {
        return await HERE.run(name, input, transfer);
      } catch (error) {
        throw carry(structuredClone(plainError(error)));
      }
    },
  });
  for (const carry of [(/** @type {any} */ plain) => errorOf(plain), (/** @type {any} */ plain) => plain]) {
    const run = await runBlock(sources, OPTIONS, { pool: across(carry), store: memory() });
    const { skipped } = run.overview();
    assert.deepEqual(
      skipped.map(({ name }) => name),
      ['broken.png'],
    );
    assert.match(JSON.stringify(skipped), /unsupported-image/);
    run.free();
  }
});

test('an image whose source gives no bytes is skipped and listed, and bytes of shared memory are taken', async () => {
  const shared = SOURCES.slice(0, 2).map(({ name, bytes }) => ({
    name,
    bytes: async () => {
      const file = await bytes();
      const memory = new Uint8Array(new SharedArrayBuffer(file.length + 8), 8);
      memory.set(file);
      return memory;
    },
  }));
  /** @type {any} */
  const given = { 'null.png': null, 'text.png': 'bytes', 'object.png': {} };
  const none = Object.entries(given).map(([name, bytes]) => ({ name, bytes: async () => bytes }));
  const store = memory();
  const run = await runBlock([...shared, ...none], { ...OPTIONS, masks: null }, { pool: HERE, store });
  const { images, skipped } = run.overview();
  assert.deepEqual(
    skipped.map(({ name, reason }) => [name, message('failure', reason)]),
    [
      ['null.png', 'bytes: got null; allowed: Uint8Array'],
      ['text.png', 'bytes: got string; allowed: Uint8Array'],
      ['object.png', 'bytes: got Object; allowed: Uint8Array'],
    ],
  );
  assert.equal(images.length, 2);
  // Records are found by the digests of the files: shared memory has the same.
  let found = 0;
  const progress = (/** @type {Step} */ step) => {
    found = Math.max(found, step.found);
  };
  await runBlock(SOURCES.slice(0, 2), OPTIONS, { pool: HERE, store, progress });
  assert.equal(found, 2);
});

test('images that a finished block does not have, and places without numbers, are refused', async () => {
  const run = await runBlock(SOURCES.slice(0, 2), OPTIONS, { pool: HERE, store: memory() });
  const refused = (/** @type {() => unknown} */ call, /** @type {RegExp} */ pattern) =>
    assert.throws(call, (/** @type {any} */ error) => error.name === 'TiepointError' && pattern.test(error.message));
  refused(() => run.epipolar_line(0, NaN, 5, 1), /^place_px is \[NaN, 5\.0\]; allowed: two finite numbers$/);
  refused(() => run.epipolar_line(0, 5, 5, 2), /got index 2; allowed: indices below 2$/);
  const scene = new BlockScene({ strips: 1, exposures: 2 });
  const reference = OrthophotoReference.open(scene.orthophoto(4).picture);
  const placing = new BlockOnOrthophoto();
  refused(() => placing.place(run, 2, grey_png(64, 48, new Uint8Array(64 * 48)), reference), /got index 2; allowed: indices below 2$/);
  for (const each of [placing, reference, scene, run]) each.free();
});

test('an error passes between workers with its name, code and figures, whatever was thrown', () => {
  const figures = { kind: 'invalid-option' };
  const refusal = Object.assign(new Error('no'), { name: 'TiepointError', code: 'invalid-option', usage: true, error: figures });
  const back = errorOf(structuredClone(plainError(refusal)));
  assert.ok(back instanceof Error);
  assert.deepEqual({ ...back, message: back.message }, { name: 'TiepointError', message: 'no', code: 'invalid-option', usage: true, error: figures });
  assert.deepEqual(plainError('lost'), { name: 'Error', message: 'lost' });
  assert.deepEqual(plainError(undefined), { name: 'Error', message: 'undefined' });
  assert.deepEqual(plainError(new DOMException('gone', 'AbortError')), { name: 'AbortError', message: 'gone' });
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

test('a mask that belongs to none of the images is refused, or listed where that is asked for', async () => {
  const strange = { name: 'zz.png', bytes: async () => grey_png(1, 1, new Uint8Array(1)) };
  const run = (/** @type {object} */ more) => runBlock(SOURCES, { ...OPTIONS, masks: [strange], ...more }, { pool: HERE, store: memory() });
  await assert.rejects(run({}), (/** @type {any} */ error) => {
    assert.deepEqual([error.name, error.code], ['TiepointError', 'invalid-input']);
    assert.match(error.message, /^masks: got zz\.png, which belongs to none of the images; allowed: masks with the names of images/);
    return true;
  });
  await assert.rejects(run({ strayMasks: 'ignore' }), /^TiepointError: strayMasks is ignore; allowed: refuse, list$/);
  const listed = await run({ strayMasks: 'list' });
  assert.deepEqual(listed.overview().unused_masks, ['zz.png']);
});
