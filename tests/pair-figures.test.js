/** Figures of a pair as panels and tables write them: digits of model coordinates, what the geometry is called. Without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
let page = {};

before(async () => {
  page = await pageModules(['pair/panel/geometry', 'pair/state/statistics']);
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
