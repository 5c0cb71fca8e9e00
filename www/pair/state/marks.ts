/** The fiducial marks of a photo: which are measured, and where. */
import type { Fiducial } from '../../shared/crate';
import type { Position } from '../../shared/state/pane';
import type { PhotoData, State } from './state';

export const isMeasured = ({ col, row }: Fiducial): boolean => Number.isFinite(col) && Number.isFinite(row);

/** The marks that are measured and whose photo coordinates are known: only they take part. */
export const wholeMarks = ({ fiducials }: PhotoData): Fiducial[] =>
  fiducials.filter((mark) => isMeasured(mark) && Number.isFinite(mark.x_mm) && Number.isFinite(mark.y_mm));

/** Where a mark lies in its image, px; null where it is not measured. */
export function placeOfMark({ origin }: PhotoData, mark: Fiducial | undefined): Position | null {
  const [left, top] = origin ?? [0, 0];
  return mark !== undefined && isMeasured(mark) ? [mark.col - left, mark.row - top] : null;
}

/** The mark in hand, where it is one of those that are there. */
export const markInHand = ({ mark, photos }: State): Fiducial | undefined => (mark === null ? undefined : photos[mark.side].fiducials[mark.index]);
