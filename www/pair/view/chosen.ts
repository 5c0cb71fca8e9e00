/** The matches that are chosen together, and the rectangle that chooses them. */
import { within } from '../../shared/view/layers';
import { toCanvas } from '../../shared/view/transform';
import type { Rect } from '../../shared/view/transform';
import { chosenLefts } from '../state/choice';
import { LEFT_OUT } from '../state/codes';
import { editedPair, placeOfLeft } from '../state/edited';
import { SIDES } from '../state/state';
import type { State } from '../state/state';
import { SELECTED } from '../../shared/view/palette';
import type { Scene } from './scene';

const RADIUS = 6;

/** Draws a ring around both points of each chosen match, with a dark edge, so that it shows on light and dark ground. */
export function drawChosen(context: CanvasRenderingContext2D, state: State, scene: Scene): void {
  const edited = editedPair(state);
  // What the filter leaves out is not shown.
  const lefts = chosenLefts(state).filter((left) => scene.panes.left.codes[left] !== LEFT_OUT);
  if (edited === null || lefts.length === 0) return;
  for (const side of SIDES) {
    const { rect, transform } = scene.panes[side];
    const path = new Path2D();
    for (const left of lefts) {
      const place = placeOfLeft(edited, left);
      const [x, y] = toCanvas(transform, ...(side === 'left' ? ([place[0], place[1]] as const) : ([place[2], place[3]] as const)));
      path.moveTo(x + RADIUS, y);
      path.arc(x, y, RADIUS, 0, 2 * Math.PI);
    }
    within(context, rect, () => {
      context.lineWidth = 3.5;
      context.strokeStyle = 'rgb(0 0 0 / 0.6)';
      context.stroke(path);
      context.lineWidth = 1.8;
      context.strokeStyle = SELECTED;
      context.stroke(path);
    });
  }
}

export function drawRectangle(context: CanvasRenderingContext2D, { left, top, width, height }: Rect): void {
  context.fillStyle = 'rgb(255 212 0 / 0.12)';
  context.fillRect(left, top, width, height);
  context.lineWidth = 3;
  context.strokeStyle = 'rgb(0 0 0 / 0.5)';
  context.strokeRect(left, top, width, height);
  context.setLineDash([6, 4]);
  context.lineWidth = 1.5;
  context.strokeStyle = SELECTED;
  context.strokeRect(left, top, width, height);
  context.setLineDash([]);
}
