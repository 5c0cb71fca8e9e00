/** Where the panes lie, and how image positions become canvas positions. Lengths are CSS px; image positions are px with the centre of the top-left pixel at (0.5, 0.5). */
import { toPosition, zoomedAbout } from '../../shared/view/transform';
import type { Rect, Transform } from '../../shared/view/transform';
import type { PaneView, Side } from '../state/state';

/** Space between the panes, crossed by the match lines. */
const GAP = 10;

/** Side by side where the canvas is wide, one above the other where it is high. */
export function panesOf(width: number, height: number): Record<Side, Rect> {
  if (width >= 0.85 * height) {
    const pane = Math.max(1, Math.floor((width - GAP) / 2));
    return { left: { left: 0, top: 0, width: pane, height }, right: { left: width - pane, top: 0, width: pane, height } };
  }
  const pane = Math.max(1, Math.floor((height - GAP) / 2));
  return { left: { left: 0, top: 0, width, height: pane }, right: { left: 0, top: height - pane, width, height: pane } };
}

export function transformOf(pane: Rect, view: PaneView): Transform {
  return {
    scale: view.scale,
    x: pane.left + pane.width / 2 - view.scale * view.x,
    y: pane.top + pane.height / 2 - view.scale * view.y,
  };
}

/** What the crate's drawing takes: `[scale, shift x, shift y, left, top, right, bottom]`. */
export function drawView(t: Transform, clip: Rect): Float64Array {
  return Float64Array.of(t.scale, t.x, t.y, clip.left, clip.top, clip.left + clip.width, clip.top + clip.height);
}

/** What the bar with the image's name takes of the top of its pane, as in the style sheet. */
const HEAD = 40;

/** The view that shows the whole image, in the middle of its pane where the bar over it leaves that free, else below the bar. */
export function fitView(pane: Rect, width: number, height: number): PaneView {
  // In a pane hardly higher than the bar there is no place beside it.
  const head = Math.min(HEAD, pane.height / 4);
  const scale = Math.min(pane.width / width, (pane.height - head) / height);
  const top = Math.max(head, (pane.height - scale * height) / 2);
  return { x: width / 2, y: (pane.height / 2 - top) / scale, scale };
}

const MAX_SCALE = 64;

/** The view after zooming by `factor` about a canvas position, within sensible limits. */
export function zoomed(pane: Rect, view: PaneView, factor: number, x: number, y: number, least: number): PaneView {
  const t = zoomedAbout(transformOf(pane, view), factor, x, y, { least, most: MAX_SCALE });
  const [centreX, centreY] = toPosition(t, pane.left + pane.width / 2, pane.top + pane.height / 2);
  return { scale: t.scale, x: centreX, y: centreY };
}

/** Keeps the centre of the pane on the image. */
export function clamped(view: PaneView, { width, height }: { width: number; height: number }): PaneView {
  return { scale: view.scale, x: Math.min(width, Math.max(0, view.x)), y: Math.min(height, Math.max(0, view.y)) };
}
