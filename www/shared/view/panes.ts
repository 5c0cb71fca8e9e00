/** Panes of a canvas, each with its own view of an image. Lengths are CSS px; image positions are px with the centre of the top-left pixel at (0.5, 0.5). */
import type { PaneView } from '../state/pane';
import { toPosition, zoomedAbout } from './transform';
import type { Rect, Size, Transform } from './transform';

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

/** CSS px of a px of the image: more shows nothing more. */
const MAX_SCALE = 64;

/** The pane that a view was first shown in. */
const SHOWN_IN = new WeakMap<PaneView, Size>();

/** A view that was made in a pane of another size, in this one: the same in its middle, and all that was seen. */
export function inPane(view: PaneView, { width, height }: Rect): PaneView {
  // As panes are before they are laid out, or while they are hidden.
  if (width <= 1 || height <= 1) return view;
  const first = SHOWN_IN.get(view);
  if (first === undefined) SHOWN_IN.set(view, { width, height });
  if (first === undefined) return view;
  const scale = view.scale * Math.min(width / first.width, height / first.height);
  return { ...view, scale: Math.min(scale, Math.max(MAX_SCALE, view.scale)) };
}

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

/** Half the size of a mark in CSS px: small in the overview, larger when pixels are enlarged. */
export function halfSize(scale: number): number {
  return Math.min(7, Math.max(1.5, 2.6 * scale));
}
