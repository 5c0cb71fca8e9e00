/** The fiducial marks of a photo: which are measured, and where. */
import type { Fiducial } from '../../shared/crate';
import type { Position } from '../../shared/state/pane';
import type { PhotoData, State } from './state';

/** A mark of which nothing is known. */
export const UNMEASURED: Fiducial = { col: NaN, row: NaN, x_mm: NaN, y_mm: NaN };

export const isMeasured = ({ col, row }: Fiducial): boolean => Number.isFinite(col) && Number.isFinite(row);

/** Whether a mark is measured and its photo coordinates are known: only then it takes part. */
export const isWhole = (mark: Fiducial): boolean => isMeasured(mark) && Number.isFinite(mark.x_mm) && Number.isFinite(mark.y_mm);

/**
 * The marks of a photo with the photo coordinates of another one of the same camera, mark for mark: where its own are missing, and as marks that are still
 * to be measured beyond those that it has. Null where nothing is missing.
 */
export function withCoordinatesOf(marks: readonly Fiducial[], others: readonly Fiducial[]): Fiducial[] | null {
  const known = ({ x_mm, y_mm }: Fiducial) => Number.isFinite(x_mm) && Number.isFinite(y_mm);
  let isSame = true;
  const all = Array.from({ length: Math.max(marks.length, others.length) }, (_, i) => {
    const [own, other] = [marks[i] ?? UNMEASURED, others[i]];
    if (other === undefined || !known(other) || known(own)) return own;
    isSame = false;
    return { ...own, x_mm: other.x_mm, y_mm: other.y_mm };
  });
  return isSame ? null : all;
}

export const wholeMarks = ({ fiducials }: PhotoData): Fiducial[] => fiducials.filter(isWhole);

/** A photo as far as it is measured. */
export const measuredPhoto = (photo: PhotoData): PhotoData => ({ ...photo, fiducials: wholeMarks(photo) });

/** Where a mark lies in its image, px; null where it is not measured. */
export function placeOfMark({ origin }: PhotoData, mark: Fiducial | undefined): Position | null {
  const [left, top] = origin ?? [0, 0];
  return mark !== undefined && isMeasured(mark) ? [mark.col - left, mark.row - top] : null;
}

/** The mark in hand, where it is one of those that are there. */
export const markInHand = ({ mark, photos }: State): Fiducial | undefined => (mark === null ? undefined : photos[mark.side].fiducials[mark.index]);
