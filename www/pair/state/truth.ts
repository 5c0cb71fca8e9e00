/** The truth of a simulated pair, where the images on the screen are that pair. */
import type { FiveParameters } from '../../shared/crate';
import type { FlightTruth, State } from './state';

/** The truth of the images on the screen; null where they are not a simulated pair in its own order. */
export function truthOf(state: State): FlightTruth | null {
  const { truth, images } = state;
  return truth !== null && images.left?.id === truth.leftId && images.right?.id === truth.rightId ? truth : null;
}

/** The true orientation with by and bz at the scale of another base; NaN where the true base is 0, which has no scale. */
export function orientationAt({ orientation, baseMm }: FlightTruth, otherMm: number): FiveParameters {
  const scale = baseMm === 0 ? NaN : otherMm / baseMm;
  return { ...orientation, by_mm: scale * orientation.by_mm, bz_mm: scale * orientation.bz_mm };
}
