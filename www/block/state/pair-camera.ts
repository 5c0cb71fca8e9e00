/** The camera that a pair of a block has. */
import { photo_camera } from '../../../pkg/wasm/tiepoint.js';
import type { CameraMm } from '../../shared/crate';
import { cameraFrom } from '../../shared/state/camera';
import type { BlockView } from './view';

/** The camera of both images: as the block calibrated it; before that, as given, and as uncertain as one of EXIF. Null where they have two cameras, or nothing is known. */
export function cameraOfImages({ images, cameras }: Pick<BlockView, 'images' | 'cameras'>, a: number, b: number): CameraMm | null {
  const [left, right] = [images[a], images[b]];
  const camera = left !== undefined && left.camera === right?.camera ? cameras[left.camera] : undefined;
  if (camera?.calibrated != null) return photo_camera(camera.calibrated);
  return camera?.given == null ? null : cameraFrom(camera.given, 'exif35_mm');
}
