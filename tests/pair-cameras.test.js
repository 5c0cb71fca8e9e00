/** What a pair on the page depends on of its cameras, and why it has no orientation: without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { resolved } from '../pkg/wasm/tiepoint.js';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
let page = {};

before(async () => {
  page = await pageModules([
    'pair/panel/orientation',
    'pair/state/cameras',
    'pair/state/interior',
    'pair/state/keys',
    'pair/state/no-orientation',
    'pair/state/state',
  ]);
});

const CAMERA = { make: 'A', model: 'B', focal_mm: 4, pixel_mm: 0.005, origin: 'exif_focal_plane' };
const PANORAMA = { focal_mm: 0.1, pixel_mm: 0.001, origin: 'panorama', cautions: [{ kind: 'panorama', projection: 'equirectangular' }] };

/**
 * A pair whose files name these cameras, and what its matching gave.
 * @param {[unknown, unknown]} cameras @param {object | null} match
 */
function pair([left, right], match = null) {
  const image = (/** @type {string} */ name, /** @type {number} */ id) => ({ id, name, source: { kind: 'file', file: new File([name], name) } });
  const opened = (/** @type {unknown} */ camera) => ({ key: '', milliseconds: 0, value: { info: { width: 1000, height: 800, camera } } });
  const state = {
    ...page.state.INITIAL,
    settings: resolved({}),
    images: { left: image('a', 1), right: image('b', 2) },
    results: { openLeft: opened(left), openRight: opened(right) },
  };
  if (match === null) return state;
  const result = { key: page.keys.wantedKeys(state).match, milliseconds: 0, value: match };
  return { ...state, results: { ...state.results, match: result } };
}

const FUNDAMENTAL = {
  model: {
    kind: 'fundamental',
    fundamental: [
      [0, 0, 0],
      [0, 0, -1],
      [0, 1, 0],
    ],
  },
  threshold_px: 1,
  sigma_px: 0.3,
  degenerate: null,
  homography: null,
  focal: null,
};

/** Matches at the same places of both images, all over them. */
const SAME = new Float64Array(Array.from({ length: 400 }, (_, k) => [(k * 379) % 1000, (k * 241) % 800]).flatMap(([x = 0, y = 0]) => [x, y, x, y, 0]));
const ROTATION = { model: { kind: 'homography' }, degenerate: 'pure-rotation', focal: null };

test('of a panorama it is said that it is one, whatever its matches are; of one photo twice that, and not that the camera turned', () => {
  const match = { matches: SAME, geometry: ROTATION, no_geometry: null };
  const reason = (/** @type {[unknown, unknown]} */ cameras) => page.orientation.whyNotOriented(pair(cameras, match));
  assert.match(reason([PANORAMA, CAMERA]), /panorama/u);
  assert.match(reason([CAMERA, CAMERA]), /one photo twice/u);
  const turned = { ...match, matches: new Float64Array() };
  assert.match(page.orientation.whyNotOriented(pair([CAMERA, CAMERA], turned)), /pure rotation/u);
});

test('another camera of the right photo leaves the interior orientation of the left one', () => {
  const keys = (/** @type {unknown} */ right) => page.keys.wantedKeys(pair([CAMERA, right]));
  const [before, after] = [keys(CAMERA), keys({ ...CAMERA, focal_mm: 5 })];
  assert.equal(after.interiorLeft, before.interiorLeft);
  assert.notEqual(after.interiorRight, before.interiorRight);
  assert.notEqual(after.orientation, before.orientation);
});

test('a photo that is not open yet says nothing against the camera that is given', () => {
  const state = pair([CAMERA, CAMERA]);
  const { openLeft } = state.results;
  const given = { focal_mm: 4, principal_point_mm: [0, 0], pixel_mm: 0.005, radial_distortion: [0, 0, 0] };
  assert.equal(page.cameras.pairCameras({ ...state, camera: given, results: { openLeft } }).doubt ?? null, null);
});

test('a panorama is one whatever the matches tell, on whichever side it is; and no camera is assumed for it', () => {
  const match = { matches: new Float64Array(), geometry: FUNDAMENTAL, no_geometry: null };
  const state = pair([CAMERA, PANORAMA], match);
  assert.deepEqual(page.no_orientation.whyNone(state), { kind: 'panorama', side: 'right' });
  assert.equal(page.interior.interiorInUse(state), null);
});

test('what is assumed of a camera follows the files and the marks: of a cropped photo its principal point is open, of a scan nothing is', () => {
  const cautions = [{ kind: 'cropped', taken_width_px: 4000, taken_height_px: 3000, width_px: 1000, height_px: 800 }];
  const cropped = { focal_mm: 4, pixel_mm: null, origin: 'focal_length_alone', cautions };
  const state = pair([cropped, null], { matches: new Float64Array(), geometry: FUNDAMENTAL, no_geometry: null });
  const before = page.interior.interiorInUse(state);
  assert.equal(before.doubt.kind, 'cropped');
  assert.ok(before.left.uncertainty.principal_point > 0.4, String(before.left.uncertainty.principal_point));
  const mark = { col: 10, row: 10, x_mm: -1, y_mm: 1 };
  const marked = { ...state, photos: { ...state.photos, left: { ...state.photos.left, fiducials: [mark] } } };
  const after = page.interior.interiorInUse(marked);
  assert.equal(after.doubt ?? null, null);
  assert.equal(after.left.uncertainty.principal_point, 0.01);
  assert.notEqual(page.keys.wantedKeys(marked).orientation, page.keys.wantedKeys(state).orientation);
});
