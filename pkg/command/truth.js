// @ts-check
/** The truth of a simulated pair on disk: truth.json with the relative orientation, and the dense map beside it. */

import { createHash } from 'node:crypto';
import { dirname, join } from 'node:path';
import { score_matches } from '../node.js';
import { atBase } from '../pair/at-base.js';
import { DataError } from './errors.js';
import { isFolder, readBytes, readText } from './files.js';

/**
 * @typedef {import('../node.js').PairOutput} PairOutput
 * @typedef {import('../node.js').FiveParameters} FiveParameters
 * @typedef {object} Truth
 * @property {FiveParameters} orientation
 * @property {number} base_mm
 * @property {number} width of the left image
 * @property {number} height
 * @property {Float32Array} right_position
 * @property {Record<Side, string | null>} digests of both images' grey values; null where the file has none
 * @typedef {'left' | 'right'} Side
 * @typedef {{ width: number, height: number, grey: () => Uint8Array }} GreyPhoto
 */

const MAP = 'map_row_col.f32';
const NAMES = /** @type {const} */ (['omega_deg', 'phi_deg', 'kappa_deg', 'by_mm', 'bz_mm']);

const SIDES = /** @type {const} */ (['left', 'right']);

/** Names an image by its grey values, row by row: whatever file holds them.  @param {Uint8Array} grey */
export const greyDigest = (grey) => createHash('sha256').update(grey).digest('hex');

/**
 * The map as a file (row and column, the centre of the top-left pixel at 0), and where it says something.
 * @param {Float32Array} rightPosition x and y in px of each left pixel @param {number} rightWidth @param {number} rightHeight
 */
export function denseMap(rightPosition, rightWidth, rightHeight) {
  const map = Buffer.alloc(rightPosition.length * 4);
  const visible = new Uint8Array(rightPosition.length / 2);
  for (let i = 0; i < visible.length; i++) {
    const [x = NaN, y = NaN] = rightPosition.subarray(2 * i, 2 * i + 2);
    map.writeFloatLE(y - 0.5, 8 * i);
    map.writeFloatLE(x - 0.5, 8 * i + 4);
    visible[i] = x >= 0 && y >= 0 && x < rightWidth && y < rightHeight ? 255 : 0;
  }
  return { map, visible };
}

/** @param {string} path truth.json, or the folder that holds it @returns {string} the file */
export const truthFile = (path) => (isFolder(path) ? join(path, 'truth.json') : path);

/** @param {string} path truth.json, or the folder that holds it @returns {Truth} */
export function readTruth(path) {
  const file = truthFile(path);
  const text = readText(file);
  /** @type {any} */
  let json;
  try {
    json = JSON.parse(text);
  } catch (error) {
    throw new DataError(`${file}: it is no JSON: ${error instanceof Error ? error.message : String(error)}`);
  }
  const orientation = json?.relative_orientation;
  for (const name of NAMES) if (!Number.isFinite(orientation?.[name])) throw new DataError(`${file}: relative_orientation.${name} is missing or no number`);
  const [width, height] = Array.isArray(json.patch_size) ? json.patch_size : [];
  if (!Number.isInteger(width) || !Number.isInteger(height) || width < 1 || height < 1) throw new DataError(`${file}: patch_size must be [columns, rows]`);
  if (!Number.isFinite(json.b_mm)) throw new DataError(`${file}: b_mm, the photo base, is missing or no number`);
  const digests = { left: readDigest(file, json, 'left'), right: readDigest(file, json, 'right') };
  return { orientation, base_mm: json.b_mm, width, height, right_position: readMap(join(dirname(file), MAP), width, height), digests };
}

/** Truths of other origin name no digest.  @param {string} file @param {any} json @param {Side} side @returns {string | null} */
function readDigest(file, json, side) {
  const digest = json[side]?.grey_sha256;
  if (digest === undefined || digest === null) return null;
  if (typeof digest !== 'string' || !/^[0-9a-f]{64}$/.test(digest)) throw new DataError(`${file}: ${side}.grey_sha256 must be 64 hexadecimal digits`);
  return digest;
}

/** @param {string} path @param {number} width @param {number} height @returns {Float32Array} x and y in px */
function readMap(path, width, height) {
  const bytes = readBytes(path);
  const wanted = width * height * 8;
  if (bytes.length !== wanted)
    throw new DataError(`${path}: it has ${bytes.length} bytes; allowed: ${wanted}, two 32-bit numbers for each of ${width} x ${height} px`);
  const positions = new Float32Array(2 * width * height);
  for (let i = 0; i < width * height; i++) {
    positions[2 * i] = bytes.readFloatLE(8 * i + 4) + 0.5;
    positions[2 * i + 1] = bytes.readFloatLE(8 * i) + 0.5;
  }
  return positions;
}

/** A truth is of one pair, in its order.  @param {Truth} truth @param {GreyPhoto} left @param {GreyPhoto} right */
export function checkPair(truth, left, right) {
  if (left.width !== truth.width || left.height !== truth.height) {
    throw new DataError(`the truth is of ${truth.width} x ${truth.height} px; the left image has ${left.width} x ${left.height}`);
  }
  const found = { left: greyDigest(left.grey()), right: greyDigest(right.grey()) };
  if (found.left === truth.digests.right && found.right === truth.digests.left && found.left !== found.right) {
    throw new DataError('the truth is of this pair in the other order; exchange the left and the right image');
  }
  for (const side of SIDES) {
    const wanted = truth.digests[side];
    if (wanted === null || wanted === found[side]) continue;
    throw new DataError(
      `the truth is of another pair: the grey values of the ${side} image have the SHA-256 digest ${short(found[side])}; allowed: ${short(wanted)}`,
    );
  }
}

/** @param {string} digest */
const short = (digest) => `${digest.slice(0, 12)}…`;

/** How right the matches are.  @param {PairOutput} output @param {Truth} truth @param {{ width: number, height: number }} right */
export function matchScoreOf(output, truth, right) {
  return score_matches(output.match.matches, output.left.points, truth.right_position, truth.width, truth.height, right.width, right.height);
}

/**
 * What a run is worth by the truth: right and missed matches, true errors of the orientation beside its standard errors.
 * @param {PairOutput} output @param {Pick<Truth, 'orientation' | 'base_mm'>} truth @param {import('../node.js').MatchScore} score
 */
export function scoreOf(output, truth, score) {
  const { rightness, ...counts } = score;
  const o = output.orientation;
  const known = o && atBase(truth.orientation, truth.base_mm, o.base_mm);
  const errors = o && known && Object.fromEntries(NAMES.map((name) => [name, o[name] - known[name]]));
  return { ...counts, strict_share: share(score.strict, score.matches), right_share: share(score.right, score.matches), errors, rightness: [...rightness] };
}

/** @param {number} part @param {number} whole @returns {number | null} */
const share = (part, whole) => (whole > 0 ? part / whole : null);
