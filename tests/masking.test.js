/** Masks that are painted: what an outline encloses, and what becomes of the masks of a pair. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import '../pkg/node.js';
import { pageModules } from './www.js';

const {
  mask: { fill },
  mask_steps: { nameOfMaskStep },
  masking: { Masking },
  store: { Store },
} = await pageModules(['pair/engine/mask', 'pair/state/mask-steps', 'pair/state/masking', 'pair/state/store']);

/** How many pixels of an image of 20 x 10 px an outline encloses.  @param {readonly (readonly [number, number])[]} corners */
function enclosed(corners) {
  const grey = new Uint8Array(200).fill(255);
  fill(grey, 20, 10, corners, 0);
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

/** A pair of two images whose masks are painted, and what was painted: over what, and which areas. `paint` makes a mask. */
function painted(paint = paintedOver) {
  const store = new Store();
  const source = { kind: 'file', file: new Blob() };
  const image = (/** @type {number} */ id) => ({ id, name: `${id}.png`, source });
  store.dispatch({ type: 'images', images: { left: image(1), right: image(2) } });
  store.dispatch({ type: 'tool', tool: 'mask' });
  /** @type {any[]} */
  const asked = [];
  const painter = (/** @type {any} */ _state, /** @type {string} */ _side, /** @type {any} */ over, /** @type {any} */ areas) => {
    asked.push([over, areas]);
    return paint(over, areas);
  };
  const masking = new Masking(store, painter);
  const draw = (x = 1, y = 1, side = 'left') =>
    masking.trace(
      side,
      [
        [x, y],
        [x + 4, y],
        [x + 4, y + 4],
      ],
      true,
    );
  const pixels = (/** @type {string} */ side) => store.state.masks[side]?.grey ?? null;
  return { store, masking, draw, asked, pixels };
}

/** As the worker paints them.  @param {any} over @param {any[]} areas @returns {Promise<any>} */
async function paintedOver(over, areas) {
  const mask = made();
  const grey = over instanceof Uint8Array ? over.slice() : mask.grey;
  for (const { corners, masked } of areas) fill(grey, 20, 10, corners, masked ? 0 : 255);
  return areas.length > 0 ? { ...mask, grey } : { ...mask, name: over.name, source: over.source };
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
  grey: new Uint8Array(200).fill(255),
  overlay: {},
});

const named = (/** @type {any} */ { state }) => state.maskSteps.edits.map((/** @type {any} */ step) => nameOfMaskStep(step, state.images));

test('a mask is what its steps make of what was there before them; all steps are undone and done again', async () => {
  const { store, masking, draw, pixels } = painted();
  const masks = [pixels('left')];
  const files = [];
  for (let i = 0; i < 40; i++) {
    draw((7 * i) % 15, i % 5);
    await masking.paint(i % 3 !== 2);
    masks.push(pixels('left'));
    files.push(store.state.masks.left.source.file);
  }
  assert.equal(store.state.maskSteps.done, 40);
  for (let done = 39; done >= 0; done--) {
    await masking.step(-1);
    assert.deepEqual(pixels('left'), masks[done]);
  }
  assert.equal(store.state.masks.left, null);
  for (const [i, mask] of masks.slice(1).entries()) {
    await masking.step(1);
    assert.deepEqual(pixels('left'), mask);
    // Who has taken its file knows it again.
    assert.equal(store.state.masks.left.source.file, files[i]);
  }
  await masking.step(1);
  assert.deepEqual(pixels('left'), masks[40]);
});

test('an undone area is painted over the file, one that is done again over the mask', async () => {
  const { store, masking, draw, asked } = painted();
  const file = made();
  store.dispatch({ type: 'mask', side: 'left', mask: file });
  assert.deepEqual(named(store), []);
  draw();
  await masking.paint(true);
  draw();
  await masking.paint(false);
  await masking.step(-1);
  await masking.step(-1);
  assert.equal(store.state.masks.left?.source, file.source);
  await masking.step(1);
  const areas = asked.map((/** @type {any} */ [over, { length }]) => [over instanceof Uint8Array ? 'mask' : over.name, length]);
  assert.deepEqual(areas, [
    ['mask', 1],
    ['mask', 1],
    ['mask.png', 1],
    ['mask.png', 0],
    ['mask', 1],
  ]);
});

test('a mask that is removed, or gives way to that of another file, comes back with its areas', async () => {
  const { store, masking, draw, pixels } = painted();
  draw();
  await masking.paint(true);
  const first = pixels('left');
  store.dispatch({ type: 'mask', side: 'left', mask: null });
  const given = { ...made(), name: 'sky.png' };
  store.dispatch({ type: 'mask', side: 'left', mask: given });
  draw(8, 2);
  await masking.paint(true);
  assert.deepEqual(named(store), ['mask an area of 1.png', 'remove the mask of 1.png', 'use sky.png as the mask of 1.png', 'mask an area of 1.png']);
  await masking.step(-1);
  assert.equal(store.state.masks.left.source, given.source);
  await masking.step(-1);
  assert.equal(store.state.masks.left, null);
  await masking.step(-1);
  assert.deepEqual(pixels('left'), first);
  // What was undone is given up by another area.
  draw();
  await masking.paint(false);
  assert.deepEqual(named(store), ['mask an area of 1.png', 'unmask an area of 1.png']);
});

test('steps that are asked for at once are gone at once, in both images; what is painted stands between', async () => {
  const { store, masking, draw, asked, pixels } = painted();
  draw();
  await masking.paint(true);
  const first = pixels('left');
  draw(2, 2, 'right');
  await masking.paint(true);
  draw(8, 2);
  await masking.paint(true);
  const before = asked.length;
  await Promise.all([masking.step(-1), masking.step(-1), masking.step(-1), masking.step(1)]);
  assert.deepEqual([store.state.maskSteps.done, pixels('left'), store.state.masks.right], [1, first, null]);
  assert.equal(asked.length, before + 1);
  const again = masking.step(1);
  draw(3, 3);
  await Promise.all([again, masking.paint(true), masking.step(-1)]);
  assert.deepEqual(named(store), ['mask an area of 1.png', 'mask an area of 2.png', 'mask an area of 1.png']);
  assert.deepEqual([store.state.maskSteps.done, pixels('left')], [2, first]);
});

test('while an area is outlined its last corner is the last step, and no step on masks is taken back or made again', async () => {
  const { store, masking, draw, asked } = painted();
  draw();
  await masking.paint(true);
  await masking.step(-1);
  for (const at of [
    [3, 3],
    [7, 3],
    [7, 7],
  ])
    masking.place('left', at);
  const before = asked.length;
  const corners = store.state.outline.corners.length;
  await masking.step(1);
  assert.equal(store.state.outline.corners.length, corners);
  for (let left = corners - 1; left > 0; left--) {
    await masking.step(-1);
    assert.equal(store.state.outline.corners.length, left);
  }
  await masking.step(-1);
  assert.equal(store.state.outline, null);
  assert.deepEqual([asked.length, store.state.maskSteps.done], [before, 0]);
  await masking.step(1);
  assert.equal(store.state.maskSteps.done, 1);
});

test('steps go with their image; in place of a mask whose file is not there another one is given', async () => {
  const { store, masking, draw } = painted();
  draw();
  await masking.paint(true);
  draw(1, 1, 'right');
  await masking.paint(true);
  store.dispatch({ type: 'swap' });
  assert.deepEqual(named(store), ['mask an area of 1.png', 'mask an area of 2.png']);
  const source = { kind: 'file', file: new Blob() };
  store.dispatch({ type: 'images', images: { left: { id: 3, name: '3.png', source } } });
  assert.deepEqual(named(store), ['mask an area of 1.png']);
  await masking.step(-1);
  assert.deepEqual([store.state.masks.left, store.state.masks.right], [null, null]);
  const mask = { ...made(), source: { kind: 'project', content: null } };
  const { store: other } = painted();
  other.dispatch({ type: 'mask', side: 'left', mask });
  other.dispatch({ type: 'mask', side: 'left', mask: made() });
  assert.deepEqual(named(other), []);
});

test('an area that is painted while the images are swapped goes with its image', async () => {
  const { store, masking, draw } = painted();
  draw();
  const end = masking.paint(true);
  store.dispatch({ type: 'swap' });
  await end;
  assert.equal(store.state.masks.left, null);
  assert.notEqual(store.state.masks.right, null);
  await masking.step(-1);
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
