/** Fiducial marks of scans that are measured in the pair's part of the page: which scans come next, and what of the marks the block takes. Without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { parse_fiducials } from '../pkg/node.js';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(
    page,
    await pageModules(['block/state/film', 'block/state/scan-marks', 'block/state/frames-step', 'block/state/state', 'block/files/keep-placing']),
  );
});

/** A film of 100 x 80 mm on a scan of 240 x 200 px.  @type {readonly (readonly [number, number, number, number])[]} */
const PLACES = [
  [20, 20.25, -50, 40],
  [220, 20, 50, 40],
  [220, 180, 50, -40],
  [20, 180, -50, -40],
];
const MARKS = PLACES.map(([col, row, x_mm, y_mm]) => ({ col, row, x_mm, y_mm }));
const TABLE = 'col,row,x_mm,y_mm\n20,20.25,-50,40\n220,20,50,40\n220,180,50,-40\n20,180,-50,-40\n';

const images = (/** @type {string[]} */ ...names) => names.map((name) => ({ name }));
const names = (/** @type {readonly { name: string }[]} */ list) => list.map(({ name }) => name);
const table = (/** @type {string} */ name, text = TABLE) => ({ name, text });
const film = (/** @type {object} */ given = {}) => ({ ...page.film.NO_FILM, ...given });

/** A scan in the pair.  @param {string} image @param {object} [measured] */
const scan = (image, measured = {}) => ({ image, all: MARKS, marks: MARKS, withoutMm: 0, size: [240, 200], ...measured });

test('marks are written as the table of their scan, which reads as the same marks', () => {
  const made = page.scan_marks.tableOfMarks('roll.1/1963_017.tif', MARKS);
  assert.deepEqual(made, table('roll.1/1963_017.csv'));
  assert.deepEqual(parse_fiducials(made.text), MARKS);
  assert.notEqual(page.film.filmOf(film({ marks: [made] }), 'roll.1/1963_017.tif'), null);
});

test('images are scans once anything is given of film, or marks are measured; frames are none', () => {
  const { scansOf, awaitsFrames } = page.film;
  const all = images('a.tif', 'b-film.png', 'c-film2.png', 'd.tif');
  const camera = { name: 'film.json', text: '{"focal_mm": 152}' };
  assert.deepEqual(scansOf(film(), all), []);
  // A table of another image makes none.
  assert.deepEqual(scansOf(film({ marks: [table('x.csv')] }), all), []);
  for (const given of [{ camera }, { areScans: true }, { marks: [table('a.csv')] }]) {
    assert.deepEqual(names(scansOf(film(given), all)), ['a.tif', 'd.tif']);
    assert.ok(awaitsFrames(film(given), all));
  }
  assert.ok(!awaitsFrames(film({ camera }), images('b-film.png')));
});

test('scans without marks come two by two, and once all have some they are gone through again', () => {
  const { nextScans, countedScans } = page.scan_marks;
  const all = images('a.tif', 'b.tif', 'c.tif', 'd.tif', 'e.tif');
  const given = film({ areScans: true, marks: [table('B.csv')] });
  assert.deepEqual(countedScans(given, all), { measured: 1, scans: 5 });
  assert.deepEqual(names(nextScans(given, all)), ['a.tif', 'c.tif']);
  assert.deepEqual(names(nextScans(given, all, ['a.tif', 'c.tif'])), ['d.tif', 'e.tif']);
  const nearly = film({ marks: ['a', 'b', 'c', 'd'].map((name) => table(`${name}.csv`)) });
  assert.deepEqual(names(nextScans(nearly, all, ['c.tif', 'd.tif'])), ['e.tif']);
  // The one that lacks them is there.
  assert.deepEqual(nextScans(nearly, all, ['e.tif']), []);
  const whole = film({ marks: all.map(({ name }) => table(name.replace('tif', 'csv'))) });
  assert.deepEqual(names(nextScans(whole, all)), ['a.tif', 'b.tif']);
  assert.deepEqual(names(nextScans(whole, all, ['c.tif', 'd.tif'])), ['e.tif', 'a.tif']);
});

test('a scan begins with its marks, or with the photo coordinates of the scan that has most', () => {
  const { marksToMeasure } = page.scan_marks;
  const given = film({ marks: [table('a.csv', TABLE.split('\n').slice(0, 4).join('\n')), table('b.csv')] });
  assert.equal(marksToMeasure(given, 'a.tif').length, 3);
  const begun = marksToMeasure(given, 'c.tif');
  assert.deepEqual(
    begun.map(({ x_mm, y_mm }) => [x_mm, y_mm]),
    PLACES.map(([, , x, y]) => [x, y]),
  );
  assert.ok(begun.every(({ col, row }) => Number.isNaN(col) && Number.isNaN(row)));
  assert.deepEqual(marksToMeasure(film(), 'c.tif'), []);
});

test('the block takes marks that suffice and that it has not; what the others lack is said', () => {
  const { tablesToTake, lackOf, isInBlock } = page.scan_marks;
  const given = film({ areScans: true, marks: [table('a.csv', TABLE.replaceAll(',', ' ; ').replace('180', '180.0'))] });
  const few = scan('c.tif', { marks: MARKS.slice(0, 2), withoutMm: 2 });
  const scans = [scan('a.tif'), scan('b.tif'), few, scan('d.tif', { marks: [] })];
  assert.deepEqual(tablesToTake(given, scans), [table('b.csv')]);
  assert.deepEqual(
    scans.map((one) => isInBlock(given, one)),
    [true, false, false, true],
  );
  assert.equal(
    lackOf(given, scans),
    'c.tif: 2 marks have no x and y in mm; type them under Camera, in the settings. c.tif: fiducial marks: 2 given; at least 3 are needed.',
  );
  // With the camera of the film the crate looks at the marks as where frames are made.
  const off = scan('b.tif', { marks: [...MARKS.slice(0, 3), { ...MARKS[3], col: 120 }] });
  const camera = { name: 'film.json', text: '{"focal_mm": 152}' };
  assert.deepEqual(tablesToTake(film({ camera }), [off]), []);
  assert.match(lackOf(film({ camera }), [off]), /^b\.tif: .*σ0 .*exchanged, or one is mistyped\.$/);
});

test('marks that fit each other badly are taken with a word, which names the one that stands out', () => {
  const { tablesToTake, lackOf } = page.scan_marks;
  const given = film({ areScans: true });
  const off = MARKS.map((mark, i) => (i === 2 ? { ...mark, col: mark.col + 20 } : mark));
  const marks = [...off, { col: 120, row: NaN, x_mm: 0, y_mm: NaN }];
  assert.equal(
    lackOf(given, [scan('b.tif', { all: marks, marks: off })]),
    'b.tif: σ₀ of its marks is 6.9 px of the scan; mark 3 fits worst: measure it again, or correct its x and y.',
  );
  assert.equal(tablesToTake(given, [scan('b.tif', { all: marks, marks: off })]).length, 1);
  // Of three marks nothing can be told; a pixel is no fault.
  assert.equal(lackOf(given, [scan('b.tif', { all: off, marks: off.slice(0, 3) })]), '');
  assert.equal(lackOf(given, [scan('b.tif', { marks: MARKS.map((mark, i) => (i === 2 ? { ...mark, col: mark.col + 3 } : mark)) })]), '');
});

test('marks that are not used stay with their scan while others are shown, and are kept with the block', () => {
  const { begunIn, marksToMeasure, tableOfMarks } = page.scan_marks;
  const { withBegun, withMarks } = page.film;
  const given = film({ areScans: true, marks: [table('b.csv')] });
  const all = MARKS.map((mark) => ({ ...mark, x_mm: NaN, y_mm: NaN }));
  const scans = [scan('a.tif', { all, marks: [], withoutMm: 4 }), scan('b.tif')];
  const begun = begunIn(given, scans);
  assert.deepEqual(begun, [{ image: 'a.tif', marks: all }]);
  const left = withBegun(given, ['a.tif', 'b.tif'], begun);
  assert.deepEqual(marksToMeasure(left, 'a.tif'), all);
  assert.deepEqual(marksToMeasure(left, 'b.tif'), MARKS);
  // Nothing to keep changes nothing; what the block takes is begun no more, and neither is what was cleared.
  assert.equal(withBegun(given, ['a.tif'], []), given);
  assert.deepEqual(withMarks(left, [tableOfMarks('a.tif', MARKS)]).begun, []);
  assert.deepEqual(withBegun(left, ['a.tif'], []).begun, []);
  // As the storage has it, also where numbers that are none are written as null.
  const { placingFrom, keptPlacing } = page.keep_placing;
  const kept = keptPlacing(null, { kind: 'level', height: 0 }, left, null, null);
  for (const there of [kept, JSON.parse(JSON.stringify(kept))]) assert.deepEqual(placingFrom(there, new Map(), { placing: {} }).film.begun, begun);
});

test('what is to be done with scans without marks is said', () => {
  const state = (/** @type {object} */ given, /** @type {any} */ files) => ({
    ...page.state.BLOCK_INITIAL,
    files,
    placing: { ...page.state.BLOCK_INITIAL.placing, film: film(given) },
  });
  const { framesStep } = page.frames_step;
  const camera = { name: 'film.json', text: '{"focal_mm": 152}' };
  const all = images('a.tif', 'b.tif');
  assert.equal(framesStep(state({}, all)), '');
  assert.match(framesStep(state({ camera }, all)), /^Press Measure marks under Scanned film, .* or give a table/);
  assert.match(framesStep(state({ camera, marks: [table('a.csv')] }, all)), /^Press Make images of one camera .*\. Marks of 1 of 2 scans\.$/);
  assert.match(framesStep(state({ camera, marks: [table('a.csv'), table('b.csv')] }, all)), /^Press Make images of one camera [^.]*\.$/);
});

test('a pair that waits is not matched by the marks that are measured in it, but by what else is changed', async () => {
  const pair = await pageModules(['pair/state/reducer', 'pair/state/state']);
  const after = (/** @type {object[]} */ ...actions) => actions.reduce((state, action) => pair.reducer.reduce(state, action), pair.state.INITIAL);
  const photo = { type: 'photo', side: 'left', photo: { fiducials: MARKS } };
  const inHand = { ...pair.state.INITIAL, paused: true, tool: 'fiducials', mark: { side: 'left', index: 0, expected: null } };
  assert.equal(pair.reducer.reduce(inHand, photo).paused, true);
  assert.equal(pair.reducer.reduce(inHand, { type: 'offset', offset: [1, 2] }).paused, false);
  assert.equal(after({ type: 'wait' }).paused, true);
  assert.equal(after({ type: 'wait' }, photo).paused, false);
});
