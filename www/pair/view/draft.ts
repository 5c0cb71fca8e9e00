/** The match that is measured: its points, and where they may lie. */
import { expectedPlace, lineOfDraft, placeOfDraft } from '../state/draft';
import { SIDES } from '../state/state';
import type { State } from '../state/state';
import { drawCross, drawExpected, drawLine } from '../../shared/view/pointer';
import type { Scene } from './scene';

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
