/** Control and check points that were given beside a finished block, and what is asked of the block again when they are measured: without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { geographic_positions, system_coordinates } from '../pkg/node.js';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(
    page,
    await pageModules(['block/state/columns', 'block/state/reducer', 'block/state/state', 'block/state/marks', 'block/state/words', 'block/engine/facts']),
  );
});

const points = { count: 0, taking: 0, sources: new Float64Array(), rays: new Uint16Array() };

/** A block of two images.  @param {object} [own] */
const viewOf = (own = {}) => ({
  partial: false,
  images: ['a', 'b'].map((name) => ({ name, rays: 0 })),
  oriented: 2,
  surveyed: [],
  orthophoto: null,
  origin: null,
  crs: null,
  components: [],
  checks: null,
  leftOut: [],
  cameras: [],
  connections: [],
  points,
  ...own,
});

const PLACING = { crs: null, geoid_m: null };

/** A finished block beside which points are given.  @param {string} text @param {any} [own] @param {any} [placing] */
function given(text, own = {}, placing = {}) {
  const options = { control: { name: 'points.csv', text }, settings: { placing: { ...PLACING, ...placing } } };
  return [
    { type: 'options', options },
    { type: 'done', key: 'k', view: viewOf(own), files: [], seconds: 1 },
  ].reduce(page.reducer.reduceBlock, page.state.BLOCK_INITIAL);
}

/** @param {string} image */
const measured = (image) => ({ type: 'mark', step: { kind: 'measure', marks: [{ image, point: 'A', x_px: 1, y_px: 2 }], after: 0 } });

test('a measurement of a given point, its undo and redo ask nothing of the block again', async () => {
  const store = { state: given('A,0,0,0\n') };
  let asked = 0;
  const facts = new page.facts.Facts(store, { observations: () => Promise.resolve({ asked: ++asked }) });
  const { view } = store.state.shown;
  assert.equal(facts.observations(), null);
  await Promise.resolve();
  const found = facts.observations();
  assert.deepEqual(found, { asked: 1 });
  const images = () => store.state.shown.given.map((/** @type {any} */ point) => point.images);
  assert.deepEqual(images(), [0]);
  for (const [action, count] of /** @type {[object, number][]} */ ([
    [measured('a'), 1],
    [measured('b'), 2],
    [{ type: 'gotoMark', done: 1 }, 1],
    [{ type: 'gotoMark', done: 2 }, 2],
  ])) {
    store.state = page.reducer.reduceBlock(store.state, action);
    assert.deepEqual(images(), [count]);
    assert.equal(store.state.shown.view, view);
    assert.equal(facts.observations(), found);
  }
  assert.equal(asked, 1);
  // Another view is another block.
  store.state = page.reducer.reduceBlock(store.state, { type: 'edited', view: viewOf(), edits: [] });
  assert.equal(facts.observations(), null);
  assert.equal(asked, 2);
});

test('of the tables only that of control and check points is made anew by a measurement', () => {
  const first = given('A,0,0,0\n');
  const second = page.reducer.reduceBlock(first, measured('a'));
  for (const subject of ['images', 'pairs', 'points', 'surveyed']) {
    const [before, after] = [first, second].map(({ shown }) => page.columns.rowsOf(subject, shown));
    assert.equal(before === after, subject !== 'surveyed', subject);
  }
});

const ORIGIN = { longitude_deg: 9.0006361, latitude_deg: 45.153927266, height_m: 150 };

/** What places in m east, north and up of the origin have in a system.  @param {string} crs @param {number[][]} local */
function coordinates(crs, local) {
  const onEarth = geographic_positions([ORIGIN.longitude_deg, ORIGIN.latitude_deg, ORIGIN.height_m, ...local.flat()]);
  const flat = system_coordinates(crs, onEarth);
  return local.map((_, i) => [...flat.subarray(3 * i, 3 * i + 3)]);
}

/** @param {number[][]} rows */
const tableOf = (rows) => rows.map((row, i) => `${'ABCDEF'[i]},${row.join(',')}\n`).join('');

/** @param {readonly number[]} got @param {readonly number[]} wanted @param {number} [within] */
const isNear = (got, wanted, within = 0.001) =>
  assert.ok(
    wanted.length === got.length && got.every((value, k) => Math.abs(value - (wanted[k] ?? NaN)) < within),
    `${got.join(' ')} is not ${wanted.join(' ')}`,
  );

test('given coordinates of a coordinate reference system lie where the block has them, on an orthophoto too', () => {
  const local = [
    [0, 0, 0],
    [100, 0, 5],
    [50, 50, -3],
  ];
  for (const crs of ['EPSG:32632', 'EPSG:4326', 'EPSG:3003'])
    for (const orthophoto of [null, { kind: 'linked', inCrs: true, text: '' }]) {
      const rows = coordinates(crs, local);
      const { shown } = given(tableOf(rows), { origin: ORIGIN, crs, orthophoto }, { crs });
      shown.given.forEach((/** @type {any} */ point, /** @type {number} */ i) => {
        isNear(point.place, local[i] ?? []);
        isNear(point.position, rows[i] ?? [], 1e-9);
      });
      // The table has them as given, and as the block has them.
      const { columns, count } = page.columns.rowsOf('surveyed', shown);
      assert.equal(count, 3);
      isNear(
        ['X', 'Y', 'Z'].map((axis) => columns.find((/** @type {any} */ { key }) => key === `surveyed-${axis}`).value(1)),
        [100, 0, 5],
      );
      isNear(
        ['X', 'Y', 'Z'].map((axis) => columns.find((/** @type {any} */ { key }) => key === `given-${axis}`).value(1)),
        rows[1] ?? [],
        1e-9,
      );
    }
});

test('heights above a geoid lie by it above the ellipsoid', () => {
  const [row = []] = coordinates('EPSG:32632', [[10, 20, 30]]);
  const { shown } = given(
    tableOf([[row[0] ?? NaN, row[1] ?? NaN, (row[2] ?? NaN) - 46.5]]),
    { origin: ORIGIN, crs: 'EPSG:32632' },
    { crs: 'EPSG:32632', geoid_m: 46.5 },
  );
  isNear(shown.given[0].place, [10, 20, 30]);
});

/** @param {string} name @param {number[]} position */
const surveyed = (name, position) => ({
  name,
  position,
  role: 'control',
  isUsed: true,
  point: -1,
  rays: 2,
  difference_m: [0, 0, 0],
  standard_errors_m: [null, null, null],
});

test('without an origin the points that both have lead to the system of the block; in the system of an orthophoto coordinates are as they are given', () => {
  const rows = [
    [500000, 5000000, 100],
    [500100, 5000000, 100],
    [500050, 5000050, 110],
  ];
  const both = [surveyed('A', [0, 0, 10]), surveyed('B', [100, 0, 10])];
  const inCrs = { kind: 'linked', inCrs: true, text: '' };
  for (const orthophoto of [null, inCrs]) isNear(given(tableOf(rows), { surveyed: both, orthophoto }).shown.given[0].place, [50, 50, 20]);
  const { shown } = given(tableOf(rows), { surveyed: both, orthophoto: { ...inCrs, inCrs: false } });
  assert.deepEqual(shown.given[0].place, rows[2]);
});

test('coordinates that nothing leads from stand in columns of their own, and are named as given', () => {
  const { shown } = given('A,500000,5000000,100\n', { surveyed: [surveyed('G', [1, 2, 3])] });
  assert.equal(shown.given[0].place, null);
  const { columns } = page.columns.rowsOf('surveyed', shown);
  const values = (/** @type {string} */ kind, /** @type {number} */ row) =>
    ['X', 'Y', 'Z'].map((axis) => columns.find((/** @type {any} */ { key }) => key === `${kind}-${axis}`).value(row));
  assert.deepEqual(
    [values('surveyed', 0), values('surveyed', 1)],
    [
      [1, 2, 3],
      [NaN, NaN, NaN],
    ],
  );
  assert.deepEqual(
    [values('given', 0), values('given', 1)],
    [
      [NaN, NaN, NaN],
      [500000, 5000000, 100],
    ],
  );
  assert.deepEqual(
    columns.filter((/** @type {any} */ { key }) => key.startsWith('given-')).map((/** @type {any} */ { label, unit }) => [label, unit]),
    ['X', 'Y', 'Z'].map((axis) => [`${axis} as given`, '']),
  );
  assert.match(page.words.describe(shown, { kind: 'given', name: 'A' }), /^A: X Y Z as given 500/);
});

test('a given point stays chosen when the block is found anew, unless it is in that, or given no longer', () => {
  const { reduceBlock } = page.reducer;
  const chosen = reduceBlock(given('A,0,0,0\n'), { type: 'choose', choice: { kind: 'given', name: 'A' } });
  const done = (/** @type {object} */ own) => reduceBlock(chosen, { type: 'done', key: 'k', view: viewOf(own), files: [], seconds: 1 });
  assert.deepEqual(done({}).selection.chosen, { kind: 'given', name: 'A' });
  assert.equal(done({ surveyed: [surveyed('A', [0, 0, 0])] }).selection.chosen, null);
  assert.equal(reduceBlock(chosen, { type: 'options', options: { control: null } }).selection.chosen, null);
});

/** A block of two images as it is given to a run, with the table of its measurements.  @param {string} marks @param {object} [own] of the block that is shown */
function withMarks(marks, own = {}) {
  const files = ['flight/IMG_1.JPG', 'IMG_2.JPG'].map((name, id) => ({ id, name, file: new Blob() }));
  const state = given('name,x,y,z,use\nA,0,0,0,control\nB,1,0,0,check\n', { geoidM: null, images: files.map(({ name }) => ({ name, rays: 0 })), ...own });
  return { ...state, files, options: { ...state.options, marks: { name: 'marks.csv', text: marks } } };
}

test('images are meant by other capitals, without folder and ending, in the file and beside measurements by hand', () => {
  const state = withMarks('image,point,x,y\nimg_1,A,10,20\nC:\\flight\\img_2.jpg,A,30,40\n');
  const { options, shown, marks } = state;
  assert.deepEqual(
    [...page.marks.placesOfGiven('A', shown.view, options.marks, marks)],
    [
      [0, [10, 20]],
      [1, [30, 40]],
    ],
  );
  // What is measured anew stands in place of what the file says of that image.
  const again = { image: 'flight/IMG_1.JPG', point: 'A', x_px: 11, y_px: 21 };
  const byHand = page.reducer.reduceBlock(state, { type: 'mark', step: { kind: 'measure', marks: [again], after: 0 } });
  assert.deepEqual(
    [...page.marks.placesOfGiven('A', shown.view, options.marks, byHand.marks)],
    [
      [0, [11, 21]],
      [1, [30, 40]],
    ],
  );
  assert.equal(page.marks.collectedOf(byHand).twice, 1);
});

test('three control points place a block; beside GNSS positions that do, one point is enough, also to check it', () => {
  const inTwo = (/** @type {any} */ state, /** @type {string} */ point) => {
    const marks = ['flight/IMG_1.JPG', 'IMG_2.JPG'].map((image) => ({ image, point, x_px: 1, y_px: 2 }));
    return page.reducer.reduceBlock(state, { type: 'mark', step: { kind: 'measure', marks, after: 0 } });
  };
  const origin = { longitude_deg: 13, latitude_deg: 47, height_m: 500 };
  const placed = { origin, crs: 'EPSG:32633', geoidM: 0 };
  for (const [own, point, needed, isTaken] of /** @type {[object, string, number, boolean][]} */ ([
    [{}, 'A', 3, false],
    [placed, 'A', 1, true],
    [placed, 'B', 1, true],
    // Heights that count from another level do not place the block.
    [{ ...placed, geoidM: null }, 'A', 3, false],
    [{ ...placed, crs: null }, 'A', 3, false],
  ])) {
    const before = { ...withMarks('', own), options: { ...withMarks('', own).options, marks: null } };
    assert.equal(page.marks.waitsForMarks(before), true);
    const state = inTwo(before, point);
    assert.equal(page.marks.waitsForMarks(state), !isTaken);
    assert.equal(page.marks.givenToRun(state).control === null, !isTaken);
    assert.equal(page.marks.collectedOf(state).needed, needed);
    assert.match(page.words.controlText(state), new RegExp(`${needed} (is|are) needed`));
  }
});
