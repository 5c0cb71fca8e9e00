// @ts-check
/** What is known of a block's results by the names of its images alone, before anything is computed. */

import { export_block, score_block } from '../node.js';
import { about, DataError, isRefusal } from './errors.js';

/**
 * @typedef {import('../node.js').BlockModel} BlockModel
 * @typedef {import('../node.js').ExportFormat} ExportFormat
 */

/**
 * A block of these images that has no points.
 * @param {readonly string[]} names @returns {BlockModel}
 */
function bare(names) {
  return {
    cameras: [{ width_px: 100, height_px: 100, focal_px: 100, principal_point_px: [50, 50], radial: [0, 0, 0], tangential: [0, 0], pixel_mm: 0.01 }],
    images: names.map((name) => ({ name, camera: 0, pose: { rotation: [[1, 0, 0], [0, 1, 0], [0, 0, 1]], position: [0, 0, 0] } })),
    points: [],
    origin: { longitude_deg: 0, latitude_deg: 0, height_m: 0 },
  };
}

/**
 * The files that formats write of images, but for those of which there is one for each two images.
 * @param {readonly string[]} names @param {readonly ExportFormat[]} formats @returns {string[]} paths with slashes, below the folder of the block
 */
export function exportPaths(names, formats) {
  /** @type {string[]} */
  const paths = [];
  const refused = formats.flatMap((format) => {
    try {
      export_block(bare(names), format, (path) => void paths.push(`${format}/${path}`));
      return [];
    } catch (error) {
      if (isRefusal(error)) return [{ format, reason: error.message }];
      throw error;
    }
  });
  const [first] = refused;
  if (first) throw new DataError(`these images cannot be exported as ${refused.map(({ format }) => format).join(', ')} (${first.reason}): rename them, or leave out what cannot hold their names`);
  return paths;
}

/** Refuses a truth that is damaged or of other images.  @param {string} file @param {BlockModel} truth @param {readonly string[]} names */
export function checkTruth(file, truth, names) {
  const { images, ...rest } = bare(names);
  about(file, () => score_block({ ...rest, images: images.map(({ name, camera }) => ({ name, camera })) }, truth));
}
