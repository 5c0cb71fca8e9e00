/** Loupes: rectangles of the canvas that show a part of an image enlarged, with its points. Their pictures are a layer, as the pictures themselves are. */
import { markInHand, placeOfMark } from '../state/marks';
import { placeOfDraft } from '../state/draft';
import { SIDES } from '../state/state';
import type { State } from '../state/state';
import type { Position } from '../../shared/state/pane';
import { within } from '../../shared/view/layers';
import { crosshair, LENS_FACTOR, lensFrame, lensRect, lensTransform } from '../../shared/view/pointer';
import { toPosition } from '../../shared/view/transform';
import type { Rect, Transform } from '../../shared/view/transform';
import { drawPoints } from './marks';
import { paintPicture } from './picture';
import { paneAt } from './scene';
import type { Pane, Scene } from './scene';
import type { TileCache } from './tilecache';

const CORNER_SIDE = 168;
/** A px of the image in the loupe over what is measured, CSS px. */
const CORNER_SCALE = 12;
const EDGE = 8;

export interface Lens {
  pane: Pane;
  rect: Rect;
  transform: Transform;
}

/** Over what is measured: both points of a match, as one place is compared with the other; the fiducial mark in hand. */
export function lensesOfMeasured(state: State, scene: Scene): Lens[] {
  const { mark, tool } = state;
  const ofMark = tool === 'fiducials' && mark !== null ? placeOfMark(state.photos[mark.side], markInHand(state)) : null;
  return SIDES.flatMap((side) =>
    [mark?.side === side ? ofMark : null, placeOfDraft(state, side)].flatMap((at) => (at === null ? [] : inCorner(scene.panes[side], at))),
  );
}

/** The magnifier at a canvas position. */
export function magnifierAt(scene: Scene, at: Position, bounds: Rect): Lens[] {
  const pane = paneAt(scene, ...at);
  if (pane === null) return [];
  const scale = Math.min(48, Math.max(4, pane.transform.scale * LENS_FACTOR));
  return lens(pane, toPosition(pane.transform, ...at), lensRect(at, bounds), scale);
}

function lens(pane: Pane, at: Position, rect: Rect, scale: number): Lens[] {
  return pane.picture === null ? [] : [{ pane, rect, transform: lensTransform(rect, at, scale) }];
}

const inCorner = (pane: Pane, at: Position) => lens(pane, at, cornerOf(pane), Math.max(CORNER_SCALE, pane.transform.scale));

/** The lower outer corner of a pane. */
function cornerOf({ rect, side }: Pane): Rect {
  const length = Math.max(40, Math.min(CORNER_SIDE, rect.width * 0.45, rect.height * 0.45));
  const left = side === 'left' ? rect.left + EDGE : rect.left + rect.width - EDGE - length;
  return { left, top: rect.top + rect.height - EDGE - length, width: length, height: length };
}

/** What of the images the loupes show. */
export function paintLenses(context: CanvasRenderingContext2D, lenses: readonly Lens[], ratio: number, tiles: TileCache): void {
  for (const { pane, rect, transform } of lenses) {
    within(context, rect, () => {
      context.fillStyle = '#000000';
      context.fillRect(rect.left, rect.top, rect.width, rect.height);
      if (pane.picture !== null) paintPicture(context, pane.picture, transform, rect, ratio, tiles);
    });
  }
}

/** What lies over them. */
export function drawOverLenses(context: CanvasRenderingContext2D, state: State, scene: Scene, lenses: readonly Lens[]): void {
  for (const { pane, rect, transform } of lenses) {
    within(context, rect, () => {
      drawPoints(context, state, scene, pane, transform, rect);
      crosshair(context, rect);
    });
    lensFrame(context, rect);
  }
}
