// @ts-check
/** The first stage: every image is decoded once, and its features are kept. */

import { version } from '../wasm/tiepoint.js';
import { BlockError, ownFault } from './errors.js';
import { digest, readFeatures, RECORD_VERSION } from './records.js';
import { runStage } from './stage.js';

/**
 * @typedef {import('./types.js').Source} Source
 * @typedef {import('./types.js').LeftOut} LeftOut
 * @typedef {import('./types.js').Features} Features
 * @typedef {import('./types.js').Surroundings} Surroundings
 * @typedef {{ name: string, head: Features['head'], count: number }} ReadImage
 */

/** Where the store keeps the features of an image.  @param {string} key */
const place = (key) => `features/${key}`;

/**
 * An image belongs to its content: renamed, it is the same; changed, it is another.
 * @param {Uint8Array} bytes @param {import('../wasm/tiepoint.js').FeatureOptions} options @returns {Promise<string>}
 */
export const imageKey = async (bytes, options) => digest(JSON.stringify(['features', RECORD_VERSION, version(), await digest(bytes), options]));

/**
 * Features that the first stage has kept.
 * @param {Surroundings['store']} store @param {string} key @returns {Promise<{ record: Uint8Array, features: Features }>}
 */
export async function keptFeatures(store, key) {
  const record = await store.get(place(key));
  const features = await readFeatures(record, key);
  if (!record || !features) throw new BlockError('what was kept of an image was changed while the run went on: start it again');
  return { record, features };
}

/**
 * @param {Source[]} sources @param {import('../wasm/tiepoint.js').FeatureOptions} options @param {Surroundings} surroundings
 * @returns {Promise<{ images: ReadImage[], leftOut: LeftOut[] }>} images in the order of their sources
 */
export async function readImages(sources, options, { pool, store, progress, signal }) {
  /** @param {Source} source @returns {Promise<{ result: ReadImage | LeftOut, found: boolean }>} */
  const act = async (source) => {
    const { name } = source;
    /** @type {Uint8Array} */
    let bytes;
    try {
      bytes = await source.bytes();
    } catch (error) {
      return { result: { name, reason: error instanceof Error ? error.message : String(error) }, found: false };
    }
    const key = await imageKey(bytes, options);
    const kept = await readFeatures(await store.get(place(key)), key);
    if (kept) return { result: { name, head: kept.head, count: kept.count }, found: true };
    try {
      const record = await pool.run('features', { bytes, key, options }, transferable(bytes));
      await store.put(place(key), record);
      const made = await readFeatures(record, key);
      if (!made) throw new Error('a record of features does not read as it was written');
      return { result: { name, head: made.head, count: made.count }, found: false };
    } catch (error) {
      return { result: { name, reason: ownFault(error) }, found: false };
    }
  };
  const results = await runStage({
    name: 'images', items: sources, width: pool.size + 1, label: ({ name }) => name, act, ...(progress && { progress }), ...(signal && { signal }),
  });
  return { images: results.filter((r) => 'head' in r), leftOut: results.filter((r) => 'reason' in r) };
}

/** The memory of an array that has it for itself.  @param {Uint8Array} bytes @returns {ArrayBufferLike[]} */
export const transferable = (bytes) => (bytes.byteLength === bytes.buffer.byteLength ? [bytes.buffer] : []);
