/** What a pair on the page depends on of its cameras, and why it has no orientation: without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { camera_of_focal_px, resolved } from '../pkg/wasm/tiepoint.js';
import { ROWS } from './rows-geometry.js';
import { pageModules } from './www.js';

/** @type {Record<string, any>} */
let page = {};

before(async () => {
  page = await pageModules([
    'pair/engine/checks',
    'pair/panel/camera',
    'pair/panel/orientation',
    'pair/state/cameras',
    'pair/state/given-camera',
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

/** Matches at the same places of both images, all over them. */
const SAME = new Float64Array(Array.from({ length: 400 }, (_, k) => [(k * 379) % 1000, (k * 241) % 800]).flatMap(([x = 0, y = 0]) => [x, y, x, y, 0]));
const ROTATION = { model: { kind: 'homography' }, degenerate: 'pure-rotation', focal: null };

test('of a panorama it is said that it is one, whatever its matches are; of one photo twice that, and not that the camera turned', () => {
  const match = { matches: SAME, counts: { matches: 40 }, geometry: ROTATION, no_geometry: null };
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
  const match = { matches: new Float64Array(), geometry: ROWS, no_geometry: null };
  const state = pair([CAMERA, PANORAMA], match);
  assert.deepEqual(page.no_orientation.whyNone(state), { kind: 'panorama', side: 'right' });
  assert.equal(page.interior.interiorInUse(state), null);
});

test('what is assumed of a camera follows the files and the marks: of a cropped photo its principal point is open, of a scan nothing is', () => {
  const cautions = [{ kind: 'cropped', taken_width_px: 4000, taken_height_px: 3000, width_px: 1000, height_px: 800 }];
  const cropped = { focal_mm: 4, pixel_mm: null, origin: 'focal_length_alone', cautions };
  const state = pair([cropped, null], { matches: new Float64Array(), geometry: ROWS, no_geometry: null });
  const before = page.interior.interiorInUse(state);
  assert.equal(before.doubt.kind, 'cropped');
  assert.ok(before.left.uncertainty.principal_point > 0.4, String(before.left.uncertainty.principal_point));
  const mark = { col: 10, row: 10, x_mm: -1, y_mm: 1 };
  const marked = { ...state, photos: { ...state.photos, left: { ...state.photos.left, fiducials: [mark] } } };
  const after = page.interior.interiorInUse(marked);
  assert.equal(after.doubt ?? null, null);
  assert.equal(after.left.uncertainty.principal_point, 0.02);
  assert.notEqual(page.keys.wantedKeys(marked).orientation, page.keys.wantedKeys(state).orientation);
});

/**
 * A pair of which no camera is known, oriented with such a focal length in px of the left photo.
 * @param {object | null} tells what the geometry of the two views has of it @param {number} focal @param {number} error
 */
function oriented(tells, focal, error) {
  const state = pair([null, null], { matches: new Float64Array(), geometry: { ...ROWS, focal: tells }, no_geometry: null });
  const own = focal === 0 ? page.interior.interiorInUse(state).focal_mm : focal * 0.001;
  const camera = { focal_mm: own, focal_standard_error_mm: error * 0.001 };
  const result = { key: page.keys.wantedKeys(state).orientation, milliseconds: 0, value: { cameras: [camera, camera] } };
  return { ...state, results: { ...state.results, orientation: result } };
}

test('the focal length that is stated is that of the orientation, not what its search began with', () => {
  const state = oriented({ focal_px: 1251, standard_error_px: 136 }, 1246.5, 24.9);
  const text = page.orientation.estimatedFocalText(state);
  assert.match(text, /estimated from the matches: 1,?247 ± 25 px\./u);
  assert.doesNotMatch(text, /1,?251|136/u);
  // Of other settings nothing is said.
  assert.equal(page.orientation.estimatedFocalText({ ...state, settings: { ...state.settings, orientation: {} } }), null);
});

test('a focal length that the matches told is not said to be assumed, and one that they did not is', () => {
  const told = oriented(null, 1378, 4);
  assert.match(page.camera.sourceText(told), /No camera is known: the matches estimate one, focal length 1,?378 ± 4 px\./u);
  assert.match(page.orientation.estimatedFocalText(told), /1,?378 ± 4 px/u);
  const untold = oriented(null, 0, 480);
  assert.match(page.camera.sourceText(untold), /that of most photographs is assumed, focal length 850 ± 480 px\./u);
  assert.equal(page.orientation.estimatedFocalText(untold), null);
});

test('a focal length in px needs no mm: it gives those by the pixel size, or the pixel size by them', () => {
  const { focalPxOf, withFocalPx } = page.given_camera;
  const alone = withFocalPx(null, 1250);
  assert.deepEqual(alone, camera_of_focal_px(1250));
  assert.equal(focalPxOf(alone), 1250);
  const lens = { principal_point_mm: [0.1, 0], radial_distortion: [1e-4, 0, 0] };
  assert.deepEqual(withFocalPx({ focal_mm: 4, pixel_mm: 0.005, ...lens }, 900), { focal_mm: 4.5, pixel_mm: 0.005, ...lens });
  assert.deepEqual(withFocalPx({ focal_mm: 24, ...lens }, 4000), { focal_mm: 24, pixel_mm: 0.006, ...lens });
  assert.equal(focalPxOf({ focal_mm: 24 }), null);
  // What was typed is what is shown.
  for (const px of [1234.5, 2759.48, 4000.1, 987.654321]) assert.equal(focalPxOf(withFocalPx({ focal_mm: 7.3, pixel_mm: 0.00245 }, px)), px);
  const by = (/** @type {any} */ camera) => (/** @type {number} */ px) => withFocalPx(camera, px);
  assert.equal(page.checks.allowedOfFocalPx(1250, by(null)), null);
  assert.match(page.checks.allowedOfFocalPx(0, by({ focal_mm: 24 })), /^1 to 10.?000.?000$/u);
  assert.match(page.checks.allowedOfFocalPx(10_000_000, by({ focal_mm: 4, pixel_mm: 0.05 })), /100.?000/u);
});

test('a focal length in px that is taken back takes nothing else along, and typed again it is the same camera', () => {
  const { withFocalPx, withoutFocalPx } = page.given_camera;
  const camera = { focal_mm: 4, principal_point_mm: [0.1, 0], pixel_mm: 0.005, radial_distortion: [1e-4, 0, 0] };
  const without = withoutFocalPx(camera);
  assert.deepEqual(without, { ...camera, pixel_mm: null });
  assert.deepEqual(withFocalPx(without, 800), camera);
  // A camera by it alone is none without it.
  const alone = withFocalPx(null, 1250);
  assert.equal(withoutFocalPx(alone), null);
  assert.deepEqual(withoutFocalPx({ ...alone, radial_distortion: [1e-4, 0, 0] }).radial_distortion, [1e-4, 0, 0]);
  assert.equal(withoutFocalPx(null), null);
});

test('the camera of one photo for both has numbers as one would type them', () => {
  const { camera } = page.given_camera.cameraForBoth(pair([{ ...CAMERA, focal_mm: 153.36000061035156, pixel_mm: 0.03978000068421601 }, null]));
  assert.deepEqual([camera.focal_mm, camera.pixel_mm], [153.36, 0.03978]);
});

test('the camera that one photo of two alike names can be taken for both', () => {
  const { cameraForBoth } = page.given_camera;
  const state = pair([CAMERA, null]);
  const [left, right] = [cameraForBoth(state), cameraForBoth(pair([null, CAMERA]))];
  assert.deepEqual([left.side, right.side], ['left', 'right']);
  assert.equal(left.camera.focal_mm, 4);
  // It is as uncertain as that of the file.
  assert.equal(left.camera.uncertainty.focal, page.cameras.pairCameras(pair([CAMERA, CAMERA])).left.uncertainty.focal);
  const used = page.cameras.pairCameras({ ...state, camera: left.camera });
  assert.equal(used.right.focal_mm, 4);
  assert.equal(cameraForBoth({ ...state, camera: left.camera }), null);
  for (const cameras of /** @type {[unknown, unknown][]} */ ([
    [CAMERA, CAMERA],
    [null, null],
    [{ ...CAMERA, pixel_mm: null, origin: 'focal_length_alone' }, null],
    [PANORAMA, null],
  ]))
    assert.equal(cameraForBoth(pair(cameras)), null);
  const { openLeft, openRight } = state.results;
  const larger = { ...openRight, value: { info: { ...openRight.value.info, width: 2000 } } };
  assert.equal(cameraForBoth({ ...state, results: { openLeft, openRight: larger } }), null);
});
