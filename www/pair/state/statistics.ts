/** The statistics of each match as columns, and the order in which a table shows them. */
import type { MatchResult, MatchScore, RelativeOrientation } from '../../shared/crate';
import { remember } from '../../shared/state/remember';

/** Values a match has in `RelativeOrientation.points`. */
const POINT_STRIDE = 9;

export interface Column {
  key: string;
  label: string;
  unit: string;
  digits: number;
  /** What the figure is, in a sentence. */
  help: string;
  value: (match: number) => number;
}

/** Everything that is known of each match, one column a figure. */
export interface Statistics {
  count: number;
  columns: readonly Column[];
  /** Whether the adjustment rejected a match. */
  rejected: Uint8Array;
  /** 0 wrong, 1 right at an edge, 2 strictly right; null without truth. */
  rightness: Uint8Array | null;
}

export type Filter = 'all' | 'used' | 'rejected' | 'wrong';

export interface Order {
  key: string;
  descending: boolean;
  filter: Filter;
}

type Described = Omit<Column, 'value'>;

const POSITION: readonly Described[] = [
  { key: 'x', label: 'x', unit: 'px', digits: 1, help: 'Column of the left point; the top-left pixel’s centre is at 0.5.' },
  { key: 'y', label: 'y', unit: 'px', digits: 1, help: 'Row of the left point.' },
];
const MEASURE: Described = { key: 'measure', label: 'measure', unit: '', digits: 4, help: 'How unlike the points are: by the moments of their windows, 1 minus the correlation coefficient, or the distance of their descriptors. Small is good.' };
const FIT: Described = {
  key: 'standard_error', label: 's(x, y)', unit: 'px', digits: 3,
  help: 'Standard error of the right position from least squares matching: of its worse direction.',
};

/** In the order of a row of `RelativeOrientation.points`; lengths in mm are given in px where that is easier to read. */
const ADJUSTED: readonly (Described & { inPixels?: boolean })[] = [
  { key: 'v', label: 'y-parallax', unit: 'px', digits: 3, inPixels: true, help: 'What is left of the y-parallax: how far the rays pass each other, at photo scale.' },
  { key: 'r', label: 'r', unit: '', digits: 3, help: 'Redundancy number: the share of an error of this match that its residual shows. Near 0 it is not checked by the others.' },
  { key: 'w', label: 'w', unit: '', digits: 2, help: 'Standardised residual. Data snooping rejects beyond the limit that α₀ sets (3.29 for 0.001).' },
  { key: 'detectable', label: '∇', unit: 'px', digits: 3, inPixels: true, help: 'Minimal detectable blunder across the epipolar line: one of this size is found with the probability β₀.' },
  { key: 'influence', label: 'δ', unit: '', digits: 2, help: 'External reliability: how far an undetected blunder of that size can move an unknown, in its standard errors.' },
  { key: 'weight', label: 'weight', unit: '', digits: 2, help: 'Weight in the adjustment; 0 where rejected.' },
  { key: 'model_x', label: 'X', unit: 'mm', digits: 2, help: 'Model coordinate at photo scale, along the base.' },
  { key: 'model_y', label: 'Y', unit: 'mm', digits: 2, help: 'Model coordinate at photo scale, across the base.' },
  { key: 'model_z', label: 'Z', unit: 'mm', digits: 2, help: 'Model coordinate at photo scale, upwards; the photo lies at minus the principal distance.' },
];

/** The larger semi-axis of the error ellipse of a fit, in px. */
function worstError(fits: Float64Array, match: number): number {
  const [xx = NaN, xy = NaN, yy = NaN] = fits.subarray(5 * match + 1, 5 * match + 4);
  return Math.sqrt(0.5 * (xx + yy) + Math.hypot(0.5 * (xx - yy), xy));
}

/** The statistics of a pair's matches; those of the adjustment where there is one. */
export const statisticsOf = remember((match: MatchResult, orientation: RelativeOrientation | null, score: MatchScore | null, pixel: number | null): Statistics => {
  const count = match.matches.length / 5;
  const columns: Column[] = POSITION.map((column, k) => ({ ...column, value: (i) => match.matches[5 * i + k] ?? NaN }));
  columns.push({ ...MEASURE, value: (i) => match.matches[5 * i + 4] ?? NaN });
  if (!match.fits.every(Number.isNaN)) columns.push({ ...FIT, value: (i) => worstError(match.fits, i) });
  const rejected = new Uint8Array(count);
  if (orientation !== null) {
    for (const i of orientation.rejected) rejected[i] = 1;
    const { points } = orientation;
    ADJUSTED.forEach(({ inPixels = false, ...column }, k) => {
      const scale = inPixels ? (pixel ?? NaN) : 1;
      columns.push({ ...column, value: (i) => (points[POINT_STRIDE * i + k] ?? NaN) / scale });
    });
  }
  return { count, columns, rejected, rightness: score !== null && score.rightness.length === count ? score.rightness : null };
});

function isKept({ rejected, rightness }: Statistics, filter: Filter, match: number): boolean {
  switch (filter) {
    case 'all': return true;
    case 'used': return rejected[match] === 0;
    case 'rejected': return rejected[match] === 1;
    case 'wrong': return rightness?.[match] === 0;
  }
}

/** The matches that a filter keeps, in order of a column; those without a value come last. Equal values keep their order. */
export const ordered = remember((statistics: Statistics, { key, descending, filter }: Order): Uint32Array => {
  const kept = Uint32Array.from({ length: statistics.count }, (_, i) => i).filter((i) => isKept(statistics, filter, i));
  const column = statistics.columns.find((candidate) => candidate.key === key);
  if (column === undefined) return descending ? kept.reverse() : kept;
  const values = Float64Array.from({ length: statistics.count }, (_, i) => column.value(i));
  const sign = descending ? -1 : 1;
  return kept.sort((a, b) => {
    const [va = NaN, vb = NaN] = [values[a], values[b]];
    if (Number.isNaN(va) || Number.isNaN(vb)) return Number(Number.isNaN(va)) - Number(Number.isNaN(vb)) || a - b;
    return sign * (va - vb) || a - b;
  });
});
