/** What the other observations say of a control or check point: its difference and the standard error of that. Pure. */
import type { ViewSurveyed } from './view';

export interface Judged {
  /** Of a control point whose own coordinates took no part in the difference, as those of check points. */
  isLeftOut: boolean;
  /** Adjusted minus surveyed, m. */
  difference: readonly number[];
  /** Standard errors of the differences; null where none is known. */
  errors: readonly (number | null)[];
}

type Differences = Pick<ViewSurveyed, 'role' | 'difference_m' | 'standard_errors_m' | 'left_out'>;

/** A control point pulls the block to itself: what it is worth says its difference where it is left out, which is taken where it is known. */
export function judgedOf({ role, difference_m: difference, standard_errors_m: errors, left_out: leftOut }: Differences): Judged {
  return role === 'control' && leftOut !== undefined
    ? { isLeftOut: true, difference: leftOut.difference, errors: leftOut.standard_errors }
    : { isLeftOut: false, difference, errors };
}

/** The difference of an axis by its standard error; NaN where that is not known. */
export function ratioOf({ difference, errors }: Judged, axis: number): number {
  const error = errors[axis] ?? NaN;
  return error > 0 ? (difference[axis] ?? NaN) / error : NaN;
}

/** The length of the difference in plan, and its standard error in the direction of the difference. */
export function planOf({ difference: [x = NaN, y = NaN], errors: [sx, sy] }: Judged): { length: number; error: number } {
  const length = Math.hypot(x, y);
  const [ex, ey] = [sx ?? NaN, sy ?? NaN];
  return { length, error: length > 0 ? Math.hypot(x * ex, y * ey) / length : Math.max(ex, ey) };
}
