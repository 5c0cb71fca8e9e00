/** Figures of a pair as panels and tables write them: digits of model coordinates, what the geometry is called, what decided on a point. Without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { resolved } from '../pkg/wasm/tiepoint.js';
import { ROWS } from './rows-geometry.js';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
let page = {};

before(async () => {
  page = await pageModules([
    'pair/panel/geometry',
    'pair/panel/verdict',
    'pair/state/keys',
    'pair/state/predicted',
    'pair/state/state',
    'pair/state/statistics',
  ]);
});

/** Values of a match in an orientation. */
const STRIDE = 9;

/** A match of two features, with nothing but what its figures need. */
const MATCH = {
  matches: Float64Array.of(10, 20, 12, 20, 0.3),
  indices: Uint32Array.of(0, 0),
  fits: new Float64Array(5).fill(NaN),
  rules: Uint8Array.of(0),
  best: Int32Array.of(0),
  places: Float64Array.of(12, 20),
  measures: Float64Array.of(0.3, Infinity),
  geometry: null,
};

/** How the table writes the model coordinates of a match at a base.  @param {number} base_mm @param {number} share */
function coordinates(base_mm, share) {
  const points = new Float64Array(STRIDE).fill(share * base_mm);
  const { columns } = page.statistics.statisticsOf(null, MATCH, { base_mm, points, rejected: [] }, null, 0.001);
  return columns.slice(-3).map((/** @type {{ text: (row: number) => string }} */ { text }) => text(0));
}

test('model coordinates have digits for a ten-thousandth of the base, at a phone as on film', () => {
  assert.deepEqual(coordinates(0.033, 1.23456), ['0.040740', '0.040740', '0.040740']);
  assert.deepEqual(coordinates(90, -1.23456), ['−111.110', '−111.110', '−111.110']);
  assert.deepEqual(coordinates(100, 1), ['100.00', '100.00', '100.00']);
});

test('cameras whose focal length the matches gave are not called calibrated', () => {
  const model = { kind: 'calibrated' };
  assert.equal(page.geometry.modelText({ model, focal: null }), 'calibrated cameras');
  assert.equal(
    page.geometry.modelText({ model, focal: { focal_px: 1380, standard_error_px: 20 } }),
    'cameras with the focal length estimated from the matches',
  );
});

/** A match of descriptors, one that least squares matching placed, and a point that the geometry rejects (rule 6). */
const BY_GRADIENTS = {
  matches: Float64Array.of(10, 20, 12, 20, 0.3, 30, 40, 32, 40, 0.02),
  indices: Uint32Array.of(0, 0, 1, 0xffffffff),
  fits: Float64Array.of(0.9, 0.01, 0, 0.01, 4, 0.98, 0.01, 0, 0.01, 4),
  rules: Uint8Array.of(0, 0, 6),
  best: Int32Array.of(0, -1, 1),
  places: Float64Array.of(12, 20, 32, 40, 50, 63),
  measures: Float64Array.of(0.3, 0.5, 0.02, Infinity, 0.4, 0.6),
  geometry: { ...ROWS, threshold_px: 0.27 },
  no_geometry: null,
};

/** What is said of a left point, whose line in the right image is drawn along these positions.  @param {number} index @param {number[]} [positions] */
function verdict(index, positions) {
  const image = (/** @type {string} */ name) => ({ id: name, name, source: { kind: 'file', file: new File([name], name) } });
  const images = { left: image('a'), right: image('b') };
  const selected = { ...page.state.INITIAL, images, settings: resolved({}), selection: { side: 'left', index } };
  const line = positions === undefined ? null : { side: 'right', positions: Float64Array.from(positions) };
  const inspection = { key: page.keys.wantedKeys(selected).inspection, milliseconds: 0, value: { parallax: null, line } };
  const shown = { left: Float64Array.of(10, 20, 1, 30, 40, 1, 50, 60, 1), right: Float64Array.of(12, 20, 1, 50, 63, 1), orientation: null };
  return page.verdict.verdictOf({ ...selected, results: { inspection } }, shown, BY_GRADIENTS).text;
}

test('a match that least squares matching placed has a correlation, and no distance of descriptors', () => {
  assert.match(verdict(0), /Distance 0\.3000, 0\.600 of the second best \(0\.5000\)\. It agrees with the geometry/);
  assert.match(verdict(1), /least squares matching placed it where the matches around it predict it, correlation 0\.9800\.$/);
  assert.doesNotMatch(verdict(1), /Distance|candidate/);
  // Table and histogram compare no correlations with distances.
  assert.deepEqual([...page.predicted.measuresOf(BY_GRADIENTS)], [0.3, NaN]);
  const { columns } = page.statistics.statisticsOf(null, BY_GRADIENTS, null, null, 0.001);
  const cells = (/** @type {string} */ wanted) => {
    const column = columns.find((/** @type {{ key: string }} */ { key }) => key === wanted);
    return column && [0, 1].map((row) => column.text(row));
  };
  assert.deepEqual(
    [cells('measure'), cells('correlation')],
    [
      ['0.3000', '–'],
      ['0.9000', '0.9800'],
    ],
  );
  // Of the other strategies the measure is the correlation already.
  const plain = page.statistics.statisticsOf(null, { ...BY_GRADIENTS, geometry: null }, null, null, 0.001);
  assert.equal(
    plain.columns.some((/** @type {{ key: string }} */ { key }) => key === 'correlation'),
    false,
  );
});

test('a match that the geometry rejects says how far it is off, once that is looked up', () => {
  assert.match(verdict(2), /does not fit: up to 0\.27 px from its epipolar line is allowed\.$/);
  assert.match(verdict(2, [0, 60, 60, 60, 100, 60]), /does not fit: it lies 3\.00 px from its epipolar line; up to 0\.27 px is allowed\.$/);
  assert.match(verdict(2, [47, 67]), /it lies 5\.00 px from/);
  // The final geometry may allow what a stricter one rejected.
  assert.match(verdict(2, [0, 63.1, 100, 63.1]), /up to 0\.27 px from its epipolar line is allowed\.$/);
});
