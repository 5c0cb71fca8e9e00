/** Why a point was matched or refused, with the numbers that its rule compared. */
import { resolved } from '../../shared/crate';
import type { MatchResult, Settings } from '../../shared/crate';
import { CODES, MATCHED, UNDECIDED } from '../state/codes';
import type { CodeName } from '../state/codes';
import { comparesGradients, comparesGreyValues } from '../state/keys';
import { textOfCode } from '../state/labels';
import { leftCodes, rightCodes } from '../state/select';
import { leftIndexOf } from '../state/selected';
import type { ShownPair } from '../state/select';
import type { State } from '../state/state';
import { page } from '../../shared/text/words';
import type { Figures } from '../../shared/text/words';

/** The rule that decided about the selected point, in words. */
export function verdictOf(state: State, shown: ShownPair, match: MatchResult): { code: number; text: string } {
  const { selection, settings } = state;
  const leftIndex = leftIndexOf(state, match.best, match.rules);
  if (selection === null || settings === null) return { code: MATCHED, text: '' };
  if (leftIndex < 0) {
    const text = comparesGreyValues(settings)
      ? 'No left point was matched to this one: this strategy searches the right image itself, at the left points.'
      : 'No left point has this point as its best candidate.';
    return { code: UNDECIDED, text };
  }
  const code = leftCodes(shown.left, match, shown.orientation)[leftIndex] ?? UNDECIDED;
  const own = selection.side === 'left' ? code : (rightCodes(shown.right, match, shown.orientation)[selection.index] ?? UNDECIDED);
  const prefix = selection.side === 'right' && own === UNDECIDED ? `${page('candidate_of', { point: leftIndex + 1 })} ` : '';
  return {
    code,
    text: `${prefix}${textOfCode(code)} ${numbers(CODES[code] ?? 'undecided', leftIndex, match, settings)}`.trimEnd(),
  };
}

function numbers(code: CodeName, index: number, match: MatchResult, settings: Settings): string {
  const { matching } = settings;
  const gradients = comparesGradients(settings);
  const byGrey = comparesGreyValues(settings);
  const largest = resolved(settings).matching.ambiguity ?? 1;
  const best = match.measures[2 * index] ?? Infinity;
  const second = match.measures[2 * index + 1] ?? Infinity;
  const compared = { best, second, ratio: best / second, correlation: 1 - best, largest };
  switch (code) {
    case 'matched':
    case 'gross_error':
      // Nothing was compared where it was measured by hand.
      if (!Number.isFinite(best)) return '';
      if (gradients) return page(agreeing(best, second, largest), compared);
      return byGrey ? page('correlation', compared) : page('good_measure', { ...compared, most: matching.max_measure });
    case 'threshold':
      if (!Number.isFinite(best)) return '';
      return byGrey
        ? page('low_correlation', { ...compared, least: matching.min_correlation })
        : page('large_measure', { ...compared, most: matching.max_measure });
    case 'ambiguous':
      return page('ambiguous', compared);
    case 'parallax':
      return gradients ? outOfGeometry(match, compared) : page('parallax', { tolerance: matching.parallax_tolerance });
    case 'border':
    case 'left_right':
      if (byGrey && Number.isFinite(best)) return page('correlation', compared);
      return gradients ? page('distance', compared) : '';
    case 'imprecise':
      return page('imprecise', { most: matching.max_standard_error });
    default:
      return '';
  }
}

/** A verified match: where its descriptor alone would not have decided, the geometry did. */
function agreeing(best: number, second: number, largest: number): string {
  if (!Number.isFinite(second)) return 'only_candidate';
  return best > largest * second ? 'agreeing_candidate' : 'clear_candidate';
}

/** Its descriptor is like enough, but it lies elsewhere than the geometry has it; or there is no geometry. */
function outOfGeometry({ geometry, no_geometry }: MatchResult, compared: Figures): string {
  if (geometry === null) return page('no_geometry', { ...compared, no_geometry });
  return page('fundamental' in geometry.model ? 'off_line' : 'off_place', { ...compared, threshold_px: geometry.threshold_px });
}
