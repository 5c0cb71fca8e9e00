/** Pairs of a block are chosen together, rejected and restored: without a browser. */

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
      'block/state/carrying',
      'block/state/columns',
      'block/state/edits',
      'block/state/naming',
      'block/state/selection',
      'block/state/words',
      'block/view/map/plan',
    ]),
  );
});

const NAMES = ['a', 'b', 'c', 'd'];

/** A pair of a view.  @param {[number, number]} images @param {Record<string, unknown>} more */
const connection = (images, more = {}) => ({
  images,
  outcome: { kind: 'connected', matches: 40 },
  reason: 'connected by 40 matches',
  geometry: null,
  shared: 5,
  chosen: 2,
  rejected: false,
  ...more,
});

/** A block of these pairs.  @param {readonly unknown[]} connections */
const viewOf = (connections) => ({ partial: false, images: NAMES.map((name) => ({ name })), leftOut: [], cameras: [], surveyed: [], connections });

const VIEW = viewOf([
  connection([0, 1]),
  connection([0, 2], { outcome: { kind: 'too_few_matches', matches: 4, needed: 15 }, reason: 'not connected' }),
  connection([1, 2]),
  connection([2, 3], { rejected: true }),
]);

const pair = (/** @type {number} */ a, /** @type {number} */ b) => ({ kind: 'pair', images: [a, b] });
const several = (/** @type {[number, number][]} */ ...pairs) => ({ kind: 'pairs', pairs });

test('pairs are chosen beside those that are, either way round; one of them leaves them again, and one alone is a pair', () => {
  const { choiceOfPairs, imagesOf, isSame, withMorePairs } = page.selection;
  const two = withMorePairs(pair(2, 1), [[0, 1]]);
  assert.deepEqual(two, several([0, 1], [1, 2]));
  assert.deepEqual(withMorePairs(two, [[2, 1]]), pair(0, 1));
  assert.deepEqual(withMorePairs({ kind: 'image', image: 1 }, [[3, 2]]), pair(2, 3));
  assert.deepEqual(withMorePairs(two, []), two);
  assert.equal(choiceOfPairs([]), null);
  assert.deepEqual(imagesOf(two), [0, 1, 2]);
  assert.ok(isSame(two, several([0, 1], [1, 2])) && !isSame(two, several([0, 1], [0, 2])) && !isSame(two, pair(0, 1)));
});

test('several chosen pairs are named, found in their table, and addressed', () => {
  const listed = { view: VIEW, given: [] };
  const two = several([0, 1], [2, 3]);
  assert.equal(page.words.describe(listed, two), '2 pairs: a – b, c – d.');
  assert.deepEqual([...page.columns.rowsOfChoice('pairs', listed, two)], [0, 3]);
  assert.deepEqual([...page.columns.rowsOfChoice('pairs', listed, pair(2, 1))], [2]);
  const address = page.address.addressOf({
    shown: { view: { ...VIEW, points: { count: 0, numbers: new Uint32Array() } } },
    onStage: 'map',
    selection: { chosen: two },
  });
  assert.equal(address, 'view=map&pairs=a&pairs=b&pairs=c&pairs=d');
  assert.deepEqual(page.address.asked(address, { ...VIEW, points: { count: 0, numbers: new Uint32Array() } }).choice, two);
  // The images were numbered anew, and one is gone.
  const moved = page.selection.inOtherView({ chosen: several([0, 1], [1, 2]), pointed: null, filters: {} }, VIEW, { images: [{ name: 'b' }, { name: 'a' }] });
  assert.deepEqual(moved.chosen, pair(0, 1));
});

test('the observations of several pairs are those of points that both images of one of them show', () => {
  const of = { images: [0, 1, 1, 2, 0, 3], points: [7, 7, 8, 8, 9, 9] };
  const rows = (/** @type {any} */ choice) => [...of.images.keys()].filter(page.columns.observationsOf(of, choice));
  assert.deepEqual(rows(pair(1, 0)), [0, 1]);
  assert.deepEqual(rows(several([0, 1], [1, 2])), [0, 1, 2, 3]);
});

test('chosen pairs that matches connect are rejected and restored together, and named', () => {
  const { editOfChoice, standingOf } = page.edits;
  const { nameOfEdit } = page.naming;
  const reject = editOfChoice('reject', several([0, 1], [0, 2], [1, 2]), VIEW, standingOf([]));
  assert.deepEqual(reject, {
    kind: 'reject_pairs',
    pairs: [
      [0, 1],
      [1, 2],
    ],
  });
  assert.equal(nameOfEdit(reject), 'reject 2 pairs');
  assert.equal(nameOfEdit({ kind: 'reject_pairs', pairs: [[1, 0]] }), 'reject 1 pair');
  assert.equal(nameOfEdit({ kind: 'restore_pairs', pairs: [[1, 0]] }, { images: NAMES, surveyed: new Map(), connected: new Set() }), 'restore b – a');
  assert.equal(editOfChoice('reject', pair(0, 2), VIEW, standingOf([])), null);
  assert.equal(editOfChoice('reject', pair(1, 0), VIEW, standingOf([reject])), null);
  assert.deepEqual(editOfChoice('restore', pair(1, 0), VIEW, standingOf([reject])), { kind: 'restore_pairs', pairs: [[1, 0]] });
  const standing = standingOf([reject, { kind: 'restore_pairs', pairs: [[1, 0]] }]);
  assert.deepEqual([...standing.pairs.values()], [[1, 2]]);
  assert.equal(editOfChoice('restore', several([0, 1], [2, 3]), VIEW, standing), null);
  assert.deepEqual(page.edits.choiceAfterEdit(several([0, 1], [1, 2]), VIEW, VIEW), several([0, 1], [1, 2]));
});

test('a rejected pair says so in its table, where it is found by it, and stays a thin line of the map', () => {
  const { columns } = page.columns.rowsOf('pairs', { view: VIEW, given: [] });
  const outcome = columns.find((/** @type {any} */ { key }) => key === 'reason');
  const texts = VIEW.connections.map((_, row) => outcome.text(row));
  assert.deepEqual(texts, ['connected by 40 matches', 'not connected', 'connected by 40 matches', 'rejected by hand; connected by 40 matches']);
  const kept = page.columns.keptBy('pairs', VIEW, { filters: { pairs: { reason: { kind: 'contains', text: 'hand' } } } });
  assert.deepEqual([0, 1, 2, 3].filter(kept), [3]);
  assert.match(page.words.describe({ view: VIEW, given: [] }, pair(2, 3)), /^c – d: rejected by hand; connected by 40 matches; /);
  const lines = page.plan.linesOf(VIEW);
  assert.deepEqual(
    lines.filter((/** @type {any} */ line) => line.rejected).map((/** @type {any} */ { pair: row, width }) => [row, width]),
    [[3, 1]],
  );
});

test('rejected pairs hold after a new run, by the names of their images', () => {
  const history = {
    edits: [
      [
        {
          kind: 'reject_pairs',
          pairs: [
            [0, 1],
            [1, 2],
          ],
        },
      ],
      [{ kind: 'restore_pairs', pairs: [[2, 3]] }],
    ],
    done: 2,
  };
  const names = (/** @type {string[]} */ images) => ({ images, surveyed: new Map(), connected: new Set(['0,1']), givenControl: 0, system: null });
  const { history: after, lost } = page.carrying.carriedOver(history, names(NAMES), names(['c', 'b', 'x']));
  assert.deepEqual([after, lost], [{ edits: [[{ kind: 'reject_pairs', pairs: [[1, 0]] }]], done: 1 }, 1]);
});
