/** How far a rejected match lies from where the geometry of the two views has it. */
import type { MatchResult } from '../../shared/crate';
import { leftIndexOf, placeOf } from './selected';
import { isCurrent } from './keys';
import type { Position } from '../../shared/state/pane';
import type { State } from './state';

/** The distance from a line of positions (stride 2), or from the only one; null of none. */
function distanceFrom(positions: Float64Array, [x, y]: Position): number | null {
  let nearest = Infinity;
  for (let k = 0; k < positions.length; k += 2) {
    const [u = NaN, v = NaN, p = u, q = v] = positions.subarray(k, k + 4);
    const [along, across] = [p - u, q - v];
    const share = ((x - u) * along + (y - v) * across) / (along ** 2 + across ** 2);
    const at = Number.isNaN(share) ? 0 : Math.min(1, Math.max(0, share));
    nearest = Math.min(nearest, Math.hypot(u + at * along - x, v + at * across - y));
  }
  return Number.isFinite(nearest) ? nearest : null;
}

/**
 * In px, of the match that the selection is about: in the other image, from the line or the place that is drawn there. Null until that is looked up, and where it
 * is within what is allowed: a stricter geometry decided then, before the final one.
 */
export function offGeometryPx(state: State, { geometry, best, rules, places }: MatchResult): number | null {
  const { selection } = state;
  const line = isCurrent(state, 'inspection') ? state.results.inspection?.value.line : null;
  if (selection === null || geometry === null || line == null) return null;
  const left = leftIndexOf(state, best, rules);
  const [x, y] = state.results.pointsLeft?.value.points.subarray(3 * left, 3 * left + 2) ?? [];
  const at: Position | null = selection.side === 'left' ? placeOf(places, left) : x === undefined || y === undefined ? null : [x, y];
  const distance = at === null ? null : distanceFrom(line.positions, at);
  return distance !== null && distance > geometry.threshold_px ? distance : null;
}
