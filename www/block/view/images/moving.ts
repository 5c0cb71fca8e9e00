/** Panes are panned and zoomed; linked ones follow to the same ground. */
import type { PaneView, Position } from '../../../shared/state/pane';
import { clamped, fitView, zoomed } from '../../../shared/view/panes';
import { contains, toCanvas } from '../../../shared/view/transform';
import { inOtherImage, placeOfPoint } from '../../state/observed';
import { pointsOf } from '../../state/selection';
import type { Zoomable } from '../looking';
import { paneView } from './scene';
import type { Pane } from './scene';
import type { Seen } from './seen';

export class Moving implements Zoomable {
  constructor(private readonly seen: Seen) {}

  pan(image: number, dx: number, dy: number): void {
    this.change(image, (pane, own) => ({ ...own, x: own.x - dx / pane.transform.scale, y: own.y - dy / pane.transform.scale }));
  }

  zoom(image: number, factor: number, x: number, y: number): void {
    this.change(image, (pane, own, least) => zoomed(pane.rect, own, factor, x, y, least));
  }

  fit(): void {
    this.seen.store.dispatch({ type: 'wholeImages' });
  }

  /** Zooms about the chosen point where the active pane shows it, else about the pane's middle. */
  zoomMiddle(factor: number): void {
    const pane = this.seen.active();
    if (pane === null) return;
    const { rect } = pane;
    const middle: Position = [rect.left + rect.width / 2, rect.top + rect.height / 2];
    const [point] = pointsOf(this.seen.store.state.selection.chosen);
    const place = point === undefined || pane.points === null ? null : placeOfPoint(pane.points, point);
    const at = place === null ? middle : toCanvas(pane.transform, ...place);
    this.zoom(pane.image, factor, ...(contains(rect, ...at) ? at : middle));
  }

  /** One image px to one CSS px. */
  actualSize(): void {
    const pane = this.seen.active();
    if (pane !== null) this.zoomMiddle(1 / pane.transform.scale);
  }

  /** Changes the view of an image; where all are linked the others follow to the same ground, where that is known. */
  private change(image: number, next: (pane: Pane, own: PaneView, least: number) => PaneView): void {
    const { state } = this.seen.store;
    const panes = this.seen.panes();
    const moved = (pane: Pane): PaneView => {
      const { scale } = fitView(pane.rect, pane.width, pane.height);
      return clamped(next(pane, paneView(state.panes, pane.image, pane.rect, pane), scale / 4), pane);
    };
    const leader = panes.find((pane) => pane.image === image);
    if (leader === undefined) return;
    const own = moved(leader);
    const views = new Map([[image, own]]);
    if (state.panes.look.linked) for (const pane of panes) if (pane !== leader) views.set(pane.image, followed(leader, own, pane, moved(pane)));
    this.seen.store.dispatch({ type: 'moveViews', views });
  }
}

function followed(leader: Pane, { x, y }: PaneView, pane: Pane, own: PaneView): PaneView {
  const ground = leader.points === null || pane.points === null ? null : inOtherImage(leader.points, pane.points, [x, y]);
  return ground === null ? own : clamped({ x: ground[0], y: ground[1], scale: own.scale }, pane);
}
