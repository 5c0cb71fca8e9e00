/** What a user does to fiducial marks, above all to measure them in the pictures, whatever was pressed for it. */
import type { Fiducial, FiducialModel, FiducialOrientation } from '../../shared/crate';
import { roundedPx } from '../../shared/state/pane';
import type { Position } from '../../shared/state/pane';
import type { Notice } from '../../shared/state/notice';
import { say } from '../../shared/text/words';
import { isMeasured, markInHand, placeOfMark, UNMEASURED, wholeMarks, withCoordinatesOf } from './marks';
import { isOnImage } from './on-image';
import { otherSide } from './state';
import type { Deed, MarkStep, PhotoData, Side } from './state';
import type { Store } from './store';

/** The interior orientation by marks; null where they do not determine it. */
export type MarkOrienter = (marks: readonly Fiducial[], model: FiducialModel) => Promise<FiducialOrientation | null>;

/** Marks that determine each transformation. */
const LEAST_SIMILARITY = 2;
const LEAST_AFFINE = 3;

const FIELDS = ['col', 'row', 'x_mm', 'y_mm'] as const;

export class Marking {
  /** What was said of a place beside the picture. */
  private refusal: Notice | null = null;

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
  place(side: Side, at: Position): void {
    this.put(side, at, isMeasured(markInHand(this.store.state) ?? UNMEASURED) ? 'moved' : 'measured');
  }

  nudge(dx: number, dy: number): void {
    const { mark, photos } = this.store.state;
    const at = mark === null ? null : placeOfMark(photos[mark.side], markInHand(this.store.state));
    if (mark !== null && at !== null) this.put(mark.side, [at[0] + dx, at[1] + dy], 'nudged');
  }

  private put(side: Side, [x, y]: Position, deed: Deed): void {
    const { mark, photos } = this.store.state;
    if (mark === null || mark.side !== side || this.refuses(side, [x, y])) return;
    const { fiducials, origin } = photos[side];
    const [left, top] = origin ?? [0, 0];
    const [col = NaN, row = NaN] = [x + left, y + top].map(roundedPx);
    this.change(side, deed, mark.index, { ...(fiducials[mark.index] ?? UNMEASURED), col, row });
  }

  /** Nothing shows a mark beside the picture: a place there is refused, which is said until one on it is taken. */
  private refuses(side: Side, at: Position): boolean {
    const { store, refusal } = this;
    const refused = !isOnImage(store.state, side, at);
    this.refusal = refused ? { kind: 'info', text: say('mark-beside-the-picture') } : null;
    if (refused || (refusal !== null && store.state.notice === refusal)) store.dispatch({ type: 'notice', notice: this.refusal });
    return refused;
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
    const { mark } = this.store.state;
    const cleared = markInHand(this.store.state);
    if (mark === null || cleared === undefined || !isMeasured(cleared)) return;
    this.change(mark.side, 'cleared', mark.index, { ...cleared, col: NaN, row: NaN });
  }

  /** Changes numbers of a mark that were typed. */
  type(side: Side, index: number, numbers: Partial<Fiducial>): void {
    const { fiducials } = this.store.state.photos[side];
    const now = fiducials[index];
    if (now === undefined || FIELDS.every((field) => Object.is(numbers[field] ?? now[field], now[field]))) return;
    this.change(side, 'typed', index, { ...now, ...numbers });
  }

  /** Takes the photo coordinates that are missing from the other photo, which the same camera took. */
  takeCoordinates(side: Side): void {
    const { photos } = this.store.state;
    const marks = photos[side].fiducials;
    const all = withCoordinatesOf(marks, photos[otherSide(side)].fiducials);
    if (all === null) return;
    const first = all.findIndex((mark, i) => mark !== marks[i]);
    this.set({ side, deed: 'coordinates', at: first, out: marks.slice(first), put: all.slice(first) });
  }

  /** A new mark, whose numbers are to be typed. */
  add(side: Side): void {
    this.change(side, 'added', this.store.state.photos[side].fiducials.length, UNMEASURED);
  }

  remove(side: Side, index: number): void {
    this.change(side, 'removed', index);
  }

  removeAll(side: Side): void {
    const { fiducials } = this.store.state.photos[side];
    if (fiducials.length > 0) this.set({ side, deed: 'all_removed', at: 0, out: fiducials, put: [] });
  }

  /** Takes so many steps back, or makes them again, and shows the mark of the last of these. */
  step(by: number): void {
    const { tool, markSteps } = this.store.state;
    const { edits, done } = markSteps;
    const step = by === 0 ? undefined : edits[by < 0 ? done + by : done + by - 1];
    if (step === undefined) return;
    this.store.dispatch({ type: 'marksAfter', done: done + by });
    // In the table it is taken back where it was done.
    if (tool !== 'fiducials') return;
    const { side } = step;
    this.resume(side, Math.min(step.at, this.store.state.photos[side].fiducials.length));
    this.store.dispatch({ type: 'activeSide', side });
  }

  /** A mark becomes another one, or goes; behind the last one a new one comes. */
  private change(side: Side, deed: Deed, at: number, ...put: Fiducial[]): void {
    this.set({ side, deed, at, out: this.store.state.photos[side].fiducials.slice(at, at + 1), put });
  }

  private set(step: MarkStep): void {
    const { tool, mark } = this.store.state;
    const { side, at } = step;
    this.store.dispatch({ type: 'marked', step });
    if (tool !== 'fiducials' || mark?.side !== side || this.store.state.mark !== null) return;
    this.resume(side, Math.min(at, this.store.state.photos[side].fiducials.length));
  }

  /** Goes on with a mark: the tool ended with the one in hand where that may be another one now. */
  private resume(side: Side, index: number): void {
    if (this.store.state.tool !== 'fiducials') this.store.dispatch({ type: 'tool', tool: 'fiducials' });
    void this.goTo(side, index);
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
