// @ts-check
/** Photos of a simulated block as image files. A worker keeps the scene from one photo to the next: building it takes longer than a photo. */

import { BlockScene } from '../wasm/tiepoint.js';
import { exifBlock } from './exif.js';
import { pngOf } from './png.js';

/** @typedef {import('../wasm/tiepoint.js').BlockFlight} BlockFlight */

/** @type {{ key: string, scene: BlockScene } | null} */
let kept = null;

/** @param {BlockFlight} flight @returns {BlockScene} */
function sceneOf(flight) {
  const key = JSON.stringify(flight);
  if (kept?.key !== key) {
    kept?.scene.free();
    kept = null;
    kept = { key, scene: new BlockScene(flight) };
  }
  return kept.scene;
}

/** The truth of a flight, its images named as their files.  @param {BlockFlight} flight @returns {import('../wasm/tiepoint.js').BlockModel} */
export function photoTruth(flight) {
  const truth = sceneOf(flight).truth();
  return { ...truth, images: truth.images.map((image) => ({ ...image, name: `${image.name}.png` })) };
}

/**
 * @param {BlockFlight} flight @param {number} index
 * @param {(bytes: Uint8Array) => Uint8Array} deflate into a zlib stream (RFC 1950)
 * @returns {Uint8Array} a PNG file with EXIF, in memory of its own
 */
export function photoFile(flight, index, deflate) {
  const scene = sceneOf(flight);
  const { images, cameras } = scene.truth();
  const camera = cameras[images[index]?.camera ?? 0];
  if (!camera) throw new RangeError(`the block has no photo ${index}`);
  const pixelMm = camera.pixel_mm ?? 1;
  const [longitude = 0, latitude = 0, height = 0] = scene.recorded_position(index);
  const exif = exifBlock({ make: 'Tiepoint', model: `Simulated ${images[index]?.camera ?? 0}`, focalMm: camera.focal_px * pixelMm, pixelMm, longitude, latitude, height });
  const taken = scene.photo(index);
  return pngOf(taken.width, taken.height, taken.grey, deflate, exif);
}
