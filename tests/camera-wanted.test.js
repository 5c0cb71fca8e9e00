/** What a verdict asks for, as the page and the command both take it. Without a browser. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { cameraWanted } from '../pkg/pair/camera-wanted.js';

/** @typedef {import('../pkg/node.js').PairVerdict} PairVerdict */

/** A verdict of which the kind of its reason alone counts.  @param {string} warning @returns {PairVerdict} */
const weak = (warning) => /** @type {PairVerdict} */ (/** @type {unknown} */ ({ kind: 'weak', points: 9, warning: { kind: warning } }));
/** @param {string} reason @returns {PairVerdict} */
const none = (reason) => /** @type {PairVerdict} */ (/** @type {unknown} */ ({ kind: 'not_oriented', no_orientation: { kind: reason } }));

test('a camera is asked for where none is known, another one where the one that is used is doubted, and none where it does not help', () => {
  for (const reason of ['no_camera', 'no_focal_length', 'no_pixel_size', 'altered', 'plane_without_camera'])
    assert.equal(cameraWanted(none(reason)), 'given', reason);
  for (const warning of ['unknown_camera', 'resized_or_cropped', 'cropped', 'other_pixels']) assert.equal(cameraWanted(weak(warning)), 'given', warning);
  for (const warning of ['focal_length', 'wide_angle', 'contradicted_focal', 'doubtful_focal', 'far_principal_point'])
    assert.equal(cameraWanted(weak(warning)), 'other', warning);
  for (const verdict of [none('no_geometry'), none('one_photo'), weak('rotation'), weak('few_matches')]) assert.equal(cameraWanted(verdict), null);
  assert.equal(cameraWanted({ kind: 'oriented', points: 9, sigma0_px: 0.1, kappa_deg: 0, half_width_deg: 0.1 }), null);
});
