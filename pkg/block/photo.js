// @ts-check
/** Photos of a simulated block as image files. A worker keeps the scene from one photo to the next: building it takes longer than a photo. */

import { BlockScene } from '../wasm/tiepoint.js';

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

/** @param {{ flight: BlockFlight, index: number }} job @returns {Uint8Array} a PNG file with EXIF, in memory of its own */
export const photoFile = ({ flight, index }) => sceneOf(flight).photo_file(index);
