/** A block's camera for a pair. */
import { camera_of_exif } from '../crate';
import type { Camera, CameraMm, ExifCamera } from '../crate';

/** The camera as uncertain as one that files tell from this origin. */
export function cameraFrom(camera: Camera, origin: NonNullable<ExifCamera['origin']>): CameraMm {
  const pixel = camera.pixel_mm ?? null;
  return camera_of_exif({ make: null, model: null, focal_mm: camera.focal_px * (pixel ?? 1), pixel_mm: pixel, origin, lens: camera });
}
