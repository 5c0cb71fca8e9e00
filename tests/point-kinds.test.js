/** Tie points of a block beside its ground control and check points, as tables, sentences and the map say them: without a browser. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pageModules } from './www.js';

const {
  columns: { observationRows, rowsOf },
  point_kinds: { countedPoints },
  words: { describe },
  ground: { longestText, offsetsOf },
} = await pageModules(['block/state/columns', 'block/state/point-kinds', 'block/state/words', 'block/view/map/ground']);

/** Two tie points, a control and a check point that take part, and a tie and a control point that were rejected by hand. */
const VIEW = {
  images: [
    { name: 'a', position: [0, 0, 100] },
    { name: 'b', position: [30, 40, 100] },
  ],
  points: {
    count: 6,
    taking: 4,
    lost: new Set(),
    numbers: Uint32Array.of(11, 12, 1001, 1002, 5, 1003),
    rays: Uint16Array.of(2, 3, 4, 5, 7, 9),
    rmsePx: new Float64Array(6).fill(NaN),
    positions: new Float64Array(18),
    errors: new Float64Array(18).fill(NaN),
    confidence: new Float64Array(6),
  },
  surveyed: [
    { name: 'GCP1', role: 'control', point: 2, isUsed: true, position: [0, 0, 0], difference_m: [0.03, 0.04, -1.2], standard_errors_m: [null, null, null] },
    { name: 'GCP2', role: 'check', point: 3, isUsed: true, position: [9, 9, 0], difference_m: [0, -0.14, 0.3], standard_errors_m: [null, null, null] },
    { name: 'GCP3', role: 'control', point: 5, isUsed: false, position: [5, 5, 0], difference_m: [NaN, NaN, NaN], standard_errors_m: [null, null, null] },
  ],
  origin: null,
  crs: null,
};

/** What a column says, row by row.  @param {any} rows @param {string} key */
const said = ({ count, columns }, key) =>
  Array.from({ length: count }, (_, row) =>
    columns
      .find((/** @type {any} */ column) => column.key === key)
      ?.text(row)
      .replace(/[\u2066-\u2069]/gu, ''),
  );

test('ground control and check points are no tie points, nor are their observations', () => {
  assert.deepEqual(countedPoints(VIEW), { tie: { points: 2, observations: 5 }, surveyed: { points: 2, observations: 9 }, gone: 1 });
  const without = { ...VIEW, surveyed: [] };
  assert.deepEqual(countedPoints(without), { tie: { points: 4, observations: 14 }, surveyed: { points: 0, observations: 0 }, gone: 2 });
});

test('the table of points calls ground control and check points by their names, and says what each point is', () => {
  const rows = rowsOf('points', { view: VIEW, given: [] });
  assert.deepEqual(said(rows, 'point'), ['11', '12', 'GCP1', 'GCP2', '5', 'GCP3']);
  assert.deepEqual(said(rows, 'point-kind'), ['tie point', 'tie point', 'control point', 'check point', 'tie point', 'control point']);
  // They are sorted by their numbers, and found by them.
  assert.deepEqual(
    [0, 2].map((row) => rows.columns[0].value(row)),
    [11, 1001],
  );
  const keys = rowsOf('points', { view: { ...VIEW, surveyed: [] }, given: [] }).columns.map((/** @type {any} */ { key }) => key);
  assert.ok(!keys.includes('point-kind'), keys.join());
});

test('rays are the same in the tables of points and of observations: rejected ones do not count in either', () => {
  // Of the first point two take part, and a third was rejected.
  const of = {
    images: Uint32Array.of(0, 1, 1, 0),
    points: Uint32Array.of(0, 0, 0, 2),
    places: new Float64Array(8),
    residuals: new Float64Array(8),
    redundancy: new Float64Array(8),
    w: new Float64Array(8),
    detectable: new Float64Array(8),
    parts: Uint8Array.of(0, 0, 1, 0),
  };
  const rows = observationRows(VIEW, of);
  assert.deepEqual(said(rows, 'observation-rays'), ['2', '2', '2', '4']);
  assert.deepEqual(said(rows, 'observation-point'), ['11', '11', '11', 'GCP1']);
  assert.deepEqual(said(rowsOf('points', { view: VIEW, given: [] }), 'point-rays').slice(0, 3), ['2', '3', '4']);
});

test('of points that are chosen together ground control and check points are counted apart', () => {
  const text = (/** @type {number[]} */ ...points) => describe({ view: VIEW, given: [] }, { kind: 'points', points: Uint32Array.from(points) });
  assert.match(text(0, 1), /^2 tie points of 2 to 3 rays\.$/u);
  assert.match(text(0, 2), /^2 points, 1 of them a ground control or check point, of 2 to 4 rays\.$/u);
  assert.match(text(0, 2, 3), /^3 points, 2 of them ground control or check points, of 2 to 5 rays\.$/u);
});

test('the longest differences are said in plan and in height', () => {
  const { longest } = offsetsOf(VIEW, { gnss: Float64Array.of(3, 4, NaN, 30, 41, NaN), footprints: new Float64Array(), gsd: new Float64Array(), origin: null });
  assert.deepEqual(longest, { gnss: { plan: 5, height: 0 }, surveyed: { plan: 0.14, height: 1.2 } });
  assert.equal(longestText(longest.surveyed, 'surveyed'), '14 cm in plan, 1.2 m in height');
  // Heights that are not known are not said.
  assert.equal(longestText(longest.gnss, 'geographic'), '5 m in plan');
});
