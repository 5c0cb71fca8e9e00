// @ts-check
/** Renders one photo of a simulated block as a file. A worker keeps the scene from one photo to the next. */

import { BlockScene } from '../node.js';
import { exifBlock } from './exif.js';
import { greyPng } from './png.js';

/** @typedef {import('../node.js').BlockFlight} BlockFlight */

/** @type {{ key: string, scene: BlockScene } | null} */
let kept = null;

/** @param {{ flight: BlockFlight, index: number }} job @returns {Promise<Uint8Array>} a PNG file with EXIF */
export async function photo({ flight, index }) {
  const key = JSON.stringify(flight);
  if (kept?.key !== key) {
    kept?.scene.free();
    kept = { key, scene: new BlockScene(flight) };
  }
  const { scene } = kept;
  const { images, cameras } = scene.truth();
  const camera = cameras[images[index]?.camera ?? 0];
  if (!camera) throw new RangeError(`the block has no photo ${index}`);
  const pixelMm = camera.pixel_mm ?? 1;
  const [longitude = 0, latitude = 0, height = 0] = scene.recorded_position(index);
  const exif = exifBlock({ make: 'Tiepoint', model: `Simulated ${images[index]?.camera ?? 0}`, focalMm: camera.focal_px * pixelMm, pixelMm, longitude, latitude, height });
  const taken = scene.photo(index);
  // A copy of its own, which can leave the worker.
  return Uint8Array.from(greyPng(taken.width, taken.height, taken.grey, exif));
}
