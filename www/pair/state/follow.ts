/** Where the ground at a place of one image lies in the other, so that linked panes show the same: by the offset, or by the matches. */
import { comparesGradients, isCurrent } from './keys';
import { expectedOrigin, expectedPosition } from './offset';
import { fitted, inverse, mapped } from '../../shared/state/plane-map';
import type { Affine, Twice } from '../../shared/state/plane-map';
import { remember } from '../../shared/state/remember';
import type { Position } from '../../shared/state/pane';
import type { Side, State } from './state';

/** Matches below which a map is not trusted. */
const LEAST_MATCHES = 10;

/** They lie along a line where 1 minus the squared correlation of x and y is below that. */
const ALONG_A_LINE = 1e-6;

/** The affine map from left to right that fits all matches best (stride 5); null where they are few or lie along a line. */
const mapOf = remember((matches: Float64Array): Affine | null => {
  const count = matches.length / 5;
  const place = (i: number): Twice => [matches[5 * i] ?? NaN, matches[5 * i + 1] ?? NaN, matches[5 * i + 2] ?? NaN, matches[5 * i + 3] ?? NaN];
  return count < LEAST_MATCHES ? null : fitted(count, place, ALONG_A_LINE);
});

/** The place in the other image of what lies at a place of one; null where nothing tells it yet. */
export function sameGround(state: State, side: Side, at: Position): Position | null {
  const { settings, results } = state;
  if (settings !== null && comparesGradients(settings)) {
    const map = results.match !== undefined && isCurrent(state, 'match') ? mapOf(results.match.value.matches) : null;
    if (map === null) return null;
    return mapped(side === 'left' ? map : inverse(map), ...at);
  }
  const field = isCurrent(state, 'offset') ? results.offset?.value : undefined;
  if (field === undefined) return null;
  return side === 'left' ? expectedPosition(field, at) : expectedOrigin(field, at);
}
