/** Coordinates of a block in the coordinate reference system of its results, as its tables and its map say them: without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { geographic_positions, system_coordinates } from '../pkg/node.js';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(
    page,
    await pageModules([
      'block/state/columns',
      'block/state/in-common',
      'block/state/result-system',
      'shared/state/plane-map',
      'block/state/under',
      'block/state/words',
    ]),
  );
});

const ORIGIN = { longitude_deg: 8.5, latitude_deg: 50.1, height_m: 150 };
const PLACES = [
  [0, 0, 10],
  [400, -300, 12],
  [NaN, NaN, NaN],
];

/** A block with its points and images in these places.  @param {object} [own] */
const viewOf = (own = {}) => ({
  images: PLACES.map(([x = 0, y = 0, z = 0], i) => ({ name: `${i}`, why: '', position: Number.isNaN(x) ? null : [x, y, z + 100] })),
  leftOut: [],
  cameras: [],
  surveyed: [{ name: 'A', position: PLACES[1], role: 'control', isUsed: true, rays: 2, difference_m: [0, 0, 0], standard_errors_m: [null, null, null] }],
  points: {
    count: 3,
    taking: 3,
    lost: new Set(),
    numbers: Uint32Array.of(1, 2, 3),
    rays: new Uint16Array(3),
    rmsePx: new Float64Array(3),
    positions: Float64Array.from(PLACES.flat()),
    errors: new Float64Array(9).fill(NaN),
  },
  origin: ORIGIN,
  crs: null,
  geoidM: null,
  ...own,
});

/** What a system has for a place of the block.  @param {string} crs @param {readonly number[]} place */
function there(crs, place, geoidM = 0) {
  const [x = NaN, y = NaN, z = NaN] = system_coordinates(crs, geographic_positions([ORIGIN.longitude_deg, ORIGIN.latitude_deg, ORIGIN.height_m, ...place]));
  return [x, y, z - geoidM];
}

/** @param {Iterable<number>} got @param {readonly number[]} wanted @param {number} within */
const isNear = (got, wanted, within) =>
  assert.ok(
    [...got].every((value, k) => Math.abs(value - (wanted[k] ?? NaN)) < within),
    `${[...got].join(' ')} is not ${wanted.join(' ')}`,
  );

/** Three columns of a row.  @param {any} rows @param {readonly string[]} keys @param {number} row */
const valuesOf = ({ columns }, keys, row) => keys.map((key) => columns.find((/** @type {any} */ column) => column.key === key)?.value(row));

/** Their heads with their units.  @param {any} rows @param {readonly string[]} keys */
const headsOf = ({ columns }, keys) =>
  keys.map((key) =>
    columns
      .filter((/** @type {any} */ column) => column.key === key)
      .map(({ label, unit }) => `${label} [${unit}]`)
      .join(),
  );

const listed = (/** @type {any} */ view) => ({ view, given: [], asGiven: undefined });

test('tables have the coordinates of the system of the results, with its code and its unit in their heads', () => {
  const view = viewOf({ crs: 'epsg:25832', system: 'ETRS89 / UTM zone 32N', geoidM: 47.5 });
  const [images, points, surveyed] = ['images', 'points', 'surveyed'].map((subject) => page.columns.rowsOf(subject, listed(view)));
  const wanted = there('EPSG:25832', PLACES[1] ?? [], 47.5);
  isNear(valuesOf(images, ['X', 'Y', 'Z'], 1), there('EPSG:25832', [400, -300, 112], 47.5), 1e-3);
  isNear(valuesOf(points, ['x', 'y', 'z'], 1), wanted, 1e-3);
  isNear(valuesOf(surveyed, ['surveyed-X', 'surveyed-Y', 'surveyed-Z'], 0), wanted, 1e-3);
  assert.ok([...valuesOf(images, ['X', 'Y', 'Z'], 2), ...valuesOf(points, ['x', 'y', 'z'], 2)].every(Number.isNaN));
  assert.deepEqual(headsOf(points, ['x', 'y', 'z', 'sigma-x']), ['X EPSG:25832 [m]', 'Y EPSG:25832 [m]', 'Z EPSG:25832 [m]', 'σ X [m]']);
  assert.match(points.columns.find((/** @type {any} */ { key }) => key === 'x').help, /^X in ETRS89 \/ UTM zone 32N/u);
  assert.match(
    page.words.describe(listed(view), { kind: 'point', point: 1 }),
    new RegExp(`X Y Z ${(wanted[0] ?? 0).toFixed(2)} ${(wanted[1] ?? 0).toFixed(2)}`),
  );
});

/** A geoid over the block that rises by 60 m a degree to the east, and by 20 m to the north. */
const SLOPING = { name: 'sloping.gtx', south_west_deg: [8, 50], step_deg: [1, 0.5], columns: 2, heights_m: [20, 80, 30, 90] };
const heightOfSloping = (/** @type {number} */ longitude, /** @type {number} */ latitude) => 20 + 60 * (longitude - 8) + 20 * (latitude - 50);

test('heights count from the geoid at each place, not from that in the middle of the block', () => {
  const places = [
    [-3000, 0, 10],
    [3000, 2000, 10],
  ];
  const points = { count: 2, taking: 2, rays: new Uint16Array(2), rmsePx: new Float64Array(2), positions: Float64Array.from(places.flat()), errors: [] };
  const view = viewOf({ crs: 'EPSG:25832', system: 'ETRS89 / UTM zone 32N', geoidM: 52, geoid: SLOPING, points });
  const rows = page.columns.rowsOf('points', listed(view));
  const heights = places.map((place, row) => {
    const [longitude = NaN, latitude = NaN] = geographic_positions([ORIGIN.longitude_deg, ORIGIN.latitude_deg, ORIGIN.height_m, ...place]);
    const height = heightOfSloping(longitude, latitude);
    isNear(valuesOf(rows, ['x', 'y', 'z'], row), there('EPSG:25832', place, height), 1e-3);
    return height;
  });
  assert.ok(Math.abs((heights[1] ?? NaN) - (heights[0] ?? NaN)) > 4, `${heights}`);
  // Given coordinates lie there again.
  const [first = []] = places;
  const position = valuesOf(rows, ['x', 'y', 'z'], 0);
  const row = { name: 'A', position, standard_errors: null, role: 'control', sigma_px: null };
  const [back] = page.in_common.inSystemOfBlock({ ...view, orthophoto: null }, [row], { crs: view.crs, heights: page.result_system.countedFrom(view) });
  isNear(back, first, 2e-3);
});

test('the points of a result are converted once, however often it is shown', () => {
  const view = viewOf({ crs: 'EPSG:25832', system: 'ETRS89 / UTM zone 32N' });
  const { pointCoordinates } = page.result_system;
  const coordinates = pointCoordinates(view);
  assert.equal(pointCoordinates({ ...view, score: null }), coordinates);
  assert.notEqual(pointCoordinates({ ...view, points: { ...view.points, positions: view.points.positions.slice() } }), coordinates);
});

test('coordinates as they were given stand beside those of the block only where they are others', () => {
  const view = viewOf({ crs: 'EPSG:25832', system: 'ETRS89 / UTM zone 32N' });
  const wanted = there('EPSG:25832', PLACES[1] ?? []);
  const keys = (/** @type {number[]} */ given) =>
    page.columns.rowsOf('surveyed', { view, given: [], asGiven: new Map([['A', given]]) }).columns.map((/** @type {any} */ { key }) => key);
  assert.ok(!keys(wanted.map((value) => Number(value.toFixed(3)))).includes('given-X'));
  assert.ok(keys(wanted.map((value) => value + 0.01)).includes('given-X'));
});

test('a block without a chosen system, or of one that cannot be read, has its own coordinates', () => {
  for (const own of [{}, { crs: 'EPSG:25832' }, { crs: 'EPSG:25832', system: 'UTM', origin: null }, { crs: 'none', system: 'none' }]) {
    const points = page.columns.rowsOf('points', listed(viewOf(own)));
    assert.deepEqual(valuesOf(points, ['x', 'y', 'z'], 1), PLACES[1]);
    assert.deepEqual(headsOf(points, ['x']), ['X [m]']);
  }
});

test('feet and degrees are told by what lengths are in the system, and degrees have the digits that they need', () => {
  const degrees = viewOf({ crs: 'EPSG:4326', system: 'WGS 84' });
  assert.deepEqual(headsOf(page.columns.rowsOf('points', listed(degrees)), ['x', 'z']), ['X EPSG:4326 [°]', 'Z EPSG:4326 [m]']);
  assert.match(page.result_system.coordinatesText(degrees, [0, 0, 10], 2), /^X Y 8\.5000000 50\.1000000 ° Z 160\.00 m$/u);
  const feet = viewOf({ crs: 'EPSG:2263', system: 'NAD83 / New York Long Island (ftUS)', origin: { longitude_deg: -74, latitude_deg: 40.7, height_m: 0 } });
  assert.equal(page.result_system.resultSystem(feet).unit[0], 'ft');
});

test('the map of a system lies as its coordinates do, over the whole of a block', () => {
  const view = viewOf({ crs: 'EPSG:25832', system: 'ETRS89 / UTM zone 32N' });
  const { toBlock } = page.result_system.resultSystem(view);
  for (const [x = 0, y = 0, z = 0] of [...PLACES.slice(0, 2), [-900, 800, 10]]) {
    const [east = NaN, north = NaN] = there('EPSG:25832', [x, y, z]);
    isNear(page.plane_map.mapped(toBlock, east, north), [x, y], 0.05);
  }
});
