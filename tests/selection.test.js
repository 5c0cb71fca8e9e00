/** What is chosen and pointed at in a block, one for all views, as the page's own code keeps it: without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(
    page,
    await pageModules([
      'block/state/selection',
      'block/state/reducer',
      'block/state/state',
      'block/state/address',
      'block/state/edits',
      'block/state/observations',
    ]),
  );
});

/** A view of images of these names.  @param {string[]} names */
const viewOf = (...names) => ({
  partial: false,
  images: names.map((name) => ({ name })),
  points: { count: 0, sources: new Float64Array(), numbers: new Uint32Array(), rays: new Uint16Array() },
});

/** @param {Record<string, unknown>} view */
const shown = (view) => ({ type: 'done', key: '', view, files: [], seconds: 0 });

test('what is chosen again, or pointed at again, is the same state', () => {
  const { reducer, state: states } = page;
  const pair = { kind: 'pair', images: [1, 2] };
  const once = reducer.reduceBlock(states.BLOCK_INITIAL, { type: 'choose', choice: pair });
  assert.notEqual(once, states.BLOCK_INITIAL);
  assert.deepEqual(once.selection.chosen, pair);
  assert.equal(reducer.reduceBlock(once, { type: 'choose', choice: { kind: 'pair', images: [2, 1] } }), once);
  assert.notEqual(reducer.reduceBlock(once, { type: 'choose', choice: { kind: 'pair', images: [2, 3] } }), once);
  const pointed = reducer.reduceBlock(once, { type: 'point', choice: { kind: 'point', point: 4 } });
  assert.equal(reducer.reduceBlock(pointed, { type: 'point', choice: { kind: 'point', point: 4 } }), pointed);
  assert.deepEqual(pointed.selection.chosen, pair);
});

test('points are chosen together once each, in order; one is one, and none is nothing', () => {
  const { choiceOfPoints, pointsOf } = page.selection;
  assert.equal(choiceOfPoints([]), null);
  assert.deepEqual(choiceOfPoints([7, 7]), { kind: 'point', point: 7 });
  assert.deepEqual(choiceOfPoints([30, 7, 100, 7]), { kind: 'points', points: Uint32Array.of(7, 30, 100) });
  assert.deepEqual([...pointsOf({ kind: 'observation', point: 3, image: 1 })], [3]);
  assert.deepEqual([...pointsOf({ kind: 'image', image: 3 })], []);
});

test('choices of other kinds are never the same', () => {
  const { isSame } = page.selection;
  const kinds = [
    null,
    { kind: 'image', image: 1 },
    { kind: 'image', image: 2 },
    { kind: 'pair', images: [1, 2] },
    { kind: 'point', point: 1 },
    { kind: 'observation', point: 1, image: 1 },
    { kind: 'observation', point: 1, image: 2 },
    { kind: 'points', points: Uint32Array.of(1, 2) },
    { kind: 'points', points: Uint32Array.of(1, 2, 3) },
    { kind: 'observations', points: Uint32Array.of(1, 1), images: Uint32Array.of(1, 2) },
    { kind: 'observations', points: Uint32Array.of(1, 1), images: Uint32Array.of(1, 3) },
  ];
  for (const [i, a] of kinds.entries()) for (const [j, b] of kinds.entries()) assert.equal(isSame(a, structuredClone(b)), i === j, JSON.stringify([a, b]));
});

test('another view of the images keeps what is chosen by name, and no point of another numbering', () => {
  const { reducer, state: states } = page;
  const first = reducer.reduceBlock(states.BLOCK_INITIAL, shown(viewOf('a', 'b', 'c')));
  const choose = (/** @type {object} */ choice) => reducer.reduceBlock(first, { type: 'choose', choice });
  const then = (/** @type {object} */ choice, /** @type {string[]} */ ...names) =>
    reducer.reduceBlock(choose(choice), shown(viewOf(...names))).selection.chosen;
  assert.deepEqual(then({ kind: 'pair', images: [1, 2] }, 'x', 'c', 'b'), { kind: 'pair', images: [2, 1] });
  assert.deepEqual(then({ kind: 'image', image: 0 }, 'x', 'a'), { kind: 'image', image: 1 });
  assert.equal(then({ kind: 'pair', images: [0, 2] }, 'a', 'b'), null);
  assert.equal(then({ kind: 'points', points: Uint32Array.of(1, 2) }, 'a', 'b', 'c'), null);
});

test('filters stand beside each other, and stay when the block is computed again', () => {
  const { reducer, state: states } = page;
  let state = reducer.reduceBlock(states.BLOCK_INITIAL, { type: 'filter', subject: 'images', filter: { name: { kind: 'contains', text: 'DJI' } } });
  state = reducer.reduceBlock(state, { type: 'filter', subject: 'points', filter: { rays: { kind: 'range', from: 3, to: null } } });
  state = reducer.reduceBlock(state, shown(viewOf('a')));
  assert.deepEqual(Object.keys(state.selection.filters), ['images', 'points']);
});

test('a view is a page of its own, and so is a pair; what is chosen there is none, nor are other photos in the place of a pair', () => {
  const { isOtherPage } = page.address;
  const pair = 'view=pair&image=a.png&image=b.png';
  assert.ok(isOtherPage('#view=map&point=3', 'view=matrix&point=3'));
  assert.ok(isOtherPage('#view=map', pair) && isOtherPage(`#${pair}`, 'view=pair&image=b.png&image=c.png'));
  assert.ok(isOtherPage('', 'view=map') && isOtherPage('#view=map', ''));
  assert.ok(!isOtherPage('#view=map&image=a.png', 'view=map&point=3') && !isOtherPage(`#${pair}`, pair));
  assert.ok(!isOtherPage(`#${pair}`, '') && !isOtherPage('', pair));
});

test('the address names view and choice, and finds them again where the block has them', () => {
  const { addressOf, asked } = page.address;
  const view = { ...viewOf('a b.jpg', 'c&d.jpg'), points: { count: 300, numbers: Uint32Array.from({ length: 300 }, (_, i) => 2 * i + 3) } };
  const written = (/** @type {object | null} */ chosen, onStage = 'map') => addressOf({ shown: { view }, onStage, selection: { chosen } });
  for (const chosen of [
    null,
    { kind: 'image', image: 1 },
    { kind: 'pair', images: [1, 0] },
    { kind: 'point', point: 11 },
    { kind: 'observation', point: 11, image: 0 },
    { kind: 'points', points: Uint32Array.of(0, 7, 299) },
  ])
    assert.deepEqual(asked(`#${written(chosen, 'images')}`, view), { view: 'images', choice: chosen });
  assert.equal(written({ kind: 'point', point: 11 }), 'view=map&point=25');
  // Too many points are not named.
  assert.equal(written({ kind: 'points', points: Uint32Array.from({ length: 200 }, (_, i) => i) }), 'view=map');
  assert.equal(asked('#block-view', view), null);
  assert.deepEqual(asked('#view=map&point=0,4,603,x', view), { view: 'map', choice: null });
  assert.deepEqual(asked('#view=matrix&image=gone.jpg', view), { view: 'matrix', choice: null });
  assert.equal(addressOf({ shown: null, onStage: 'map', selection: { chosen: null } }), '');
});

test('an image of the block that is placed on the orthophoto is chosen in both, or in neither', () => {
  const { reducer, state: states } = page;
  const files = ['a', 'b', 'c'].map((name, i) => ({ id: 10 + i, name, file: null }));
  const placed = { key: '', result: null, problem: '', found: null, steps: [], done: 0 };
  /** @param {any} state @param {object[]} actions */
  const after = (state, ...actions) => actions.reduce((now, action) => reducer.reduceBlock(now, action), state);
  const looked = (/** @type {number | null} */ image, link = null) => ({ type: 'choosePlaced', looked: { image, link } });
  const choose = (/** @type {object | null} */ choice) => ({ type: 'choose', choice });
  const start = after(
    states.BLOCK_INITIAL,
    { type: 'files', files, truth: null },
    // In another order than the files, and one of them is in no block.
    shown(viewOf('b', 'a')),
    { type: 'placed', image: files[0], placed },
    { type: 'placed', image: files[2], placed },
  );
  const chosen = (/** @type {any} */ { selection, placing }) => [selection.chosen, placing.chosen];
  assert.deepEqual(chosen(after(start, choose({ kind: 'image', image: 1 }))), [
    { kind: 'image', image: 1 },
    { image: 10, link: null },
  ]);
  assert.deepEqual(chosen(after(start, looked(10))), [
    { kind: 'image', image: 1 },
    { image: 10, link: null },
  ]);
  assert.deepEqual(chosen(after(start, choose({ kind: 'image', image: 1 }), choose(null))), [null, { image: null, link: null }]);
  assert.deepEqual(chosen(after(start, looked(10), looked(null))), [null, { image: null, link: null }]);
  // A link is one of its image; what one of them does not have stays as it is in the other.
  assert.deepEqual(chosen(after(start, looked(10), { type: 'choosePlaced', looked: { image: 10, link: 3 } })), [
    { kind: 'image', image: 1 },
    { image: 10, link: 3 },
  ]);
  assert.deepEqual(chosen(after(start, looked(10), choose({ kind: 'image', image: 0 }))), [
    { kind: 'image', image: 0 },
    { image: 10, link: null },
  ]);
  assert.deepEqual(chosen(after(start, choose({ kind: 'point', point: 4 }), looked(12))), [
    { kind: 'point', point: 4 },
    { image: 12, link: null },
  ]);
});

test('points that are chosen stay so in a block of the same tie points, and in no other one', () => {
  const { reduceBlock } = page.reducer;
  const codes = (/** @type {object[]} */ ...sources) => Float64Array.from(sources, (source) => page.edits.codeOfSource(source));
  const found = (/** @type {Float64Array} */ sources, /** @type {object[]} */ surveyed = []) => ({
    ...viewOf('a', 'b'),
    surveyed,
    givenControl: surveyed.length,
    points: { count: sources.length, sources, numbers: new Uint32Array(sources.length), rays: new Uint16Array(sources.length).fill(2) },
  });
  const before = found(codes({ tie_point: 4 }, { tie_point: 9 }, { ground_control: 0 }), [{ name: 'G0', control: 0 }]);
  const chosen = (/** @type {object} */ view, /** @type {object} */ choice) => {
    const first = reduceBlock(reduceBlock(page.state.BLOCK_INITIAL, shown(before)), { type: 'choose', choice });
    return reduceBlock(first, shown(view)).selection.chosen;
  };
  const point = (/** @type {number} */ index) => ({ kind: 'point', point: index });
  assert.deepEqual(chosen({ ...before }, point(1)), point(1));
  assert.deepEqual(chosen({ ...before }, { kind: 'observation', point: 1, image: 1 }), { kind: 'observation', point: 1, image: 1 });
  assert.deepEqual(chosen({ ...before }, point(2)), point(2));
  // Other tie points, and another surveyed point of the same number.
  assert.equal(chosen(found(codes({ tie_point: 4 }, { tie_point: 10 }, { ground_control: 0 }), before.surveyed), point(1)), null);
  assert.equal(chosen({ ...before, surveyed: [{ name: 'G1', control: 0 }] }, point(2)), null);
  assert.deepEqual(chosen({ ...before, surveyed: [{ name: 'G1', control: 0 }] }, point(1)), point(1));
});

test('observations are chosen together once each; one is one, and what is done to them is done to none beside them', () => {
  const { observations, selection, edits, address } = page;
  const of = (/** @type {[number, number][]} */ ...pairs) => ({
    points: Uint32Array.from(pairs, ([point]) => point),
    images: Uint32Array.from(pairs, ([, image]) => image),
  });
  assert.equal(observations.choiceOfObservations(of()), null);
  const one = observations.choiceOfObservations(of([7, 2], [7, 2]));
  assert.deepEqual(one, { kind: 'observation', point: 7, image: 2 });
  const several = observations.withMoreObservations(one, of([7, 0], [3, 5], [7, 2]));
  assert.deepEqual(several, { kind: 'observations', ...of([3, 5], [7, 0], [7, 2]) });
  assert.deepEqual([...selection.pointsOf(several)], [3, 7]);
  assert.deepEqual(observations.withMoreObservations(several, of([7, 0])), { kind: 'observations', ...of([3, 5], [7, 2]) });
  // In the place of points, whose other observations nobody chose.
  assert.deepEqual(observations.withMoreObservations({ kind: 'points', points: Uint32Array.of(1, 2) }, of([7, 0])), {
    kind: 'observation',
    point: 7,
    image: 0,
  });

  const view = {
    ...viewOf('a', 'b', 'c'),
    points: { count: 8, sources: Float64Array.from({ length: 8 }, (_, i) => 3 * i), numbers: Uint32Array.from({ length: 8 }, (_, i) => i + 1) },
  };
  const rejected = [{ kind: 'reject_observations', observations: [{ point: { tie_point: 3 }, image: 5 }] }];
  const edit = (/** @type {string} */ kind) => edits.editOfChoice(kind, several, view, edits.standingOf(rejected));
  assert.deepEqual(edit('reject'), {
    kind: 'reject_observations',
    observations: [0, 2].map((image) => ({ point: { tie_point: 7 }, image })),
  });
  assert.deepEqual(edit('restore'), { kind: 'restore_observations', observations: [{ point: { tie_point: 3 }, image: 5 }] });
  // Points go by what they are, and one that is gone takes its observations along.
  const after = { ...view, points: { ...view.points, sources: Float64Array.of(0, 21) } };
  assert.deepEqual(edits.choiceAfterEdit(several, view, after), { kind: 'observations', ...of([1, 0], [1, 2]) });
  // An address that named their points would choose all observations of these.
  assert.equal(address.addressOf({ shown: { view }, onStage: 'map', selection: { chosen: several } }), 'view=map');
});
