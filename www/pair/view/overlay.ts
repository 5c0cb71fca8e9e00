/** What follows the pointer and the selection: the selected point, its search window and candidates, the magnifier. */
import { comparesGradients, comparesGreyValues, isCurrent } from '../state/keys';
import { expectedPosition } from '../state/offset';
import { leftIndexOf, placeOf } from '../state/selected';
import type { State } from '../state/state';
import { drawSupport } from './frames';
import { within } from '../../shared/view/layers';
import { contains, toCanvas, toPosition } from '../../shared/view/transform';
import type { Rect } from '../../shared/view/transform';
import { drawPoints } from './marks';
import { CANDIDATE, SELECTED } from '../../shared/view/palette';
import { crosshair, drawLine, LENS_FACTOR, lensFrame, lensRect, lensTransform, ring } from '../../shared/view/pointer';
import { paintPicture } from './picture';
import type { Pane, Scene } from './scene';
import type { TileCache } from './tilecache';

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

/** The magnifier at a canvas position: the image under the pointer, enlarged, with its points. */
export function drawLens(
  context: CanvasRenderingContext2D,
  state: State,
  scene: Scene,
  at: [number, number],
  ratio: number,
  tiles: TileCache,
  bounds: Rect,
): void {
  const pane = contains(scene.panes.left.rect, at[0], at[1]) ? scene.panes.left : scene.panes.right;
  if (pane.picture === null || !contains(pane.rect, at[0], at[1])) return;
  const scale = Math.min(48, Math.max(4, pane.transform.scale * LENS_FACTOR));
  paintLens(context, state, scene, pane, toPosition(pane.transform, at[0], at[1]), lensRect(at, bounds), scale, ratio, tiles);
}

/** A rectangle of the canvas that shows what lies around a place of an image, enlarged, with its points. */
export function paintLens(
  context: CanvasRenderingContext2D,
  state: State,
  scene: Scene,
  pane: Pane,
  at: [number, number],
  rect: Rect,
  scale: number,
  ratio: number,
  tiles: TileCache,
): void {
  const { picture } = pane;
  if (picture === null) return;
  const transform = lensTransform(rect, at, scale);
  within(context, rect, () => {
    context.fillStyle = '#000000';
    context.fillRect(rect.left, rect.top, rect.width, rect.height);
    paintPicture(context, picture, transform, rect, ratio, tiles);
    drawPoints(context, state, scene, pane, transform, rect);
    crosshair(context, rect);
  });
  lensFrame(context, rect);
}
