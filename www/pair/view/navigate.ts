/** Moves through the images and from point to point. */
import type { PaneView } from '../../shared/state/pane';
import { isCodeShown } from '../state/display';
import { sameGround } from '../state/follow';
import { otherSide, SIDES } from '../state/state';
import type { Selection, Side } from '../state/state';
import type { Store } from '../state/store';
import { clamped, fitView, inPane, zoomed } from '../../shared/view/panes';
import { contains, toCanvas } from '../../shared/view/transform';
import type { Rect } from '../../shared/view/transform';
import { placeOfDraft } from '../state/draft';
import type { Position } from '../../shared/state/pane';
import { middleOf } from './scene';
import type { Pane, Scene } from './scene';
import type { View } from './view';

export class Navigator {
  constructor(
    private readonly store: Store,
    private readonly view: View,
  ) {}

  /** Moves the content by CSS px; both panes where they are linked. */
  pan(side: Side, dx: number, dy: number): void {
    this.change(side, (pane, own) => ({ ...own, x: own.x - dx / pane.transform.scale, y: own.y - dy / pane.transform.scale }));
  }

  /** Zooms about a canvas position; in a linked pane about the same place of the pane. */
  zoom(side: Side, factor: number, x: number, y: number): void {
    const origin = this.view.scene().panes[side].rect;
    this.change(side, (pane, own, least) => zoomed(pane.rect, own, factor, x - origin.left + pane.rect.left, y - origin.top + pane.rect.top, least));
  }

  /** Zooms about the selected point where the active pane shows it, else about the pane's middle. */
  zoomMiddle(factor: number): void {
    const pane = this.activePane();
    const { rect } = pane;
    const middle: [number, number] = [rect.left + rect.width / 2, rect.top + rect.height / 2];
    this.zoom(pane.side, factor, ...(this.selectedPlace(pane) ?? middle));
  }

  /** Shows whole images. */
  fit(): void {
    this.store.dispatch({ type: 'views', views: { left: null, right: null } });
  }

  /** One image px to one CSS px. */
  actualSize(): void {
    this.zoomMiddle(1 / this.activePane().transform.scale);
  }

  /** Selects the next or previous shown point of the active side, in raster order. */
  step(by: 1 | -1): void {
    const { state } = this.store;
    const { panes, shown } = this.view.scene();
    const pane = panes[state.activeSide];
    const count = pane.codes.length;
    const start = state.selection?.side === pane.side ? state.selection.index : by > 0 ? -1 : count;
    for (let i = start + by; i >= 0 && i < count; i += by) {
      if (isCodeShown(shown, pane.codes[i] ?? 0)) {
        this.select({ side: pane.side, index: i });
        return;
      }
    }
  }

  /** Selects a point and brings it, and its match, into view. */
  select(selection: Selection | null): void {
    this.store.dispatch({ type: 'select', selection });
    if (selection === null) return;
    const scene = this.view.scene();
    this.bringIntoView(scene, selection);
    const partner = partnerOf(scene, selection);
    if (partner !== null) this.bringIntoView(scene, partner);
  }

  /** Shows the points of the match that is measured, the second one as large as the first. */
  followDraft(): void {
    const { state } = this.store;
    const scene = this.view.scene();
    const scale = Math.max(...SIDES.map((side) => scene.panes[side].transform.scale));
    const views = SIDES.flatMap((side) => {
      const { rect, transform } = scene.panes[side];
      const at = placeOfDraft(state, side);
      if (at === null || (contains(inner(rect), ...toCanvas(transform, ...at)) && transform.scale === scale)) return [];
      return [[side, { x: at[0], y: at[1], scale }] as const];
    });
    if (views.length > 0) this.store.dispatch({ type: 'views', views: Object.fromEntries(views) });
  }

  /** Brings a position of an image into view. */
  show(side: Side, at: Position): void {
    const { rect, transform } = this.view.scene().panes[side];
    if (contains(inner(rect), ...toCanvas(transform, ...at))) return;
    this.store.dispatch({ type: 'views', views: { [side]: { x: at[0], y: at[1], scale: transform.scale } } });
  }

  /** The position in the middle of a pane, the active one if none is named; null where it shows no image. */
  middle(of?: Side): [Side, Position] | null {
    const { side, ...pane } = of === undefined ? this.activePane() : this.view.scene().panes[of];
    return pane.picture === null ? null : [side, middleOf(pane)];
  }

  private activePane(): Pane {
    return this.view.scene().panes[this.store.state.activeSide];
  }

  private selectedPlace(pane: Pane): [number, number] | null {
    const { selection } = this.store.state;
    if (selection?.side !== pane.side) return null;
    const x = pane.points?.[3 * selection.index];
    const y = pane.points?.[3 * selection.index + 1];
    if (x === undefined || y === undefined) return null;
    const place = toCanvas(pane.transform, x, y);
    return contains(pane.rect, ...place) ? place : null;
  }

  private bringIntoView(scene: Scene, { side, index }: Selection): void {
    const pane = scene.panes[side];
    const x = pane.points?.[3 * index];
    const y = pane.points?.[3 * index + 1];
    if (x === undefined || y === undefined || contains(pane.rect, ...toCanvas(pane.transform, x, y))) return;
    this.store.dispatch({ type: 'views', views: { [side]: { x, y, scale: pane.transform.scale } } });
  }

  /** Changes the view of a side; a linked one follows to the same ground, where that is known. */
  private change(side: Side, next: (pane: Pane, own: PaneView, least: number) => PaneView): void {
    const scene = this.view.scene();
    const { state } = this.store;
    const move = (pane: Pane): [Side, PaneView][] => {
      if (pane.picture === null) return [];
      const whole = fitView(pane.rect, pane.picture.width, pane.picture.height);
      const own = state.views[pane.side];
      return [[pane.side, clamped(next(pane, own === null ? whole : inPane(own, pane.rect), whole.scale / 4), pane.picture)]];
    };
    const own = move(scene.panes[side]);
    const other = state.display.linked ? move(scene.panes[otherSide(side)]) : [];
    this.store.dispatch({ type: 'views', views: Object.fromEntries([...own, ...other.map((entry) => this.followed(side, own[0]?.[1], entry))]) });
  }

  /** The view of the linked pane, centred where the ground at the other one's centre is expected. */
  private followed(side: Side, leader: PaneView | undefined, [other, view]: [Side, PaneView]): [Side, PaneView] {
    const ground = leader === undefined ? null : sameGround(this.store.state, side, [leader.x, leader.y]);
    return ground === null ? [other, view] : [other, { x: ground[0], y: ground[1], scale: view.scale }];
  }
}

/** A place at the very edge of a pane is hardly seen. */
function inner({ left, top, width, height }: Rect): Rect {
  return { left: left + width / 8, top: top + height / 8, width: 0.75 * width, height: 0.75 * height };
}

/** The best right point of a left one, or the left point that a right one is matched to. */
function partnerOf(scene: Scene, { side, index }: Selection): Selection | null {
  const best = scene.match?.best;
  if (best === undefined) return null;
  const found = side === 'left' ? (best[index] ?? -1) : best.findIndex((right, left) => right === index && scene.match?.rules[left] === 0);
  return found < 0 ? null : { side: otherSide(side), index: found };
}
