// @ts-check
/** How many rays the images of a block have, and how these are spread over them. */

/**
 * Counts over a model, places by the nine parts of an image in which von Gruber wants points.
 * @param {import('../wasm/tiepoint.js').BlockModel} model @returns {import('./types.js').BlockRun['selection']}
 */
export function spreadOf({ cameras, images, points }) {
  const raysOfImages = images.map(() => 0);
  /** @type {Set<number>[]} */
  const places = images.map(() => new Set());
  const third = (/** @type {number} */ at, /** @type {number} */ length) => Math.min(2, Math.floor((3 * at) / length));
  for (const { image, x_px, y_px } of points.flatMap(({ rays }) => rays)) {
    const camera = cameras[images[image]?.camera ?? 0];
    raysOfImages[image] = (raysOfImages[image] ?? 0) + 1;
    if (camera) places[image]?.add(3 * third(y_px, camera.height_px) + third(x_px, camera.width_px));
  }
  return { points: points.length, raysOfImages, placesOfImages: places.map(({ size }) => size) };
}
