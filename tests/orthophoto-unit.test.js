/** The unit that the page shows beside coordinates in the system of an orthophoto. Without a browser. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pageModules } from './www.js';

const {
  orthophoto_unit: { unitOfOrthophoto },
  placed_columns: { linkColumns, placedColumns },
  ground: { orthophotoText },
  placing_answer: { heightsText },
} = await pageModules(['block/state/orthophoto-unit', 'block/state/placed-columns', 'block/files/ground', 'block/panel/placing-answer']);

/** An orthophoto of San Francisco.  @param {number | null} epsg @param {[number, number]} origin @param {string | null} described */
const orthophotoOf = (epsg, origin, described = null) => ({
  raster: { name: 'city.tif', world: null, projection: null },
  info: { width: 4000, height: 3000, gsd: 0.5, epsg, described, georeference: { origin, by_column: [0.5, 0], by_row: [0, -0.5] } },
});
/** Feet of the US survey and international ones, metres of the same zone, UTM, a map of the world. */
const SYSTEMS = /** @type {const} */ ([
  [2227, [6_000_000, 2_100_000], 'ft'],
  [2913, [7_600_000, 1_000_000], 'ft'],
  [26943, [1_828_000, 640_000], 'm'],
  [32610, [550_000, 4_180_000], 'm'],
  [3857, [-13_600_000, 4_550_000], 'm'],
]);

test('an orthophoto is in feet where its system is', () => {
  for (const [epsg, [x, y], unit] of SYSTEMS) assert.equal(unitOfOrthophoto(orthophotoOf(epsg, [x, y])), unit, `EPSG:${epsg}`);
  assert.equal(unitOfOrthophoto(orthophotoOf(null, [0, 0])), 'm');
  assert.equal(unitOfOrthophoto(orthophotoOf(null, [0, 0], 'NAD83 / California zone 3 (ftUS)')), 'ft');
  // One that the crate does not know says nothing.
  assert.equal(unitOfOrthophoto(orthophotoOf(999999, [0, 0])), 'm');
  assert.equal(unitOfOrthophoto(null), 'm');
});

test('tables and texts of images that are placed on an orthophoto in feet name feet, and no metres', () => {
  const units = (/** @type {{ unit: string }[]} */ columns) => new Set(columns.map(({ unit }) => unit));
  assert.deepEqual(units(placedColumns([], () => '', 'ft')), new Set(['', 'ft', '°', 'px']));
  assert.deepEqual(units(placedColumns([], () => '', 'm')), new Set(['', 'm', '°', 'px']));
  const links = { at: [], places: [], residuals: [], uses: [] };
  assert.deepEqual(units(linkColumns({ links }, [], 0, 'ft')), new Set(['', 'ft', 'px']));
  assert.match(orthophotoText(orthophotoOf(2227, [6_000_000, 2_100_000])), / px of 0\.5 ft/);
});

test('heights are in the unit of the orthophoto, level ground too', () => {
  const said = (/** @type {object} */ heights, /** @type {number} */ epsg, /** @type {[number, number]} */ origin) => {
    const orthophoto = orthophotoOf(epsg, origin);
    return heightsText({ placing: { heights, orthophoto: { ...orthophoto, info: { ...orthophoto.info, heights: [10, 20] } } } });
  };
  const level = { kind: 'level', height: 12 };
  const model = { kind: 'model', model: { name: 'heights.tif' } };
  for (const [epsg, origin, unit] of SYSTEMS) {
    assert.match(said(level, epsg, origin), new RegExp(`level at 12\\.00 ${unit}: `), `EPSG:${epsg}`);
    assert.match(said(model, epsg, origin), new RegExp(`: 10\\.0 to 20\\.0 ${unit}\\.`), `EPSG:${epsg}`);
  }
  const orthophoto = orthophotoOf(32610, [550_000, 4_180_000]);
  const converted = { ...orthophoto, info: { ...orthophoto.info, heights: [10, 20], heights_given_in: 'ft' } };
  assert.match(heightsText({ placing: { heights: model, orthophoto: converted } }), /: 10\.0 to 20\.0 m, converted from ft as their file says\./);
});
