/** Several images of a block are chosen together, and removed or rejected at once: without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(
    page,
    await pageModules([
      'block/state/address',
      'block/state/columns',
      'block/state/edits',
      'block/state/naming',
      'block/state/plots',
      'block/state/reducer',
      'block/state/removing',
      'block/state/selection',
      'block/state/state',
      'block/state/words',
      'block/files/edit',
      'shared/files/journal',
    ]),
  );
});

const NAMES = ['a', 'b', 'c', 'd', 'e'];

/** @param {readonly string[]} names */
const viewOf = (names) => ({
  partial: false,
  images: names.map((name) => ({ name, rays: 3, rmsePx: 0.5 })),
  leftOut: [],
  cameras: [],
  connections: [],
  oriented: names.length,
  surveyed: [],
  components: [],
  checks: null,
  points: { count: 0, taking: 0, lost: new Set(), sources: new Float64Array(), numbers: new Uint32Array(), rays: new Uint16Array() },
});

/** A finished block of these images.  @param {readonly string[]} names */
function found(names = NAMES) {
  const files = names.map((name, i) => ({ id: i + 1, name, file: new Blob([name]) }));
  return [
    { type: 'files', files, truth: null },
    { type: 'done', key: 'k', view: viewOf(names), files, seconds: 1 },
  ].reduce(page.reducer.reduceBlock, page.state.BLOCK_INITIAL);
}

const several = (/** @type {number[]} */ ...images) => ({ kind: 'images', images });

test('images are chosen beside those that are; one of them leaves them again, and one alone is an image', () => {
  const { choiceOfImages, isSame, withMoreImages } = page.selection;
  const two = withMoreImages({ kind: 'image', image: 3 }, [1]);
  assert.deepEqual(two, several(1, 3));
  assert.deepEqual(withMoreImages(two, [1]), { kind: 'image', image: 3 });
  // An image that is not in the block changes nothing.
  assert.deepEqual(withMoreImages({ kind: 'point', point: 2 }, []), { kind: 'point', point: 2 });
  assert.deepEqual(withMoreImages(two, [1, 2, 3]), several(1, 2, 3));
  // A pair or a point is something else.
  assert.deepEqual(withMoreImages({ kind: 'pair', images: [0, 1] }, [2]), { kind: 'image', image: 2 });
  assert.equal(choiceOfImages([]), null);
  assert.ok(isSame(two, several(1, 3)) && !isSame(two, several(1, 2, 3)) && !isSame(several(1, 2, 3), two) && !isSame(two, { kind: 'pair', images: [1, 3] }));
});

test('several chosen images are named, found in their table and in a plot, addressed, and kept through a new run by their names', () => {
  const { reduceBlock } = page.reducer;
  const state = reduceBlock(found(), { type: 'choose', choice: several(1, 3) });
  assert.equal(page.words.describe(state.shown, state.selection.chosen), '2 images: b, d.');
  assert.deepEqual([...page.columns.rowsOfChoice('images', state.shown, state.selection.chosen)], [1, 3]);
  assert.deepEqual(page.plots.plotOf('images', state.shown.view, {}).together([1, 3]), several(1, 3));
  const address = page.address.addressOf(state);
  assert.equal(address, 'view=map&images=b&images=d');
  assert.deepEqual(page.address.asked(address, state.shown.view).choice, several(1, 3));
  const again = reduceBlock(state, { type: 'done', key: 'k', view: viewOf(['a', 'd', 'b', 'x']), files: [], seconds: 1 });
  assert.deepEqual(again.selection.chosen, several(1, 2));
  const one = reduceBlock(state, { type: 'done', key: 'k', view: viewOf(['a', 'd']), files: [], seconds: 1 });
  assert.deepEqual(one.selection.chosen, { kind: 'image', image: 1 });
});

test('the chosen images are removed in one step, undone by its name, and two images stay', () => {
  const { removable } = page.removing;
  const { reduceBlock } = page.reducer;
  const state = found();
  const names = (/** @type {any} */ of) => of.files.map((/** @type {any} */ { name }) => name).join('');
  const files = (/** @type {any} */ choice) => removable(state.files, choice, state.shown.view.images).map((/** @type {any} */ { id }) => id);
  assert.deepEqual(files(several(1, 3)), [2, 4]);
  assert.deepEqual(files({ kind: 'image', image: 4 }), [5]);
  assert.deepEqual(files(several(0, 1, 2, 3)), []);
  assert.deepEqual(files({ kind: 'pair', images: [0, 1] }), []);
  // A file that is not there cannot be taken out.
  assert.deepEqual(removable(state.files.slice(2), several(1, 3), state.shown.view.images), []);
  const step = { kind: 'remove_images', files: files(several(1, 3)), after: 0 };
  const removed = reduceBlock(state, { type: 'mark', step });
  assert.deepEqual([names(removed), removed.marks.edits.length, page.naming.nameOfMarks(step)], ['ace', 1, 'remove 2 images']);
  // The journal that outlives the page has it whole.
  const journal = () => new page.journal.Journal('block/marks', page.edit.markStepFrom, page.edit.bytesOfMarks);
  const kept = new Map([...journal().parts(removed.marks)].map(([name, { value }]) => [name, structuredClone(value)]));
  assert.deepEqual(journal().read(kept), removed.marks);
  assert.equal(names(reduceBlock(removed, { type: 'gotoMark', done: 0 })), 'abcde');
});

test('the chosen images are rejected and restored together', () => {
  const { editOfChoice, standingOf } = page.edits;
  const { view } = found().shown;
  const reject = editOfChoice('reject', several(1, 3), view, standingOf([]));
  assert.deepEqual(reject, { kind: 'reject_images', images: [1, 3] });
  assert.equal(page.naming.nameOfEdit(reject), 'reject 2 images');
  assert.deepEqual(editOfChoice('reject', several(1, 2, 3), view, standingOf([reject])), { kind: 'reject_images', images: [2] });
  assert.deepEqual(editOfChoice('restore', several(0, 1, 3), view, standingOf([reject])), { kind: 'restore_images', images: [1, 3] });
  assert.equal(editOfChoice('restore', several(0, 2), view, standingOf([reject])), null);
});
