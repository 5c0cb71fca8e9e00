/** Which cameras the page remembers of a block. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pageModules } from './www.js';

const {
  calibrated: { calibrationsOf },
  calibrations: { rememberCalibrations, calibrationOf, forgetCalibration },
} = await pageModules(['block/state/calibrated', 'shared/state/calibrations']);

const CAMERA = { width_px: 4000, height_px: 3000, focal_px: 3600, principal_point_px: [2000, 1500] };
const AT = 1e12;

/** @param {object} [camera] @param {object} [found] @param {object | null} [truth] */
const block = (camera = {}, found = {}, truth = null) => ({
  truth,
  shown: {
    found: {
      partial: false,
      verdict: { kind: 'oriented', text: '' },
      cameras: [{ label: 'A', images: 30, given: null, calibrated: CAMERA, focalErrorPx: 2, ...camera }],
      ...found,
    },
  },
});

test('what an oriented block calibrated well is remembered, and nothing else', () => {
  assert.deepEqual(calibrationsOf(block(), AT), [{ label: 'A', camera: CAMERA, focalErrorPx: 2, images: 30, at: AT }]);
  for (const other of [
    block({ focalErrorPx: 80 }),
    block({ focalErrorPx: null }),
    block({ calibrated: null }),
    block({}, { partial: true }),
    block({}, { verdict: { kind: 'weak', text: '' } }),
    block({}, { verdict: null }),
    block({}, {}, {}),
    { truth: null, shown: null },
  ])
    assert.deepEqual(calibrationsOf(other, AT), []);
});

test('the latest calibration of a camera takes the place of the former one; damage is as if nothing were kept', () => {
  /** @type {Map<string, string>} */
  const storage = new Map();
  Object.defineProperty(globalThis, 'localStorage', {
    configurable: true,
    value: {
      getItem: (/** @type {string} */ name) => storage.get(name) ?? null,
      setItem: (/** @type {string} */ name, /** @type {string} */ value) => storage.set(name, value),
    },
  });
  const [first] = calibrationsOf(block(), AT);
  rememberCalibrations([first]);
  rememberCalibrations([{ ...first, label: 'B' }]);
  rememberCalibrations([{ ...first, images: 31 }]);
  rememberCalibrations([]);
  assert.deepEqual([calibrationOf('A').images, calibrationOf('B').images, calibrationOf('C')], [31, 30, null]);
  forgetCalibration('A');
  assert.equal(calibrationOf('A'), null);
  for (let i = 0; i < 60; i++) rememberCalibrations([{ ...first, label: String(i) }]);
  assert.deepEqual([calibrationOf('9'), calibrationOf('10')?.label, calibrationOf('59')?.label], [null, '10', '59']);
  for (const damage of ['{', '{}', '[null, 1, {"label": "A"}]']) {
    storage.set('tiepoint-cameras', damage);
    assert.equal(calibrationOf('A'), null);
  }
});
