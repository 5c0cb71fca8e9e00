/** The match that is measured: its points, where they may lie, and both of them enlarged. */
import type { Rect } from '../../shared/view/transform';
import { expectedPlace, lineOfDraft, placeOfDraft } from '../state/draft';
import { SIDES } from '../state/state';
import type { Side, State } from '../state/state';
import type { Position } from '../../shared/state/pane';
import { paintLens } from './overlay';
import { drawCross, drawExpected, drawLine } from '../../shared/view/pointer';
import type { Pane, Scene } from './scene';
import type { TileCache } from './tilecache';

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

/** Enlarges what lies around both points: one place is compared with the other. */
export function drawDraftLenses(context: CanvasRenderingContext2D, state: State, scene: Scene, ratio: number, tiles: TileCache): void {
  for (const side of SIDES) {
    const at = placeOfDraft(state, side);
    if (at !== null) drawCornerLens(context, state, scene, side, at, ratio, tiles);
  }
}

/** Enlarges what lies around a place, in the lower outer corner of its pane. */
export function drawCornerLens(context: CanvasRenderingContext2D, state: State, scene: Scene, side: Side, at: Position, ratio: number, tiles: TileCache): void {
  const pane = scene.panes[side];
  paintLens(context, state, scene, pane, at, cornerOf(pane), Math.max(LENS_SCALE, pane.transform.scale), ratio, tiles);
}

function cornerOf({ rect, side }: Pane): Rect {
  const length = Math.max(40, Math.min(LENS_SIDE, rect.width * 0.45, rect.height * 0.45));
  const left = side === 'left' ? rect.left + EDGE : rect.left + rect.width - EDGE - length;
  return { left, top: rect.top + rect.height - EDGE - length, width: length, height: length };
}
