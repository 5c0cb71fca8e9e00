import assert from 'node:assert/strict';
import { test } from 'node:test';
import { ThreadPool } from '../../pkg/command/pool.js';

test('a job that fails rejects by itself, and the others go on', async () => {
  const pool = new ThreadPool(1);
  try {
    const jobs = [
      pool.run('dance', {}),
      pool.run('features', { bytes: () => 1 }),
      pool.run('features', { bytes: new Uint8Array([1, 2, 3]), key: '', options: {} }),
      pool.run('likeness', { own: new Uint8Array(128), others: [new Uint8Array(128), new Uint8Array(0)] }),
    ];
    const [dance, uncopied, image, likeness] = await Promise.allSettled(jobs);
    assert.match(String(dance?.status === 'rejected' && dance.reason), /there is no job dance/);
    assert.match(String(uncopied?.status === 'rejected' && uncopied.reason), /could not be cloned/);
    assert.ok(image?.status === 'rejected' && image.reason.name === 'TiepointError' && image.reason.code === 'unsupported-image', JSON.stringify(image));
    assert.deepEqual(likeness, { status: 'fulfilled', value: Uint32Array.of(1, 0) });
  } finally {
    await pool.close();
  }
});

test('a job whose memory has moved elsewhere rejects, and the next one runs', async () => {
  const pool = new ThreadPool(1);
  try {
    const bytes = new Uint8Array(8);
    structuredClone(bytes, { transfer: [bytes.buffer] });
    const [moved, likeness] = await Promise.allSettled([
      pool.run('features', { bytes, key: '', options: {} }, [bytes.buffer]),
      pool.run('likeness', { own: new Uint8Array(0), others: [] }),
    ]);
    assert.match(String(moved?.status === 'rejected' && moved.reason), /deserialize/);
    assert.equal(likeness?.status, 'fulfilled');
  } finally {
    await pool.close();
  }
});

test('a pool that is closed rejects what waits', async () => {
  const pool = new ThreadPool(1);
  const waiting = [1, 2, 3].map(() => pool.run('likeness', { own: new Uint8Array(0), others: [] }));
  const settled = Promise.allSettled(waiting);
  await pool.close();
  assert.ok((await settled).slice(1).every(({ status }) => status === 'rejected'));
});
