/** A picture with what is known of its place in the camera: fiducial marks follow what is done to the picture. */

import * as pictures from './pictures.mjs';

/**
 * @typedef {import('./pictures.mjs').Picture} Picture
 * @typedef {import('../../../pkg/node.js').Fiducial} Fiducial
 * @typedef {{ picture: Picture, fiducials: Fiducial[], isWhole?: boolean }} View marks at positions of this picture, which may lie outside; none of a digital camera;
 *   isWhole: said to be no part of a larger scan, so that they may not
 * @typedef {import('../data.mjs').TruePose} Pose
 * @typedef {import('../../../pkg/node.js').CameraMm} CameraMm
 * @typedef {{ left: View, right: View, right_position: Float32Array, isExchanged?: boolean }} Seen the views as they were simulated, and where each left pixel's surface is seen;
 *   isExchanged: the pair has left and right exchanged since
 * @typedef {{ left: View, right: View, camera: import('../../../pkg/node.js').Given<CameraMm> | null, pose: Pose | null, seen?: Seen }} Pair
 */

/** @param {View} view @param {(position: [number, number]) => [number, number]} to @returns {Fiducial[]} */
const moved = ({ fiducials }, to) =>
  fiducials.map((mark) => {
    const [col, row] = to([mark.col, mark.row]);
    return { ...mark, col, row };
  });

/** @param {View} view @param {number} x @param {number} y @param {number} width @param {number} height @returns {View} */
export const cropped = (view, x, y, width, height) => ({
  picture: pictures.cropped(view.picture, x, y, width, height),
  fiducials: moved(view, ([col, row]) => [col - x, row - y]),
});

/** Scanned the other way round.  @param {View} view @param {90 | 180} deg clockwise @returns {View} */
export function turned(view, deg) {
  const { width, height } = view.picture;
  const picture = pictures.turned(view.picture, deg);
  return { picture, fiducials: moved(view, ([col, row]) => (deg === 180 ? [width - col, height - row] : [height - row, col])) };
}

/** @param {View} view @param {number} by @returns {View} */
export const reduced = (view, by) => ({ picture: pictures.reduced(view.picture, by), fiducials: moved(view, ([col, row]) => [col / by, row / by]) });

/** The same with another picture of the same camera and place.  @param {View} view @param {(picture: Picture) => Picture} change @returns {View} */
export const withPicture = (view, change) => ({ ...view, picture: change(view.picture) });

/** Left and right exchanged: the base is negative.  @param {Pair} pair @returns {Pair} */
export function exchanged({ left, right, camera, pose, seen }) {
  const sides = { left: right, right: left, camera, ...(seen && { seen: { ...seen, isExchanged: !seen.isExchanged } }) };
  if (!pose) return { ...sides, pose };
  const rotation = pictures.transposed(pose.rotation);
  return { ...sides, pose: { ...pose, rotation, direction: rotation.map((row) => -dot(row, pose.direction)) } };
}

/** @param {number[]} a @param {number[]} b */
export const dot = (a, b) => a.reduce((sum, v, k) => sum + v * (b[k] ?? 0), 0);

/** What a pair is matched with.  @param {Pair} pair @returns {import('../../../pkg/node.js').Given<import('../../../pkg/node.js').PairInput>} */
export function inputOf({ left, right, camera }) {
  const side = (/** @type {View} */ { fiducials, isWhole }) => ({
    fiducials,
    ...(fiducials.length > 0 && !isWhole ? { origin: /** @type {[number, number]} */ ([0, 0]) } : {}),
  });
  return { camera, left: side(left), right: side(right) };
}
