/** What is said of images that were placed on an orthophoto, each by itself. Without a browser. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { placing_parameters } from '../pkg/node.js';
import { pageModules } from './www.js';

const {
  state: { BLOCK_INITIAL },
  placed: { placingKey, placingKeyOf },
  placing_answer: { placingAnswer },
  options: { optionInLanguage },
} = await pageModules(['block/state/state', 'block/state/placed', 'block/panel/placing-answer', 'shared/text/options']);

const PLACED = { kind: 'placed', links: 900, sigma0_px: 0.5, half_width_m: 0.4 };
const WEAK = { kind: 'weak', links: 80, placing_weakness: { kind: 'coverage', share: 0.1, needed: 0.25 } };
const LOST = { kind: 'not_placed', not_placed: { kind: 'no_orientation', points: 3 } };

/** The answer of images a.jpg, b.jpg … with these verdicts.  @param {...object} verdicts */
function answer(...verdicts) {
  const files = verdicts.map((_, id) => ({ id, name: `${'abc'.charAt(id)}.jpg`, file: new Blob([]) }));
  const raster = { id: 7, name: 'city.tif', file: new Blob([]), world: null, projection: null };
  const info = { width: 400, height: 300, gsd: 0.5, epsg: null, described: null, georeference: { origin: [0, 0], by_column: [0.5, 0], by_row: [0, -0.5] } };
  const placing = { ...BLOCK_INITIAL.placing, orthophoto: { raster, info, ofBlock: null }, heights: { kind: 'model', model: { ...raster, id: 8 } } };
  const catalogue = { labels: { parameters: placing_parameters().map(optionInLanguage), flightParameters: [] } };
  const state = { ...BLOCK_INITIAL, catalogue, files, placing };
  const placed = new Map(
    verdicts.map((verdict, id) => {
      const key = placingKeyOf(placingKey(state), { film: placing.film, positions: new Map() }, files[id]?.name ?? '');
      return [id, { key, result: { verdict, placement: null }, problem: '', found: null, steps: [], done: 0 }];
    }),
  );
  return placingAnswer({ ...state, placing: { ...placing, placed } }, {});
}

test('images that are placed with doubt count among those that are placed, and the first reason is said', () => {
  const said = (/** @type {object[]} */ ...verdicts) => answer(...verdicts).text;
  assert.equal(said(PLACED, PLACED), '2 of 2 images placed.');
  assert.equal(said(WEAK, WEAK, WEAK), '3 of 3 images placed, all with doubt.');
  assert.equal(said(PLACED, WEAK, WEAK), '3 of 3 images placed, 2 of them with doubt.');
  assert.equal(said(LOST, WEAK), '1 of 2 images placed, with doubt, 1 not placed.');
  assert.equal(said(LOST, PLACED), '1 of 2 images placed, 1 not placed.');
  assert.match(answer(PLACED, WEAK).more, /^b\.jpg: Placed with doubt by 80 points\. Points lie in 10\s?% of the image; 25\s?% are needed\./);
  assert.match(answer(LOST, WEAK).more, /^a\.jpg: Not placed: /);
  assert.doesNotMatch(answer(PLACED, PLACED).more, /jpg/);
  // Of one image it is the headline.
  assert.match(answer(WEAK).text, /^Placed with doubt by 80 points\./);
  assert.doesNotMatch(answer(WEAK).more, /jpg/);
});

test('what may be mended in the settings is named as these are', () => {
  const high = { kind: 'weak', links: 80, placing_weakness: { kind: 'gnss_height', height_m: -47.2, usual_m: 1.5 } };
  for (const text of [answer(high).text, answer(PLACED, high).more]) {
    assert.match(text, /It lies 47\.2\sm below its GNSS position, .* in place of the ellipsoid \(Settings: “Geoid of the heights”\), and the position\./);
  }
});
