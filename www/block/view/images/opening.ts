/** Images open at what is chosen, once: what is shown after that is up to the user, whatever is edited. */
import type { PointDetail } from '../../../../pkg/wasm/tiepoint.js';
import type { PaneView, Position } from '../../../shared/state/pane';
import { contains, toCanvas } from '../../../shared/view/transform';
import { footprintsAt } from '../../state/footprints';
import { codeOfSource } from '../../state/edits';
import { likeliest } from '../../state/likely';
import { FEW_PANES, MOST_PANES, shownImages } from '../../state/panes';
import { imagesOf, pointsOf } from '../../state/selection';
import type { Choice } from '../../state/selection';
import type { Shown } from '../../state/state';
import type { BlockView } from '../../state/view';
import type { Measuring } from './measuring';
import { fillScale, isOn } from './scene';
import type { Seen } from './seen';

/** A chosen point is shown at least so large: CSS px of a px of the image. */
const LEAST_SCALE = 1;

export class Opening {
  /** The point that the panes were opened at, of the block as it was found, by what it is. */
  private openedAt: { found: BlockView; source: number; unmeasured: boolean } | null = null;
  /** The choice whose images were shown. */
  private shownFor: Choice | null = null;
  /** Images of a given point that are still to be moved to where it is expected: what says so is on its way. */
  private pending: ReadonlySet<number> = new Set();
  /** The block as it was shown last. */
  private last: { found: BlockView; view: BlockView } | null = null;

  constructor(
    private readonly seen: Seen,
    private readonly measuring: Measuring,
  ) {}

  /** A press on the point that is chosen shows it in the middle again. */
  again(): void {
    this.openedAt = null;
  }

  /** Opens the images of the point that is chosen, once its figures are there. */
  follow(): void {
    const { onStage, panes, selection, shown } = this.seen.store.state;
    if (shown === null) return;
    const { view, found } = shown;
    this.afterEdit(found, view);
    // It is followed again once the panes have their sizes.
    if (onStage !== 'images' || !this.seen.isLaid) return;
    const chosen = this.seen.chosen();
    if (chosen === null) {
      if (selection.chosen === null) this.openedAt = null;
      if (selection.chosen?.kind === 'given') {
        this.showGiven(selection.chosen, shown);
        return;
      }
      if (selection.chosen !== this.shownFor) this.showChosenImages(selection.chosen, view);
      return;
    }
    const { unmeasured } = panes.look;
    const { openedAt } = this;
    const source = this.sourceOf(view, chosen.point);
    if (openedAt?.found === found && openedAt.source === source && openedAt.unmeasured === unmeasured) return;
    this.openedAt = { found, source, unmeasured };
    this.open(chosen.detail, view);
  }

  /** Moves the point that is measured into sight where it is placed or expected. */
  showDraft(): void {
    const panes = this.seen.panes();
    const scale = Math.max(LEAST_SCALE, ...panes.map(({ transform }) => transform.scale));
    const views = panes.flatMap((pane): [number, PaneView][] => {
      const at = this.measuring.placeIn(pane);
      if (at === null || !isOn(pane, at)) return [];
      const { left, top, width, height } = pane.rect;
      const inner = { left: left + width / 8, top: top + height / 8, width: 0.75 * width, height: 0.75 * height };
      return contains(inner, ...toCanvas(pane.transform, ...at)) ? [] : [[pane.image, viewAt(at, scale)]];
    });
    if (views.length > 0) this.seen.store.dispatch({ type: 'moveViews', views: new Map(views) });
  }

  /** After an edit of the same block the panes stay as they are, and what is chosen now counts as opened: a point that was added is where it was measured. */
  private afterEdit(found: BlockView, view: BlockView): void {
    const { last } = this;
    this.last = { found, view };
    if (last?.found !== found || last.view === view || this.openedAt === null) return;
    const [point] = pointsOf(this.seen.store.state.selection.chosen);
    if (point !== undefined) this.openedAt = { ...this.openedAt, source: this.sourceOf(view, point) };
  }

  /** A block that is not oriented does not say what its points are; it is not edited either. */
  private sourceOf({ points }: BlockView, point: number): number {
    return points.sources[point] ?? codeOfSource({ tie_point: point });
  }

  /** Shows a given point where it is measured, and else where its coordinates say; where these say nothing, in few images. */
  private showGiven(chosen: Extract<Choice, { kind: 'given' }>, shown: Shown): void {
    const { store } = this.seen;
    if (chosen !== this.shownFor) {
      const images = this.imagesOfGiven(chosen.name, shown);
      if (images === null) return;
      this.shownFor = chosen;
      this.openedAt = null;
      store.dispatch({ type: 'showImages', images });
      this.pending = new Set(images);
    }
    if (this.pending.size === 0) return;
    const known = this.knownPlaces();
    const panes = this.seen.panes().filter(({ image }) => this.pending.has(image));
    const full = Math.max(LEAST_SCALE, ...panes.map((pane) => fillScale(pane.rect, pane)));
    const views = panes.flatMap((pane): [number, PaneView][] => {
      const at = known.get(pane.image) ?? this.measuring.ofGround(pane);
      return at === null ? [] : [[pane.image, viewAt(at, full)]];
    });
    // Where the points of an image are there and say nothing, it stays as it is.
    const moved = new Set(views.map(([image]) => image));
    const done = new Set(panes.filter(({ image, points }) => moved.has(image) || points !== null).map(({ image }) => image));
    if (done.size > 0) this.pending = new Set([...this.pending].filter((image) => !done.has(image)));
    if (views.length > 0) store.dispatch({ type: 'moveViews', views: new Map(views) });
  }

  /** The images that may show a given point, those with a measurement first; null while it is not known which. */
  private imagesOfGiven(name: string, { view, given }: Shown): readonly number[] | null {
    const { panes } = this.seen.store.state;
    const measured = [...this.knownPlaces().keys()];
    const place = given.find((own) => own.name === name)?.place ?? null;
    const within = place === null ? null : this.seen.facts.ground();
    if (place !== null && within === null) return null;
    const likely = place === null || within === null ? [] : footprintsAt(within.footprints, [place[0], place[1]]);
    if (likely.length > 0) return [...new Set([...measured, ...likely])].slice(0, MOST_PANES);
    const [near] = measured;
    const others = near === undefined ? [...shownImages(panes, view), ...likeliest(view, near)] : likeliest(view, near);
    return [...new Set([...measured, ...others])].slice(0, Math.min(MOST_PANES, Math.max(FEW_PANES, measured.length)));
  }

  /** Where the given point is measured, or placed. */
  private knownPlaces(): ReadonlyMap<number, Position> {
    return new Map([...this.measuring.marks(), ...this.measuring.ownPlaces()]);
  }

  /** Shows the images that were chosen. */
  private showChosenImages(chosen: Choice | null, view: BlockView): void {
    this.shownFor = chosen;
    const images = chosen?.kind === 'image' || chosen?.kind === 'images' || chosen?.kind === 'pair' ? imagesOf(chosen).slice(0, MOST_PANES) : [];
    const shown = shownImages(this.seen.store.state.panes, view);
    // An image that is shown beside others stays among them.
    const is = images.every((image) => shown.includes(image)) && (chosen?.kind === 'image' || shown.length === images.length);
    if (images.length > 0 && !is) this.seen.store.dispatch({ type: 'showImages', images });
  }

  /** Shows a point in the middle of a pane of each image that shows it, all at one scale, at which the panes are filled. */
  private open(detail: PointDetail, view: BlockView): void {
    const { store } = this.seen;
    const { panes } = store.state;
    const places = new Map(detail.observations.map(({ image, x_px, y_px }): [number, Position] => [image, [x_px, y_px]]));
    // A surveyed point is there to be measured.
    const isSurveyed = detail.id !== null && 'ground_control' in detail.id;
    if (panes.look.unmeasured || isSurveyed) for (const { image, x_px, y_px } of detail.elsewhere) places.set(image, [x_px, y_px]);
    for (const [image, at] of this.measuring.ownPlaces()) places.set(image, at);
    if (places.size === 0) return;
    const before = shownImages(panes, view);
    const scale = this.seen.active()?.transform.scale ?? 0;
    // Those that are shown stay in their order.
    const images = [...before.filter((image) => places.has(image)), ...[...places.keys()].filter((image) => !before.includes(image))].slice(0, MOST_PANES);
    store.dispatch({ type: 'showImages', images });
    const full = Math.max(LEAST_SCALE, scale, ...this.seen.panes().map((pane) => fillScale(pane.rect, pane)));
    store.dispatch({ type: 'moveViews', views: new Map(images.map((image) => [image, viewAt(places.get(image), full)])) });
  }
}

function viewAt(at: Position | undefined, scale: number): PaneView {
  const [x, y] = at ?? [0, 0];
  return { x, y, scale };
}
