import assert from 'node:assert/strict';
import { test } from 'node:test';
import { ThreadPool } from '../../pkg/command/pool.js';
import { spawnSync } from 'node:child_process';
import { breakdownOf } from '../../pkg/block/index.js';
import { explain, oneLine } from '../../pkg/command/errors.js';
import { block_settings, defaults } from '../../pkg/node.js';
import { folder, image, PROGRAM, speckle } from './command.js';

const FEATURES = JSON.stringify({ kind: 'features', key: 'features/none', options: block_settings({}).features, mask: null });

/** Coarse descriptors of images, so many each.  @param {number[]} counts */
const likeness = (...counts) => ({
  task: JSON.stringify({ kind: 'likeness', key: 'likeness/none', counts }),
  inputs: [new Uint8Array(128 * counts.reduce((sum, count) => sum + count, 0))],
});

test('a job that fails rejects by itself, and the others go on', async () => {
  const pool = new ThreadPool(1);
  try {
    const jobs = [
      pool.run('dance', {}),
      pool.run('block', { task: () => 1 }),
      pool.run('block', { task: FEATURES, inputs: [new Uint8Array([1, 2, 3])] }),
      pool.run('block', likeness(1, 1, 0)),
    ];
    const [dance, uncopied, image, alike] = await Promise.allSettled(jobs);
    assert.match(String(dance?.status === 'rejected' && dance.reason), /there is no job dance/);
    assert.match(String(uncopied?.status === 'rejected' && uncopied.reason), /could not be cloned/);
    assert.ok(image?.status === 'rejected' && image.reason.name === 'TiepointError' && image.reason.code === 'unsupported-image', JSON.stringify(image));
    // The record ends with how many descriptors each of the others has in common.
    assert.deepEqual(alike?.status === 'fulfilled' && [...alike.value.slice(-8)], [1, 0, 0, 0, 0, 0, 0, 0]);
  } finally {
    await pool.close();
  }
});

test('a job whose memory has moved elsewhere rejects, and the next one runs', async () => {
  const pool = new ThreadPool(1);
  try {
    const bytes = new Uint8Array(8);
    structuredClone(bytes, { transfer: [bytes.buffer] });
    const [moved, alike] = await Promise.allSettled([pool.run('block', { task: FEATURES, inputs: [bytes] }, [bytes.buffer]), pool.run('block', likeness())]);
    assert.match(String(moved?.status === 'rejected' && moved.reason), /deserialize/);
    assert.equal(alike?.status, 'fulfilled');
  } finally {
    await pool.close();
  }
});

test('a trap is a fault of the program, but for memory that ran out', () => {
  const error = (/** @type {string} */ name, /** @type {string} */ message) => Object.assign(new Error(message), { name });
  for (const [name, message, kind] of /** @type {const} */ ([
    ['RuntimeError', 'unreachable', 'memory'],
    ['RuntimeError', 'memory access out of bounds', 'fault'],
    ['RuntimeError', 'integer divide by zero', 'fault'],
    ['RangeError', 'Array buffer allocation failed', 'memory'],
    ['RangeError', 'Maximum call stack size exceeded', 'fault'],
    ['WorkerError', 'Worker terminated due to reaching memory limit: JS heap out of memory', 'memory'],
    ['WorkerError', 'the worker ended with code 1', 'fault'],
    ['Panic', 'panicked at src/lib.rs', 'fault'],
    ['TiepointError', 'got 3; allowed: 4', null],
  ])) {
    assert.equal(breakdownOf(error(name, message)), kind, `${name}: ${message}`);
    const { line, code } = explain(error(name, message), (text) => text);
    assert.ok(kind === null || (code === 1 && line.includes(message)), line);
    assert.equal(/please report it/.test(line), kind === 'fault', line);
    assert.equal(/not enough memory/.test(line), kind === 'memory', line);
  }
});

test('a panic of the module is a fault with its place, and ends the command with 1', () => {
  // What the module itself has just written no longer reads.
  const { parse } = JSON;
  /** @type {unknown} */
  let thrown;
  try {
    JSON.parse = () => {
      throw new SyntaxError('broken on purpose');
    };
    defaults();
  } catch (error) {
    thrown = error;
  } finally {
    JSON.parse = parse;
  }
  assert.ok(thrown instanceof Error && thrown.name === 'Panic', String(thrown));
  assert.match(thrown.message, /convert\.rs:\d+.*JSON that was just written/s);
  const { line, code } = explain(thrown, (text) => text);
  assert.equal(code, 1);
  assert.match(oneLine(line), /^the computation broke off at a fault of the program \(.*convert\.rs.*\): please report it$/);
});

test('a command whose module panics says so in one line', () => {
  const speckled = image(folder(), 'speckled.png', 40, 30, speckle);
  const preload =
    "const parse = JSON.parse; JSON.parse = (text) => { if (String(text).startsWith('{\"candidates\":')) throw new SyntaxError('broken on purpose'); return parse(text); };";
  const { status, stderr } = spawnSync(process.execPath, ['--import', `data:text/javascript,${encodeURIComponent(preload)}`, PROGRAM, 'points', speckled], {
    encoding: 'utf8',
  });
  assert.equal(status, 1, stderr);
  assert.match(stderr, /^tiepoint: the computation broke off at a fault of the program \(.*\): please report it\n$/);
});

test('a pool that is closed rejects what waits', async () => {
  const pool = new ThreadPool(1);
  const waiting = [1, 2, 3].map(() => pool.run('block', likeness()));
  const settled = Promise.allSettled(waiting);
  await pool.close();
  assert.ok((await settled).slice(1).every(({ status }) => status === 'rejected'));
});
