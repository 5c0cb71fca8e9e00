/** What an opened project takes the place of: where it cannot be kept, the user is asked first. Without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(page, await pageModules(['block/files/aside', 'block/state/of-file', 'block/state/state', 'block/state/reducer']));
});

const CATALOGUE = { defaults: { placing: { crs: null } }, flight: {}, placing: {} };

/** @param {object} own */
const stateOf = (own = {}) => ({ ...page.reducer.reduceBlock(page.state.BLOCK_INITIAL, { type: 'ready', catalogue: CATALOGUE }), ...own });

/**
 * What comes of leaving a state for an opened project, and what is asked.
 * @param {any} state @param {{ keeps: boolean, answer?: boolean, isSetUp?: boolean }} how
 */
async function left(state, { keeps, answer = false, isSetUp = true }) {
  /** @type {string[]} */
  const asked = [];
  Object.assign(globalThis, { window: { confirm: (/** @type {string} */ text) => asked.push(text) > 0 && answer } });
  const aside = new page.aside.BlockAside({ state }, async () => keeps);
  return { stays: await aside.leave('Open the other project', () => {}, isSetUp), asked };
}

const CHANGED = { settings: { placing: { crs: 'EPSG:25832' } } };

test('a set-up that cannot be kept is not replaced before the user has said so', async () => {
  const state = stateOf();
  const setUp = { ...state, options: { ...state.options, ...CHANGED } };
  assert.equal(page.of_file.isReplaced(setUp, { images: [] }), true);
  assert.deepEqual(await left(setUp, { keeps: false }), {
    stays: null,
    asked: ['What was set up cannot be kept in this browser. Open the other project without it?'],
  });
  assert.equal((await left(setUp, { keeps: false, answer: true })).stays, false);
  assert.deepEqual(await left(setUp, { keeps: true }), { stays: true, asked: [] });
});

test('images that wait for a run, and a point that is being measured, are asked for, too', async () => {
  const waiting = stateOf({ files: [{ id: 1, name: 'a.jpg', file: new Blob() }] });
  assert.equal(page.of_file.isReplaced(waiting, { images: [] }), true);
  assert.equal((await left(waiting, { keeps: false })).stays, null);
  const measured = stateOf({ draft: { of: null, places: new Map([[0, { at: [1, 2], by: 'hand' }]]) } });
  const { stays, asked } = await left(measured, { keeps: false, isSetUp: false });
  assert.deepEqual([stays, asked.length], [null, 1]);
});

test('nothing, and what is simulated again, is not asked for', async () => {
  assert.deepEqual(await left(stateOf(), { keeps: false, isSetUp: false }), { stays: false, asked: [] });
  assert.deepEqual(await left(stateOf({ truth: {} }), { keeps: false }), { stays: false, asked: [] });
});
