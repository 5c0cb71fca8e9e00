/** Whether a run that ended with its tab goes on by itself: without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(page, await pageModules(['block/files/going-on', 'block/state/reducer', 'block/state/state', 'shared/state/store']));
});

const STARTED = { type: 'started', key: 'a' };
const STEP = { type: 'step', step: { stage: 'images', done: 1, of: 4 } };

/** What is kept after these actions, with so many records of earlier runs.  @param {number} records @param {object[]} actions */
function keptAfter(records, ...actions) {
  const { BLOCK_INITIAL } = page.state;
  const store = new page.store.Holder(BLOCK_INITIAL, page.reducer.reduceBlock);
  const engine = { records: new Map(Array.from({ length: records }, (_, i) => [String(i), null])) };
  const run = new page.going_on.RunUnderWay(store, engine);
  for (const action of actions) {
    store.dispatch(action);
    // What it makes does not change when it began.
    engine.records.set(`made ${engine.records.size}`, null);
  }
  return new Map(run.parts().map((/** @type {[string, { value: object }]} */ [name, { value }]) => [name, value]));
}

test('that a run is under way is kept as long as it is, with what was there when it began', () => {
  assert.deepEqual([...keptAfter(2)], []);
  assert.deepEqual([...keptAfter(2, STARTED, STEP, STEP)], [['block/running', { records: 2 }]]);
  assert.deepEqual([...keptAfter(2, STARTED, STEP, { type: 'ended', failure: null })], []);
});

test('it goes on where it made something, and waits where it made nothing before the tab ended', () => {
  const { goesOn } = page.going_on;
  const kept = keptAfter(2, STARTED);
  assert.deepEqual(
    [2, 3].map((records) => goesOn(kept, records)),
    [false, true],
  );
  assert.equal(goesOn(new Map(), 3), false);
  assert.throws(() => goesOn(new Map([['block/running', { records: 'many' }]]), 3), /running\.records/);
});
