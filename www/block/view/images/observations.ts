/** The observations of an image with their residuals, drawn by the crate. */
import { draw_points, draw_vectors } from '../../../shared/crate';
import { PointGrid } from '../../../shared/view/grid';
import { within } from '../../../shared/view/layers';
import { ACCEPTED, MEASURED, REJECTED, REJECTED_BY_HAND, RESIDUAL, RESIDUAL_REJECTED } from '../../../shared/view/palette';
import { drawView, halfSize } from '../../../shared/view/panes';
import type { Rect, Transform } from '../../../shared/view/transform';
import type { ImagePoints } from '../../state/facts';
import type { Pane } from './scene';
import { asSentence } from '../../../shared/text/direction';
import { say } from '../../../shared/text/words';

/** Styles by code: what the adjustment accepted and rejected, what was rejected by hand and what was measured by hand. */
export const STYLES = [ACCEPTED, REJECTED, REJECTED_BY_HAND, MEASURED];
const BY_HAND = 3;

interface Drawn {
  /** Stride 3, as the crate draws points. */
  points: Float64Array;
  /** Stride 4: from a place, along its residual. */
  vectors: Float64Array;
}

const drawnOf = new WeakMap<ImagePoints, Drawn>();

function drawn(of: ImagePoints): Drawn {
  const known = drawnOf.get(of);
  if (known !== undefined) return known;
  const made: Drawn = { points: new Float64Array(3 * of.points.length), vectors: new Float64Array(4 * of.points.length) };
  for (let i = 0; i < of.points.length; i++) {
    made.points.set(of.places.subarray(2 * i, 2 * i + 2), 3 * i);
    made.vectors.set(of.places.subarray(2 * i, 2 * i + 2), 4 * i);
    made.vectors.set(of.residuals.subarray(2 * i, 2 * i + 2), 4 * i + 2);
  }
  drawnOf.set(of, made);
  return made;
}

const grids = new WeakMap<ImagePoints, PointGrid>();

/** The observation nearest to a place, by its row; -1 where none is near. */
export function nearestRow(of: ImagePoints, { width, height }: Pane, x: number, y: number, radius: number, keeps: Marked['keeps']): number {
  const grid = grids.get(of) ?? new PointGrid(drawn(of).points, width, height);
  grids.set(of, grid);
  return grid.nearest(x, y, radius, (row) => keeps(of.points[row] ?? -1));
}

/** What of the points of an image is shown, and how. */
export interface Marked {
  /** Points that were measured by hand in the image. */
  byHand: ReadonlySet<number>;
  /** Whether the filter keeps a point. */
  keeps: (point: number) => boolean;
}

const NOT_DRAWN = 255;

/** One code a point. */
function codesOf({ points, parts }: ImagePoints, { byHand, keeps }: Marked): Uint8Array {
  return parts.map((part, i) => {
    const point = points[i] ?? -1;
    if (!keeps(point)) return NOT_DRAWN;
    return part === 0 && byHand.has(point) ? BY_HAND : part;
  });
}

/** Draws the observations that `clip` shows. */
export function drawObservations(context: CanvasRenderingContext2D, of: ImagePoints, marked: Marked, t: Transform, clip: Rect): void {
  const half = halfSize(t.scale);
  const styles = Float64Array.from(STYLES.flatMap(({ shape }, code) => [shape, code === 1 || code === 2 ? 0.85 * half : half, 1.6]));
  draw_points(
    context,
    drawn(of).points,
    codesOf(of, marked),
    styles,
    STYLES.map(({ colour }) => colour),
    drawView(t, clip),
  );
}

/** Draws residuals, so many times longer than they are, and a bar for their length. */
export function drawResiduals(context: CanvasRenderingContext2D, of: ImagePoints, marked: Marked, factor: number, { transform, rect }: Pane): void {
  const colours = [RESIDUAL, RESIDUAL_REJECTED, RESIDUAL_REJECTED, RESIDUAL];
  draw_vectors(context, drawn(of).vectors, codesOf(of, marked), Float64Array.of(1.4, 1.4, 1.4, 1.4), colours, factor, drawView(transform, rect));
}

/** About how long the bar is, CSS px. */
const BAR = 70;

/** A bar as long as a residual of a round length is drawn. */
export function drawScaleBar(context: CanvasRenderingContext2D, factor: number, { transform, rect }: Pick<Pane, 'transform' | 'rect'>): void {
  const { px, length } = barOf(factor * transform.scale);
  const [x, y] = [rect.left + 10, rect.top + rect.height - 10];
  const text = asSentence(say('px-4', { px, factor }));
  within(context, rect, () => {
    context.font = '11px system-ui, sans-serif';
    const width = Math.max(length, context.measureText(text).width) + 12;
    context.fillStyle = 'rgb(20 23 26 / 0.72)';
    context.fillRect(x - 6, y - 22, width, 28);
    context.fillStyle = '#f2f4f5';
    context.fillText(text, x, y - 10);
    context.strokeStyle = RESIDUAL;
    context.lineWidth = 2;
    context.beginPath();
    for (const [from, to] of [
      [
        [x, y],
        [x + length, y],
      ],
      [
        [x, y - 4],
        [x, y + 4],
      ],
      [
        [x + length, y - 4],
        [x + length, y + 4],
      ],
    ] as const) {
      context.moveTo(...from);
      context.lineTo(...to);
    }
    context.stroke();
  });
}

/** The round length whose bar is as long as it may be, in px of the image and on the canvas. `scale`: CSS px of a px of a residual. */
export function barOf(scale: number): { px: number; length: number } {
  const wanted = BAR / scale;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const digit = [5, 2, 1].find((step) => step * power <= wanted) ?? 1;
  const px = Number((digit * power).toPrecision(1));
  return { px, length: px * scale };
}
