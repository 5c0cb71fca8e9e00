/** What belongs to the edits by hand in the state of a block. */
import { NO_HISTORY } from '../../shared/state/history';
import type { History } from '../../shared/state/history';
import type { Position } from '../../shared/state/pane';
import type { MeasuredBy, PointSource } from '../../../pkg/wasm/tiepoint.js';
import { fixed } from '../../shared/text/format';
import { say } from '../../shared/text/words';
import type { EditStep } from './edits';
import type { Awaiting, Former } from './former';
import type { BlockView } from './view';

/** What says how good a block is, before an edit and after it. */
export interface Figures {
  sigma0Px: number | null;
  rmsePx: number | null;
  oriented: number;
  points: number;
  observations: number;
  /** Root mean square difference of check points in m, and of how many; null without any. */
  checks: { rmseM: number; points: number } | null;
}

/** A place of a draft. */
export interface Placed {
  at: Position;
  by: MeasuredBy;
}

/** A control or check point that was given and is not in the block, by its name. */
export interface GivenPoint {
  given: string;
}

/** A point that is measured by hand and not accepted yet. */
export interface Draft {
  /** The point whose observations are measured; null for a new one. */
  of: PointSource | GivenPoint | null;
  /** By image; the first one placed comes first. */
  places: ReadonlyMap<number, Placed>;
}

/** Of the state what belongs to the edits. */
export interface Edits {
  history: History<EditStep>;
  /** Figures of the block before the latest edit; null without any. */
  before: Figures | null;
  /** The block is adjusted with other edits. */
  adjusting: boolean;
  draft: Draft | null;
  /** Edits of blocks that were found before this one. */
  former: readonly Former[];
  /** Edits of the former block until this one lies on the orthophoto; null where none wait for it. */
  awaiting: Awaiting | null;
}

export const UNEDITED: Edits = { history: NO_HISTORY, before: null, adjusting: false, draft: null, former: [], awaiting: null };

export function figuresOf(view: BlockView): Figures {
  const { sigma0Px, rmsePx, oriented, points, checks, images } = view;
  const ofChecks = checks === null ? null : { rmseM: Math.hypot(...checks.rmse_m), points: checks.points };
  return { sigma0Px, rmsePx, oriented, points: points.taking, observations: images.reduce((sum, image) => sum + image.rays, 0), checks: ofChecks };
}

/** What the latest edit did, in a line. */
export function comparedText(before: Figures, now: Figures): string {
  const [checks, checksNow] = [before.checks, now.checks];
  const points = { points: checks?.points ?? 0, points_2: checksNow?.points ?? 0 };
  // Others than before have other differences, whatever the block is worth.
  const of = points.points === points.points_2 ? '' : say('of-so-many-check-points', points);
  const parts = [
    say('n-0-px', { sigma0_px: figureText(before.sigma0Px), sigma0_px_2: figureText(now.sigma0Px) }),
    say('rmse-px', { rmse_px: figureText(before.rmsePx), rmse_px_2: figureText(now.rmsePx) }),
    checks === null && checksNow === null
      ? ''
      : say('check-points-m', { checks_m: figureText(checks?.rmseM ?? null), checks_m_2: figureText(checksNow?.rmseM ?? null), of }),
    before.oriented === now.oriented ? '' : say('images-oriented', { oriented: before.oriented, oriented_2: now.oriented }),
  ];
  return parts.filter((part) => part !== '').join(' · ');
}

/** In px or m. */
export function figureText(value: number | null): string {
  return value === null ? '–' : fixed(value, 3);
}
