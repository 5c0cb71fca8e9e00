/** The interior orientations of the pair on the screen: of known cameras, or as the matches tell them. */
import type { PairCameras, PairInterior } from '../../shared/crate';
import { pairCameras } from './keys';
import { remember } from '../../shared/state/remember';
import type { StageValues, State } from './state';

type Known = StageValues['interiorLeft'];

const paired = remember(
  (left: Known, right: Known, cameras: PairCameras): PairInterior => ({
    ...cameras,
    left: left.interior,
    right: right.interior,
    focal_mm: cameras.left.focal_mm,
  }),
);

/** Those of known cameras; null where a camera is missing or its stage has no result. */
export function knownInterior(state: State): PairInterior | null {
  const cameras = pairCameras(state);
  const { interiorLeft, interiorRight } = state.results;
  if ('missing' in cameras || interiorLeft === undefined || interiorRight === undefined) return null;
  return paired(interiorLeft.value, interiorRight.value, cameras);
}

/** Those in use: where no camera is known, as the matches tell them. */
export function interiorInUse(state: State): PairInterior | null {
  return 'missing' in pairCameras(state) ? (state.results.match?.value.estimated ?? null) : knownInterior(state);
}
