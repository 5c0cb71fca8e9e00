/** Why a point was matched or refused, with the numbers that its rule compared. */
import { resolved } from '../../shared/crate';
import type { MatchResult, Settings } from '../../shared/crate';
import { CODES, MATCHED, UNDECIDED } from '../state/codes';
import type { CodeName } from '../state/codes';
import { comparesGradients, comparesGreyValues, isCurrent } from '../state/keys';
import { textOfCode } from '../state/labels';
import { offGeometryPx } from '../state/off-geometry';
import { isPredicted } from '../state/predicted';
import { leftCodes, rightCodes } from '../state/select';
import { leftIndexOf } from '../state/selected';
import type { ShownPair } from '../state/select';
import type { State } from '../state/state';
import type { Figures } from '../../shared/text/words';
import { say } from '../../shared/text/words';
import { message } from '../../shared/text/messages';

/** The rule that decided about the selected point, in words. */
export function verdictOf(state: State, shown: ShownPair, match: MatchResult): { code: number; text: string } {
  const { selection, settings } = state;
  const leftIndex = leftIndexOf(state, match.best, match.rules);
  if (selection === null || settings === null) return { code: MATCHED, text: '' };
  if (leftIndex < 0) {
    const text = comparesGreyValues(settings) ? say('no-left-point-was-matched') : say('no-left-point-has-this');
    return { code: UNDECIDED, text };
  }
  const code = leftCodes(shown.left, match, shown.orientation)[leftIndex] ?? UNDECIDED;
  const own = selection.side === 'left' ? code : (rightCodes(shown.right, match, shown.orientation)[selection.index] ?? UNDECIDED);
  const beside = code === CODES.indexOf('parallax') ? besideNeighbours(state) : null;
  const prefix = selection.side === 'right' && own === UNDECIDED ? `${say('candidate-of', { point: leftIndex + 1 })} ` : '';
  return {
    code,
    text: `${prefix}${beside ?? `${textOfCode(code)} ${numbers(CODES[code] ?? 'undecided', leftIndex, match, state, settings)}`}`.trimEnd(),
  };
}

/** A y-parallax that those of the nearest matches refuse, with both figures once they are looked up. */
function besideNeighbours(state: State): string | null {
  const { parallax = null } = isCurrent(state, 'inspection') ? (state.results.inspection?.value ?? {}) : {};
  return parallax !== null && parallax.deviation_px > parallax.allowed_px ? say('parallax-beside', { ...parallax }) : null;
}

function numbers(code: CodeName, index: number, match: MatchResult, state: State, settings: Settings): string {
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
      if (isPredicted(match, index)) return say('predicted-match', compared);
      if (gradients) return say(agreeing(best, second, largest), compared);
      return byGrey ? say('correlation', compared) : say('good-measure', { ...compared, most: matching.max_measure });
    case 'threshold':
      if (!Number.isFinite(best)) return '';
      return byGrey
        ? say('low-correlation', { ...compared, least: matching.min_correlation })
        : say('large-measure', { ...compared, most: matching.max_measure });
    case 'ambiguous':
      return say('ambiguous', compared);
    case 'parallax':
      return gradients
        ? outOfGeometry(match, { ...compared, off_px: offGeometryPx(state, match) })
        : say('parallax', { tolerance: matching.parallax_tolerance });
    case 'border':
    case 'left_right':
      if (byGrey && Number.isFinite(best)) return say('correlation', compared);
      return gradients ? say('distance', compared) : '';
    case 'imprecise':
      return say('imprecise', { most: matching.max_standard_error });
    default:
      return '';
  }
}

/** A verified match: where its descriptor alone would not have decided, the geometry did. */
function agreeing(best: number, second: number, largest: number): string {
  if (!Number.isFinite(second)) return 'only-candidate';
  return best > largest * second ? 'agreeing-candidate' : 'clear-candidate';
}

/** Its descriptor is like enough, but it lies elsewhere than the geometry has it; or there is no geometry. */
function outOfGeometry({ geometry, no_geometry }: MatchResult, compared: Figures): string {
  if (geometry === null) return say('no-geometry', { ...compared, no_geometry: no_geometry === null ? null : message('no_geometry', no_geometry) });
  const off = 'fundamental' in geometry.model ? 'off-line' : 'off-place';
  return say(off, { ...compared, threshold_px: geometry.threshold_px });
}
