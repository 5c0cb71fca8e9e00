/** Least squares matching of one place that was measured by hand. */
import { constant_offset } from '../../../pkg/wasm/tiepoint.js';
import type { Position } from '../state/selected';
import type { State } from '../state/state';
import { settingsOf } from './inputs';
import type { Workers } from './inputs';

/** How far around the given place is searched: a window of so many px. */
const SEARCH_PX = 9;

/** The place in the right image that least squares matching finds near a given one; null where it confirms none. */
export async function fitted(state: State, workers: Workers, left: Position, right: Position): Promise<Position | null> {
  const settings = settingsOf(state);
  const worker = await workers.withPair(state);
  const { matches } = await worker.call('match', {
    left: { points: Float64Array.of(...left, 0) },
    right: { points: new Float64Array() },
    offset: constant_offset(right[0] - left[0], right[1] - left[1]),
    interior: null,
    settings: {
      ...settings,
      matching: { ...settings.matching, strategy: 'least-squares', refine: null, epipolar: false, search: SEARCH_PX, left_right: false },
    },
    nearest: null,
  });
  const [, , x, y] = matches;
  return x === undefined || y === undefined ? null : [x, y];
}
