/** Counts of values in equal bins. */

export interface Histogram {
  low: number;
  high: number;
  counts: number[];
  /** Values below `low` or above `high`, counted in the first or last bin. */
  outside: number;
  total: number;
  median: number;
}

/** A quantile of sorted values; NaN of none. */
function quantile(sorted: Float64Array, q: number): number {
  return sorted[Math.min(sorted.length - 1, Math.floor(q * sorted.length))] ?? NaN;
}

/** One value of each row of a flat array. */
export function columnOf(values: Float64Array, stride: number, at: number): Float64Array {
  const column = new Float64Array(Math.floor(values.length / stride));
  for (let i = 0; i < column.length; i++) column[i] = values[i * stride + at] ?? NaN;
  return column;
}

/** The finite values in ascending order. */
function sortedFinite(values: Float64Array): Float64Array {
  const sorted = values.slice().sort();
  // Sorting puts NaN last and the infinities at the ends.
  let end = sorted.length;
  while (end > 0 && !((sorted[end - 1] ?? NaN) < Infinity)) end -= 1;
  let start = 0;
  while (start < end && sorted[start] === -Infinity) start += 1;
  return sorted.subarray(start, end);
}

/**
 * The histogram of the finite values in `bins` bins. The range is that of the values from the 0.5 % to the 99.5 % quantile, so that
 * a few extreme ones do not squeeze the rest into one bin; `symmetric` centres it on 0, `from` fixes its lower end.
 */
export function histogram(values: Float64Array, bins: number, { symmetric = false, from }: { symmetric?: boolean; from?: number } = {}): Histogram {
  const sorted = sortedFinite(values);
  let low = from ?? quantile(sorted, 0.005);
  let high = quantile(sorted, 0.995);
  if (symmetric) {
    high = Math.max(Math.abs(low), Math.abs(high));
    low = -high;
  }
  if (!(high > low)) high = low + 1;
  const counts = new Array<number>(bins).fill(0);
  let outside = 0;
  for (const value of sorted) {
    if (value < low || value > high) outside += 1;
    const bin = Math.min(bins - 1, Math.max(0, Math.floor(((value - low) / (high - low)) * bins)));
    counts[bin] = (counts[bin] ?? 0) + 1;
  }
  return { low, high, counts, outside, total: sorted.length, median: quantile(sorted, 0.5) };
}
