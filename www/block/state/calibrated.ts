/** Which cameras of a finished block are calibrated so well that pairs may take them. */
import type { Calibration } from '../../shared/state/calibrations';
import type { BlockView } from './view';

/** Share of the focal length that its standard error may be. */
const MOST_FOCAL_ERROR = 0.01;

/** Nothing is learned from a block that is weak or simulated, from a focal length that nothing told, and of cameras that the block has twice by one name. */
export function calibrationsOf({ verdict, cameras }: Pick<BlockView, 'verdict' | 'cameras'>, isSimulated: boolean, at: number): Calibration[] {
  if (isSimulated || verdict?.kind !== 'oriented') return [];
  return cameras.flatMap(({ label, images, given, calibrated: camera, focalErrorPx }) => {
    const isAlone = cameras.filter((other) => other.label === label).length === 1;
    if (!isAlone || given === null || camera === null || focalErrorPx === null || focalErrorPx > MOST_FOCAL_ERROR * camera.focal_px) return [];
    const { radial = [0, 0, 0], tangential = [0, 0] } = given;
    return [{ label, recorded: { radial, tangential }, camera, focalErrorPx, images, at }];
  });
}
