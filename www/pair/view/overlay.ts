/** What follows the selection: the selected point, its search window and candidates. */
import { comparesGradients, comparesGreyValues, isCurrent } from '../state/keys';
import { expectedPosition } from '../state/offset';
import { leftIndexOf, placeOf } from '../state/selected';
import type { State } from '../state/state';
import { drawSupport } from './frames';
import { within } from '../../shared/view/layers';
import { toCanvas } from '../../shared/view/transform';
import { CANDIDATE, SELECTED } from '../../shared/view/palette';
import { drawLine, ring } from '../../shared/view/pointer';
import type { Pane, Scene } from './scene';

const MOST_CANDIDATES_DRAWN = 200;
/** Candidates by gradients lie all over the image: the nearest of them. */
const MOST_GRADIENT_CANDIDATES_DRAWN = 10;

function pointOf(pane: Pane, index: number): [number, number] | null {
  const x = pane.points?.[3 * index];
  const y = pane.points?.[3 * index + 1];
  return x === undefined || y === undefined ? null : [x, y];
}

function square(context: CanvasRenderingContext2D, pane: Pane, [x, y]: [number, number], side: number, colour: string, dash: number[]): void {
  const [left, top] = toCanvas(pane.transform, x - side / 2, y - side / 2);
  context.setLineDash(dash);
  context.lineWidth = 1.5;
  context.strokeStyle = colour;
  context.strokeRect(left, top, side * pane.transform.scale, side * pane.transform.scale);
  context.setLineDash([]);
}

/** Draws the selection in both panes: the point, its window, its search window with all candidates, its best place. */
export function drawSelection(context: CanvasRenderingContext2D, state: State, scene: Scene): void {
  const { selection, settings } = state;
  if (selection === null || settings === null) return;
  const own = scene.panes[selection.side];
  const at = pointOf(own, selection.index);
  if (at === null) return;
  within(context, own.rect, () => {
    if (comparesGradients(settings)) drawSupport(context, settings, own, selection.index);
    else square(context, own, at, comparesGreyValues(settings) ? settings.matching.template : settings.window.side, SELECTED, []);
    ring(context, own, at, 9, SELECTED, 2.5);
  });
  if (scene.match === null) return;
  const line = isCurrent(state, 'inspection') ? state.results.inspection?.value.line : undefined;
  if (line != null) drawLine(context, scene.panes[line.side], line.positions);
  const leftIndex = leftIndexOf(state, scene.match.best, scene.match.rules);
  const leftAt = pointOf(scene.panes.left, leftIndex);
  if (leftAt === null) return;
  if (selection.side === 'right') within(context, scene.panes.left.rect, () => ring(context, scene.panes.left, leftAt, 9, SELECTED, 2));
  drawCandidates(context, state, scene, leftIndex, leftAt, placeOf(scene.match.places, leftIndex));
}

function drawCandidates(
  context: CanvasRenderingContext2D,
  state: State,
  scene: Scene,
  leftIndex: number,
  leftAt: [number, number],
  best: [number, number] | null,
): void {
  const pane = scene.panes.right;
  within(context, pane.rect, () => {
    const { settings } = state;
    const gradients = settings !== null && comparesGradients(settings);
    const field = isCurrent(state, 'offset') ? state.results.offset?.value : undefined;
    if (field !== undefined) square(context, pane, expectedPosition(field, leftAt), state.settings?.matching.search ?? 0, CANDIDATE, [5, 4]);
    if (isCurrent(state, 'inspection')) {
      const list = state.results.inspection?.value.candidates ?? new Float64Array();
      const most = gradients ? MOST_GRADIENT_CANDIDATES_DRAWN : MOST_CANDIDATES_DRAWN;
      for (let i = 0; i < Math.min(list.length / 2, most); i++) {
        const at = pointOf(pane, list[2 * i] ?? -1);
        if (at !== null) ring(context, pane, at, 4, CANDIDATE, 1.2);
      }
    }
    if (gradients) drawSupport(context, settings, pane, scene.match?.best[leftIndex] ?? -1);
    if (best !== null) ring(context, pane, best, 9, SELECTED, state.selection?.side === 'right' ? 2.5 : 2);
  });
}
