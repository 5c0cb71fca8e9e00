/** Fiducial marks while they are measured: where they are, where the next one is expected, and the one in hand enlarged. */
import { drawCross, drawExpected } from '../../shared/view/pointer';
import { markInHand, placeOfMark } from '../state/marks';
import { SIDES } from '../state/state';
import type { State } from '../state/state';
import { drawCornerLens } from './draft';
import { middleOf } from './scene';
import type { Scene } from './scene';
import type { TileCache } from './tilecache';

export function drawFiducials(context: CanvasRenderingContext2D, state: State, scene: Scene, ratio: number, tiles: TileCache): void {
  const { tool, mark, photos } = state;
  if (tool !== 'fiducials') return;
  for (const side of SIDES) {
    for (const [index, one] of photos[side].fiducials.entries()) {
      const at = placeOfMark(photos[side], one);
      if (at !== null) drawCross(context, scene.panes[side], at, mark?.side === side && mark.index === index);
    }
  }
  if (mark === null) return;
  const at = placeOfMark(photos[mark.side], markInHand(state));
  if (at !== null) {
    drawCornerLens(context, state, scene, mark.side, at, ratio, tiles);
    return;
  }
  const pane = scene.panes[mark.side];
  drawCross(context, pane, middleOf(pane), false);
  if (mark.expected !== null) drawExpected(context, pane, [mark.expected[0], mark.expected[1]]);
}
