// @ts-check
/** How long the stages of a run take. */

/** @typedef {import('./types.js').Step} Step */

/**
 * Adds to each step of a run the time since its stage began, and the time that is left.
 * @param {number} width so many jobs go on at the same time
 * @returns {(step: Pick<Step, 'stage' | 'done' | 'total' | 'found' | 'name'>) => Step}
 */
export function timed(width) {
  /** @type {string | null} */
  let last = null;
  let began = 0;
  return ({ stage, done, total, found, name }) => {
    if (stage !== last) [last, began] = [stage, performance.now()];
    const seconds = (performance.now() - began) / 1000;
    const made = done - found;
    // What was found went by at once: the rest takes as long as what was made. The first of each worker wait for its start.
    const left = made >= 2 * width || (made > 0 && done === total) ? { secondsLeft: (seconds / made) * (total - done) } : {};
    return { stage, done, total, found, seconds, ...(name && { name }), ...left };
  };
}
