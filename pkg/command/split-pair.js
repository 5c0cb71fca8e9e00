// @ts-check
/** One pair by several workers: both images are described at the same time, and the search for nearest descriptors is cut into pieces. */

import { match_described_pair, match_pair, resolved } from '../node.js';
import { ThreadPool } from './pool.js';

/**
 * @typedef {import('../node.js').Photo} Photo
 * @typedef {import('../node.js').PairOutput} PairOutput
 * @typedef {import('../node.js').PairInput} PairInput
 * @typedef {import('../node.js').PairSettings} PairSettings
 * @typedef {import('../node.js').DescribedPoints} DescribedPoints
 * @typedef {{ left: Photo, right: Photo, input: import('../node.js').Given<PairInput>, settings: PairSettings, masks: [Uint8Array | undefined, Uint8Array | undefined] }} Pair
 */

/** Bytes of a gradient descriptor. */
const DESCRIPTOR_BYTES = 128;

/**
 * The outcome of `match_pair`, to the last bit, for any number of workers. Only the strategy gradient has work that can be split.
 * @param {Pair} pair @param {number} workers @returns {Promise<PairOutput>}
 */
export async function matchPair({ left, right, input, settings, masks }, workers) {
  if (workers === 1 || resolved(settings).matching.strategy !== 'gradient') return match_pair(left, right, input, settings, ...masks);
  const pool = new ThreadPool(workers);
  try {
    const describe = (/** @type {Photo} */ photo, /** @type {Uint8Array | undefined} */ mask) => {
      const grey = photo.grey();
      return pool.run('describe', { width: photo.width, height: photo.height, grey, mask, settings }, [grey.buffer]);
    };
    /** @type {[DescribedPoints, DescribedPoints]} */
    const described = await Promise.all([describe(left, masks[0]), describe(right, masks[1])]);
    const [ofLeft, ofRight] = described;
    const pieces = await nearestPieces(ofLeft.gradients ?? new Uint8Array(), ofRight.gradients ?? new Uint8Array(), pool);
    const matched = match_described_pair(left, right, ofLeft, ofRight, input, settings, pieces);
    return { ...matched, left: detected(ofLeft), right: detected(ofRight) };
  } finally {
    await pool.close();
  }
}

/** In the order of the left descriptors, one a worker.  @param {Uint8Array} left @param {Uint8Array} right @param {ThreadPool} pool */
function nearestPieces(left, right, pool) {
  const count = left.length / DESCRIPTOR_BYTES;
  const cut = (/** @type {number} */ piece) => Math.round((count * piece) / pool.size);
  return Promise.all(Array.from({ length: pool.size }, (_, piece) => pool.run('nearest', { left, first: cut(piece), end: cut(piece + 1), right })));
}

/** Points without what they are compared by.  @param {DescribedPoints} described */
const detected = ({ moments: _moments, gradients: _gradients, ...points }) => points;
