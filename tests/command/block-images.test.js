/** What a block makes of files that are none of its images: files that cannot be read, kinds that are not decoded, copies. */

import assert from 'node:assert/strict';
import { copyFileSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { photographed, records } from './blocks.js';
import { folder, tiepoint } from './command.js';

const BLOCK = photographed();

test('an image that cannot be read is skipped and listed', () => {
  const mixed = folder();
  for (const name of readdirSync(BLOCK.photos)) copyFileSync(join(BLOCK.photos, name), join(mixed, name));
  const names = readdirSync(mixed);
  writeFileSync(join(mixed, 'a_text.jpg'), 'no image at all');
  const cut = readFileSync(join(mixed, names[2] ?? ''));
  writeFileSync(join(mixed, names[2] ?? ''), cut.subarray(0, 2000));
  const out = folder();
  const { code, stdout, stderr } = tiepoint('block', mixed, ...BLOCK.call.slice(2), '--out', out, '--json');
  assert.equal(code, 0, stderr);
  const summary = JSON.parse(stdout);
  assert.equal(summary.images.read, 5);
  assert.deepEqual(
    summary.images.left_out.map((/** @type {any} */ image) => image.name),
    ['a_text.jpg', names[2]],
  );
  assert.match(stderr, /a_text\.jpg is skipped: /);
  assert.match(stderr, new RegExp(`${names[2]} is skipped: the image cannot be read`));
  const alone = tiepoint('block', join(mixed, 'a_text.jpg'), join(mixed, names[0] ?? ''), '--out', folder());
  assert.equal(alone.code, 1);
  assert.match(alone.stderr, /images of the block: got 1 that could be read, of 2 \(a_text\.jpg: /);
});

test('files of kinds that are not decoded are named beside the images of a folder, each reason once', () => {
  const mixed = folder();
  const heic = Buffer.concat([Buffer.from([0, 0, 0, 24]), Buffer.from('ftypheic\0\0\0\0mif1heic'), Buffer.alloc(100)]);
  for (let i = 1; i <= 7; i++) writeFileSync(join(mixed, `IMG_${i}.HEIC`), heic);
  writeFileSync(join(mixed, 'map.ecw'), 'e');
  writeFileSync(join(mixed, 'notes.txt'), 'heic');
  const none = tiepoint('block', mixed, '--out', folder());
  assert.equal(none.code, 1);
  assert.match(
    none.stderr,
    /there is no image in this folder \(JPEG, .*\); 7 files are skipped \(IMG_1\.HEIC, .*IMG_5\.HEIC and 2 more\): HEIC pictures are not read: export them as JPEG .*; map\.ecw is skipped: ECW pictures/,
  );
  const alone = tiepoint('points', join(mixed, 'IMG_1.HEIC'));
  assert.deepEqual([alone.code, /IMG_1\.HEIC: HEIC pictures are not read: export them as JPEG/.test(alone.stderr)], [1, true], alone.stderr);
  for (const name of readdirSync(BLOCK.photos)) copyFileSync(join(BLOCK.photos, name), join(mixed, name));
  const { code, stderr } = tiepoint(...BLOCK.call.with(1, mixed), '--out', folder());
  assert.equal(code, 0, stderr);
  const notes = stderr.split('\n').filter((line) => line.includes('skipped'));
  assert.deepEqual(
    notes.map((line) => line.slice(0, line.indexOf(' pictures'))),
    ['tiepoint: 7 files are skipped (IMG_1.HEIC, IMG_2.HEIC, IMG_3.HEIC, IMG_4.HEIC, IMG_5.HEIC and 2 more): HEIC', 'tiepoint: map.ecw is skipped: ECW'],
  );
});

test('copies of an image are left out of a block and named', () => {
  const twins = folder();
  const [name = '', other = ''] = readdirSync(BLOCK.photos);
  for (const copy of ['img_10.png', 'img_9.png', 'IMG.png', 'img_9b.png']) copyFileSync(join(BLOCK.photos, name), join(twins, copy));
  copyFileSync(join(BLOCK.photos, other), join(twins, 'other.png'));
  const out = folder();
  const { stdout, stderr } = tiepoint('block', twins, ...BLOCK.call.slice(2), '--out', out, '--json');
  const summary = JSON.parse(stdout);
  const copies = ['img_9.png', 'img_9b.png', 'img_10.png'];
  assert.equal(stderr, `tiepoint: 3 files are skipped (${copies.join(', ')}): image of the block: got the same picture as IMG.png; allowed: each image once\n`);
  assert.equal(summary.images.read, 2);
  assert.deepEqual(
    summary.images.left_out.map((/** @type {{name: string}} */ image) => image.name),
    copies,
  );
  assert.equal(records(out, 'features'), 2);
  const rows = readFileSync(join(out, 'images.csv'), 'utf8').trimEnd().split('\n').slice(1);
  assert.deepEqual(
    rows.map((row) => row.split(',')[1]),
    ['IMG.png', 'other.png'],
  );
});
