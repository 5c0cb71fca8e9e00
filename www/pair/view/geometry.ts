/** Where the panes of both images lie. Lengths are CSS px. */
import type { Rect } from '../../shared/view/transform';
import type { Side, State } from '../state/state';

/** Space between the panes, crossed by the match lines. */
const GAP = 10;

/** One above the other only where images are so much larger then. */
const CLEARLY = 1.2;

/** Width by height of the images that are open; null where none is. */
function ratioOf({ openLeft, openRight }: State['results']): number | null {
  const ratios = [openLeft, openRight].flatMap((opened) => (opened === undefined ? [] : [opened.value.info.width / opened.value.info.height]));
  return ratios.length === 0 ? null : ratios.reduce((sum, ratio) => sum + ratio, 0) / ratios.length;
}

/** Whether images of a ratio of width to height are seen well side by side; without any, where the canvas is wide. */
export function isBeside(width: number, height: number, ratio: number | null): boolean {
  if (ratio === null) return width >= 0.85 * height;
  return Math.min(height / 2, width / ratio) <= CLEARLY * Math.min(height, width / 2 / ratio);
}

/** Side by side, or one above the other where the images are larger so. */
export function panesOf({ results }: Pick<State, 'results'>, width: number, height: number): Record<Side, Rect> {
  if (isBeside(width, height, ratioOf(results))) {
    const pane = Math.max(1, Math.floor((width - GAP) / 2));
    return { left: { left: 0, top: 0, width: pane, height }, right: { left: width - pane, top: 0, width: pane, height } };
  }
  const pane = Math.max(1, Math.floor((height - GAP) / 2));
  return { left: { left: 0, top: 0, width, height: pane }, right: { left: 0, top: height - pane, width, height: pane } };
}
