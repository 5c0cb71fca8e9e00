/** Masks between a block and the pairs of it: without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(page, await pageModules(['block/state/masks']));
});

const [one, two, painted] = [new Blob(['1']), new Blob(['2']), new Blob(['3'])];
const MASKS = [
  { id: 1, name: 'IMG_1_mask.png', file: one },
  { id: 2, name: 'of-none.png', file: two },
];

test('a pair has the masks of its images, and gives others in place of them alone', () => {
  const { maskOf, otherMasks, withMasks } = page.masks;
  assert.equal(maskOf(MASKS, 'IMG_1.jpg'), MASKS[0]);
  assert.equal(maskOf(MASKS, 'IMG_2.jpg'), null);
  const ofPair = [
    { image: 'IMG_1.jpg', file: one },
    { image: 'IMG_2.jpg', file: painted },
  ];
  assert.deepEqual(otherMasks(MASKS, ofPair), [ofPair[1]]);
  const second = withMasks(MASKS, [ofPair[1]], () => 7);
  assert.deepEqual(second, [...MASKS, { id: 7, name: 'IMG_2.jpg.png', file: painted }]);
  assert.deepEqual(otherMasks(second, ofPair), []);
  // The former mask of the image goes.
  const again = withMasks(second, [{ image: 'IMG_1.jpg', file: painted }], () => 8);
  assert.deepEqual(
    again.map(({ id }) => id),
    [2, 7, 8],
  );
  assert.equal(maskOf(again, 'IMG_1.jpg').file, painted);
});
