/** Which cameras of a block are calibrated so well that a pair may take them as known. */
import type { Calibration } from '../../shared/state/calibrations';
import type { BlockState } from './state';

/** Share of the focal length that its standard error may be: a pair takes a calibrated camera without one. */
const MOST_FOCAL_ERROR = 0.01;

/** Those of a block that was found or opened; nothing is learned from one that is weak, under way, or simulated. */
export function calibrationsOf({ shown, truth }: Pick<BlockState, 'shown' | 'truth'>, at: number): Calibration[] {
  if (shown === null || truth !== null || shown.found.partial || shown.found.verdict?.kind !== 'oriented') return [];
  return shown.found.cameras.flatMap(({ label, images, calibrated: camera, focalErrorPx }) =>
    camera === null || focalErrorPx === null || focalErrorPx > MOST_FOCAL_ERROR * camera.focal_px ? [] : [{ label, camera, focalErrorPx, images, at }],
  );
}
