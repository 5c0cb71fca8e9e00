/** The statistics of each match as columns. */
import type { MatchResult, MatchScore, RelativeOrientation } from '../../shared/crate';
import { BY_HAND, GROSS_ERROR, MANUAL, MATCHED } from './codes';
import { MANUAL_MEASURE } from './edited';
import { POINT_STRIDE } from './residuals';
import { matchCodes } from './select';
import { remember } from '../../shared/state/remember';
import type { Column } from '../../shared/state/rows';
import { fixed } from '../../shared/text/format';
import { say } from '../../shared/text/words';

/** A column of numbers. */
export interface Figure extends Column {
  digits: number;
  value: (match: number) => number;
}

/** Everything that is known of each match, one column a figure. */
export interface Statistics {
  count: number;
  columns: readonly Figure[];
  /** The code of each match, which says what became of it. */
  codes: Uint8Array;
  /** The left point of each. */
  lefts: Uint32Array;
  /** 0 wrong, 1 right at an edge, 2 strictly right; null without truth. */
  rightness: Uint8Array | null;
}

export type Filter = 'all' | 'used' | 'rejected' | 'by-hand' | 'wrong';

type Described = Omit<Figure, 'value' | 'text'>;

const POSITION: readonly Described[] = [
  { key: 'x', label: 'x', unit: 'px', digits: 1, help: say('column-of-the-left-point') },
  { key: 'y', label: 'y', unit: 'px', digits: 1, help: say('row-of-the-left-point') },
];
const MEASURE: Described = {
  key: 'measure',
  label: say('measure-2'),
  unit: '',
  digits: 4,
  help: say('dissimilarity-of-the-points-by'),
};
const FIT: Described = {
  key: 'standard_error',
  label: 's(x, y)',
  unit: 'px',
  digits: 3,
  help: say('standard-error-of-the-right'),
};

/** In the order of a row of `RelativeOrientation.points`; lengths in mm are given in px where that is easier to read. */
const ADJUSTED: readonly (Described & { inPixels?: boolean })[] = [
  {
    key: 'v',
    label: say('y-parallax'),
    unit: 'px',
    digits: 3,
    inPixels: true,
    help: say('residual-y-parallax-the-distance'),
  },
  {
    key: 'r',
    label: 'r',
    unit: '',
    digits: 3,
    help: say('redundancy-number-the-share-of'),
  },
  {
    key: 'w',
    label: 'w',
    unit: '',
    digits: 2,
    help: say('w-statistic-standardised-residual-data'),
  },
  {
    key: 'detectable',
    label: '∇',
    unit: 'px',
    digits: 3,
    inPixels: true,
    help: say('minimal-detectable-bias-mdb-across'),
  },
  {
    key: 'influence',
    label: 'δ',
    unit: '',
    digits: 2,
    help: say('external-reliability-the-largest-effect'),
  },
  { key: 'weight', label: say('weight'), unit: '', digits: 2, help: say('weight-in-the-adjustment-0') },
  { key: 'model_x', label: 'X', unit: 'mm', digits: 2, help: say('model-coordinate-at-photo-scale') },
  { key: 'model_y', label: 'Y', unit: 'mm', digits: 2, help: say('model-coordinate-at-photo-scale-across') },
  { key: 'model_z', label: 'Z', unit: 'mm', digits: 2, help: say('model-coordinate-at-photo-scale-upwards') },
];

/** The larger semi-axis of the error ellipse of a fit, in px. */
function worstError(fits: Float64Array, match: number): number {
  if (5 * match >= fits.length) return NaN;
  const [xx = NaN, xy = NaN, yy = NaN] = fits.subarray(5 * match + 1, 5 * match + 4);
  return Math.sqrt(0.5 * (xx + yy) + Math.hypot(0.5 * (xx - yy), xy));
}

/** The statistics of a pair's matches, then of those that were rejected by hand; those of the adjustment where there is one. */
export const statisticsOf = remember(
  (left: Float64Array | null, match: MatchResult, orientation: RelativeOrientation | null, score: MatchScore | null, pixel: number | null): Statistics => {
    const used = match.matches.length / 5;
    const off = Uint32Array.from(match.rules, (_, left) => left).filter((left) => match.rules[left] === BY_HAND);
    const count = used + off.length;
    const lefts = Uint32Array.from({ length: count }, (_, i) => (i < used ? (match.indices[2 * i] ?? 0) : (off[i - used] ?? 0)));
    const at = (i: number, k: number) => (i < used ? match.matches[5 * i + k] : left?.[3 * (lefts[i] ?? 0) + k]) ?? NaN;
    const measure = (i: number) => {
      const own = (i < used ? match.matches[5 * i + 4] : match.measures[2 * (lefts[i] ?? 0)]) ?? NaN;
      return own === MANUAL_MEASURE || !Number.isFinite(own) ? NaN : own;
    };
    const figure = (described: Described, value: (i: number) => number): Figure => ({ ...described, value, text: (i) => fixed(value(i), described.digits) });
    const columns = POSITION.map((column, k) => figure(column, (i) => at(i, k)));
    columns.push(figure(MEASURE, measure));
    if (!match.fits.every(Number.isNaN)) columns.push(figure(FIT, (i) => worstError(match.fits, i)));
    const codes = new Uint8Array(count).fill(BY_HAND);
    codes.set(matchCodes(match, orientation));
    if (orientation !== null) {
      const { points } = orientation;
      ADJUSTED.forEach(({ inPixels = false, ...column }, k) => {
        const scale = inPixels ? (pixel ?? NaN) : 1;
        columns.push(figure(column, (i) => (points[POINT_STRIDE * i + k] ?? NaN) / scale));
      });
    }
    return { count, columns, codes, lefts, rightness: score !== null && score.rightness.length === used ? score.rightness : null };
  },
);

/** Whether a filter keeps a match. */
export function isKept({ codes, rightness }: Statistics, filter: Filter, match: number): boolean {
  switch (filter) {
    case 'all':
      return true;
    case 'used':
      return codes[match] === MATCHED || codes[match] === MANUAL;
    case 'rejected':
      return codes[match] === GROSS_ERROR;
    case 'by-hand':
      return codes[match] === BY_HAND || codes[match] === MANUAL;
    case 'wrong':
      return rightness?.[match] === 0;
  }
}
