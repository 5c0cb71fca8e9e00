/** The area that is being outlined on a picture, and where keys place its next corner. */
import { within } from '../../shared/view/layers';
import { SELECTED } from '../../shared/view/palette';
import { drawCross } from '../../shared/view/pointer';
import { toCanvas } from '../../shared/view/transform';
import type { State } from '../state/state';
import { middleOf } from './scene';
import type { Scene } from './scene';

const CORNER = 3;

export function drawOutline(context: CanvasRenderingContext2D, { outline, tool, activeSide }: State, scene: Scene): void {
  const active = scene.panes[activeSide];
  if (tool === 'mask' && active.picture !== null) drawCross(context, active, middleOf(active), false);
  if (outline === null) return;
  const { rect, transform } = scene.panes[outline.side];
  const corners = outline.corners.map(([x, y]) => toCanvas(transform, x, y));
  const path = new Path2D();
  for (const [i, [x, y]] of corners.entries()) {
    if (i === 0) path.moveTo(x, y);
    else path.lineTo(x, y);
  }
  path.closePath();
  within(context, rect, () => {
    context.fillStyle = 'rgb(255 212 0 / 0.2)';
    context.fill(path);
    context.lineWidth = 3;
    context.strokeStyle = 'rgb(0 0 0 / 0.6)';
    context.stroke(path);
    context.lineWidth = 1.5;
    context.strokeStyle = SELECTED;
    context.stroke(path);
    context.fillStyle = SELECTED;
    // A line that was drawn has a corner every few px.
    if (corners.length <= 64) for (const [x, y] of corners) context.fillRect(x - CORNER, y - CORNER, 2 * CORNER, 2 * CORNER);
  });
}
