/** Masks that are painted: what an outline encloses, and what becomes of the masks of a pair. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import '../pkg/node.js';
import { pageModules } from './www.js';

const {
  mask: { fill },
  masking: { Masking },
  store: { Store },
} = await pageModules(['pair/engine/mask', 'pair/state/masking', 'pair/state/store']);

/** How many pixels of an image of 20 x 10 px an outline encloses.  @param {readonly (readonly [number, number])[]} corners */
function enclosed(corners) {
  const grey = new Uint8Array(200).fill(255);
  fill(grey, 20, 10, Float64Array.from(corners.flat()), 0);
  return grey.reduce((sum, value) => sum + Number(value === 0), 0);
}

test('an outline encloses the pixels whose middles lie in it, in the image alone', () => {
  const square = /** @type {const} */ ([
    [2, 3],
    [6, 3],
    [6, 8],
    [2, 8],
  ]);
  assert.equal(enclosed(square), 20);
  assert.equal(enclosed([...square].reverse()), 20);
  assert.equal(
    enclosed([
      [-50, -50],
      [50, -50],
      [50, 50],
      [-50, 50],
    ]),
    200,
  );
  // One that goes round twice, and a figure of eight: all of it.
  assert.equal(enclosed([...square, ...square]), 20);
  const eight = enclosed([
    [2, 2],
    [8, 8],
    [8, 2],
    [2, 8],
  ]);
  assert.ok(eight >= 12 && eight <= 24, `${eight}`);
  assert.equal(
    enclosed([
      [3, 3],
      [5, 5],
    ]),
    0,
  );
});

/** A pair of two images whose masks are painted, and what was said. `paint` makes a mask. */
function painted(paint = async () => made()) {
  const store = new Store();
  const source = { kind: 'file', file: new Blob() };
  const image = (/** @type {number} */ id) => ({ id, name: `${id}.png`, source });
  store.dispatch({ type: 'images', images: { left: image(1), right: image(2) } });
  store.dispatch({ type: 'tool', tool: 'mask' });
  const masking = new Masking(store, paint);
  const draw = () =>
    masking.trace(
      'left',
      [
        [1, 1],
        [5, 1],
        [5, 5],
      ],
      true,
    );
  return { store, masking, draw };
}

/** Differ for every mask. */
const ids = (function* () {
  for (let id = 100; ; id += 1) yield id;
})();
const made = () => ({
  id: ids.next().value,
  name: 'mask.png',
  source: { kind: 'file', file: new Blob() },
  width: 20,
  height: 10,
  leftOut: 0.1,
  grey: new Uint8Array(),
  overlay: {},
});

test('undoing an area takes no mask away that was given since', async () => {
  const { store, masking, draw } = painted();
  draw();
  await masking.paint(true);
  const first = store.state.masks.left;
  draw();
  await masking.paint(false);
  masking.step(-1);
  assert.equal(store.state.masks.left, first);
  const given = made();
  store.dispatch({ type: 'mask', side: 'left', mask: given });
  assert.equal(masking.history.done, 0);
  masking.step(-1);
  assert.equal(store.state.masks.left, given);
});

test('an area that was undone is painted again, unless another one was painted or its image has another mask', async () => {
  const { store, masking, draw } = painted();
  draw();
  await masking.paint(true);
  const first = store.state.masks.left;
  draw();
  await masking.paint(false);
  const second = store.state.masks.left;
  assert.deepEqual(
    masking.history.edits.map((/** @type {any} */ { name }) => name),
    ['mask an area', 'unmask an area'],
  );
  masking.step(-1);
  masking.step(-1);
  assert.equal(store.state.masks.left, null);
  masking.step(1);
  assert.equal(store.state.masks.left, first);
  masking.step(1);
  assert.equal(store.state.masks.left, second);
  masking.step(1);
  assert.equal(store.state.masks.left, second);
  masking.step(-1);
  draw();
  await masking.paint(true);
  assert.deepEqual([masking.history.edits.length, masking.history.done], [2, 2]);
  masking.step(-1);
  store.dispatch({ type: 'mask', side: 'left', mask: made() });
  assert.equal(masking.history.edits.length, 0);
});

test('a mask that is removed leaves the areas of the other image to be undone', async () => {
  const { store, masking, draw } = painted();
  draw();
  await masking.paint(true);
  masking.trace(
    'right',
    [
      [1, 1],
      [5, 1],
      [5, 5],
    ],
    true,
  );
  await masking.paint(true);
  store.dispatch({ type: 'mask', side: 'right', mask: null });
  assert.equal(masking.history.done, 1);
  masking.step(-1);
  assert.equal(store.state.masks.left, null);
});

test('an area that is painted while the images are swapped goes with its image', async () => {
  const { store, masking, draw } = painted();
  draw();
  const end = masking.paint(true);
  store.dispatch({ type: 'swap' });
  await end;
  assert.equal(store.state.masks.left, null);
  assert.notEqual(store.state.masks.right, null);
  masking.step(-1);
  assert.equal(store.state.masks.right, null);
});

test('an area that cannot be painted is outlined again', async () => {
  for (const paint of [async () => null, () => Promise.reject(new Error('no'))]) {
    const { store, masking, draw } = painted(paint);
    draw();
    await masking.paint(true).catch(() => {});
    assert.equal(store.state.outline?.corners.length, 3);
    assert.equal(store.state.masks.left, null);
  }
});

test('a line that is given up leaves the corners that were pressed', () => {
  const { store, masking } = painted();
  masking.place('left', [1, 1]);
  masking.place('left', [9, 1]);
  masking.trace(
    'left',
    [
      [3, 3],
      [4, 4],
    ],
    false,
  );
  masking.giveUp();
  assert.deepEqual(store.state.outline?.corners, [
    [1, 1],
    [9, 1],
  ]);
  masking.back();
  assert.equal(store.state.outline?.corners.length, 1);
  masking.trace(
    'left',
    [
      [3, 3],
      [4, 4],
      [5, 6],
    ],
    true,
  );
  masking.back();
  assert.equal(store.state.outline, null);
});
