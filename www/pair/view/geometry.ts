/** Where the panes of both images lie. Lengths are CSS px. */
import type { Rect } from '../../shared/view/transform';
import type { Side } from '../state/state';

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
