/** The loupes over the panes: at the pointer and at the same ground in the other images, or at the point that is measured. */
import type { Position } from '../../../shared/state/pane';
import { LENS_FACTOR, lensRect, lensTransform } from '../../../shared/view/pointer';
import { toCanvas } from '../../../shared/view/transform';
import type { Rect, Transform } from '../../../shared/view/transform';
import type { Measuring } from './measuring';
import { isOn } from './scene';
import type { At, Pane } from './scene';
import type { Seen } from './seen';

/** A px of the image in the loupe over a point that is measured, CSS px. */
const DRAFT_SCALE = 6;
const EDGE = 8;

export interface Lens {
  pane: Pane;
  rect: Rect;
  transform: Transform;
}

/** At the pointer's place on the canvas, over what it points at. */
export function lensesAt(seen: Seen, panes: readonly Pane[], pointer: Position, pointed: At): Lens[] {
  const from = panes.find(({ image }) => image === pointed.image);
  const scale = Math.min(48, Math.max(4, (from?.transform.scale ?? 1) * LENS_FACTOR));
  return panes.flatMap((pane) => {
    const own = pane === from;
    const at = own ? pointed.at : seen.sameGround(from, pane, pointed.at);
    if (at === null || !isOn(pane, at)) return [];
    const rect = own ? besidePointer(pointer, pane.rect) : cornerOf(pane.rect);
    return [{ pane, rect, transform: lensTransform(rect, at, scale) }];
  });
}

/** Over the point that is measured, in all images: one place is compared with the others. */
export function draftLenses(measuring: Measuring, panes: readonly Pane[]): Lens[] {
  return panes.flatMap((pane) => {
    const at = measuring.placeIn(pane);
    if (at === null || !isOn(pane, at)) return [];
    const rect = cornerOf(pane.rect, toCanvas(pane.transform, ...at));
    return [{ pane, rect, transform: lensTransform(rect, at, Math.max(DRAFT_SCALE, pane.transform.scale)) }];
  });
}

/** Beside the pointer, within its pane. */
function besidePointer([x, y]: Position, { left, top, width, height }: Rect): Rect {
  const rect = lensRect([x - left, y - top], { left: 0, top: 0, width, height });
  return { ...rect, left: left + rect.left, top: top + Math.min(rect.top, height - rect.height) };
}

/** The lower right corner of a pane; the left one where the right half holds a place of the canvas, which is not to lie under it. */
function cornerOf({ left, top, width, height }: Rect, [x] = [left, top]): Rect {
  const side = Math.max(40, Math.min(176, width * 0.45, height * 0.45));
  const start = x > left + width / 2 ? left + EDGE : left + width - EDGE - side;
  return { left: start, top: top + height - EDGE - side, width: side, height: side };
}
