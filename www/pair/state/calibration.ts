/** The calibration that this browser remembers of the camera of both images. */
import { camera_label } from '../../shared/crate';
import { calibrationOf } from '../../shared/state/calibrations';
import type { Calibration } from '../../shared/state/calibrations';
import type { State, StageValues } from './state';

type Opened = StageValues['openLeft']['info'];

/** Images that name no camera may be of any. */
function labelOf({ camera, width, height }: Opened): string | null {
  return camera === null || (camera.make === null && camera.model === null) ? null : camera_label(camera, width, height);
}

/** What can be taken in place of the images' own camera; null where a camera is given, or none is remembered. */
export function offeredCalibration({ camera, results: { openLeft, openRight } }: State): Calibration | null {
  if (camera !== null || openLeft === undefined || openRight === undefined) return null;
  const label = labelOf(openLeft.value.info);
  return label !== null && label === labelOf(openRight.value.info) ? calibrationOf(label) : null;
}
