/** What the panes show as they stand: images, the chosen point in them, and which of their points are drawn. */
import type { BlockEdit, PointDetail } from '../../../../pkg/wasm/tiepoint.js';
import type { Position } from '../../../shared/state/pane';
import { remember } from '../../../shared/state/remember';
import type { BlockStore } from '../../engine/engine';
import type { Facts } from '../../engine/facts';
import { keptBy } from '../../state/columns';
import { standingOf } from '../../state/edits';
import { inOtherImage, placeOfPoint } from '../../state/observed';
import { shownImages } from '../../state/panes';
import { pointsOf } from '../../state/selection';
import type { BlockView } from '../../state/view';
import { columnsOf } from './grid';
import type { Marked } from './observations';
import { panesOf } from './scene';
import type { Pane } from './scene';

/** Narrower pages show the panes one below the other. */
const NARROW = 720;

const NOBODY: ReadonlySet<number> = new Set();

export class Seen {
  constructor(
    readonly store: BlockStore,
    readonly facts: Facts,
    /** Of the canvas, CSS px. */
    private readonly size: () => { width: number; height: number; isLaid: boolean },
  ) {}

  /** Whether the panes have their sizes, by which what they show is scaled. */
  get isLaid(): boolean {
    return this.size().isLaid;
  }

  view(): BlockView | null {
    return this.store.state.shown?.view ?? null;
  }

  get isNarrow(): boolean {
    return window.innerWidth < NARROW;
  }

  panes(): Pane[] {
    const view = this.view();
    if (view === null) return [];
    const { width, height } = this.size();
    return panesOf(this.store.state, view, this.facts, this.columns(view, width, height), width, height);
  }

  /** The pane that keys move. */
  active(): Pane | null {
    const panes = this.panes();
    return panes.find(({ image }) => image === this.store.state.panes.active) ?? panes[0] ?? null;
  }

  /** The point that is chosen alone, with its figures; null while they are on their way. */
  chosen(): { point: number; detail: PointDetail } | null {
    const [point, ...more] = pointsOf(this.store.state.selection.chosen);
    if (point === undefined || more.length > 0) return null;
    const detail = this.facts.point(point);
    return detail === null ? null : { point, detail };
  }

  /** Which points of an image are shown: what the filter of a table leaves out, no view shows. */
  marked(image: number): Marked {
    const { shown, selection } = this.store.state;
    if (shown === null) return { byHand: NOBODY, keeps: () => false };
    return { byHand: handMeasured(shown.view, shown.edits).get(image) ?? NOBODY, keeps: keptBy('points', shown.view, selection) };
  }

  /** Where the ground at a place of one pane lies in another, to the px where both show the chosen point near it. */
  sameGround(from: Pane | undefined, to: Pane, at: Position): Position | null {
    if (from?.points == null || to.points === null) return null;
    const moved = inOtherImage(from.points, to.points, at);
    const [point] = pointsOf(this.store.state.selection.chosen);
    const [own, other] = point === undefined ? [null, null] : [placeOfPoint(from.points, point), placeOfPoint(to.points, point)];
    const known = own === null ? null : inOtherImage(from.points, to.points, own);
    if (moved === null || own === null || other === null || known === null) return moved;
    return [moved[0] + other[0] - known[0], moved[1] + other[1] - known[1]];
  }

  private columns(view: BlockView, across: number, down: number): number {
    const images = shownImages(this.store.state.panes, view);
    const { width = 4, height = 3 } = view.images[images[0] ?? 0] ?? {};
    return columnsOf(images.length, across, down, width / height, this.isNarrow);
  }
}

/** The indices of the points that were measured by hand, by image. */
const handMeasured = remember((view: BlockView, edits: readonly BlockEdit[]): ReadonlyMap<number, ReadonlySet<number>> => {
  const { measured } = standingOf(edits);
  const indices = new Map([...view.points.sources].map((code, point) => [code, point]));
  return new Map([...measured].map(([image, codes]) => [image, new Set([...codes].flatMap((code) => indices.get(code) ?? []))]));
});
