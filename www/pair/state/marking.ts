/** What a user does to measure fiducial marks in the pictures, whatever was pressed for it. */
import type { Fiducial, FiducialModel, FiducialOrientation } from '../../shared/crate';
import { roundedPx } from '../../shared/state/pane';
import type { Position } from '../../shared/state/pane';
import { isMeasured, markInHand, placeOfMark, wholeMarks } from './marks';
import type { PhotoData, Side } from './state';
import type { Store } from './store';

/** The interior orientation by marks; null where they do not determine it. */
export type MarkOrienter = (marks: readonly Fiducial[], model: FiducialModel) => Promise<FiducialOrientation | null>;

/** Marks that determine each transformation. */
const LEAST_SIMILARITY = 2;
const LEAST_AFFINE = 3;

export class Marking {
  constructor(
    private readonly store: Store,
    private readonly orienter: MarkOrienter,
    /** Brings a place of an image into view. */
    private readonly show: (side: Side, at: Position) => void,
  ) {
    // What is known of the other marks tells where this one is.
    store.watch(['photos', 'fiducialModel'], () => {
      const { mark } = store.state;
      if (mark !== null) void this.take(mark.side, mark.index);
    });
  }

  /** Begins with the first mark of a photo that is not measured, or a new one; puts the tool away where it is in use there. */
  toggle(side: Side): void {
    const { tool, mark, images, photos } = this.store.state;
    const ends = tool === 'fiducials' && mark?.side === side;
    this.store.dispatch({ type: 'tool', tool: ends || images[side] === null ? 'look' : 'fiducials' });
    if (ends || images[side] === null) return;
    const { fiducials } = photos[side];
    const first = fiducials.findIndex((one) => !isMeasured(one));
    void this.goTo(side, first < 0 ? fiducials.length : first);
    this.store.dispatch({ type: 'activeSide', side });
  }

  /** Places the mark in hand, where it is of that image. */
  place(side: Side, [x, y]: Position): void {
    const { mark, photos } = this.store.state;
    if (mark === null || mark.side !== side) return;
    const { fiducials, origin } = photos[side];
    const [left, top] = origin ?? [0, 0];
    const [col = NaN, row = NaN] = [x + left, y + top].map(roundedPx);
    const placed: Fiducial = { ...(fiducials[mark.index] ?? { x_mm: NaN, y_mm: NaN }), col, row };
    this.set(side, [...fiducials.slice(0, mark.index), placed, ...fiducials.slice(mark.index + 1)]);
  }

  nudge(dx: number, dy: number): void {
    const { mark, photos } = this.store.state;
    const at = mark === null ? null : placeOfMark(photos[mark.side], markInHand(this.store.state));
    if (mark !== null && at !== null) this.place(mark.side, [at[0] + dx, at[1] + dy]);
  }

  /** Takes the next or the former mark in hand; behind the last one a new one. */
  async go(by: 1 | -1): Promise<void> {
    const { mark, photos } = this.store.state;
    if (mark === null) return;
    const { side, index } = mark;
    const last = photos[side].fiducials.length;
    await this.goTo(side, Math.min(last, Math.max(0, index + by)));
  }

  /** The mark in hand is not measured any more. */
  clear(): void {
    const { mark, photos } = this.store.state;
    const cleared = markInHand(this.store.state);
    if (mark === null || cleared === undefined) return;
    const { fiducials } = photos[mark.side];
    this.set(
      mark.side,
      fiducials.map((one) => (one === cleared ? { ...one, col: NaN, row: NaN } : one)),
    );
  }

  private set(side: Side, fiducials: Fiducial[]): void {
    this.store.dispatch({ type: 'photo', side, photo: { fiducials } });
  }

  /** Takes a mark in hand, and shows where it is, or is expected. */
  private async goTo(side: Side, index: number): Promise<void> {
    const at = await this.take(side, index);
    if (at !== null) this.show(side, at);
  }

  /** Takes a mark in hand; where others tell where it is, that follows. */
  private async take(side: Side, index: number): Promise<Position | null> {
    this.store.dispatch({ type: 'mark', mark: { side, index, expected: null } });
    const photo = this.store.state.photos[side];
    const wanted = photo.fiducials[index];
    const at = placeOfMark(photo, wanted);
    const known = wholeMarks(photo);
    if (at !== null || wanted === undefined || known.length < LEAST_SIMILARITY) return at;
    const model = known.length < LEAST_AFFINE ? 'similarity' : this.store.state.fiducialModel;
    const found = await this.orienter(known, model);
    const expected = found === null ? null : positionOf(photo, found, wanted);
    const { mark, photos } = this.store.state;
    // Meanwhile another mark may be in hand, or the others are elsewhere.
    if (expected === null || photos[side] !== photo || mark?.side !== side || mark.index !== index) return null;
    this.store.dispatch({ type: 'mark', mark: { side, index, expected } });
    return expected;
  }
}

/** Where an interior orientation has a mark in the image. */
function positionOf({ origin }: PhotoData, { parameters }: FiducialOrientation, { x_mm, y_mm }: Fiducial): Position | null {
  const [[a, b, tx], [d, e, ty]] = parameters;
  const [u, v, determinant] = [x_mm - tx, y_mm - ty, a * e - b * d];
  const [left, top] = origin ?? [0, 0];
  const at: Position = [(e * u - b * v) / determinant - left, (a * v - d * u) / determinant - top];
  return at.every(Number.isFinite) ? at : null;
}
