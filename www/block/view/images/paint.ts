/** What is drawn on the panes: pictures, observations and residuals, loupes, the chosen point, lines, and the point that is measured. */
import type { Position } from '../../../shared/state/pane';
import { paintBitmap, smooth, visiblePart } from '../../../shared/view/bitmap';
import { within } from '../../../shared/view/layers';
import { CANDIDATE, SELECTED } from '../../../shared/view/palette';
import { crosshair, drawCross, drawExpected, drawLine, lensFrame, ring } from '../../../shared/view/pointer';
import { toCanvas } from '../../../shared/view/transform';
import type { Rect, Transform } from '../../../shared/view/transform';
import { placeOfPoint } from '../../state/observed';
import { pointsOf } from '../../state/selection';
import type { Bitmaps, Slot } from './bitmaps';
import type { Lens } from './lenses';
import type { Measuring } from './measuring';
import { drawObservations, drawResiduals, drawScaleBar } from './observations';
import type { At, Pane } from './scene';
import type { Seen } from './seen';

/** Of many chosen points so many are marked. */
const MOST_RINGS = 3000;

/** The pictures of the images. `ratio`: device px per CSS px. */
export function paintPictures(context: CanvasRenderingContext2D, bitmaps: Bitmaps, panes: readonly Pane[], ratio: number): void {
  for (const pane of panes) paintPart(context, bitmaps, pane, pane.transform, pane.rect, 'pane', ratio);
  bitmaps.keep(new Set(panes.flatMap(({ file }) => file?.id ?? [])));
}

export function paintLenses(context: CanvasRenderingContext2D, bitmaps: Bitmaps, lenses: readonly Lens[], ratio: number): void {
  for (const { pane, rect, transform } of lenses) paintPart(context, bitmaps, pane, transform, rect, 'loupe', ratio);
}

function paintPart(context: CanvasRenderingContext2D, bitmaps: Bitmaps, pane: Pane, t: Transform, clip: Rect, slot: Slot, ratio: number): void {
  within(context, clip, () => {
    context.fillStyle = '#0c0e10';
    context.fillRect(clip.left, clip.top, clip.width, clip.height);
    if (pane.file === null) return;
    smooth(context, t.scale, ratio);
    const part = visiblePart(pane, t, clip);
    for (const { bitmap, x, y, step } of bitmaps.pieces(pane.file, pane, slot, part, t.scale * ratio)) paintBitmap(context, bitmap, x, y, step, part, t);
  });
}

/** Observations and their residuals, as far as they are to be seen. */
export function paintMarks(context: CanvasRenderingContext2D, seen: Seen, panes: readonly Pane[]): void {
  const { points: shown, vectors } = seen.store.state.panes.look;
  for (const pane of panes) {
    const { points, rect, transform } = pane;
    if (points !== null) {
      within(context, rect, () => {
        if (shown) drawObservations(context, points, seen.marked(pane.image), transform, rect);
        if (vectors > 0) drawResiduals(context, points, seen.marked(pane.image), vectors, pane);
      });
    }
    if (vectors > 0) drawScaleBar(context, vectors, pane);
  }
}

/** What stands over all: the chosen point, its lines, the point that is measured, and the edges of the loupes. */
export function paintOverlay(
  context: CanvasRenderingContext2D,
  seen: Seen,
  measuring: Measuring,
  panes: readonly Pane[],
  lenses: readonly Lens[],
  pointed: At | null,
): void {
  paintChosen(context, seen, panes);
  paintGiven(context, measuring, panes);
  paintLines(context, seen, measuring, panes, pointed);
  paintDraft(context, seen, measuring, panes);
  for (const { pane, rect, transform } of lenses) {
    within(context, rect, () => {
      if (pane.points !== null) drawObservations(context, pane.points, seen.marked(pane.image), transform, rect);
      crosshair(context, rect);
    });
    lensFrame(context, rect);
  }
}

/** Rings around the chosen points; of one that is chosen alone where the adjustment predicts it. */
function paintChosen(context: CanvasRenderingContext2D, seen: Seen, panes: readonly Pane[]): void {
  const { chosen, pointed } = seen.store.state.selection;
  const alone = seen.chosen();
  for (const pane of panes) {
    const { points } = pane;
    if (points === null) continue;
    within(context, pane.rect, () => {
      for (const point of pointsOf(chosen).subarray(0, MOST_RINGS)) {
        const place = placeOfPoint(points, point);
        if (place !== null) ring(context, pane, place, 9, SELECTED, 2.5);
      }
      for (const point of pointsOf(pointed).subarray(0, 1)) {
        const place = placeOfPoint(points, point);
        if (place !== null) ring(context, pane, place, 7, CANDIDATE, 1.5);
      }
      const predicted = alone?.detail.observations.find(({ image }) => image === pane.image)?.predicted_px;
      if (predicted != null) paintPredicted(context, pane, predicted);
      const elsewhere = alone?.detail.elsewhere.find(({ image }) => image === pane.image);
      if (elsewhere !== undefined) drawExpected(context, pane, [elsewhere.x_px, elsewhere.y_px]);
    });
  }
}

/** A control or check point that is chosen and not in the block: where it is measured, else where its coordinates say. */
function paintGiven(context: CanvasRenderingContext2D, measuring: Measuring, panes: readonly Pane[]): void {
  const marks = measuring.marks();
  for (const pane of panes) {
    within(context, pane.rect, () => {
      const place = marks.get(pane.image);
      const expected = place === undefined && measuring.draft === null ? measuring.ofGround(pane) : null;
      if (place !== undefined) ring(context, pane, place, 9, SELECTED, 2.5);
      if (expected !== null) drawExpected(context, pane, expected);
    });
  }
}

/** The place whose epipolar lines are drawn: that of the chosen point in the image pointed at, else the pointer's own while the loupe is there. */
function sourceOfLines(seen: Seen, panes: readonly Pane[], pointed: At | null): At | null {
  const pane = pointed === null ? seen.active() : (panes.find(({ image }) => image === pointed.image) ?? null);
  const [point] = pointsOf(seen.store.state.selection.chosen);
  const place = point === undefined || pane?.points == null ? null : placeOfPoint(pane.points, point);
  if (pane !== null && place !== null) return { image: pane.image, at: place };
  return seen.store.state.panes.look.loupe ? pointed : null;
}

function paintLines(context: CanvasRenderingContext2D, seen: Seen, measuring: Measuring, panes: readonly Pane[], pointed: At | null): void {
  const source = sourceOfLines(seen, panes, pointed);
  for (const pane of panes) {
    const measured = measuring.sources(pane.image);
    for (const { image, at } of measured.length > 0 || source === null || source.image === pane.image ? measured : [source]) {
      const line = seen.facts.line(image, at, pane.image);
      if (line !== null && line.length > 0) drawLine(context, pane, line);
    }
  }
}

/** The point that is measured: where it is placed, or expected. */
function paintDraft(context: CanvasRenderingContext2D, seen: Seen, measuring: Measuring, panes: readonly Pane[]): void {
  if (measuring.draft === null) return;
  const active = seen.active()?.image;
  for (const pane of panes) {
    const expected = measuring.expected(pane);
    if (expected !== null) drawExpected(context, pane, expected);
    const at = measuring.placeIn(pane);
    if (at !== null) drawCross(context, pane, at, pane.image === active);
  }
}

/** Where the adjustment expects an observation: a small ×. */
function paintPredicted(context: CanvasRenderingContext2D, pane: Pane, at: Position): void {
  const [x, y] = toCanvas(pane.transform, ...at);
  const path = new Path2D();
  path.moveTo(x - 4, y - 4);
  path.lineTo(x + 4, y + 4);
  path.moveTo(x - 4, y + 4);
  path.lineTo(x + 4, y - 4);
  context.lineWidth = 3;
  context.strokeStyle = 'rgb(0 0 0 / 0.6)';
  context.stroke(path);
  context.lineWidth = 1.5;
  context.strokeStyle = CANDIDATE;
  context.stroke(path);
}
