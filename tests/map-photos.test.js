/** The photos on the map of a block: which ones, and what is kept of them. Without a browser. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pageModules } from './www.js';

const {
  plan: { nearestImages, thumbWidth },
  thumbs: { Thumbs },
} = await pageModules(['block/view/map/plan', 'block/view/map/thumbs']);

const PLAN = { scale: 1, x: 0, y: 0 };

/** Images at places of the plan.  @param {readonly (readonly [number, number])[]} places */
const viewOf = (places) => ({ images: places.map((_, i) => ({ name: `${i}.jpg` })), layout: { kind: 'oriented', places: Float64Array.from(places.flat()) } });

test('of a large block the photos nearest to the middle of what is seen are shown, wherever they stand in the list', () => {
  const view = viewOf(Array.from({ length: 1000 }, (_, i) => [10 * i, 0]));
  const all = () => true;
  const sorted = (/** @type {number[]} */ images) => images.slice().sort((a, b) => a - b);
  assert.deepEqual(nearestImages(view, PLAN, all, [7000, 0], 3), [700, 699, 701]);
  const near = nearestImages(view, PLAN, all, [7000, 50], 150);
  assert.equal(near.length, 150);
  assert.deepEqual([near[0], sorted(near)[0], sorted(near).at(-1)], [700, 625, 774]);
  // Zoomed and moved, it is what is in the middle then; what a filter leaves out takes no place.
  assert.equal(nearestImages(view, { scale: 2, x: -8000, y: 0 }, all, [200, 0], 1)[0], 410);
  assert.deepEqual(
    nearestImages(view, PLAN, (/** @type {number} */ image) => image < 5, [7000, 0], 150),
    [0, 1, 2, 3, 4],
  );
  // An image without a place is nowhere.
  assert.deepEqual(
    nearestImages(
      viewOf([
        [NaN, NaN],
        [1, 0],
        [2, 0],
      ]),
      PLAN,
      all,
      [0, 0],
      2,
    ),
    [1, 2],
  );
});

test('photos have room by the least distance of two images, in whatever order and however many they are', () => {
  assert.ok(
    Math.abs(
      thumbWidth(
        viewOf([
          [0, 0],
          [1000, 5],
          [40, 30],
          [500, 0],
        ]),
        PLAN,
      ) - 40,
    ) < 1e-9,
  );
  const many = viewOf(Array.from({ length: 20_000 }, (_, i) => [100 * (i % 200), 100 * Math.floor(i / 200)]));
  const started = performance.now();
  assert.ok(Math.abs(thumbWidth(many, PLAN) - 80) < 1e-9);
  assert.ok(performance.now() - started < 2000);
});

test('copies of photos that are shown no longer are not made, and the oldest of them are given up', async () => {
  /** @type {string[]} */
  const made = [];
  /** @type {string[]} */
  const closed = [];
  Object.assign(globalThis, {
    createImageBitmap: async (/** @type {{ name: string }} */ file) => {
      made.push(file.name);
      return { name: file.name, close: () => closed.push(file.name) };
    },
  });
  const thumbs = new Thumbs(() => undefined);
  const file = (/** @type {number} */ id) => ({ id, name: `${id}.jpg`, file: { name: `${id}.jpg` } });
  const settled = () => new Promise((resolve) => setTimeout(resolve, 20));
  for (const id of [1, 2, 3]) assert.equal(thumbs.get(file(id)), null);
  // The first is under way; of the others the third is shown still.
  thumbs.shows(new Set([3]));
  await settled();
  assert.deepEqual(made, ['1.jpg', '3.jpg']);
  assert.equal(thumbs.get(file(3)).name, '3.jpg');
  for (let id = 100; id < 600; id++) thumbs.get(file(id));
  await settled();
  thumbs.shows(new Set([3]));
  assert.ok(closed.length >= 50 && closed[0] === '1.jpg' && !closed.includes('3.jpg'), closed.slice(0, 5).join());
  assert.equal(thumbs.get(file(3)).name, '3.jpg');
});
