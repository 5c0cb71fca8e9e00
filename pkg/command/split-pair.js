// @ts-check
/** One pair by several workers: both images are described at the same time, and the search for nearest descriptors is cut into pieces. */

import { constant_offset, estimated_interior, interior, match_pair, match_photos, orient_matches, scaled_interior } from '../node.js';
import { isRefusal } from './errors.js';
import { ThreadPool } from './pool.js';

/**
 * @typedef {import('../node.js').Camera} Camera
 * @typedef {import('../node.js').Photo} Photo
 * @typedef {import('../node.js').PairOutput} PairOutput
 * @typedef {import('../node.js').PairInterior} PairInterior
 * @typedef {import('../node.js').PairSettings} PairSettings
 * @typedef {import('../node.js').DescribedPoints} DescribedPoints
 * @typedef {import('../node.js').Given<import('../node.js').PairInput>} GivenInput
 * @typedef {{ left: Photo, right: Photo, input: GivenInput, settings: PairSettings, masks: [Uint8Array | undefined, Uint8Array | undefined] }} Pair
 */

/** Bytes of a gradient descriptor. */
const DESCRIPTOR_BYTES = 128;

/**
 * The outcome of `match_pair`, to the last bit, for any number of workers. Only the strategy gradient has work that can be split.
 * @param {Pair} pair @param {number} workers @returns {Promise<PairOutput>}
 */
export async function matchPair(pair, workers) {
  const { left, right, input, settings, masks } = pair;
  const whole = () => match_pair(left, right, input, settings, ...masks);
  if (workers === 1 || settings.matching.strategy !== 'gradient') return whole();
  // What is wrong with the camera is told before the images are searched.
  const known = knownInterior(pair);
  const pool = new ThreadPool(workers);
  try {
    // Why a pair is not oriented is for the crate to say.
    return (await oriented(pair, known, pool)) ?? whole();
  } finally {
    await pool.close();
  }
}

/** @param {Pair} pair @param {PairInterior | null} known @param {ThreadPool} pool @returns {Promise<PairOutput | null>} null where nothing is oriented */
async function oriented({ left, right, input, settings, masks }, known, pool) {
  const describe = (/** @type {Photo} */ photo, /** @type {Uint8Array | undefined} */ mask) => {
    const grey = photo.grey();
    return pool.run('describe', { width: photo.width, height: photo.height, grey, mask, settings }, [grey.buffer]);
  };
  /** @type {[DescribedPoints, DescribedPoints]} */
  const described = await Promise.all([describe(left, masks[0]), describe(right, masks[1])]);
  const [ofLeft, ofRight] = described.map(({ gradients }) => gradients);
  const pieces = await nearestPieces(ofLeft ?? new Uint8Array(), ofRight ?? new Uint8Array(), pool);
  const offset = input.offset ? constant_offset(...input.offset) : null;
  const match = match_photos(left, right, ...described, offset, known, settings, pieces);
  const { geometry } = match;
  if (!geometry || geometry.degenerate === 'pure-rotation') return null;
  const used = known ?? estimated_interior(geometry.focal, left.width, left.height, right.width, right.height);
  const orientation = used && orientationOf(match, used, settings);
  if (!orientation) return null;
  const [leftPoints, rightPoints] = described.map(({ moments: _moments, gradients: _gradients, ...points }) => points);
  if (!leftPoints || !rightPoints) return null;
  return { left: leftPoints, right: rightPoints, offset, match, interior: used, pixel_mm: pixelOf(used), orientation, orientation_reason: null };
}

/** In the order of the left descriptors, one a worker.  @param {Uint8Array} left @param {Uint8Array} right @param {ThreadPool} pool */
function nearestPieces(left, right, pool) {
  const count = left.length / DESCRIPTOR_BYTES;
  const cut = (/** @type {number} */ piece) => Math.round((count * piece) / pool.size);
  return Promise.all(Array.from({ length: pool.size }, (_, piece) => pool.run('nearest', { left, first: cut(piece), end: cut(piece + 1), right })));
}

/** Of cameras that are given or that the files name; null where one of them is not known.  @param {Pair} pair @returns {PairInterior | null} */
function knownInterior({ left, right, input }) {
  const [ofLeft, ofRight] = [cameraOf(left, input), cameraOf(right, input)];
  const sideOf = (/** @type {Photo} */ { width, height }, /** @type {Camera | null} */ camera, /** @type {'left' | 'right'} */ side) => {
    const { fiducials = [], origin = null } = input[side] ?? {};
    return camera && (fiducials.length > 0 || camera.pixel_mm != null) ? interior(camera, { width, height, fiducials, origin }) : null;
  };
  const [leftSide, rightSide] = [sideOf(left, ofLeft, 'left'), sideOf(right, ofRight, 'right')];
  if (!ofLeft || !ofRight || !leftSide || !rightSide) return null;
  return { left: leftSide, right: scaled_interior(rightSide, ofLeft.focal_mm / ofRight.focal_mm), focal_mm: ofLeft.focal_mm };
}

/** @param {Photo} photo @param {GivenInput} input @returns {Camera | null} */
function cameraOf(photo, { camera }) {
  if (camera) return /** @type {Camera} */ (camera);
  const exif = photo.info().camera;
  return exif && { focal_mm: exif.focal_mm, pixel_mm: exif.pixel_mm };
}

/** Null where the matches determine none.  @param {PairOutput['match']} match @param {PairInterior} used @param {PairSettings} settings */
function orientationOf({ matches, fits }, used, settings) {
  try {
    return orient_matches(matches, fits, used, settings.orientation);
  } catch (error) {
    if (!isRefusal(error) || error.usage) throw error;
    return null;
  }
}

/** Side of a left pixel in mm.  @param {PairInterior} interior */
function pixelOf({ left: { parameters: [[a, b], [d, e]] } }) {
  return Math.sqrt(Math.abs(a * e - b * d));
}
