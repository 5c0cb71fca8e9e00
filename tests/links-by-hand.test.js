/** Links of an image on an orthophoto by hand, as the page's own code applies the steps: without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(
    page,
    await pageModules([
      'block/state/placed-columns',
      'block/files/keep-draft',
      'block/state/links',
      'block/state/reducer',
      'block/state/state',
      'block/state/steps',
      'block/engine/link-hands',
    ]),
  );
});

const LINKS = [
  { at: [10, 20], place: [100, 200, 5], residual_px: [0.1, -0.2], sigma_px: 0.3, role: 'used', by_hand: false },
  { at: [30, 40], place: [110, 190, 6], residual_px: [3, 4], sigma_px: 0.4, role: 'rejected', by_hand: false },
  { at: [50, 60], place: [120, 180, 7], residual_px: [0, 0.5], sigma_px: null, role: 'check', by_hand: false },
];
const IMAGE = { verdict: { kind: 'placed' }, placement: { links: LINKS, rmse_px: 0.3 } };

test('links in columns are the same ones in rows again', () => {
  const { inColumns, inRows, usedSo } = page.links;
  const linked = inColumns(IMAGE, [800, 600]);
  assert.deepEqual(linked.size, [800, 600]);
  assert.deepEqual(inRows(linked), IMAGE);
  assert.deepEqual(
    ['used', 'check', 'rejected'].map((use) => usedSo(linked.placement.links, use)),
    [1, 1, 1],
  );
  assert.deepEqual(inRows(inColumns({ verdict: { kind: 'not_placed' }, placement: null }, [1, 1])), { verdict: { kind: 'not_placed' }, placement: null });
});

test('steps change how links are used, in their order, and add further ones behind them', () => {
  const { givenLinks, shownLinks } = page.steps;
  const found = page.links.inColumns(IMAGE, [800, 600]);
  const uses = (/** @type {object[]} */ ...steps) => givenLinks(found, steps).map((/** @type {{ use: string }} */ { use }) => use);
  // What data snooping rejected is judged anew; a check link that is restored checks again.
  assert.deepEqual(uses(), ['used', 'used', 'check']);
  assert.deepEqual(uses({ kind: 'reject', link: 0 }), ['rejected', 'used', 'check']);
  assert.deepEqual(uses({ kind: 'reject', link: 0 }, { kind: 'restore', link: 0 }), ['used', 'used', 'check']);
  assert.deepEqual(uses({ kind: 'reject', link: 2 }, { kind: 'restore', link: 2 }), ['used', 'used', 'check']);
  const add = { kind: 'add', at: [1, 2], place: [3, 4] };
  assert.deepEqual(givenLinks(found, [add]).at(-1), { at: [1, 2], place: [3, 4], use: 'used', by_hand: true });
  // A link that was added is left out by its number, too.
  assert.deepEqual(uses(add, { kind: 'reject', link: 3 }), ['used', 'used', 'check', 'rejected']);
  assert.deepEqual(
    givenLinks(found, []).map((/** @type {{ place: number[] }} */ { place }) => place.length),
    [2, 2, 2],
  );
  // An image that was not placed has what was added.
  const none = page.links.inColumns({ verdict: { kind: 'not_placed' }, placement: null }, [800, 600]);
  assert.equal(shownLinks({ result: none, steps: [add], done: 0 }), null);
  assert.equal(shownLinks({ result: none, steps: [add, add], done: 1 }).count, 1);
  assert.equal(shownLinks({ result: found, steps: [add], done: 1 }).count, 3);
});

test('who left a link out is said: the user, or data snooping', () => {
  const { useWord } = page.steps;
  const steps = [
    { kind: 'add', at: [1, 2], place: [3, 4] },
    { kind: 'reject', link: 0 },
    { kind: 'restore', link: 0 },
  ];
  assert.equal(useWord({ steps, done: 3 }, 0, 'used'), 'used');
  assert.equal(useWord({ steps, done: 2 }, 0, 'rejected'), 'rejected by hand');
  // What was used again, or measured, by hand may still be rejected by data snooping.
  assert.equal(useWord({ steps, done: 3 }, 0, 'rejected'), 'rejected as a gross error');
  assert.equal(useWord({ steps, done: 1 }, 3, 'rejected'), 'rejected as a gross error');
  assert.equal(useWord({ steps: [], done: 0 }, 2, 'check'), 'check');
  // The table says of a link that was measured by hand that it was, whatever became of it.
  assert.deepEqual(
    [useWord({ steps, done: 1 }, 3, 'used', true), useWord({ steps, done: 2 }, 0, 'rejected', true), useWord({ steps, done: 1 }, 3, 'rejected', true)],
    ['measured by hand, used', 'measured by hand, rejected by hand', 'measured by hand, rejected as a gross error'],
  );
  const links = { count: 2, at: [1, 2, 1, 2], places: [0, 0, 0, 0, 0, 0], residuals: [0, 0, 9, 9], uses: [2, 2], byHand: [0, 1] };
  const use = page.placed_columns.linkColumns({ links }, [], 0, 'm').find((/** @type {{ key: string }} */ { key }) => key === 'link-use');
  assert.deepEqual([use.text(0), use.text(1)], ['rejected as a gross error', 'measured by hand, rejected as a gross error']);
});

test('a link that is measured is given up by no press where it cannot be taken', () => {
  const initial = page.state.BLOCK_INITIAL;
  const draft = { at: [1, 2], place: [3, 4] };
  const state = { ...initial, placing: { ...initial.placing, draft } };
  const done = /** @type {object[]} */ ([]);
  new page.link_hands.LinkHands({ state, dispatch: (/** @type {object} */ action) => done.push(action) }, {}).accept();
  assert.deepEqual(done, []);
});

test('a link that is being measured is kept with its image, read as it was, and given up only with that', () => {
  const { linkParts, withLink } = page.keep_draft;
  const { placing } = page.state.BLOCK_INITIAL;
  const draft = { at: [1.5, 2], place: null };
  const measured = { ...placing, draft, chosen: { image: 7, link: null } };
  assert.equal(linkParts(placing).size, 0);
  assert.equal(linkParts(measured).get('block/link'), linkParts({ ...measured, adds: true }).get('block/link'));
  const read = (/** @type {object} */ own, /** @type {object} */ change = {}) =>
    withLink({ ...placing, ...own }, new Map([...linkParts(measured)].map(([name, { value }]) => [name, { ...structuredClone(value), ...change }])));
  const placed = new Map([[7, {}]]);
  assert.deepEqual(read({ placed }), { ...placing, placed, draft, chosen: { image: 7, link: null } });
  assert.deepEqual(read({}), placing);
  assert.equal(withLink(placing, new Map()), placing);
  assert.throws(() => read({ placed }, { at: [1] }), /link\.at is damaged/u);
});

test('a project with a link that is being measured shows the orthophoto, beside a block too', () => {
  const { BLOCK_INITIAL } = page.state;
  const restored = (/** @type {object} */ own) => {
    const { files, removed, options, flight, truth, shown, opened, history, former, marks, placing } = BLOCK_INITIAL;
    const all = { files, removed, options, flight, truth, shown, opened, history, former, marks, draft: null, placing: { ...placing, ...own } };
    return page.reducer.reduceBlock(BLOCK_INITIAL, { type: 'restored', restored: all });
  };
  assert.equal(restored({}).onStage, 'map');
  assert.equal(restored({ draft: { at: null, place: [3, 4] }, chosen: { image: 7, link: null } }).onStage, 'orthophoto');
});

test('where the other end of a link is expected is asked of the end that was kept', async () => {
  const { BLOCK_INITIAL } = page.state;
  /** @type {object[]} */
  const asked = [];
  const placement = {};
  const file = { id: 7, name: 'a.jpg', file: new Blob() };
  const placed = new Map([[7, { key: 'k', result: { placement }, problem: '', found: null, steps: [], done: 0 }]]);
  const expected = (/** @type {object} */ draft) => {
    const placing = { ...BLOCK_INITIAL.placing, draft, chosen: { image: 7, link: null }, placed };
    const engine = { predict: async (/** @type {object} */ _, /** @type {object} */ given) => asked.push(given) && [5, 6] };
    return new page.link_hands.LinkHands({ state: { ...BLOCK_INITIAL, files: [file], placing } }, engine).expected();
  };
  assert.deepEqual(await expected({ at: [1, 2], place: null }), [5, 6]);
  assert.deepEqual(await expected({ at: null, place: [3, 4] }), [5, 6]);
  assert.deepEqual([await expected({ at: null, place: null }), await expected({ at: [1, 2], place: [3, 4] })], [null, null]);
  assert.deepEqual(asked, [
    { at: [1, 2], place: null },
    { at: null, place: [3, 4] },
  ]);
});
