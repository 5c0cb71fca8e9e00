/** Least squares matching of one place that was pointed at. */
import { constant_offset } from '../../../pkg/wasm/tiepoint.js';
import type { OffsetField, Settings } from '../crate';
import type { Position } from '../state/pane';

/** How far around the given place is searched: a window of so many px. */
const SEARCH_PX = 9;

/** What the matching of a left place near a right one is given. */
export function fitInput(left: Position, right: Position, settings: Settings): { left: Float64Array; offset: OffsetField; settings: Settings } {
  return {
    left: Float64Array.of(...left, 0),
    offset: constant_offset(right[0] - left[0], right[1] - left[1]),
    settings: {
      ...settings,
      matching: { ...settings.matching, strategy: 'least-squares', refine: null, epipolar: false, search: SEARCH_PX, left_right: false },
    },
  };
}

/** The right place of the match that was found; null where none was confirmed. */
export function placeOfFit(matches: Float64Array): Position | null {
  const [, , x, y] = matches;
  return x === undefined || y === undefined ? null : [x, y];
}
