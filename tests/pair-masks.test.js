/** Masks between a block and the pairs of it: without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(page, await pageModules(['block/pair', 'block/state/lacking', 'block/state/masks']));
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

test('what a pair has no mask of any more is taken from the block, but for what is not here', () => {
  const { otherMasks, withMasks } = page.masks;
  const gone = [
    { image: 'IMG_1.jpg', file: null },
    { image: 'IMG_2.jpg', file: null },
  ];
  assert.deepEqual(otherMasks(MASKS, gone), [gone[0]]);
  assert.deepEqual(
    withMasks(MASKS, [gone[0]], () => 7),
    [MASKS[1]],
  );
  const lacking = [{ id: 1, name: 'IMG_1_mask.png', file: page.lacking.standIn('IMG_1_mask.png') }];
  assert.deepEqual(otherMasks(lacking, gone), []);
});

test('a pair tells which masks were undone or removed, not that it never had one', () => {
  const { masksOf } = page.pair;
  const image = (/** @type {string} */ name) => ({ name });
  const state = { images: { left: image('a.jpg'), right: image('b.jpg') }, masks: { left: null, right: null } };
  const edits = [{ side: 'right', given: null }];
  assert.deepEqual(masksOf({ ...state, maskSteps: { edits: [], done: 0 } }), []);
  assert.deepEqual(masksOf({ ...state, maskSteps: { edits, done: 0 } }), [{ image: 'b.jpg', file: null }]);
});
