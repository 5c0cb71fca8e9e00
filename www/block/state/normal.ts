/** What normally distributed values look like when they are sorted. */

/** Beyond so many standard errors one of some 10⁹ values lies. */
const FARTHEST = 6.2;
/** Steps of the integral of the density: it is good to 1e-7. */
const STEP = 0.001;

/** The values of a standard normal variable below which (i + 1/2) of `count` parts lie, in their order: the density is summed up once for all of them. */
export function normalQuantiles(count: number): Float64Array {
  const quantiles = new Float64Array(count);
  const density = (x: number) => Math.exp(-0.5 * x * x) / Math.sqrt(2 * Math.PI);
  // Half of them; the others are their negatives.
  let [x, below] = [-FARTHEST, 0];
  for (let i = 0; i < Math.floor(count / 2); i++) {
    const wanted = (i + 0.5) / count;
    for (;;) {
      const next = x < 0 ? (STEP / 6) * (density(x) + 4 * density(x + STEP / 2) + density(x + STEP)) : Infinity;
      if (below + next >= wanted) {
        quantiles[i] = x + (STEP * (wanted - below)) / next;
        break;
      }
      [x, below] = [x + STEP, below + next];
    }
    quantiles[count - 1 - i] = -(quantiles[i] ?? 0);
  }
  return quantiles;
}
