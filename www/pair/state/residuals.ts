/** Residuals of the orientation in the units of the images. */
import type { Interior, MatchResult, RelativeOrientation } from '../../shared/crate';
import { remember } from '../../shared/state/remember';
import type { Side } from './state';

/** Side of a pixel in mm: the root of the area that the interior orientation gives a pixel. */
export function pixelMm(interior: Interior): number {
  const [[a, b], [d, e]] = interior.parameters;
  return Math.sqrt(Math.abs(a * e - b * d));
}

/** Values a match has in `RelativeOrientation.residuals_mm` and `points`. */
export const RESIDUAL_STRIDE = 4;
export const POINT_STRIDE = 9;

/** Of how many matches an orientation is, and how many of them took part. */
export function countsOf({ residuals_mm: residuals, rejected }: Pick<RelativeOrientation, 'residuals_mm' | 'rejected'>): { all: number; used: number } {
  const all = residuals.length / RESIDUAL_STRIDE;
  return { all, used: all - rejected.length };
}

/** The residual of each match at its point of one image: stride 4, x, y, dx, dy in px. */
function vectorsOf(side: Side) {
  return remember((match: MatchResult, orientation: RelativeOrientation, interior: Interior): Float64Array => {
    const [[a, b], [d, e]] = interior.parameters;
    const determinant = a * e - b * d;
    const first = side === 'left' ? 0 : 2;
    const residuals = orientation.residuals_mm;
    const vectors = new Float64Array(residuals.length);
    for (let i = 0; RESIDUAL_STRIDE * i < residuals.length; i++) {
      const vx = residuals[RESIDUAL_STRIDE * i + first] ?? NaN;
      const vy = residuals[RESIDUAL_STRIDE * i + first + 1] ?? NaN;
      vectors[4 * i] = match.matches[5 * i + first] ?? NaN;
      vectors[4 * i + 1] = match.matches[5 * i + first + 1] ?? NaN;
      vectors[4 * i + 2] = (e * vx - b * vy) / determinant;
      vectors[4 * i + 3] = (a * vy - d * vx) / determinant;
    }
    return vectors;
  });
}

export const residualVectors: Record<Side, ReturnType<typeof vectorsOf>> = { left: vectorsOf('left'), right: vectorsOf('right') };

/** The y-parallax left in each match that the adjustment kept, in px: the right photo's correction in y minus the left one's. */
export const parallaxResiduals = remember((orientation: RelativeOrientation, interior: Interior): Float64Array => {
  const rejected = new Set(orientation.rejected);
  const pixel = pixelMm(interior);
  const residuals = orientation.residuals_mm;
  const across = (i: number) => (residuals[RESIDUAL_STRIDE * i + 3] ?? NaN) - (residuals[RESIDUAL_STRIDE * i + 1] ?? NaN);
  return Float64Array.from({ length: countsOf(orientation).all }, (_, i) => across(i) / pixel).filter((_, i) => !rejected.has(i));
});
