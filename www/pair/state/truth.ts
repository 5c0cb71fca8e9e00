/** The truth of a simulated pair, where the images on the screen are that pair. */
import type { FlightTruth, State } from './state';

/** The truth of the images on the screen; null where they are not a simulated pair in its own order. */
export function truthOf(state: State): FlightTruth | null {
  const { truth, images } = state;
  return truth !== null && images.left?.id === truth.leftId && images.right?.id === truth.rightId ? truth : null;
}
