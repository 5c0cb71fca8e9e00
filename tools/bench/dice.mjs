/** Random numbers of the bench: the same ones in every run. */

/** Uniform numbers from 0 to 1.  @param {number} seed */
export function dice(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}
