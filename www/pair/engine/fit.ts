/** Least squares matching of one place that was measured by hand. */
import { fitInput, placeOfFit } from '../../shared/engine/fit';
import type { Position } from '../../shared/state/pane';
import type { State } from '../state/state';
import { settingsOf } from './inputs';
import type { Workers } from './inputs';

/** The place in the right image that least squares matching finds near a given one; null where it confirms none. */
export async function fitted(state: State, workers: Workers, left: Position, right: Position): Promise<Position | null> {
  const { left: point, offset, settings } = fitInput(left, right, settingsOf(state));
  const worker = await workers.withPair(state);
  const { matches } = await worker.call('match', {
    left: { points: point },
    right: { points: new Float64Array() },
    offset,
    interior: null,
    settings,
    nearest: null,
  });
  return placeOfFit(matches);
}
