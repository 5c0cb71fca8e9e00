/** Whether matches of a simulated pair are right by where its surface is seen, whatever has been done to the pictures since: the fiducial marks went with them. */

import { interior } from '../../../pkg/node.js';
import { LIMIT_PX, placesOf, share } from '../../score.mjs';

/** @typedef {import('./views.mjs').View} View @typedef {import('./views.mjs').Pair} Pair @typedef {[number, number]} Place in px */

/** The share of right matches.  @param {Pair} pair a simulated one @returns {(matches: Float64Array) => number} */
export function seenShare({ left, right, seen }) {
  if (!seen) throw new Error('the pair is not simulated');
  const { isExchanged = false, right_position, left: first, right: second } = seen;
  const toFirst = between(isExchanged ? right : left, first);
  const toView = between(second, isExchanged ? left : right);
  const { width, height } = first.picture;
  const at = (/** @type {number} */ col, /** @type {number} */ row) => {
    const [x = NaN, y = NaN] = right_position.subarray(2 * (row * width + col), 2 * (row * width + col) + 2);
    return Number.isNaN(x) ? null : /** @type {Place} */ ([x, y]);
  };
  const isRight = (/** @type {Place} */ from, /** @type {Place} */ to) =>
    placesOf({ width, height, at }, ...toFirst(from)).some((place) => {
      const [x, y] = toView(place);
      return Math.hypot(x - to[0], y - to[1]) <= LIMIT_PX;
    });
  return (matches) => share(matches, (xl, yl, xr, yr) => (isExchanged ? isRight([xr, yr], [xl, yl]) : isRight([xl, yl], [xr, yr]))).share;
}

/** From the pixels of a view to those of another one of the same photograph: the affine map of the marks, whose rows are upside down as a camera's y is.  @param {View} from @param {View} to @returns {(place: Place) => Place} */
function between(from, to) {
  const fiducials = from.fiducials.map(({ col, row }, k) => ({ col, row, x_mm: to.fiducials[k]?.col ?? NaN, y_mm: -(to.fiducials[k]?.row ?? NaN) }));
  const { width, height } = from.picture;
  const {
    parameters: [[a, b, c], [d, e, f]],
  } = interior({ focal_mm: 1 }, { width, height, fiducials, origin: [0, 0] });
  return ([x, y]) => [a * x + b * y + c, -(d * x + e * y + f)];
}
