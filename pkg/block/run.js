// @ts-check
/** A block from its image files to its orientation: the crate says what is to be done, a pool does it, and a store keeps it. */

import { Run, sha256 } from '../wasm/tiepoint.js';
import { breakdownOf } from './faults.js';
import { checkGiven } from './given.js';
import { ownBytes } from './own-bytes.js';
import { timed } from './timed.js';
import { plainError } from './wire.js';

/**
 * @typedef {import('./types.js').Source} Source
 * @typedef {import('./types.js').Surroundings} Surroundings
 * @typedef {import('../wasm/tiepoint.js').Job} Job
 * @typedef {import('../wasm/tiepoint.js').Failure} Failure
 */

/**
 * Runs a block. What an earlier run with the same images and settings has kept in the store is not done again; the result is the same, for
 * any number of workers. Images that cannot be read are skipped and listed.
 * @param {readonly Source[]} sources in the order in which they follow each other; no two have the same name
 * @param {import('./types.js').RunOptions} options @param {Surroundings} surroundings
 * @returns {Promise<import('../wasm/tiepoint.js').FinishedBlock>} which the caller frees
 */
export async function runBlock(sources, options, surroundings) {
  checkGiven(sources, options, surroundings);
  const { settings = {}, cameras, gps, control, geoid, positions, onOrthophoto = false, strayMasks } = options;
  const masks = options.masks ?? [];
  const { pool, progress, news, signal } = surroundings;
  const names = (/** @type {readonly Source[]} */ files) => files.map(({ name }) => name);
  const run = new Run({
    images: names(sources),
    masks: names(masks),
    settings,
    cameras: cameras?.text ?? null,
    use_gnss: gps !== 'ignore',
    control: control ?? null,
    ...(geoid && { geoid: geoid.name }),
    ...(positions !== undefined && positions !== null && { positions }),
    on_orthophoto: onOrthophoto,
    refuse_stray_masks: strayMasks !== 'list',
  });
  // One job more than there are workers, so that none of them waits.
  const width = pool.size + 1;
  const step = timed(width);
  const tell = () => {
    for (const found of run.news()) {
      if (found.kind === 'step') progress?.(step(found));
      else news?.(found);
    }
  };
  /** @type {Set<Promise<void>>} */
  const underway = new Set();
  /** @type {{ error: unknown } | null} */
  let failure = null;
  const perform = (/** @type {Job} */ job) => {
    const done = performed(job, run, { image: sources, mask: masks, geoid: geoid ? [geoid] : [] }, surroundings)
      .catch((error) => {
        failure ??= { error };
      })
      .finally(() => underway.delete(done));
    underway.add(done);
  };
  try {
    for (;;) {
      if (signal?.aborted) throw signal.reason;
      run.next(width - underway.size).forEach(perform);
      tell();
      if (underway.size === 0) break;
      await Promise.race(underway);
      if (failure) throw /** @type {{ error: unknown }} */ (failure).error;
    }
  } catch (error) {
    // Nothing goes on behind the caller's back.
    await Promise.all(underway);
    // After a trap the module is not to be called again.
    if (breakdownOf(error) === null) run.free();
    throw error;
  }
  return run.finish();
}

/**
 * Does a job, or finds it done.
 * @param {Job} job @param {Run} run @param {Record<import('../wasm/tiepoint.js').FileNeeded['kind'], readonly Source[]>} files @param {Surroundings} surroundings
 */
async function performed({ id, files: needed }, run, files, { pool, store }) {
  /** @type {Uint8Array[]} */
  let inputs;
  try {
    inputs = await Promise.all(needed.map(async ({ kind, index }) => ownBytes(await /** @type {Source} */ (files[kind][index]).bytes())));
  } catch (error) {
    return run.failed(id, { kind: 'unreadable', message: plainError(error).message });
  }
  const { key, task, records, input } = run.prepare(id, await Promise.all(inputs.map(digest)));
  const kept = key === null ? null : await store.get(key);
  if (kept && run.found(id, kept)) return;
  for (const place of records) {
    const record = await store.get(place);
    if (!record)
      return run.failed(id, {
        kind: 'refused',
        code: 'unreadable-file',
        message: `the kept record ${place} was removed while the run went on: start the run again`,
        usage: false,
      });
    inputs.push(record);
  }
  if (input) inputs.push(input);
  if (task === null) return run.complete(id, inputs[0] ?? new Uint8Array());
  /** @type {Uint8Array} */
  let output;
  try {
    output = await pool.run('block', { task, inputs }, input ? [/** @type {ArrayBuffer} */ (input.buffer)] : []);
  } catch (error) {
    return run.failed(id, failureOf(error));
  }
  if (key !== null) await store.put(key, output);
  run.complete(id, output);
}

/** SHA-256 in hexadecimal digits.  @param {Uint8Array} bytes */
async function digest(bytes) {
  // Faster, but browsers have it on secure pages only.
  const own = globalThis.crypto?.subtle;
  const sum = own ? new Uint8Array(await own.digest('SHA-256', /** @type {Uint8Array<ArrayBuffer>} */ (bytes))) : sha256(bytes);
  return Array.from(sum, (byte) => byte.toString(16).padStart(2, '0')).join('');
}

/** What a job says of itself, or that its worker broke down; any other error is thrown on.  @param {unknown} error @returns {Failure} */
function failureOf(error) {
  const { name, message, code = '', usage = false, error: refusal } = plainError(error);
  if (name === 'TiepointError') return { kind: 'refused', code, message, usage, ...(refusal && { error: refusal }) };
  // The worker was replaced.
  const breakdown = breakdownOf(error);
  if (breakdown === null) throw error;
  return { kind: breakdown === 'memory' ? 'out_of_memory' : 'broke_off', message };
}
