/** A geometry of two views for tests of the page without a browser. */

/** A point is seen in its own row of the right image. */
export const ROWS = {
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
