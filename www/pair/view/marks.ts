/** Points, match lines and residual vectors, drawn by the crate. */
import { isCodeShown } from '../state/display';
import { draw_match_lines, draw_points, draw_vectors } from '../../shared/crate';
import { GROSS_ERROR, LEFT_OUT, OF_MATCHES } from '../state/codes';
import { remember } from '../../shared/state/remember';
import { within } from '../../shared/view/layers';
import { SIDES } from '../state/state';
import type { PointLayer, Side, State } from '../state/state';
import { drawFrames } from './frames';
import { drawView, halfSize } from '../../shared/view/panes';
import type { Rect, Transform } from '../../shared/view/transform';
import { RESIDUAL, RESIDUAL_REJECTED } from '../../shared/view/palette';
import { DRAWN, LINE, LINE_REJECTED, STYLES } from './palette';
import type { Pane, Scene } from './scene';

/** Lines drawn when only some are wanted. */
export const SOME_LINES = 100;
const ALL = 0xffffffff;
const NOT_DRAWN = 255;

interface Styles {
  styles: Float64Array;
  colours: string[];
}

/** The styles in drawing order, refused points smaller than matches. */
function stylesAt(scale: number): Styles {
  const half = halfSize(scale);
  const rows = DRAWN.map((code) => {
    const matched = OF_MATCHES.includes(code);
    return [STYLES[code]?.shape ?? 0, matched ? half : 0.75 * half, matched ? 1.6 : 1.2];
  });
  return { styles: Float64Array.from(rows.flat()), colours: DRAWN.map((code) => STYLES[code]?.colour ?? '#ffffff') };
}

function makeSlots() {
  return remember((codes: Uint8Array, points: PointLayer, hidden: readonly number[]): Uint8Array => {
    const slots = Uint8Array.from(STYLES, (_, code) => (isCodeShown({ points, hidden }, code) ? DRAWN.indexOf(code) : NOT_DRAWN));
    return codes.map((code) => slots[code] ?? NOT_DRAWN);
  });
}

/** For each point the place of its style in the drawing order; kept until codes or layers change, as a drag draws many times. */
const slotsOf: Record<Side, ReturnType<typeof makeSlots>> = { left: makeSlots(), right: makeSlots() };

const slotsOfPlaces = makeSlots();

/** Draws the points of one image where `clip` shows them, and the matched places that are no points. */
export function drawPoints(context: CanvasRenderingContext2D, state: State, scene: Scene, pane: Pane, transform: Transform, clip: Rect): void {
  const { points, hidden } = scene.shown;
  if (pane.points === null || points === 'none') return;
  const { styles, colours } = stylesAt(transform.scale);
  const view = drawView(transform, clip);
  draw_points(context, pane.points, slotsOf[pane.side](pane.codes, points, hidden), styles, colours, view);
  drawFrames(context, state, scene.shown, pane, transform, clip);
  if (pane.side === 'right') draw_points(context, scene.places.points, slotsOfPlaces(scene.places.codes, points, hidden), styles, colours, view);
}

function drawLines(context: CanvasRenderingContext2D, state: State, scene: Scene): void {
  const { lines } = state.display;
  if (scene.match === null || lines === 'none') return;
  const { left, right } = scene.panes;
  // Rejected matches are lines where rejected points are drawn.
  const { shown } = scene;
  const rejected = isCodeShown({ ...shown, points: shown.points === 'none' ? 'matched' : shown.points }, GROSS_ERROR) ? 1 : NOT_DRAWN;
  const codes = scene.matchCodes.map((code) => (code === LEFT_OUT ? NOT_DRAWN : code === GROSS_ERROR ? rejected : 0));
  draw_match_lines(
    context,
    scene.match.matches,
    codes,
    Float64Array.of(1, 1),
    [LINE, LINE_REJECTED],
    drawView(left.transform, left.rect),
    drawView(right.transform, right.rect),
    lines === 'all' ? ALL : SOME_LINES,
  );
}

function drawResiduals(context: CanvasRenderingContext2D, state: State, scene: Scene, pane: Pane): void {
  if (pane.vectors === null || state.display.vectors === 0) return;
  const codes = scene.matchCodes.map((code) => (code === LEFT_OUT ? NOT_DRAWN : code === GROSS_ERROR ? 1 : 0));
  draw_vectors(
    context,
    pane.vectors,
    codes,
    Float64Array.of(1.4, 1.4),
    [RESIDUAL, RESIDUAL_REJECTED],
    state.display.vectors,
    drawView(pane.transform, pane.rect),
  );
}

/** Draws all layers of marks over both panes. */
export function drawMarks(context: CanvasRenderingContext2D, state: State, scene: Scene): void {
  drawLines(context, state, scene);
  for (const side of SIDES) {
    const pane = scene.panes[side];
    within(context, pane.rect, () => {
      drawPoints(context, state, scene, pane, pane.transform, pane.rect);
      drawResiduals(context, state, scene, pane);
    });
  }
}
