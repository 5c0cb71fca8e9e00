/** Why a point was matched or refused, with the numbers that its rule compared. */
import { message, resolved } from '../../shared/crate';
import type { MatchResult, Settings } from '../../shared/crate';
import { CODES, MATCHED, UNDECIDED } from '../state/codes';
import type { CodeName } from '../state/codes';
import { comparesGradients, comparesGreyValues } from '../state/keys';
import { leftCodes, rightCodes } from '../state/select';
import { leftIndexOf } from '../state/selected';
import type { ShownPair } from '../state/select';
import type { State } from '../state/state';
import { count, fixed } from '../../shared/text/format';

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
  const prefix =
    selection.side === 'right' && own === UNDECIDED ? `Not matched. It is the best candidate of left point ${count(leftIndex + 1)}, which is rejected. ` : '';
  return {
    code,
    text: `${prefix}${message('verdict', CODES[code] ?? 'undecided')} ${numbers(CODES[code] ?? 'undecided', leftIndex, match, settings)}`.trimEnd(),
  };
}

function numbers(code: CodeName, index: number, match: MatchResult, settings: Settings): string {
  const { matching } = settings;
  const gradients = comparesGradients(settings);
  const largest = resolved(settings).matching.ambiguity ?? 1;
  const best = match.measures[2 * index] ?? Infinity;
  const second = match.measures[2 * index + 1] ?? Infinity;
  const ratio = Number.isFinite(second) ? `${fixed(best / second, 3)} of the second best (${fixed(second, 4)})` : 'without a second candidate';
  const byGrey = comparesGreyValues(settings);
  const correlation = `Correlation ${fixed(1 - best, 4)}, measure ${fixed(best, 4)}`;
  switch (code) {
    case 'matched':
    case 'gross_error':
      if (gradients) return agreeing(best, second, largest);
      return byGrey ? `${correlation}.` : `Its best measure ${fixed(best, 4)} is below ${String(matching.max_measure)}, and ${ratio}.`;
    case 'threshold':
      if (!Number.isFinite(best)) return '';
      return byGrey
        ? `Correlation ${fixed(1 - best, 4)}, allowed from ${String(matching.min_correlation)}.`
        : `Best ${fixed(best, 4)}, allowed below ${String(matching.max_measure)}.`;
    case 'ambiguous':
      return `Best ${fixed(best, 4)} is ${ratio}; allowed up to ${String(largest)}.`;
    case 'parallax':
      if (gradients) return outOfGeometry(match, ratio, best);
      return `Tolerance: ${String(matching.parallax_tolerance)} px, or three times the neighbours' scatter where that is more.`;
    case 'border':
    case 'left_right':
      return byGrey && Number.isFinite(best) ? `${correlation}.` : gradients ? `Distance ${fixed(best, 4)}, ${ratio}.` : '';
    case 'imprecise':
      return `Allowed: ${String(matching.max_standard_error)} px.`;
    default:
      return '';
  }
}

/** A verified match: where its descriptor alone would not have decided, the geometry did. */
function agreeing(best: number, second: number, largest: number): string {
  const distance = `Distance ${fixed(best, 4)}`;
  if (!Number.isFinite(second)) return `${distance}, the only candidate that agrees with the geometry of the two views.`;
  const ratio = `${distance}, ${fixed(best / second, 3)} of the second best (${fixed(second, 4)})`;
  return best > largest * second
    ? `${ratio}: more than ${String(largest)}, but it agrees with the geometry of the two views, which leaves few to choose from.`
    : `${ratio}. It agrees with the geometry of the two views.`;
}

/** Its descriptor is like enough, but it lies elsewhere than the geometry has it; or there is no geometry. */
function outOfGeometry({ geometry, no_geometry: none }: MatchResult, ratio: string, best: number): string {
  const alike = `Distance ${fixed(best, 4)}, ${ratio}`;
  if (geometry === null) return `${alike}. No geometry of the two views was found${none === null ? '' : `: ${message('no_geometry', none)}`}.`;
  const what = 'fundamental' in geometry.model ? 'its epipolar line' : 'the place that the map gives';
  return `${alike}; but it does not fit: allowed are up to ${fixed(geometry.threshold_px, 2)} px from ${what}.`;
}
