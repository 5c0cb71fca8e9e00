/** The match that is measured: its points, where they may lie, and both of them enlarged. */
import { within } from '../../shared/view/layers';
import { toCanvas } from '../../shared/view/transform';
import type { Rect } from '../../shared/view/transform';
import { expectedPlace, lineOfDraft, placeOfDraft } from '../state/draft';
import type { Position } from '../state/selected';
import { SIDES } from '../state/state';
import type { State } from '../state/state';
import { drawLine, paintLens } from './overlay';
import { CANDIDATE, SELECTED } from './palette';
import type { Pane, Scene } from './scene';
import type { TileCache } from './tilecache';

const ARM = 12;
const LENS_SIDE = 168;
/** A px of the image in the lens, CSS px. */
const LENS_SCALE = 12;
const EDGE = 8;

/** Draws the points of the draft as crosses that leave their middle free, and what is known of where the second one may lie. */
export function drawDraft(context: CanvasRenderingContext2D, state: State, scene: Scene): void {
  const { draft } = state;
  if (draft === null) return;
  const line = lineOfDraft(state);
  if (line !== null) drawLine(context, scene.panes[line.side], line.positions);
  const expected = expectedPlace(state);
  if (expected !== null && draft.places[draft.side] !== null) drawExpected(context, scene.panes[draft.side], expected);
  for (const side of SIDES) {
    const at = placeOfDraft(state, side);
    if (at !== null) drawCross(context, scene.panes[side], at, side === draft.side);
  }
}

function drawExpected(context: CanvasRenderingContext2D, pane: Pane, at: Position): void {
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

function drawCross(context: CanvasRenderingContext2D, pane: Pane, at: Position, active: boolean): void {
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

/** Enlarges what lies around both points, in the lower outer corner of each pane: one place is compared with the other. */
export function drawDraftLenses(context: CanvasRenderingContext2D, state: State, scene: Scene, ratio: number, tiles: TileCache): void {
  for (const side of SIDES) {
    const pane = scene.panes[side];
    const at = placeOfDraft(state, side);
    if (at === null) continue;
    paintLens(context, state, scene, pane, at, cornerOf(pane), Math.max(LENS_SCALE, pane.transform.scale), ratio, tiles);
  }
}

function cornerOf({ rect, side }: Pane): Rect {
  const length = Math.max(40, Math.min(LENS_SIDE, rect.width * 0.45, rect.height * 0.45));
  const left = side === 'left' ? rect.left + EDGE : rect.left + rect.width - EDGE - length;
  return { left, top: rect.top + rect.height - EDGE - length, width: length, height: length };
}
