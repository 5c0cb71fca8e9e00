/** Where the panes of some images lie on their canvas. */
import type { Rect } from '../../../shared/view/transform';

/** Space between panes, CSS px. */
const GAP = 4;

/** Columns in which images of a ratio of width to height are largest; where a screen is narrow one below the other. */
export function columnsOf(count: number, width: number, height: number, ratio: number, narrow: boolean): number {
  if (narrow) return 1;
  const scale = (columns: number) => Math.min(width / columns, (ratio * height) / Math.ceil(count / columns));
  const all = Array.from({ length: count }, (_, i) => i + 1);
  return all.reduce((best, columns) => (scale(columns) > scale(best) * 1.001 ? columns : best), 1);
}

/** The panes, row by row; those of the last row share its width. */
export function gridOf(count: number, columns: number, width: number, height: number): Rect[] {
  const rows = Math.ceil(count / columns);
  return Array.from({ length: count }, (_, i) => {
    const row = Math.floor(i / columns);
    const across = row === rows - 1 ? count - row * columns : columns;
    const [left, right] = edges(width, across, i - row * columns);
    const [top, bottom] = edges(height, rows, row);
    return { left, top, width: Math.max(1, right - left), height: Math.max(1, bottom - top) };
  });
}

/** Where one of several equal parts of a length begins and ends. */
function edges(length: number, parts: number, part: number): [number, number] {
  const side = (length - GAP * (parts - 1)) / parts;
  const from = Math.round(part * (side + GAP));
  return [from, Math.round(part * (side + GAP) + side)];
}
