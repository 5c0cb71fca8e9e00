/** The key that places a measured point, while what says where it is expected is on its way. Without a browser. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pageModules } from './www.js';

const { edits, facts, measuring } = await pageModules(['block/state/edits', 'block/engine/facts', 'block/view/images/measuring']);

const POINT = { tie_point: 7 };
const MIDDLE = [50, 40];
const pane = { image: 1, width: 100, height: 80, points: null };

/** A point of a block that is measured, and what its worker is asked: `answer` ends the question. */
function begun() {
  const view = { points: { sources: [edits.codeOfSource(POINT)] }, partial: false, images: [] };
  const draft = { of: POINT, places: new Map() };
  /** @type {any} */
  const store = { state: { shown: { view }, running: { kind: 'no' }, draft, selection: { chosen: null } } };
  store.dispatch = (/** @type {any} */ action) => {
    if (action.type === 'draft') store.state.draft = action.draft;
  };
  /** @type {{ resolve: (detail: any) => void, reject: (error: Error) => void }[]} */
  const asked = [];
  const engine = { pointDetail: () => new Promise((resolve, reject) => asked.push({ resolve, reject })) };
  const known = new facts.Facts(store, engine);
  const measured = new measuring.Measuring(store, engine, known, () => [pane]);
  return { store, asked, measured, place: () => store.state.draft?.places.get(1)?.at };
}

const detail = (/** @type {{ image: number, x_px: number, y_px: number }[]} */ elsewhere) => ({ elsewhere, observations: [] });

test('a point whose expected place is on its way is placed there when it has come, and not in the middle', async () => {
  const { asked, measured, place } = begun();
  const settled = measured.settle(pane, MIDDLE);
  assert.equal(place(), undefined);
  assert.equal(asked.length, 1);
  asked[0]?.resolve(detail([{ image: 1, x_px: 12, y_px: 34 }]));
  await settled;
  assert.deepEqual(place(), [12, 34]);
});

test('a point of which nothing is expected in an image, or whose answer does not come, is placed in the middle', async () => {
  for (const end of [(/** @type {any} */ one) => one.resolve(detail([])), (/** @type {any} */ one) => one.reject(new Error('the worker was ended'))]) {
    const { asked, measured, place } = begun();
    const settled = measured.settle(pane, MIDDLE);
    end(asked[0]);
    await settled;
    assert.deepEqual(place(), MIDDLE);
  }
});

test('where the block is adjusted anew meanwhile, the point is placed where that expects it, and not in the middle', async () => {
  const { store, asked, measured, place } = begun();
  const settled = measured.settle(pane, MIDDLE);
  // As the edit that added the point is followed.
  store.state.shown = { view: { ...store.state.shown.view } };
  measured.expected(pane);
  await null;
  assert.deepEqual([asked.length, place()], [2, undefined]);
  asked[0]?.resolve(detail([{ image: 1, x_px: 1, y_px: 2 }]));
  asked[1]?.resolve(detail([{ image: 1, x_px: 12, y_px: 34 }]));
  await settled;
  assert.deepEqual(place(), [12, 34]);
});

test('a place that comes when the user has gone on to something else places nothing', async () => {
  const { store, asked, measured, place } = begun();
  const settled = measured.settle(pane, MIDDLE);
  store.state.draft = { of: null, places: new Map() };
  asked[0]?.resolve(detail([{ image: 1, x_px: 12, y_px: 34 }]));
  await settled;
  assert.equal(place(), undefined);
});
