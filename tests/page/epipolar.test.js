/** Epipolar images of the pair on the screen. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { strFromU8, unzipSync } from 'fflate';
import { Photo } from '../../pkg/node.js';
import { CAMERA, done, hosted, open, part, pngs, sample, saved, says, SKIP } from './page.js';

hosted();

const CELLS = 8;

/** Mean grey values of the cells of an image: images that are turned or shifted differ in them.  @param {Photo} photo */
function cells(photo) {
  const { width, height } = photo;
  const grey = photo.grey();
  const sums = Array.from({ length: CELLS * CELLS }, () => ({ sum: 0, count: 0 }));
  for (const [i, value] of grey.entries()) {
    const cell = sums[Math.floor((CELLS * Math.floor(i / width)) / height) * CELLS + Math.floor((CELLS * (i % width)) / width)];
    if (cell) {
      cell.sum += value;
      cell.count += 1;
    }
  }
  return sums.map(({ sum, count }) => sum / count);
}

test('epipolar images are saved in one archive, the left one first whichever was given first', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open();
  await sample(page);
  const files = unzipSync(new Uint8Array(await saved(page, 'export-epipolar')));
  assert.deepEqual(Object.keys(files).sort(), ['anaglyph.png', 'epipolar.json', 'left.png', 'right.png']);
  const told = JSON.parse(strFromU8(files['epipolar.json'] ?? new Uint8Array()));
  assert.deepEqual([told.left, told.right], ['sample left', 'sample right']);
  for (const name of ['left.png', 'right.png', 'anaglyph.png']) {
    const { width, height } = Photo.decode(files[name] ?? new Uint8Array());
    assert.deepEqual([width, height], [told.width_px, told.height_px]);
  }
  assert.ok(told.parallaxes.y_rms_px < 0.5, JSON.stringify(told.parallaxes));
  await says(page, 'status', /Residual y-parallax of [\d\s]+ points: 0\.\d\d px/);
  // The other way round both lie as before.
  await part(page, 'swap').click();
  await done(page);
  const swapped = unzipSync(new Uint8Array(await saved(page, 'export-epipolar')));
  const again = JSON.parse(strFromU8(swapped['epipolar.json'] ?? new Uint8Array()));
  assert.deepEqual([again.left, again.right], ['sample left', 'sample right']);
  assert.ok(Math.abs(again.focal_px - told.focal_px) < 1 && again.parallaxes.y_rms_px < 0.5);
  const [left, other] = [files, swapped].map((of) => cells(Photo.decode(of['left.png'] ?? new Uint8Array())));
  const differences = (left ?? []).map((value, k) => Math.abs(value - (other?.[k] ?? NaN)));
  assert.ok(Math.max(...differences) < 8, differences.map((value) => value.toFixed(0)).join(' '));
  assert.deepEqual(complaints, []);
  await close();
});

test('a pair that is not oriented has none', { skip: SKIP }, async () => {
  const { page, complaints, close } = await open({ fresh: true });
  const [left] = pngs();
  assert.ok(left);
  await part(page, 'file-input').setInputFiles([left, { ...left, name: 'same.png' }, CAMERA]);
  await done(page);
  await part(page, 'export-menu').click();
  assert.ok(await part(page, 'export-epipolar').isDisabled());
  assert.deepEqual(complaints, []);
  await close();
});
