/** A picture with what is known of its place in the camera: fiducial marks follow what is done to the picture. */

import * as pictures from './pictures.mjs';

/**
 * @typedef {import('./pictures.mjs').Picture} Picture
 * @typedef {import('../../../pkg/node.js').Fiducial} Fiducial
 * @typedef {{ picture: Picture, fiducials: Fiducial[], isWhole?: boolean }} View marks at positions of this picture, which may lie outside; none of a digital camera;
 *   isWhole: said to be no part of a larger scan, so that they may not
 * @typedef {import('../data.mjs').TruePose} Pose
 * @typedef {import('../../../pkg/node.js').CameraMm} CameraMm
 * @typedef {{ left: View, right: View, camera: import('../../../pkg/node.js').Given<CameraMm> | null, pose: Pose | null }} Pair
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
export function exchanged({ left, right, camera, pose }) {
  if (!pose) return { left: right, right: left, camera, pose };
  const rotation = pictures.transposed(pose.rotation);
  return { left: right, right: left, camera, pose: { ...pose, rotation, direction: rotation.map((row) => -dot(row, pose.direction)) } };
}

/** @param {number[]} a @param {number[]} b */
export const dot = (a, b) => a.reduce((sum, v, k) => sum + v * (b[k] ?? 0), 0);
