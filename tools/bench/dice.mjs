/** Random numbers of the bench: the same ones in every run. */

/** Uniform numbers from 0 to 1.  @param {number} seed */
export function dice(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** Numbers of the normal distribution with the standard deviation 1, by the sum of twelve uniform ones.  @param {number} seed */
export function normal(seed) {
  const uniform = dice(seed);
  return () => {
    let sum = -6;
    for (let k = 0; k < 12; k++) sum += uniform();
    return sum;
  };
}
