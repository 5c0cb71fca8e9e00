import assert from 'node:assert/strict';
import { copyFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { photographed } from './blocks.js';
import { folder, image, json, speckle, tiepoint } from './command.js';

const BLOCK = photographed();
const out = folder();
const { orientation } = json(...BLOCK.call, '--out', out, '--workers', '2');
const project = join(out, 'project.tiepoint');
const photo = (/** @type {number} */ index) => join(BLOCK.photos, `photo_0000${index}.png`);

test('a pair takes the camera that a block calibrated', () => {
  const pair = json('match', photo(0), photo(1), '--camera', project);
  assert.ok(pair.orientation, JSON.stringify(pair.no_orientation));
  // Its focal length by its pixel is that of the block.
  const [camera] = orientation.cameras;
  const text = tiepoint('match', photo(0), photo(1), '--camera', project);
  assert.doesNotMatch(text.stdout, /EXIF/);
  const [own] = pair.orientation.cameras;
  assert.ok(Math.abs(own.focal_mm / pair.pixel_mm - camera.focal_px) < 1e-6 * camera.focal_px, JSON.stringify([own, pair.pixel_mm, camera]));
  // It is known as well as cameras that are given.
  assert.ok(Math.abs(own.focal_standard_error_mm / own.focal_mm - 0.003) < 1e-9);
  // Other photos of the only camera are as good, by whatever name.
  const at = folder();
  for (const [from, to] of [
    [0, 'a.png'],
    [1, 'b.png'],
  ])
    copyFileSync(photo(Number(from)), join(at, String(to)));
  const renamed = json('match', join(at, 'a.png'), join(at, 'b.png'), '--camera', project);
  assert.deepEqual(renamed.orientation, pair.orientation);
});

test('photos of another size do not take it', () => {
  const at = folder();
  const other = image(at, 'other.png', 320, 240, speckle);
  const { code, stderr } = tiepoint('match', other, other, '--camera', project);
  assert.equal(code, 1);
  assert.match(stderr, /the camera of the block is of photos of 480 x 360 px, not of 320 x 240 px/);
});
