import assert from 'node:assert/strict';
import { test } from 'node:test';
import { ThreadPool } from '../../pkg/command/pool.js';
import { block_settings } from '../../pkg/node.js';

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

test('a pool that is closed rejects what waits', async () => {
  const pool = new ThreadPool(1);
  const waiting = [1, 2, 3].map(() => pool.run('block', likeness()));
  const settled = Promise.allSettled(waiting);
  await pool.close();
  assert.ok((await settled).slice(1).every(({ status }) => status === 'rejected'));
});
