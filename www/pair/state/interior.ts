/** The interior orientations of the pair on the screen: of known cameras, or as the matches tell them. */
import { assumed_interior } from '../../shared/crate';
import type { PairCameras, PairInterior, PhotoFacts } from '../../shared/crate';
import { remember } from '../../shared/state/remember';
import { pairCameras, photoFacts } from './cameras';
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

const assumed = remember((geometry: StageValues['match']['geometry'], facts: [PhotoFacts, PhotoFacts]) =>
  geometry === null ? null : assumed_interior(geometry, ...facts),
);

/**
 * Those that the matches tell where a camera is missing; null where they tell none. No camera that may be assumed sees a panorama, and none takes the
 * place of the one that was given.
 */
export function assumedInterior(state: State): PairInterior | null {
  const cameras = pairCameras(state);
  const { match } = state.results;
  if (!('missing' in cameras) || cameras.missing.kind === 'panorama' || state.camera !== null || match === undefined) return null;
  return assumed(match.value.geometry, photoFacts(state));
}

/** Those in use: where no camera is known, as the matches tell them. */
export function interiorInUse(state: State): PairInterior | null {
  return 'missing' in pairCameras(state) ? assumedInterior(state) : knownInterior(state);
}
