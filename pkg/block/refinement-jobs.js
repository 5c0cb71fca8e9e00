// @ts-check
/** What a worker does for the refinement of rays: it cuts windows out of an image, and refines points by windows of several images. */

import { Photo, refine_points } from '../wasm/tiepoint.js';
import { writeWindows } from './records.js';

/** @typedef {import('./types.js').Jobs} Jobs */

/** The image is decoded once more, and let go with the job.  @param {Jobs['windows']['input']} job @returns {Promise<Uint8Array>} */
export async function windows({ bytes, key, rays, options }) {
  const photo = Photo.decode(bytes);
  try {
    const { side, places, grey } = photo.observation_windows(rays, options);
    return await writeWindows({ key, side }, places, grey);
  } finally {
    photo.free();
  }
}

/** @param {Jobs['refine']['input']} job @returns {Promise<Float64Array>} */
export const refine = async ({ starts, rays, places, grey, options }) => refine_points(starts, rays, places, grey, options);
