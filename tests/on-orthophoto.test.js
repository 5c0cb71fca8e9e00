/** What the page does with an orthophoto, and what becomes of edits in its system: without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(page, await pageModules(['block/state/state', 'block/state/reducer', 'block/state/purpose']));
});

const file = (/** @type {number} */ id) => ({ id, name: `photo_${id}.png`, file: new Blob([]) });
const raster = (/** @type {number} */ id) => ({ ...file(id), world: null });
const orthophoto = (/** @type {number} */ id, /** @type {string | null} */ ofBlock = null) => ({ raster: raster(id), info: {}, ofBlock });
const view = (/** @type {string[]} */ surveyed = [], more = {}) => ({
  partial: false,
  oriented: 2,
  images: [1, 2].map((id) => ({ name: `photo_${id}.png`, rays: 0 })),
  points: { taking: 0, sources: new Float64Array() },
  surveyed: surveyed.map((name, control) => ({ name, control })),
  orthophoto: null,
  ...more,
});

/** A state after actions, with two photographs. @param {object[]} actions */
const after = (...actions) =>
  [{ type: 'files', files: [file(1), file(2)], truth: null }, ...actions].reduce(
    (state, action) => page.reducer.reduceBlock(state, action),
    page.state.BLOCK_INITIAL,
  );

const model = (/** @type {number} */ id) => ({ type: 'heights', heights: { kind: 'model', model: raster(id) }, info: {} });
const given = [{ type: 'orthophoto', orthophoto: orthophoto(7) }, model(8)];
const run = (/** @type {any} */ state, found = view()) => [
  { type: 'started', key: page.state.wantedKey(state) },
  { type: 'done', key: page.state.wantedKey(state), view: found, files: state.files, seconds: 1 },
];

test('photographs with an orthophoto are a block where it has heights, else each is placed by itself; a finished block is asked about', () => {
  const { purposeOf, asksPurpose } = page.purpose;
  assert.equal(purposeOf(after()), null);
  assert.equal(purposeOf(after(given[0])), 'images');
  assert.equal(purposeOf(after(...given)), 'block');
  assert.equal(purposeOf(after({ type: 'files', files: [file(1)], truth: null }, ...given)), 'images');
  const finished = after(...run(after()));
  assert.ok(!asksPurpose(finished));
  const asked = given.reduce(page.reducer.reduceBlock, finished);
  assert.ok(asksPurpose(asked) && purposeOf(asked) === null);
  assert.equal(purposeOf(page.reducer.reduceBlock(asked, { type: 'purpose', purpose: 'map' })), 'map');
  // One that was made of the block, and a block that came in the system of an orthophoto, ask nothing.
  assert.equal(purposeOf(page.reducer.reduceBlock(finished, { type: 'orthophoto', orthophoto: orthophoto(9, 'key') })), 'images');
  const opened = after({ type: 'openedFile', view: view([], { orthophoto: { kind: 'linked', text: '' } }), edits: [] }, ...given);
  assert.equal(purposeOf(opened), 'map');
  assert.ok(!page.purpose.lacksPlaceAlone(page.reducer.reduceBlock(opened, { type: 'purpose', purpose: 'block' })));
  // What could not be oriented as a block.
  assert.equal(purposeOf(after(...run(after(), view([], { oriented: 0 })), ...given)), 'images');
});

test('a block is off its ground until it is placed, and again after other heights or options', () => {
  const { isOffGround, lacksPlaceAlone, groundKey } = page.purpose;
  const reduce = page.reducer.reduceBlock;
  const wanted = [...given, { type: 'purpose', purpose: 'block' }].reduce(reduce, after(...run(after())));
  assert.ok(isOffGround(wanted) && lacksPlaceAlone(wanted));
  const ground = { key: groundKey(wanted), before: new Blob([]) };
  const placed = reduce(wanted, { type: 'onGround', view: view(['orthophoto_1']), edits: [], ground });
  assert.ok(!isOffGround(placed) && placed.shown.found.surveyed.length === 1);
  assert.ok(lacksPlaceAlone(reduce(placed, model(10))));
  assert.ok(!isOffGround(reduce(reduce(placed, model(10)), { type: 'purpose', purpose: 'map' })));
  // Other images: all of it is run.
  const more = reduce(placed, { type: 'files', files: [...placed.files, file(3)], truth: null });
  assert.ok(!lacksPlaceAlone(more) && page.purpose.isStale(more));
});

test('edits hold in the system of an orthophoto, but for those of places of another one', () => {
  const reduce = page.reducer.reduceBlock;
  const edits = [
    { kind: 'reject_points', points: [{ tie_point: 5 }] },
    { kind: 'set_use', point: 0, use: 'check' },
  ];
  const before = edits.reduce((state, edit) => reduce(state, { type: 'edit', edits: [edit] }), after(...run(after(), view(['G1']))));
  const ground = { key: '', before: new Blob([]) };
  const placed = reduce(before, { type: 'onGround', view: view(['G1', 'orthophoto_1']), edits: [], ground });
  assert.equal(placed.history, before.history);
  const rejected = reduce(placed, { type: 'edit', edits: [{ kind: 'reject_points', points: [{ ground_control: 1 }, { ground_control: 0 }] }] });
  const again = reduce(rejected, { type: 'onGround', view: view(['G1', 'orthophoto_1']), edits: [], ground });
  assert.deepEqual(again.history.edits.flat().slice(2), [{ kind: 'reject_points', points: [{ ground_control: 0 }] }]);
  const other = reduce(placed, { type: 'edit', edits: [{ kind: 'reject_points', points: [{ ground_control: 1 }] }] });
  assert.equal(reduce(other, { type: 'onGround', view: view(['G1']), edits: [], ground: null }).history.edits.length, 2);
});
