/** Fiducial marks that are measured in the pictures: which one is in hand, where it is expected, and which take part. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { orient_fiducials } from '../pkg/node.js';
import { pageModules } from './www.js';

const {
  mark_steps: { nameOfMarkStep },
  marking: { Marking },
  marks: { measuredPhoto, wholeMarks },
  store: { Store },
} = await pageModules(['pair/state/mark-steps', 'pair/state/marking', 'pair/state/marks', 'pair/state/store']);

const PIXEL_MM = 0.02;

/** Photo coordinates of a place in a scan of 1000 x 800 px.  @param {readonly [number, number]} place */
const photo = ([col, row]) => ({ x_mm: PIXEL_MM * (col - 500), y_mm: PIXEL_MM * (400 - row) });

/** @type {readonly (readonly [number, number])[]} */
const PLACES = [
  [30, 40],
  [970, 45],
  [965, 760],
  [35, 755],
];

/** A left image that begins at column 10 and row 20 of its scan, whose marks are known but not measured. */
function begun() {
  const store = new Store();
  const image = { id: 1, name: 'left.png', source: { kind: 'file', file: new Blob() } };
  store.dispatch({ type: 'images', images: { left: image } });
  const fiducials = PLACES.map((place) => ({ col: NaN, row: NaN, ...photo(place) }));
  store.dispatch({ type: 'photo', side: 'left', photo: { fiducials, origin: [10, 20] } });
  /** @type {[string, readonly number[]][]} */
  const shown = [];
  const orienter = async (/** @type {any} */ marks, /** @type {any} */ model) => orient_fiducials(marks, model);
  const marking = new Marking(store, orienter, (/** @type {string} */ side, /** @type {readonly number[]} */ at) => shown.push([side, at]));
  return { store, marking, shown, marks: () => store.state.photos.left.fiducials };
}

test('a place beside the picture is refused, which is said until one on it is taken; the mark stays where it was', () => {
  const { store, marking, marks } = begun();
  store.dispatch({ type: 'stageDone', stage: 'openLeft', result: { key: 'left', ms: 1, value: { info: { width: 990, height: 780 }, overview: null } } });
  marking.toggle('left');
  for (const beside of [
    [-0.5, 20],
    [20, 780.5],
    [995, 20],
  ]) {
    marking.place('left', beside);
    assert.ok(Number.isNaN(marks()[0].col), `${beside}`);
    assert.match(store.state.notice?.text ?? '', /beside the picture/);
  }
  assert.equal(store.state.markSteps.edits.length, 0);
  marking.place('left', [0, 20]);
  assert.deepEqual([marks()[0].col, marks()[0].row, store.state.notice], [10, 40, null]);
  // Nor do keys bring it there.
  marking.nudge(-1, 0);
  assert.deepEqual([marks()[0].col, store.state.notice?.kind], [10, 'info']);
});

test('marks are measured one after the other, and expected where those that are measured have them', async () => {
  const { store, marking, shown, marks } = begun();
  marking.toggle('left');
  assert.deepEqual(store.state.mark, { side: 'left', index: 0, expected: null });
  assert.deepEqual(wholeMarks(store.state.photos.left), []);
  for (const [index, [col, row]] of PLACES.entries()) {
    const { expected } = store.state.mark;
    // From two marks on; exact, since the scan is.
    if (index < 2) assert.equal(expected, null);
    else assert.ok(Math.abs(expected[0] - (col - 10)) < 1e-6 && Math.abs(expected[1] - (row - 20)) < 1e-6, `${expected}`);
    marking.place('left', [col - 10, row - 20]);
    // Not of that image.
    marking.place('right', [1, 1]);
    assert.deepEqual([marks()[index].col, marks()[index].row], [col, row]);
    assert.equal(wholeMarks(store.state.photos.left).length, index + 1);
    await marking.go(1);
  }
  assert.equal(store.state.mark.index, 4);
  // The third and the fourth were expected before they were measured, and shown.
  assert.deepEqual(
    shown.map(([side]) => side),
    ['left', 'left'],
  );
  // A new one, whose photo coordinates are still to be typed: it takes no part.
  marking.place('left', [500, 400]);
  assert.equal(marks().length, 5);
  assert.equal(wholeMarks(store.state.photos.left).length, 4);
  marking.toggle('left');
  assert.deepEqual([store.state.tool, store.state.mark], ['look', null]);
});

test('a mark is moved by hundredths of a pixel at most, and cleared', async () => {
  const { store, marking, marks } = begun();
  marking.toggle('left');
  marking.nudge(1, 1);
  assert.ok(Number.isNaN(marks()[0].col), 'nothing is moved that is not measured');
  marking.place('left', [20.123456, 20]);
  marking.nudge(0.1, -0.1);
  assert.deepEqual([marks()[0].col, marks()[0].row], [30.22, 39.9]);
  marking.clear();
  assert.ok(Number.isNaN(marks()[0].col));
  assert.deepEqual(photo(PLACES[0] ?? [0, 0]), { x_mm: marks()[0].x_mm, y_mm: marks()[0].y_mm });
  await marking.go(-1);
  assert.equal(store.state.mark.index, 0);
});

test('the tool ends where the mark in hand may be another one: images swapped, marks removed', () => {
  for (const act of [
    (/** @type {any} */ store) => store.dispatch({ type: 'swap' }),
    (/** @type {any} */ store) => store.dispatch({ type: 'photo', side: 'left', photo: { fiducials: [] } }),
    (/** @type {any} */ store) => store.dispatch({ type: 'photo', side: 'left', photo: { fiducials: store.state.photos.left.fiducials.slice(1) } }),
  ]) {
    const { store, marking, marks } = begun();
    marking.toggle('left');
    assert.equal(store.state.tool, 'fiducials');
    act(store);
    assert.deepEqual([store.state.tool, store.state.mark], ['look', null]);
    const before = marks();
    marking.place('left', [5, 5]);
    assert.equal(marks(), before);
  }
});

test('a mark is expected anew when another one moves, and an answer that comes late counts no more', async () => {
  const { store, marking } = begun();
  marking.toggle('left');
  for (const [col, row] of PLACES.slice(0, 3)) {
    marking.place('left', [col - 10, row - 20]);
    await marking.go(1);
  }
  const { expected } = store.state.mark;
  const end = marking.go(1);
  store.dispatch({ type: 'photo', side: 'left', photo: { origin: [0, 0] } });
  await end;
  await marking.go(-1);
  const later = store.state.mark.expected;
  assert.ok(Math.abs(later[0] - expected[0] - 10) < 1e-6 && Math.abs(later[1] - expected[1] - 20) < 1e-6, `${expected} ${later}`);
});

const named = (/** @type {any} */ { state }) => state.markSteps.edits.map((/** @type {any} */ step) => nameOfMarkStep(step, state.images));

test('what was done to marks is undone and done again, by its names; a mark that keys move is moved once', async () => {
  const { store, marking, marks } = begun();
  const states = [marks()];
  marking.toggle('left');
  marking.place('left', [20, 20]);
  states.push(marks());
  for (let i = 0; i < 3; i++) marking.nudge(0.1, 0);
  states.push(marks());
  assert.equal(marks()[0].col, 30.3);
  marking.place('left', [500, 500]);
  states.push(marks());
  marking.clear();
  states.push(marks());
  marking.remove('left', 0);
  states.push(marks());
  marking.removeAll('left');
  states.push(marks());
  assert.deepEqual(
    named(store),
    [
      ...['measure fiducial mark 1', 'move fiducial mark 1', 'move fiducial mark 1', 'clear fiducial mark 1', 'remove fiducial mark 1'],
      'remove all fiducial marks',
    ].map((name) => `${name} of left.png`),
  );
  for (const state of states.slice(0, -1).reverse()) {
    marking.step(-1);
    assert.deepEqual(marks(), state);
    assert.equal(store.state.tool, 'fiducials');
    assert.deepEqual([store.state.mark.side, store.state.mark.index], ['left', 0]);
  }
  marking.step(-1);
  assert.deepEqual(marks(), states[0]);
  for (const state of states.slice(1)) {
    marking.step(1);
    assert.deepEqual(marks(), state);
  }
  // What was undone is given up by another step.
  marking.step(-1);
  marking.type('left', 1, { x_mm: 7 });
  assert.deepEqual([named(store).at(-1), marks()[1].x_mm, named(store).length], ['change fiducial mark 2 of left.png', 7, 6]);
});

test('the tool goes on where marks are removed by hand, and stays away where it was; what changes nothing is no step', () => {
  const { store, marking, marks } = begun();
  const all = marks();
  // From the table alone.
  marking.remove('left', 1);
  assert.equal(marks().length, 3);
  marking.step(-1);
  assert.deepEqual([marks(), store.state.tool, store.state.mark], [all, 'look', null]);
  // New ones are alike until they are typed.
  marking.add('left');
  marking.add('left');
  marking.type('left', 4, { x_mm: 7 });
  assert.deepEqual([marks()[4].x_mm, marks()[5].x_mm], [7, NaN]);
  for (let i = 0; i < 3; i++) marking.step(-1);
  assert.deepEqual(marks(), all);
  marking.toggle('left');
  marking.remove('left', 3);
  assert.deepEqual([marks().length, store.state.tool, store.state.mark.index], [3, 'fiducials', 3]);
  marking.step(-1);
  assert.deepEqual(marks(), all);
  marking.removeAll('left');
  assert.deepEqual([store.state.tool, store.state.mark.index], ['fiducials', 0]);
  marking.step(-1);
  // What was taken back can still be done again.
  marking.clear();
  marking.type('left', 0, { x_mm: all[0].x_mm, col: NaN });
  const done = () => store.state.markSteps.done;
  assert.deepEqual([named(store), done()], [['remove all fiducial marks of left.png'], 0]);
  marking.step(1);
  marking.removeAll('left');
  assert.deepEqual([named(store), done()], [['remove all fiducial marks of left.png'], 1]);
});

test('steps go with their image, and are none on marks that another pair has', () => {
  const { store, marking, marks } = begun();
  marking.toggle('left');
  marking.place('left', [20, 20]);
  store.dispatch({ type: 'swap' });
  const before = store.state.photos.right.fiducials;
  marking.step(-1);
  assert.notEqual(store.state.photos.right.fiducials, before);
  marking.step(1);
  assert.deepEqual(store.state.photos.right.fiducials, before);
  assert.deepEqual(named(store), ['measure fiducial mark 1 of left.png']);
  store.dispatch({ type: 'swap' });
  store.dispatch({ type: 'photo', side: 'left', photo: { fiducials: [] } });
  assert.equal(named(store).length, 0);
  marking.step(-1);
  assert.deepEqual(marks(), []);
  // Those of the other image stay.
  store.dispatch({ type: 'images', images: { right: { id: 2, name: 'right.png', source: { kind: 'file', file: new Blob() } } } });
  marking.add('left');
  marking.add('right');
  marking.add('left');
  marking.step(-1);
  store.dispatch({ type: 'images', images: { left: { id: 3, name: 'other.png', source: { kind: 'file', file: new Blob() } } } });
  assert.deepEqual([named(store), store.state.markSteps.done], [['add fiducial mark 1 to right.png'], 1]);
});

test('the table that a photo has first is given, one that takes the place of marks is a step', () => {
  const { store, marking, marks } = begun();
  const table = (/** @type {number} */ col) => [{ col, row: 2, x_mm: 3, y_mm: 4 }];
  const give = (/** @type {string} */ side, /** @type {number} */ col) =>
    store.dispatch({ type: 'marked', step: { side, deed: 'given', at: 0, out: store.state.photos[side].fiducials, put: table(col) } });
  give('right', 1);
  assert.deepEqual([named(store), store.state.photos.right.fiducials], [[], table(1)]);
  const before = marks();
  give('left', 5);
  assert.deepEqual([named(store), marks()], [['take a table of fiducial marks for left.png'], table(5)]);
  marking.removeAll('left');
  give('left', 6);
  for (const expected of [[], table(5), before]) {
    marking.step(-1);
    assert.deepEqual(marks(), expected);
  }
});

test('thousands of steps on marks are undone and done again, in whatever order', () => {
  const { store, marking, marks } = begun();
  const states = [marks()];
  for (let i = 0; i < 3000; i++) {
    if (i % 5 === 0) marking.add('left');
    else if (i % 5 === 4) marking.remove('left', i % marks().length);
    else marking.type('left', i % marks().length, { col: i });
    states.push(marks());
  }
  assert.equal(store.state.markSteps.done, 3000);
  for (const done of [2999, 17, 0, 1500, 3000, 1]) {
    store.dispatch({ type: 'marksAfter', done });
    assert.deepEqual(marks(), states[done]);
  }
});

test('what is not complete changes nothing of the pair', () => {
  const whole = { col: 1, row: 2, x_mm: 3, y_mm: 4 };
  const measured = (/** @type {object[]} */ fiducials) => JSON.stringify(measuredPhoto({ fiducials, origin: null }));
  assert.equal(measured([whole, { ...whole, col: NaN }]), measured([whole]));
  assert.equal(measured([{ ...whole, y_mm: NaN }]), measured([]));
});

test('without an image there is nothing to measure in', () => {
  const { store, marking } = begun();
  marking.toggle('right');
  assert.deepEqual([store.state.tool, store.state.mark], ['look', null]);
});

test('photo coordinates are taken from the other image where they are missing, and it is undone', () => {
  const { store, marking, marks } = begun();
  store.dispatch({ type: 'images', images: { right: { id: 2, name: 'right.png', source: { kind: 'file', file: new Blob() } } } });
  const right = () => store.state.photos.right.fiducials;
  // One is measured already, and one has coordinates of its own.
  const own = [
    { col: 12, row: 34, x_mm: NaN, y_mm: NaN },
    { col: 900, row: 30, x_mm: 9, y_mm: 8 },
  ];
  store.dispatch({ type: 'photo', side: 'right', photo: { fiducials: own } });
  marking.takeCoordinates('right');
  assert.deepEqual(right(), [{ ...own[0], ...photo(PLACES[0] ?? [0, 0]) }, own[1], ...marks().slice(2)]);
  assert.deepEqual(wholeMarks(store.state.photos.right), right().slice(0, 2));
  const taken = right();
  // Nothing is missing any more.
  marking.takeCoordinates('right');
  assert.equal(right(), taken);
  marking.takeCoordinates('left');
  assert.deepEqual(marks().length, 4);
  assert.deepEqual(named(store), ['take photo coordinates for right.png']);
  marking.step(-1);
  assert.deepEqual(right(), own);
});
