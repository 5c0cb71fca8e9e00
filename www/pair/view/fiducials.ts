/** Fiducial marks while they are measured: where they are, and where the next one is expected. */
import { drawCross, drawExpected } from '../../shared/view/pointer';
import { markInHand, placeOfMark } from '../state/marks';
import { SIDES } from '../state/state';
import type { State } from '../state/state';
import { middleOf } from './scene';
import type { Scene } from './scene';

export function drawFiducials(context: CanvasRenderingContext2D, state: State, scene: Scene): void {
  const { tool, mark, photos } = state;
  if (tool !== 'fiducials') return;
  for (const side of SIDES) {
    for (const [index, one] of photos[side].fiducials.entries()) {
      const at = placeOfMark(photos[side], one);
      if (at !== null) drawCross(context, scene.panes[side], at, mark?.side === side && mark.index === index);
    }
  }
  if (mark === null) return;
  if (placeOfMark(photos[mark.side], markInHand(state)) !== null) return;
  const pane = scene.panes[mark.side];
  drawCross(context, pane, middleOf(pane), false);
  if (mark.expected !== null) drawExpected(context, pane, [mark.expected[0], mark.expected[1]]);
}
