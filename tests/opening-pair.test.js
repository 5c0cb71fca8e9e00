/** A pair of a block is opened in place of the pair on the page, which keeps what the user made: without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
let page = {};

/** A camera that the block calibrated. */
const CAMERA = { width_px: 480, height_px: 360, focal_px: 500, principal_point_px: [240, 180] };

/** What was asked of the user, and the answer. */
const asked = { text: '', answer: false };

before(async () => {
  Object.assign(globalThis, {
    window: {
      confirm: (/** @type {string} */ text) => {
        asked.text = text;
        return asked.answer;
      },
    },
  });
});

/** The page with a block of three images, and a pair of two other ones; the pair opened from the block is new to it. */
async function opened() {
  page = await pageModules(['block/pair', 'pair/state/reducer', 'pair/state/state']);
  const file = (/** @type {string} */ name) => new File([name], name, { lastModified: 1 });
  const files = ['a.jpg', 'b.jpg', 'c.jpg'].map((name, i) => ({ id: i + 1, name, file: file(name) }));
  const masks = [{ id: 9, name: 'b_mask.png', file: file('b_mask.png') }];
  const images = files.map(({ name }) => ({ name, camera: 0 }));
  /** @type {any[]} */
  const notices = [];
  const block = {
    state: { shown: { view: { images, cameras: [{ calibrated: CAMERA, given: null }] }, files }, files, options: { settings: null, masks } },
    dispatch: (/** @type {any} */ action) => notices.push(action),
  };
  const store = {
    state: page.state.INITIAL,
    dispatch: (/** @type {any} */ action) => {
      store.state = page.reducer.reduce(store.state, action);
    },
  };
  const image = (/** @type {string} */ name, /** @type {number} */ id) => ({ id, name, source: { kind: 'file', file: file(name) } });
  store.dispatch({ type: 'images', images: { left: image('x.jpg', 1), right: image('y.jpg', 2) } });
  /** @type {any[]} */
  const aside = [];
  const open = (stays = true) => {
    const read = { width: 1, height: 1, grey: new Uint8Array(1), leftOut: 1 };
    const engine = { open: () => Promise.resolve(), client: () => ({ call: () => Promise.resolve(read) }) };
    const putAside = () => Promise.resolve(aside.push(store.state)).then(() => stays);
    return page.pair.openPair(block, { dispatch: () => undefined }, { store, engine }, { putAside, stays: async () => () => undefined }, [0, 1]);
  };
  const names = () => ['left', 'right'].map((side) => store.state.images[side].name).join(' ');
  const mark = () => store.dispatch({ type: 'photo', side: 'left', photo: { fiducials: [{ image: [1, 2], photo_mm: [3, 4] }], origin: null } });
  return { store, aside, open, names, mark };
}

test('a pair with fiducial marks stays under Projects, with them; one that has nothing by hand is not kept twice', async () => {
  const { store, aside, open, names, mark } = await opened();
  mark();
  await open();
  assert.equal(names(), 'a.jpg b.jpg');
  assert.equal(aside.length, 1);
  assert.equal(aside[0].photos.left.fiducials.length, 1);
  assert.equal(aside[0].images.left.name, 'x.jpg');
  assert.match(store.state.notice.text, /x\.jpg.* stay under Projects\.$/);
  assert.deepEqual(store.state.photos.left.fiducials, []);
  // It has the masks of the block, which are nothing that was done to the pair.
  assert.deepEqual([store.state.masks.left, store.state.masks.right.name], [null, 'b_mask.png']);
  assert.deepEqual(
    page.pair.masksOf(store.state).map((/** @type {any} */ { image }) => image),
    ['b.jpg'],
  );
  // The pair of the block, as it was opened.
  await open();
  assert.equal(aside.length, 1);
  // Marks on a pair of the block.
  mark();
  await open();
  assert.equal(aside.length, 2);
});

test('where it cannot be kept the user is asked, and the pair stays where that is wanted', async () => {
  const { store, open, names, mark } = await opened();
  mark();
  asked.answer = false;
  await open(false);
  assert.match(asked.text, /^The pair on the page, .* cannot be kept in this browser\. Open the pair of the block without it\?$/);
  assert.equal(names(), 'x.jpg y.jpg');
  assert.equal(store.state.photos.left.fiducials.length, 1);
  asked.answer = true;
  await open(false);
  assert.equal(names(), 'a.jpg b.jpg');
});

test('a pair of a block has its camera, in place of a simulated pair too', async () => {
  const { store, open } = await opened();
  store.state = { ...store.state, truth: { leftId: 1, rightId: 2 } };
  await open();
  assert.equal(store.state.truth, null);
  assert.notEqual(store.state.camera, null);
});
