// @ts-check
/** The camera that a block calibrated, for pairs of its photos or of other photos with it. */

import { basename } from 'node:path';
import { FinishedBlock, photo_camera, project_kind } from '../node.js';
import { about, DataError } from './errors.js';

/**
 * @typedef {object} BlockCamera
 * @property {import('../node.js').CameraMm} camera
 * @property {[number, number]} size_px of the photos that it is of
 */

/** Whether a file is the project of a block.  @param {Uint8Array} bytes */
export const holdsBlock = (bytes) => project_kind(bytes.subarray(0, 1024)) === 'block';

/**
 * The calibrated camera of these photos: by their names, or the only one of the block.
 * @param {string} path of the project file @param {Uint8Array} bytes @param {readonly string[]} photos @returns {BlockCamera}
 */
export function cameraOfBlock(path, bytes, photos) {
  const block = about(path, () => FinishedBlock.open(bytes));
  try {
    const { images, cameras } = block.overview();
    const named = photos.map((photo) => images.find(({ name }) => name === basename(photo))?.camera);
    const calibrated = cameras.flatMap(({ calibrated: camera }, index) => (camera === null ? [] : [index]));
    const [own] = calibrated;
    const used = [...new Set(named.map((camera) => camera ?? (calibrated.length === 1 ? own : undefined)))];
    if (used.includes(undefined)) {
      const unknown = photos.filter((_, i) => named[i] === undefined).map((photo) => basename(photo));
      throw new DataError(`${path}: it has ${calibrated.length} calibrated cameras and not ${unknown.join(', ')}: which is meant?`);
    }
    if (used.length > 1) throw new DataError(`${path}: ${photos.map((photo) => basename(photo)).join(' and ')} have different cameras; a pair takes one`);
    const camera = cameras[used[0] ?? -1]?.calibrated;
    if (!camera) throw new DataError(`${path}: no photo of this camera is oriented, and it is not calibrated`);
    return { camera: about(path, () => photo_camera(camera)), size_px: [camera.width_px, camera.height_px] };
  } finally {
    block.free();
  }
}

/**
 * Refuses photos of another size than those that the camera was calibrated with.
 * @param {BlockCamera | null} known @param {readonly { width: number, height: number }[]} photos
 */
export function checkSize(known, photos) {
  if (known === null) return;
  const [width, height] = known.size_px;
  const other = photos.find((photo) => photo.width !== width || photo.height !== height);
  if (other) throw new DataError(`the camera of the block is of photos of ${width} x ${height} px, not of ${other.width} x ${other.height} px`);
}
