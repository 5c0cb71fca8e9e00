// @ts-check
/** One stage of a run: so many jobs at the same time, in order of their results, with the time that is left. */

/**
 * @typedef {import('./types.js').Step} Step
 * @typedef {import('./types.js').StageName} StageName
 */

/** Thrown where the signal of a run has fired.  @param {AbortSignal | undefined} signal */
export function throwIfAborted(signal) {
  if (signal?.aborted) throw signal.reason;
}

/**
 * Does the items of a stage, `width` at a time; results stand in the order of the items.
 * @template T, R
 * @param {object} stage
 * @param {StageName} stage.name @param {readonly T[]} stage.items @param {number} stage.width
 * @param {(item: T) => string} stage.label what progress calls an item
 * @param {(item: T) => Promise<{ result: R, found: boolean }>} stage.act `found`: an earlier run has done it
 * @param {(step: Step) => void} [stage.progress] @param {AbortSignal} [stage.signal]
 * @returns {Promise<R[]>}
 */
export async function runStage({ name, items, width, label, act, progress, signal }) {
  const began = performance.now();
  /** @type {R[]} */
  const results = new Array(items.length);
  let [next, done, found] = [0, 0, 0];
  /** @type {{ error: unknown } | null} */
  let failure = null;
  const tell = (/** @type {string} */ last) => {
    const seconds = (performance.now() - began) / 1000;
    const made = done - found;
    // What was found went by at once: the rest takes as long as what was made. The first of each worker wait for its start.
    const left = made >= 2 * width || (made > 0 && done === items.length) ? { secondsLeft: (seconds / made) * (items.length - done) } : {};
    progress?.({ stage: name, done, total: items.length, found, seconds, ...(last && { name: last }), ...left });
  };
  tell('');
  const lane = async () => {
    while (next < items.length && !failure) {
      const index = next++;
      const item = /** @type {T} */ (items[index]);
      try {
        throwIfAborted(signal);
        const outcome = await act(item);
        // Another lane has failed in the meantime: nothing more is told.
        if (failure) return;
        results[index] = outcome.result;
        done += 1;
        found += outcome.found ? 1 : 0;
        tell(label(item));
      } catch (error) {
        failure ??= { error };
      }
    }
  };
  // Nothing goes on behind the caller's back: the jobs under way are waited for.
  await Promise.all(Array.from({ length: Math.min(width, items.length) }, lane));
  if (failure) throw /** @type {{ error: unknown }} */ (failure).error;
  throwIfAborted(signal);
  return results;
}
