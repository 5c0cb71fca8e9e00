/** Matches by gradients that no descriptors made: least squares matching placed them where the matches around them predict them. */
import type { MatchResult } from '../../shared/crate';
import { remember } from '../../shared/state/remember';
import { MANUAL_MEASURE } from './edited';

type Compared = Pick<MatchResult, 'best' | 'measures' | 'geometry'>;

/** Whether the match of a left point is one: it has no right point, and 1 minus the correlation coefficient in place of a distance of descriptors. */
export function isPredicted({ best, measures, geometry }: Compared, left: number): boolean {
  return geometry !== null && best[left] === -1 && Number.isFinite(measures[2 * left]);
}

/** What the strategy compared of each match; none of those that were predicted, or measured by hand. */
export const measuresOf = remember(
  (match: MatchResult): Float64Array =>
    Float64Array.from({ length: match.matches.length / 5 }, (_, row) => {
      const measure = match.matches[5 * row + 4] ?? NaN;
      return measure === MANUAL_MEASURE || isPredicted(match, match.indices[2 * row] ?? -1) ? NaN : measure;
    }),
);
