/** The focal length of the left photo as the orientation has it, where its camera is not known without error. */
import { pairCameras } from './cameras';
import { interiorInUse } from './interior';
import { isCurrent } from './keys';
import { pixelMm } from './residuals';
import type { State } from './state';

export interface FocalLength {
  focalPx: number;
  errorPx: number;
  /** Whether the matches tell it where no camera is known; else it is that of most cameras, which the matches did not change. */
  isEstimated: boolean;
}

/** Null where there is no orientation by what is wanted now, or where it knows the camera. */
export function focalOf(state: State): FocalLength | null {
  const { match, orientation } = state.results;
  const [camera] = (isCurrent(state, 'orientation') ? orientation?.value.cameras : null) ?? [];
  const interior = interiorInUse(state);
  if (camera === undefined || interior === null) return null;
  const pixel = pixelMm(interior.left);
  const isEstimated = 'missing' in pairCameras(state) && (match?.value.geometry?.focal != null || camera.focal_mm !== interior.focal_mm);
  return { focalPx: camera.focal_mm / pixel, errorPx: camera.focal_standard_error_mm / pixel, isEstimated };
}
