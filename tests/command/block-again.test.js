/** Runs of a block that are repeated: with other settings, by other numbers of workers, after one that was killed, over records that are damaged. */

import assert from 'node:assert/strict';
import { copyFileSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { contents, killed, PAIRS, records, runOnce } from './blocks.js';
import { folder, json, tiepoint } from './command.js';

const { block: BLOCK, whole: WHOLE, ran } = runOnce('--export', 'colmap,bingo');

test('killed at any moment and started again, it gives the same bytes', async () => {
  const wanted = contents(WHOLE.out);
  const out = folder();
  const args = [...BLOCK.call, '--out', out, '--workers', '2', '--export', 'colmap,bingo'];
  // Ended in the midst of the images, of the pairs, and right after the last of them.
  const moments = [
    () => records(out, 'features') >= 2,
    () => records(out, 'pairs') >= 1,
    () => records(out, 'pairs') >= 8,
    () => records(out, 'pairs') >= PAIRS,
  ];
  let kills = 0;
  for (const moment of moments) kills += (await killed(args, moment)) ? 1 : 0;
  assert.ok(kills >= 3, `${kills}`);
  const before = records(out, 'pairs');
  assert.ok(before >= 8, `${before}`);
  // Ended while it wrote.
  for (const name of ['summary.json', 'work/pairs/00.record.7']) writeFileSync(join(out, `${name}.tiepoint-99999999.part`), 'half');
  const { code, stderr } = tiepoint(...args);
  assert.equal(code, 0, stderr);
  assert.match(stderr, /images: 6 \(6 from an earlier run\)/);
  assert.deepEqual(contents(out), wanted);
  assert.deepEqual(
    readdirSync(join(out, 'work', 'pairs')).filter((name) => !name.endsWith('.record')),
    [],
  );
});

test('one worker gives the bytes of two', () => {
  const out = folder();
  json(...BLOCK.call, '--out', out, '--workers', '1', '--export', 'colmap,bingo');
  assert.deepEqual(contents(out, ''), contents(WHOLE.out, ''));
});

test('a damaged record is made again', () => {
  const { out } = ran();
  const wanted = contents(out, '');
  const features = join(out, 'work', 'features');
  const pairs = join(out, 'work', 'pairs');
  const [one = '', two = '', three = ''] = readdirSync(features);
  const flipped = readFileSync(join(features, one));
  flipped[flipped.length - 7] = (flipped[flipped.length - 7] ?? 0) ^ 1;
  writeFileSync(join(features, one), flipped);
  writeFileSync(join(features, two), readFileSync(join(features, two)).subarray(0, 1000));
  writeFileSync(join(features, three), '');
  const [first = '', second = ''] = readdirSync(pairs);
  copyFileSync(join(pairs, first), join(pairs, second));
  json(...BLOCK.call, '--out', out);
  assert.deepEqual(contents(out, ''), wanted);
});

test('other settings and other images are computed again, a renamed image is not', () => {
  const { out } = ran();
  json(...BLOCK.call.slice(0, 2), '--out', out, '--features', '1100');
  assert.equal(records(out, 'features'), 12);
  json(...BLOCK.call, '--out', out, '--least-matches', '17');
  assert.equal(records(out, 'features'), 12);
  assert.equal(records(out, 'pairs'), 3 * PAIRS);
  const renamed = folder();
  for (const name of readdirSync(BLOCK.photos)) copyFileSync(join(BLOCK.photos, name), join(renamed, `new_${name}`));
  const [, ...settings] = BLOCK.call.slice(1);
  json('block', renamed, ...settings, '--out', out);
  assert.equal(records(out, 'features'), 12);
  assert.equal(records(out, 'pairs'), 3 * PAIRS);
});
