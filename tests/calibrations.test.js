/** Which cameras the page remembers of a block, and what a pair's camera is worth. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { photo_camera } from '../pkg/node.js';
import { pageModules } from './www.js';

const {
  calibrated: { calibrationsOf },
  camera: { cameraOf },
  pair_camera: { cameraOfImages },
  calibrations: { rememberCalibrations, calibrationBehind, calibrationOf, cameraOfPair, forgetCalibration },
} = await pageModules(['block/state/calibrated', 'block/state/pair-camera', 'pair/panel/camera', 'shared/state/calibrations']);

const CAMERA = { width_px: 4000, height_px: 3000, focal_px: 3600, principal_point_px: [2000, 1500], radial: [-0.01, 0, 0] };
const GIVEN = { ...CAMERA, focal_px: 3700, radial: [0, 0, 0] };
const RECORDED = { radial: [0, 0, 0], tangential: [0, 0] };
const AT = 1e12;

/** @param {object} [camera] @param {string} [verdict] @param {object[]} [others] */
const block = (camera = {}, verdict = 'oriented', others = []) => ({
  verdict: { kind: verdict, text: '' },
  cameras: [{ label: 'A', images: 30, given: GIVEN, calibrated: CAMERA, focalErrorPx: 2, ...camera }, ...others],
});

test('what an oriented block calibrated well is remembered, and nothing else', () => {
  const kept = { label: 'A', recorded: RECORDED, camera: CAMERA, focalErrorPx: 2, images: 30, at: AT };
  assert.deepEqual(calibrationsOf(block(), false, AT), [kept]);
  assert.deepEqual(calibrationsOf(block(), true, AT), []);
  const other = { label: 'B', images: 3, given: GIVEN, calibrated: CAMERA, focalErrorPx: 3 };
  assert.equal(calibrationsOf(block({}, 'oriented', [other]), false, AT).length, 2);
  for (const view of [
    block({ focalErrorPx: 80 }),
    block({ focalErrorPx: null }),
    block({ calibrated: null }),
    block({ given: null }),
    block({}, 'weak'),
    block({}, 'oriented', [{ ...other, label: 'A' }]),
    { ...block(), verdict: null },
  ])
    assert.deepEqual(calibrationsOf(view, false, AT), []);
});

test('the latest calibration of a camera takes the place of the former one, and tells photographs by their recorded lens', () => {
  const [first] = calibrationsOf(block(), false, AT);
  const of = (/** @type {string} */ label, lens = {}) => calibrationOf(label, lens);
  rememberCalibrations([first]);
  rememberCalibrations([{ ...first, label: 'B' }]);
  rememberCalibrations([{ ...first, images: 31 }]);
  rememberCalibrations([]);
  assert.deepEqual([of('A').images, of('B').images, of('C')], [31, 30, null]);
  assert.deepEqual([of('A', RECORDED)?.images, of('A', { radial: [-0.2, 0, 0] })], [31, null]);
  // It is known again by the camera that a pair took, which is as uncertain as one that a file records.
  const camera = cameraOfPair(first);
  assert.ok(camera.uncertainty.focal > 0);
  assert.equal(calibrationBehind(JSON.parse(JSON.stringify(camera))).label, 'A');
  assert.equal(calibrationBehind({ ...camera, uncertainty: undefined }), null);
  forgetCalibration('A');
  assert.equal(of('A'), null);
  for (let i = 0; i < 60; i++) rememberCalibrations([{ ...first, label: String(i) }]);
  assert.deepEqual([of('9'), of('10')?.label, of('59')?.label], [null, '10', '59']);
});

test('a pair of a block has the calibrated camera, else the given one, as uncertain as one of EXIF', () => {
  const of = (/** @type {object} */ camera, second = 0) => cameraOfImages({ images: [{ camera: 0 }, { camera: second }], cameras: [camera, camera] }, 0, 1);
  assert.deepEqual(of({ given: GIVEN, calibrated: CAMERA }), photo_camera(CAMERA));
  const given = of({ given: GIVEN, calibrated: null });
  const { uncertainty, ...constants } = given;
  assert.deepEqual(constants, photo_camera(GIVEN));
  // Less is known of it than of one that a file calls calibrated.
  assert.ok(uncertainty.focal > cameraOfPair({ camera: GIVEN }).uncertainty.focal);
  assert.equal(of({ given: null, calibrated: null }), null);
  assert.equal(of({ given: GIVEN, calibrated: CAMERA }, 1), null);
});

test('a camera of which a number is changed stays as uncertain as it was loaded; one that is typed anew says nothing', () => {
  const uncertainty = { focal: 0.01, principal_point: 0.003, k1: 0.01 };
  const loaded = { focal_mm: 85, pixel_mm: 0.15, uncertainty };
  const changed = cameraOf([86, 0.15], loaded);
  assert.deepEqual([changed.focal_mm, changed.uncertainty], [86, uncertainty]);
  assert.equal(cameraOf([undefined, 0.15], loaded), null);
  assert.ok(!('uncertainty' in cameraOf([86, 0.15], null)));
});
