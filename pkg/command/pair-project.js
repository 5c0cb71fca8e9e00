// @ts-check
/** The project file of a pair. */

import { createHash } from 'node:crypto';
import { basename } from 'node:path';
import { readBytes } from './files.js';

/**
 * @typedef {import('../node.js').PairOutput} PairOutput
 * @typedef {import('./truth.js').Truth} Truth
 */

/**
 * All that is known of a pair that was matched.
 * @param {{ images: [string, string], masks: [string | undefined, string | undefined] }} paths @param {import('./split-pair.js').Pair} pair @param {PairOutput} output
 * @param {{ truth: Truth, score: import('../node.js').MatchScore } | null} known @returns {import('../node.js').PairProject}
 */
export function projectOf({ images: [left, right], masks }, pair, output, known) {
  const photo = (/** @type {string} */ path, /** @type {string | undefined} */ mask, /** @type {import('../node.js').Photo} */ image) => {
    const { width, height, format, bits_per_sample, camera } = image.info();
    const content = createHash('sha256').update(readBytes(path)).digest('hex');
    return {
      name: basename(path),
      content,
      width_px: width,
      height_px: height,
      format,
      bits_per_sample,
      mask: mask === undefined ? null : basename(mask),
      camera,
    };
  };
  return {
    images: [photo(left, masks[0], pair.left), photo(right, masks[1], pair.right)],
    input: pair.input,
    settings: pair.settings,
    output,
    truth: known && { orientation: known.truth.orientation, base_mm: known.truth.base_mm, score: known.score },
  };
}
