/** What a pair is given whose cameras are calibrated, each by itself. */

import { cameraOf } from './accuracy.mjs';

/**
 * @typedef {import('../score.mjs').Pinhole} Pinhole
 * @typedef {{ width: number, height: number }} Size in px
 * @typedef {import('../../pkg/node.js').Given<import('../../pkg/node.js').PairInput>} PairInput
 */

/** What is not known of the camera of digital photographs where nothing is said of it: marks would make it one that is known without error. */
const UNCERTAINTY = { focal: 0.003, principal_point: 0.002, k1: 0.003 };

/**
 * One camera, whose images differ at most in focal length, shape of pixels and principal point: then the corners say where these lie.
 * @param {[Pinhole, Pinhole]} cameras @param {[Size, Size]} sizes @returns {PairInput}
 */
export function calibratedInput([first, second], sizes) {
  const camera = cameraOf(first, sizes[0].width, sizes[0].height);
  const isOne = [first, second].every(({ f, fy = f, cx, cy }) => f === first.f && fy === f && cx === first.cx && cy === first.cy);
  if (isOne) return { camera };
  const side = (/** @type {Pinhole} */ of, /** @type {Size} */ size) => ({
    fiducials: corners(size, of, camera.focal_mm),
    origin: /** @type {[number, number]} */ ([0, 0]),
  });
  return { camera: { ...camera, principal_point_mm: [0, 0], uncertainty: UNCERTAINTY }, left: side(first, sizes[0]), right: side(second, sizes[1]) };
}

/** The corners of an image as marks of a camera of this focal length.  @param {Size} size @param {Pinhole} camera @param {number} focal_mm @returns {import('../../pkg/node.js').Fiducial[]} */
export function corners({ width, height }, { f, fy = f, cx, cy }, focal_mm) {
  const at = (/** @type {number} */ col, /** @type {number} */ row) => ({ col, row, x_mm: ((col - cx) * focal_mm) / f, y_mm: ((cy - row) * focal_mm) / fy });
  return [at(0, 0), at(width, 0), at(width, height), at(0, height)];
}
