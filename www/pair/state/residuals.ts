/** Residuals of the orientation in the units of the images. */
import type { Interior, MatchResult, RelativeOrientation } from '../../shared/crate';
import { remember } from '../../shared/state/remember';
import type { Side } from './state';

/** Side of a pixel in mm: the root of the area that the interior orientation gives a pixel. */
export function pixelMm(interior: Interior): number {
  const [[a, b], [d, e]] = interior.parameters;
  return Math.sqrt(Math.abs(a * e - b * d));
}

/** The residual of each match at its point of one image: stride 4, x, y, dx, dy in px. */
function vectorsOf(side: Side) {
  return remember((match: MatchResult, orientation: RelativeOrientation, interior: Interior): Float64Array => {
    const [[a, b], [d, e]] = interior.parameters;
    const determinant = a * e - b * d;
    const first = side === 'left' ? 0 : 2;
    const vectors = new Float64Array(4 * orientation.residuals_mm.length);
    orientation.residuals_mm.forEach((residual, i) => {
      const [vx, vy] = [residual[first] ?? NaN, residual[first + 1] ?? NaN];
      vectors[4 * i] = match.matches[5 * i + first] ?? NaN;
      vectors[4 * i + 1] = match.matches[5 * i + first + 1] ?? NaN;
      vectors[4 * i + 2] = (e * vx - b * vy) / determinant;
      vectors[4 * i + 3] = (a * vy - d * vx) / determinant;
    });
    return vectors;
  });
}

export const residualVectors: Record<Side, ReturnType<typeof vectorsOf>> = { left: vectorsOf('left'), right: vectorsOf('right') };

/** The y-parallax left in each match that the adjustment kept, in px: the right photo's correction in y minus the left one's. */
export const parallaxResiduals = remember((orientation: RelativeOrientation, interior: Interior): Float64Array => {
  const rejected = new Set(orientation.rejected);
  const pixel = pixelMm(interior);
  const kept = orientation.residuals_mm.filter((_, i) => !rejected.has(i));
  return Float64Array.from(kept, ([, left, , right]) => (right - left) / pixel);
});
