/** Cameras that a user gives: by a focal length in px, or the camera of one photo for both. */
import { camera_of_focal_px, pair_cameras } from '../../shared/crate';
import type { CameraMm } from '../../shared/crate';
import { photoFacts } from './cameras';
import { SIDES } from './state';
import type { Side, State } from './state';

/** Digits of a quotient of two typed numbers that mean something; of what a file names there are no more than those of single precision. */
const DIGITS = 12;
const DIGITS_OF_FILES = 7;

function rounded(value: number, digits = DIGITS): number {
  return Number(value.toPrecision(digits));
}

/** The focal length in px; null where the camera has no pixel size. */
export function focalPxOf({ focal_mm, pixel_mm }: CameraMm): number | null {
  return pixel_mm == null ? null : rounded(focal_mm / pixel_mm);
}

/**
 * The camera with a focal length in px. That gives the focal length in mm by the pixel size; where there is none, the pixel size by the focal length in mm; of
 * no camera both, by pixels of any size.
 */
export function withFocalPx(camera: CameraMm | null, px: number): CameraMm {
  if (camera === null) return camera_of_focal_px(px);
  const { focal_mm, pixel_mm } = camera;
  return pixel_mm == null ? { ...camera, pixel_mm: rounded(focal_mm / px) } : { ...camera, focal_mm: rounded(pixel_mm * px) };
}

/** The camera without its focal length in px, which is there by the pixel size; null where nothing else was given. */
export function withoutFocalPx(camera: CameraMm | null): CameraMm | null {
  if (camera === null) return null;
  const px = focalPxOf(camera);
  const isAll = px !== null && JSON.stringify(camera) === JSON.stringify(camera_of_focal_px(px));
  return isAll ? null : { ...camera, pixel_mm: null };
}

/** The camera that the file of one photo names, in numbers as one would type them, where that of the other names none and both are of one size; null where it is not so. */
export function cameraForBoth(state: State): { side: Side; camera: CameraMm } | null {
  const { openLeft, openRight } = state.results;
  if (state.camera !== null || openLeft === undefined || openRight === undefined) return null;
  const [left, right] = photoFacts(state);
  if (left.width_px !== right.width_px || left.height_px !== right.height_px) return null;
  const named = SIDES.flatMap((side) => {
    const facts = side === 'left' ? left : right;
    const cameras = pair_cameras(null, facts, facts);
    return 'missing' in cameras ? [] : [{ side, camera: cameras[side] }];
  });
  const [one, other] = named;
  return one === undefined || other !== undefined ? null : { ...one, camera: asTyped(one.camera) };
}

function asTyped(camera: CameraMm): CameraMm {
  const { focal_mm, pixel_mm } = camera;
  const pixel = pixel_mm == null ? {} : { pixel_mm: rounded(pixel_mm, DIGITS_OF_FILES) };
  return { ...camera, focal_mm: rounded(focal_mm, DIGITS_OF_FILES), ...pixel };
}
