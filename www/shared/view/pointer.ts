/** What marks a place of an image: a ring, a cross, a line; and the loupe. Each has a dark edge, so that it shows on light and dark ground. */
import type { Position } from '../state/pane';
import { within } from './layers';
import { CANDIDATE, EPIPOLAR, SELECTED } from './palette';
import { toCanvas } from './transform';
import type { Rect, Transform } from './transform';

/** Where marks are drawn. */
interface Pane {
  rect: Rect;
  transform: Transform;
}

/** Half the length of a cross, CSS px. */
const ARM = 12;

/** Side of the magnifier in CSS px, and how much more it enlarges. */
const LENS_SIDE = 176;
export const LENS_FACTOR = 4;

/** A ring around a position. */
export function ring(context: CanvasRenderingContext2D, pane: Pane, at: Position, radius: number, colour: string, width: number): void {
  const [x, y] = toCanvas(pane.transform, at[0], at[1]);
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.lineWidth = width + 2;
  context.strokeStyle = 'rgb(0 0 0 / 0.65)';
  context.stroke();
  context.lineWidth = width;
  context.strokeStyle = colour;
  context.stroke();
}

/** An epipolar line, or a cross at the one place that a map gives. */
export function drawLine(context: CanvasRenderingContext2D, pane: Pane, positions: Float64Array): void {
  const places = Array.from({ length: positions.length / 2 }, (_, i) => toCanvas(pane.transform, positions[2 * i] ?? 0, positions[2 * i + 1] ?? 0));
  const path = new Path2D();
  for (const [i, [x, y]] of places.entries()) {
    if (places.length > 1) {
      if (i === 0) path.moveTo(x, y);
      else path.lineTo(x, y);
      continue;
    }
    path.moveTo(x - 14, y);
    path.lineTo(x + 14, y);
    path.moveTo(x, y - 14);
    path.lineTo(x, y + 14);
  }
  within(context, pane.rect, () => {
    context.lineWidth = 3;
    context.strokeStyle = 'rgb(0 0 0 / 0.5)';
    context.stroke(path);
    context.setLineDash([9, 5]);
    context.lineWidth = 1.5;
    context.strokeStyle = EPIPOLAR;
    context.stroke(path);
    context.setLineDash([]);
  });
}

/** A dashed ring where a point is expected. */
export function drawExpected(context: CanvasRenderingContext2D, pane: Pane, at: Position): void {
  const [x, y] = toCanvas(pane.transform, ...at);
  within(context, pane.rect, () => {
    context.beginPath();
    context.arc(x, y, 7, 0, 2 * Math.PI);
    context.setLineDash([4, 3]);
    context.lineWidth = 1.5;
    context.strokeStyle = CANDIDATE;
    context.stroke();
    context.setLineDash([]);
  });
}

/** A cross that leaves its middle free. */
export function drawCross(context: CanvasRenderingContext2D, pane: Pane, at: Position, active: boolean): void {
  const [x, y] = toCanvas(pane.transform, ...at);
  const path = new Path2D();
  for (const [ux, uy] of [
    [1, 0],
    [-1, 0],
    [0, 1],
    [0, -1],
  ] as const) {
    path.moveTo(x + 3 * ux, y + 3 * uy);
    path.lineTo(x + ARM * ux, y + ARM * uy);
  }
  within(context, pane.rect, () => {
    context.lineWidth = active ? 4.5 : 3.5;
    context.strokeStyle = 'rgb(0 0 0 / 0.65)';
    context.stroke(path);
    context.lineWidth = active ? 2.2 : 1.4;
    context.strokeStyle = SELECTED;
    context.stroke(path);
  });
}

/** Beside the pointer, on the canvas. */
export function lensRect([x, y]: [number, number], bounds: Rect): Rect {
  const side = Math.min(LENS_SIDE, bounds.width, bounds.height);
  const left = x + 24 + side > bounds.width ? x - 24 - side : x + 24;
  const top = y + 24 + side > bounds.height ? y - 24 - side : y + 24;
  return { left: Math.max(1, left), top: Math.max(1, top), width: side, height: side };
}

/** In the middle of the loupe. */
export function crosshair(context: CanvasRenderingContext2D, rect: Rect): void {
  const x = rect.left + rect.width / 2;
  const y = rect.top + rect.height / 2;
  context.beginPath();
  for (const [ux, uy] of [
    [1, 0],
    [-1, 0],
    [0, 1],
    [0, -1],
  ] as const) {
    context.moveTo(x + 6 * ux, y + 6 * uy);
    context.lineTo(x + 18 * ux, y + 18 * uy);
  }
  context.lineWidth = 1;
  context.strokeStyle = SELECTED;
  context.stroke();
}

/** The edge of the loupe. */
export function lensFrame(context: CanvasRenderingContext2D, rect: Rect): void {
  context.lineWidth = 2;
  context.strokeStyle = SELECTED;
  context.strokeRect(rect.left, rect.top, rect.width, rect.height);
}

/** How the loupe shows the place in its middle. */
export function lensTransform({ left, top, width, height }: Rect, [x, y]: Position, scale: number): Transform {
  return { scale, x: left + width / 2 - scale * x, y: top + height / 2 - scale * y };
}
