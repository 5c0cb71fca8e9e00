/** The calibration that this browser remembers of the camera of both images. */
import { camera_label } from '../../shared/crate';
import { calibrationBehind, calibrationOf } from '../../shared/state/calibrations';
import type { Calibration } from '../../shared/state/calibrations';
import { remember } from '../../shared/state/remember';
import { isCurrent } from './keys';
import { SIDES } from './state';
import type { Side, State, StageValues } from './state';

type Opened = StageValues['openLeft']['info'];

/** Null for images that name no camera, are no photographs of one, or are not as it took them. */
function labelOf({ camera, width, height }: Opened): string | null {
  if (camera === null || camera.origin === 'panorama' || (camera.cautions ?? []).length > 0) return null;
  return camera.make === null && camera.model === null ? null : camera_label(camera, width, height);
}

const labels = { left: remember(labelOf), right: remember(labelOf) };

/** What a side names as its camera; undefined until the image is opened. */
function named(state: State, side: Side): string | null | undefined {
  const stage = side === 'left' ? 'openLeft' : 'openRight';
  const opened = state.results[stage];
  return opened === undefined || !isCurrent(state, stage) ? undefined : labels[side](opened.value.info);
}

/** What can be taken in place of the images' own camera; null where a camera or fiducial marks are given, or none is remembered. */
export function offeredCalibration(state: State): Calibration | null {
  const { camera, images, photos, results } = state;
  if (camera !== null || SIDES.some((side) => images[side]?.source.kind !== 'file' || photos[side].fiducials.length > 0)) return null;
  const label = named(state, 'left');
  if (label == null || label !== named(state, 'right')) return null;
  return calibrationOf(label, results.openLeft?.value.info.camera?.lens ?? {});
}

/** Whether the camera was taken for photographs of another camera than those that are open now. */
export function isOfOthers(state: State): boolean {
  if (state.camera === null) return false;
  const behind = calibrationBehind(state.camera);
  if (behind === null) return false;
  return SIDES.some((side) => {
    const name = state.images[side]?.source.kind === 'file' ? named(state, side) : undefined;
    return name !== undefined && name !== behind.label;
  });
}
