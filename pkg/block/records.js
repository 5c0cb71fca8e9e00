// @ts-check
/**
 * What is kept of an image and of a pair: flat binary records that know what they belong to and whether they are whole.
 *
 * A record is little-endian: the letters TPRC; 16 bits each of version and kind; 32 bits each of the length of its head and of its number
 * of rows; SHA-256 of all that follows; the head, JSON padded with blanks to a multiple of 8 bytes; its columns, one after the other.
 */

import { sha256 as sha256InModule } from '../wasm/tiepoint.js';

/**
 * @typedef {import('./types.js').FeatureHead} FeatureHead
 * @typedef {import('./types.js').PairHead} PairHead
 * @typedef {import('./types.js').Features} Features
 * @typedef {import('./types.js').Pair} Pair
 */

/** Written into every key and record: records of another version are made again. */
export const RECORD_VERSION = 3;

const MAGIC = 0x43525054;
const HEADER = 48;
const DESCRIPTOR_BYTES = 128;

const KINDS = { features: 1, pair: 2, likeness: 3, windows: 4 };

/** SHA-256 in hexadecimal digits.  @param {Uint8Array | string} content @returns {Promise<string>} */
export async function digest(content) {
  return Array.from(await sha256(typeof content === 'string' ? new TextEncoder().encode(content) : content), (byte) => byte.toString(16).padStart(2, '0')).join('');
}

/** @param {Uint8Array} bytes @returns {Promise<Uint8Array>} */
async function sha256(bytes) {
  // Faster, but browsers have it on secure pages only.
  if (!globalThis.crypto?.subtle) return sha256InModule(bytes);
  return new Uint8Array(await crypto.subtle.digest('SHA-256', /** @type {Uint8Array<ArrayBuffer>} */ (bytes)));
}

/**
 * @param {Float32Array} positions x and y in px; stride 2
 * @param {Float32Array} shapes scale in px, direction in rad and weight; stride 3
 * @param {Uint8Array} descriptors 128 bytes each @param {FeatureHead} head
 */
export const writeFeatures = (head, positions, shapes, descriptors) => write(KINDS.features, head, positions.length / 2, [positions, shapes, descriptors]);

/** @param {PairHead} head @param {Uint32Array} indices of the left and the right feature; stride 2 @param {Float32Array} strengths */
export const writePair = (head, indices, strengths) => write(KINDS.pair, head, strengths.length, [indices, strengths]);

/** @param {{ key: string }} head @param {Uint32Array} counts common features with each of the images behind */
export const writeLikeness = (head, counts) => write(KINDS.likeness, head, counts.length, [counts]);

/** @param {import('./types.js').WindowHead} head @param {Uint32Array} places as `observation_windows` gives them; stride 4 @param {Uint8Array} grey */
export const writeWindows = (head, places, grey) => write(KINDS.windows, head, places.length / 4, [places, grey]);

/**
 * A record of features; null where the bytes are none of this key: of other settings, damaged or cut off.
 * @param {Uint8Array | null} bytes @param {string} key @returns {Promise<Features | null>}
 */
export async function readFeatures(bytes, key) {
  const read = await readRecord(KINDS.features, bytes, key, (n) => n * (8 + 12 + DESCRIPTOR_BYTES));
  if (!read) return null;
  const { head, count, body } = read;
  const { buffer, byteOffset: at } = body;
  return {
    head: /** @type {FeatureHead} */ (head),
    count,
    positions: new Float32Array(buffer, at, 2 * count),
    shapes: new Float32Array(buffer, at + 8 * count, 3 * count),
    descriptors: new Uint8Array(buffer, at + 20 * count, DESCRIPTOR_BYTES * count),
  };
}

/** As `readFeatures`, of a pair.  @param {Uint8Array | null} bytes @param {string} key @returns {Promise<Pair | null>} */
export async function readPair(bytes, key) {
  const read = await readRecord(KINDS.pair, bytes, key, (n) => n * 12);
  if (!read) return null;
  const { head, count, body } = read;
  const { buffer, byteOffset: at } = body;
  return { head: /** @type {PairHead} */ (head), count, indices: new Uint32Array(buffer, at, 2 * count), strengths: new Float32Array(buffer, at + 8 * count, count) };
}

/** As `readFeatures`, of likenesses.  @param {Uint8Array | null} bytes @param {string} key @returns {Promise<Uint32Array | null>} */
export async function readLikeness(bytes, key) {
  const read = await readRecord(KINDS.likeness, bytes, key, (n) => 4 * n);
  return read && new Uint32Array(read.body.buffer, read.body.byteOffset, read.count);
}

/** As `readFeatures`, of windows around rays.  @param {Uint8Array | null} bytes @param {string} key @returns {Promise<import('./types.js').Windows | null>} */
export async function readWindows(bytes, key) {
  const read = await readRecord(KINDS.windows, bytes, key, (n, head) => n * (16 + head.side * head.side));
  if (!read) return null;
  const { head, count, body } = read;
  return { head: /** @type {import('./types.js').WindowHead} */ (head), count, places: new Uint32Array(body.buffer, body.byteOffset, 4 * count), grey: body.subarray(16 * count) };
}

/**
 * @param {number} kind @param {object} head @param {number} count @param {(Float32Array | Uint32Array | Uint8Array)[]} columns
 * @returns {Promise<Uint8Array>}
 */
async function write(kind, head, count, columns) {
  const text = new TextEncoder().encode(JSON.stringify(head));
  const padded = Math.ceil(text.length / 8) * 8;
  const bytes = new Uint8Array(HEADER + padded + columns.reduce((sum, column) => sum + column.byteLength, 0));
  const view = new DataView(bytes.buffer);
  view.setUint32(0, MAGIC, true);
  view.setUint16(4, RECORD_VERSION, true);
  view.setUint16(6, kind, true);
  view.setUint32(8, padded, true);
  view.setUint32(12, count, true);
  bytes.fill(0x20, HEADER, HEADER + padded);
  bytes.set(text, HEADER);
  let at = HEADER + padded;
  for (const column of columns) {
    bytes.set(new Uint8Array(column.buffer, column.byteOffset, column.byteLength), at);
    at += column.byteLength;
  }
  bytes.set(await sha256(bytes.subarray(HEADER)), 16);
  return bytes;
}

/**
 * @param {number} kind @param {Uint8Array | null} bytes @param {string} key @param {(count: number, head: any) => number} bodyBytes
 * @returns {Promise<{ head: object, count: number, body: Uint8Array } | null>}
 */
async function readRecord(kind, bytes, key, bodyBytes) {
  if (!bytes || bytes.length < HEADER) return null;
  // Columns are read where they lie, which must be at whole multiples of their numbers' size.
  const whole = bytes.byteOffset % 8 === 0 ? bytes : bytes.slice();
  const view = new DataView(whole.buffer, whole.byteOffset, whole.length);
  if (view.getUint32(0, true) !== MAGIC || view.getUint16(4, true) !== RECORD_VERSION || view.getUint16(6, true) !== kind) return null;
  const [head, count] = [view.getUint32(8, true), view.getUint32(12, true)];
  const sum = await sha256(whole.subarray(HEADER));
  if (!sum.every((byte, i) => byte === whole[16 + i])) return null;
  const read = JSON.parse(new TextDecoder().decode(whole.subarray(HEADER, HEADER + head)));
  if (whole.length !== HEADER + head + bodyBytes(count, read)) return null;
  return read.key === key ? { head: read, count, body: whole.subarray(HEADER + head) } : null;
}

/** The descriptors of some features, one after the other.  @param {Uint8Array} descriptors @param {ArrayLike<number>} numbers */
export function descriptorsOf(descriptors, numbers) {
  const some = new Uint8Array(DESCRIPTOR_BYTES * numbers.length);
  for (let k = 0; k < numbers.length; k++) {
    const from = DESCRIPTOR_BYTES * (numbers[k] ?? 0);
    some.set(descriptors.subarray(from, from + DESCRIPTOR_BYTES), DESCRIPTOR_BYTES * k);
  }
  return some;
}
