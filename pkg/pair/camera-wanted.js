// @ts-check
/** Whether a camera would help a pair. */

/** @typedef {import('../node.js').Warning['kind'] | import('../node.js').NoOrientation['kind']} Reason */

/** Reasons for no orientation, and warnings, that a camera answers: none is known, or hardly.  @type {readonly Reason[]} */
const GIVEN = [
  'no_camera',
  'no_focal_length',
  'no_pixel_size',
  'altered',
  'plane_without_camera',
  'unknown_camera',
  'resized_or_cropped',
  'cropped',
  'other_pixels',
];

/** Warnings that doubt the camera that is used.  @type {readonly Reason[]} */
const OTHER = ['focal_length', 'wide_angle', 'contradicted_focal', 'doubtful_focal', 'far_principal_point'];

/**
 * What a verdict asks for: `given`, a camera where none is known or hardly one; `other`, another one than that which is used; null: no camera helps.
 * @param {import('../node.js').PairVerdict} verdict @returns {'given' | 'other' | null}
 */
export function cameraWanted(verdict) {
  if (verdict.kind === 'oriented') return null;
  const { kind } = verdict.kind === 'weak' ? verdict.warning : verdict.no_orientation;
  if (GIVEN.includes(kind)) return 'given';
  return OTHER.includes(kind) ? 'other' : null;
}
