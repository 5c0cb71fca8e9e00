/** The height of level ground under images that are placed on an orthophoto, as a block says it: without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { geographic_positions, system_coordinates } from '../pkg/node.js';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
const page = {};

before(async () => {
  Object.assign(page, await pageModules(['block/state/level', 'block/state/placing', 'block/files/ground', 'block/files/keep-placing']));
});

/** Points of a block on ground between 21 and 41 m, one of them far off. */
const PLACES = [...[-200, 0, 200].flatMap((x) => [-200, 0, 200].map((y) => [x, y, 31 + x / 20])), [0, 0, 900]];

/** @param {object} [own] @param {{ longitude_deg: number, latitude_deg: number, height_m: number } | null} [origin] */
const shownAt = (own = {}, origin = { longitude_deg: 8.5, latitude_deg: 50.1, height_m: 150 }) => ({
  key: 'k',
  view: {
    partial: false,
    layout: { kind: 'oriented' },
    images: [{ name: 'a', position: [0, 0, 500] }],
    points: { count: 10, taking: 10, positions: Float64Array.from(PLACES.flat()) },
    surveyed: [],
    origin,
    crs: null,
    geoidM: null,
    orthophoto: null,
    ...own,
  },
});

/** An orthophoto of the ground of the block in a system, with pixels of a unit.  @param {number | null} epsg @param {any} shown */
function orthophotoOf(epsg, { view: { origin } }, ofBlock = null, unit = 1) {
  const [x = 0, y = 0] =
    epsg === null || origin === null
      ? [0, 0]
      : system_coordinates(`EPSG:${epsg}`, geographic_positions([origin.longitude_deg, origin.latitude_deg, origin.height_m, 0, 0, 0]));
  const georeference = { origin: [x - 500 / unit, y + 500 / unit], by_column: [1, 0], by_row: [0, -1] };
  const info = { width: 1000 / unit, height: 1000 / unit, gsd: 1, georeference, epsg, described: null, heights: [0, 0] };
  return { raster: { id: 1, name: 'o.tif', file: new Blob(), world: null, projection: null }, info, ofBlock };
}

const LEVEL = { kind: 'level', height: 0 };

test('level ground lies at the median of the tie points of the block, in the system, unit and heights of the orthophoto', () => {
  const { levelByBlock } = page.level;
  const shown = shownAt();
  assert.deepEqual(levelByBlock({ orthophoto: orthophotoOf(32632, shown), heights: LEVEL }, shown), { kind: 'level', height: 181, by: 'block' });
  const above = shownAt({ crs: 'EPSG:32632', geoidM: 47.5 });
  assert.equal(levelByBlock({ orthophoto: orthophotoOf(32632, above), heights: LEVEL }, above).height, 133.5);
  const feet = shownAt({}, { longitude_deg: -74, latitude_deg: 40.7, height_m: 0 });
  assert.equal(levelByBlock({ orthophoto: orthophotoOf(2263, feet, null, 0.3048), heights: LEVEL }, feet).height, Math.round(310 / 0.3048) / 10);
});

test('an orthomosaic of a block without a system lies as high as the block', () => {
  const shown = shownAt({}, null);
  assert.equal(page.level.levelByBlock({ orthophoto: orthophotoOf(null, shown, /** @type {any} */ ('k')), heights: LEVEL }, shown).height, 31);
  assert.equal(page.level.levelByBlock({ orthophoto: orthophotoOf(null, shown), heights: LEVEL }, shown), null);
});

test('heights that were given stay, and a block that says none changes nothing', () => {
  const { levelByBlock } = page.level;
  const shown = shownAt();
  const orthophoto = orthophotoOf(32632, shown);
  for (const heights of [
    { kind: 'level', height: 0, by: 'hand' },
    { kind: 'level', height: 12 },
    { kind: 'model', model: {} },
  ])
    assert.equal(levelByBlock({ orthophoto, heights }, shown), null);
  assert.equal(levelByBlock({ orthophoto: null, heights: LEVEL }, shown), null);
  assert.equal(levelByBlock({ orthophoto, heights: LEVEL }, null), null);
  assert.equal(levelByBlock({ orthophoto, heights: LEVEL }, shownAt({ layout: { kind: 'recorded' } })), null);
  // Another block says another height.
  assert.equal(levelByBlock({ orthophoto, heights: { kind: 'level', height: 90, by: 'block' } }, shown).height, 181);
});

test('it is set once, before images are placed, and said', async () => {
  const shown = shownAt();
  const state = { placing: { ...page.placing.NO_PLACING, orthophoto: orthophotoOf(32632, shown) }, shown };
  const store = { state, dispatch: () => {} };
  let set = 0;
  const engine = {
    setHeights: async (/** @type {any} */ heights) => {
      set += 1;
      state.placing = { ...state.placing, heights };
    },
  };
  const ground = new page.ground.GroundFiles(store, engine);
  assert.equal(await ground.takeLevelOfBlock(() => {}), 'Its height is the median of the tie points of the block: 181.0 m.');
  assert.equal(await ground.takeLevelOfBlock(() => {}), '');
  assert.equal(set, 1);
});
