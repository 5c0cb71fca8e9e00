/** Which left point a selection is about, and where its best place lies. */
import type { Position } from '../../shared/state/pane';
import { BY_HAND, MATCHED } from './codes';
import type { State } from './state';

/** Where the best place of a left point lies in the right image; null where it has none. */
export function placeOf(places: Float64Array, index: number): Position | null {
  if (index < 0) return null;
  const [x = NaN, y = NaN] = places.subarray(2 * index, 2 * index + 2);
  return Number.isNaN(x) || Number.isNaN(y) ? null : [x, y];
}

/** The left point that a selection is about: itself, or the one that has the selected right point as its best candidate; a match of them before others. */
export function leftIndexOf(state: Pick<State, 'selection'>, best: Int32Array, rules: Uint8Array): number {
  const { selection } = state;
  if (selection === null) return -1;
  if (selection.side === 'left') return selection.index;
  let found = -1;
  for (let i = 0; i < best.length; i++) {
    if (best[i] !== selection.index) continue;
    if (rules[i] === MATCHED) return i;
    if (found < 0 || (rules[i] === BY_HAND && rules[found] !== BY_HAND)) found = i;
  }
  return found;
}
