/** A point that is being measured by hand, as it is kept and measured on, and the images that are looked at for it: without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(
    page,
    await pageModules([
      ...['block/files/keep-draft', 'block/state/edits', 'block/state/likely', 'block/state/panes', 'block/state/reducer', 'block/state/resumed'],
      ...['block/state/selection', 'block/state/state'],
    ]),
  );
});

/** A block of images of these names and points of these numbers of tie points.  @param {string[]} names @param {number[]} points */
const viewOf = (names, points) => ({
  partial: false,
  images: names.map((name) => ({ name, rays: points.length })),
  connections: [],
  oriented: names.length,
  surveyed: [],
  givenControl: 0,
  crs: null,
  components: [],
  checks: null,
  points: {
    count: points.length,
    taking: points.length,
    sources: Float64Array.from(points, (point) => page.edits.codeOfSource({ tie_point: point })),
    rays: Uint16Array.from(points, () => 2),
  },
});

const done = (/** @type {any} */ view) => ({ type: 'done', key: 'k', view, files: [], seconds: 1 });
const reduced = (/** @type {any[]} */ ...actions) => actions.reduce((state, action) => page.reducer.reduceBlock(state, action), page.state.BLOCK_INITIAL);
const place = (/** @type {number} */ x, /** @type {number} */ y, by = 'hand') => ({ at: [x, y], by });

test('a draft is read as it was kept, without images that the block does not have, and what is damaged is named', () => {
  const { draftParts, draftFrom } = page.keep_draft;
  const read = (/** @type {any} */ draft, count = 4) =>
    draftFrom(new Map([...draftParts(draft, [2, 0])].map(([name, { value }]) => [name, structuredClone(value)])), count);
  assert.equal(draftParts(null, []).size, 0);
  assert.equal(draftFrom(new Map(), 4), null);
  for (const of of [null, { given: 'A' }, { tie_point: 7 }, { manual: 0 }]) {
    const draft = {
      of,
      places: new Map([
        [2, place(1.5, 2)],
        [0, place(3, 4, 'least_squares')],
      ]),
    };
    assert.deepEqual(read(draft), { ...draft, images: [2, 0] });
    assert.deepEqual(read(draft, 2), { of, places: new Map([[0, place(3, 4, 'least_squares')]]), images: [0] });
  }
  assert.throws(() => read({ of: { given: 1 }, places: new Map() }), /draft\.of\.given/u);
  assert.throws(() => read({ of: null, places: new Map([[0, place(NaN, 2)]]) }), /draft\.places\[0\]/u);
});

test('a draft is written anew only where it, or what is shown, has changed', () => {
  const draft = { of: null, places: new Map([[0, place(1, 2)]]) };
  const images = [0, 1];
  const part = () => page.keep_draft.draftParts(draft, images).get('block/draft');
  assert.equal(part(), part());
});

test('what was measured is chosen and shown when its project is opened', () => {
  const view = viewOf(['a', 'b', 'c'], [10, 11]);
  const resumed = page.resumed.resumed({ of: { tie_point: 11 }, places: new Map([[2, place(1, 2)]]), images: [2, 1] }, view);
  assert.deepEqual(resumed.selection.chosen, { kind: 'point', point: 1 });
  assert.deepEqual([resumed.panes.images, resumed.panes.look.unmeasured, resumed.onStage], [[2, 1], true, 'images']);
  assert.deepEqual(page.resumed.resumed(null, view), { draft: null });
});

test('a point whose edits come after it is the chosen one once the block has it', () => {
  const draft = { of: { tie_point: 12 }, places: new Map([[0, place(1, 2)]]) };
  const edits = [{ kind: 'reject_points', points: [{ tie_point: 10 }] }];
  const state = reduced(done(viewOf(['a', 'b'], [10, 11])), { type: 'draft', draft }, { type: 'edited', view: viewOf(['a', 'b'], [11, 12]), edits });
  assert.deepEqual(state.selection.chosen, { kind: 'point', point: 1 });
  assert.equal(state.draft, draft);
});

test('a run leaves a new point that is placed in one image alone where it is, by the name of the image', () => {
  const draft = { of: null, places: new Map([[2, place(5, 6)]]) };
  const first = [done(viewOf(['a', 'b', 'c'], [10])), { type: 'draft', draft }];
  assert.deepEqual(reduced(...first, done(viewOf(['c', 'a'], [10]))).draft, { of: null, places: new Map([[0, place(5, 6)]]) });
  assert.equal(reduced(...first, done(viewOf(['a', 'b'], [10]))).draft, null);
});

test('images that have most matches with one are looked at first, and those in which a point is placed stay', () => {
  const { likeliest, turned } = page.likely;
  const connected = (/** @type {number[]} */ images, /** @type {number} */ matches) => ({ images, outcome: { kind: 'connected', matches }, matches });
  const images = Array.from({ length: 12 }, (_, i) => ({ name: String(i) }));
  const connections = [connected([3, 4], 50), connected([3, 9], 80), connected([1, 2], 99)];
  assert.deepEqual(likeliest({ images, connections }, undefined).slice(0, 3), [0, 1, 2]);
  const order = likeliest({ images, connections }, 3);
  assert.deepEqual(order.slice(0, 4), [3, 9, 4, 0]);
  assert.deepEqual(turned([3, 9, 4, 0], order, new Set([3]), 1), [3, 1, 2, 5]);
  assert.deepEqual(turned([3, 1, 2, 5], order, new Set([3]), -1), [3, 9, 4, 0]);
  assert.deepEqual(turned([3, 9], order, new Set([3, 9]), 1), [3, 9, 4]);
  const all = images.map((_, i) => i);
  assert.deepEqual(turned([0, 1, 2, 3], all, new Set(), 1), [4, 5, 6, 7]);
  assert.deepEqual(turned([0, 1, 2, 3], all, new Set(), -1), [8, 9, 10, 11]);
  assert.deepEqual(turned([0, 1], [0, 1], new Set([0, 1]), 1), [0, 1]);
});
