/** The statistics of each match as columns. */
import type { MatchResult, MatchScore, RelativeOrientation } from '../../shared/crate';
import { BY_HAND } from './codes';
import { interiorInUse } from './interior';
import { isPredicted, measuresOf } from './predicted';
import { pixelMm, POINT_STRIDE } from './residuals';
import { matchCodes, shownPair } from './select';
import type { State } from './state';
import { numbers } from '../../shared/state/columns';
import { remember } from '../../shared/state/remember';
import type { Column, Total } from '../../shared/state/rows';
import { decimalsOfError } from '../../shared/text/format';
import { say } from '../../shared/text/words';

/** Everything that is known of each match, one column a figure. */
export interface Statistics {
  count: number;
  columns: readonly Column[];
  /** The code of each match, which says what became of it. */
  codes: Uint8Array;
  /** The left point of each. */
  lefts: Uint32Array;
  /** 0 wrong, 1 right at an edge, 2 strictly right; null without truth. */
  rightness: Uint8Array | null;
}

interface Described {
  key: string;
  label: string;
  unit: string;
  digits: number;
  help: string;
  total?: Total;
}

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
  total: 'mean',
};
const CORRELATION: Described = {
  key: 'correlation',
  label: say('correlation-of-a-match'),
  unit: '',
  digits: 4,
  help: say('correlation-after-least-squares'),
  total: 'mean',
};
const FIT: Described = {
  key: 'standard_error',
  label: 's(x, y)',
  unit: 'px',
  digits: 3,
  help: say('standard-error-of-the-right'),
  total: 'rms',
};

/** A figure of the adjustment: a length that is given in px where that is easier to read, or one of the model, whose size is that of the base. */
interface OfAdjustment extends Described {
  inPixels?: boolean;
  ofModel?: boolean;
}

/** In the order of a row of `RelativeOrientation.points`. */
const ADJUSTED: readonly OfAdjustment[] = [
  {
    key: 'v',
    label: say('y-parallax'),
    unit: 'px',
    digits: 3,
    inPixels: true,
    help: say('residual-y-parallax-the-distance'),
    total: 'rms',
  },
  {
    key: 'r',
    label: 'r',
    unit: '',
    digits: 3,
    help: say('redundancy-number-the-share-of'),
    total: 'sum',
  },
  {
    key: 'w',
    label: 'w',
    unit: '',
    digits: 2,
    help: say('w-statistic-standardised-residual-data'),
    total: 'rms',
  },
  {
    key: 'detectable',
    label: '∇',
    unit: 'px',
    digits: 3,
    inPixels: true,
    help: say('minimal-detectable-bias-mdb-across'),
    total: 'mean',
  },
  {
    key: 'influence',
    label: 'δ',
    unit: '',
    digits: 2,
    help: say('external-reliability-the-largest-effect'),
    total: 'mean',
  },
  { key: 'weight', label: say('weight'), unit: '', digits: 2, help: say('weight-in-the-adjustment-0'), total: 'mean' },
  { key: 'model_x', label: 'X', unit: 'mm', digits: 2, ofModel: true, help: say('model-coordinate-at-photo-scale') },
  { key: 'model_y', label: 'Y', unit: 'mm', digits: 2, ofModel: true, help: say('model-coordinate-at-photo-scale-across') },
  { key: 'model_z', label: 'Z', unit: 'mm', digits: 2, ofModel: true, help: say('model-coordinate-at-photo-scale-upwards') },
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
    const compared = measuresOf(match);
    const measure = (i: number) => {
      if (i < used) return compared[i] ?? NaN;
      const [index = 0, own = NaN] = [lefts[i], match.measures[2 * (lefts[i] ?? 0)]];
      return Number.isFinite(own) && !isPredicted(match, index) ? own : NaN;
    };
    const figure = ({ key, label, unit, digits, help, ...told }: Described, value: (i: number) => number) =>
      numbers(key, label, unit, digits, value, help, told);
    const columns = POSITION.map((column, k) => figure(column, (i) => at(i, k)));
    columns.push(figure(MEASURE, measure));
    if (!match.fits.every(Number.isNaN)) {
      // Of the other strategies the measure says it.
      if (match.geometry !== null) columns.push(figure(CORRELATION, (i) => match.fits[5 * i] ?? NaN));
      columns.push(figure(FIT, (i) => worstError(match.fits, i)));
    }
    const codes = new Uint8Array(count).fill(BY_HAND);
    codes.set(matchCodes(match, orientation));
    if (orientation !== null) {
      const { points, base_mm: base } = orientation;
      ADJUSTED.forEach(({ inPixels = false, ofModel = false, digits, ...column }, k) => {
        const scale = inPixels ? (pixel ?? NaN) : 1;
        // Bases are a hundredth of a mm at the sensors of phones, and decimetres on film: model coordinates are given to a ten-thousandth.
        const shown = ofModel ? decimalsOfError(base / 1000, digits) : digits;
        columns.push(figure({ ...column, digits: shown }, (i) => (points[POINT_STRIDE * i + k] ?? NaN) / scale));
      });
    }
    return { count, columns, codes, lefts, rightness: score !== null && score.rightness.length === used ? score.rightness : null };
  },
);

/** Those of the matches that are shown; null where there are none. */
export function statisticsOfState(state: State): Statistics | null {
  const { left, match, orientation, edited } = shownPair(state);
  if (match === null || edited?.found.counts.matches === 0) return null;
  const interior = interiorInUse(state)?.left;
  return statisticsOf(left, match, orientation, state.results.score?.value ?? null, interior === undefined ? null : pixelMm(interior));
}
