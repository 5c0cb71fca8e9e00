/** The tables of images that were placed on an orthophoto, and of the links of one of them. */
import type { LinkUse, PlacingVerdict } from '../../../pkg/wasm/tiepoint.js';
import { numbers, words } from '../../shared/state/columns';
import type { Column } from '../../shared/state/rows';
import { USES, usedSo } from './links';
import type { LinkedPlacement } from './links';
import type { LengthUnit } from './orthophoto-unit';
import type { PlacedFile } from './placed';
import { say } from '../../shared/text/words';
import { useWord } from './steps';
import type { LinkStep } from './steps';

const VERDICTS: Readonly<Record<PlacingVerdict['kind'], string>> = { placed: say('placed-2'), weak: say('with-doubt-2'), not_placed: say('not-placed-2') };

/** What became of an image, in a word or two. */
function placedWord({ result }: Pick<PlacedFile, 'result'>): string {
  return result === null ? say('not-read-2') : VERDICTS[result.verdict.kind];
}

/** `said`: the verdict of an image in a sentence; `unit`: that of the orthophoto. */
export function placedColumns(rows: readonly PlacedFile[], said: (row: PlacedFile) => string, unit: LengthUnit): readonly Column[] {
  const of = (row: number): LinkedPlacement | null => rows[row]?.result?.placement ?? null;
  const axes = ['X', 'Y', 'Z'] as const;
  const angles = ['ω', 'φ', 'κ'] as const;
  const uses = (row: number, use: LinkUse) => {
    const placement = of(row);
    return placement === null ? null : usedSo(placement.links, use);
  };
  const text = (row: number, made: (shown: PlacedFile) => string) => {
    const shown = rows[row];
    return shown === undefined ? '' : made(shown);
  };
  return [
    words('placed-image', say('image-2'), (i) => rows[i]?.file.name ?? '', say('file-name-press-a-row')),
    words(
      'placed-verdict',
      say('verdict'),
      (i) => text(i, (row) => `${placedWord(row)}${row.isStale ? say('earlier-settings') : ''}`),
      say('what-the-place-of-the'),
    ),
    ...axes.map((axis, k) =>
      numbers(`placed-${axis.toLowerCase()}`, axis, unit, 2, (i) => of(i)?.pose.position[k], say('projection-centre-in-the-system', { axis })),
    ),
    ...axes.map((axis, k) =>
      numbers(`placed-s${axis.toLowerCase()}`, `σ ${axis}`, unit, 2, (i) => of(i)?.position_errors_m?.[k], say('standard-error-of-2', { axis })),
    ),
    ...angles.map((angle, k) => numbers(`placed-angle${String(k)}`, angle, '°', 3, (i) => of(i)?.angles_deg[k], say('rotation', { angle }))),
    ...angles.map((angle, k) =>
      numbers(`placed-sangle${String(k)}`, `σ ${angle}`, '°', 3, (i) => of(i)?.angle_errors_deg?.[k], say('standard-error-of-3', { angle })),
    ),
    numbers('placed-links', say('links-2'), '', 0, (i) => uses(i, 'used'), say('points-of-the-image-and')),
    numbers('placed-rejected', say('rejected'), '', 0, (i) => uses(i, 'rejected'), say('links-rejected-as-gross-errors')),
    numbers('placed-rmse', 'RMSE', 'px', 2, (i) => of(i)?.rmse_px, say('root-mean-square-length-of-the-residuals')),
    numbers('placed-checks', say('checks'), '', 0, (i) => of(i)?.checks?.number, say('links-that-took-no-part-and')),
    numbers('placed-check-rmse', say('check-rmse'), 'px', 2, (i) => of(i)?.checks?.rmse_px, say('root-mean-square-length-of-the-residuals-of')),
    numbers('placed-check-ground', say('on-the-ground'), unit, 2, (i) => of(i)?.checks?.rmse_m, say('the-same-on-the-ground')),
    numbers('placed-gsd', 'GSD', unit, 3, (i) => of(i)?.gsd_m, say('ground-sample-distance-the-side')),
    numbers('placed-above', say('above-ground'), unit, 1, (i) => of(i)?.above_ground_m, say('height-of-the-projection-centre')),
    words('placed-why', say('why'), (i) => text(i, said), say('the-verdict-in-a-sentence')),
  ];
}

/** `unit`: that of the orthophoto. */
export function linkColumns(
  { links: { at, places, residuals, uses, byHand } }: LinkedPlacement,
  steps: readonly LinkStep[],
  done: number,
  unit: LengthUnit,
): readonly Column[] {
  return [
    numbers('link', say('link'), '', 0, (i) => i + 1, say('number-of-the-link-press')),
    words('link-use', say('use'), (i) => useWord({ steps, done }, i, USES[uses[i] ?? 0] ?? 'used', byHand[i] === 1), say('used-for-the-orientation-kept')),
    numbers('link-column', say('column'), 'px', 2, (i) => at[2 * i], say('position-in-the-image-the')),
    numbers('link-row', say('row-2'), 'px', 2, (i) => at[2 * i + 1], say('position-in-the-image')),
    numbers('link-x', 'X', unit, 2, (i) => places[3 * i], say('place-on-the-orthophoto-2')),
    numbers('link-y', 'Y', unit, 2, (i) => places[3 * i + 1], say('place-on-the-orthophoto-2')),
    numbers('link-z', 'Z', unit, 2, (i) => places[3 * i + 2], say('height-of-the-ground-at')),
    numbers('link-dx', say('residual-x'), 'px', 2, (i) => residuals[2 * i], say('observed-minus-computed-column')),
    numbers('link-dy', say('residual-y'), 'px', 2, (i) => residuals[2 * i + 1], say('observed-minus-computed-row')),
    numbers('link-length', say('length'), 'px', 2, (i) => Math.hypot(residuals[2 * i] ?? NaN, residuals[2 * i + 1] ?? NaN), say('length-of-the-residual')),
  ];
}
