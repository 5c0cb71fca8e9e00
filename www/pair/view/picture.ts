/** Paints an image into a pane: its reduced copy at once, detail tiles as they come. */
import { within } from '../../shared/view/layers';
import type { MaskImage, Overview } from '../state/data';
import type { Rect, Transform } from '../../shared/view/transform';
import { toPosition } from '../../shared/view/transform';
import { TILE_SIDE } from './tilecache';
import type { TileCache } from './tilecache';

export interface Picture {
  imageId: number;
  width: number;
  height: number;
  overview: Overview;
}

/** The part of the image that a rectangle of the canvas shows: left, top, right, bottom in px, within the image. */
function visiblePart(picture: Picture, t: Transform, clip: Rect): [number, number, number, number] {
  const [left, top] = toPosition(t, clip.left, clip.top);
  const [right, bottom] = toPosition(t, clip.left + clip.width, clip.top + clip.height);
  return [Math.max(0, left), Math.max(0, top), Math.min(picture.width, right), Math.min(picture.height, bottom)];
}

/** The reduction whose pixels are nearest to, and not larger than, device pixels. */
function wantedLevel(scale: number, ratio: number): number {
  return Math.max(0, Math.floor(Math.log2(1 / (scale * ratio))));
}

/** Draws the part of a bitmap that is seen. `step`: image px of one bitmap px; `x`, `y`: image position of its corner. */
function paintBitmap(
  context: CanvasRenderingContext2D,
  bitmap: ImageBitmap,
  x: number,
  y: number,
  step: number,
  part: [number, number, number, number],
  t: Transform,
): void {
  const left = Math.max(0, Math.floor((part[0] - x) / step));
  const top = Math.max(0, Math.floor((part[1] - y) / step));
  const right = Math.min(bitmap.width, Math.ceil((part[2] - x) / step));
  const bottom = Math.min(bitmap.height, Math.ceil((part[3] - y) / step));
  if (right <= left || bottom <= top) return;
  const size = step * t.scale;
  context.drawImage(
    bitmap,
    left,
    top,
    right - left,
    bottom - top,
    t.scale * x + t.x + left * size,
    t.scale * y + t.y + top * size,
    (right - left) * size,
    (bottom - top) * size,
  );
}

/** Paints what a rectangle of the canvas shows of an image. `ratio`: device px per CSS px. */
export function paintPicture(context: CanvasRenderingContext2D, picture: Picture, t: Transform, clip: Rect, ratio: number, tiles: TileCache | null): void {
  within(context, clip, () => {
    // Enlarged pixels are shown as they are; reduced ones are smoothed.
    context.imageSmoothingEnabled = t.scale * ratio < 2;
    context.imageSmoothingQuality = 'medium';
    const part = visiblePart(picture, t, clip);
    paintBitmap(context, picture.overview.bitmap, 0, 0, 2 ** picture.overview.halvings, part, t);
    const level = wantedLevel(t.scale, ratio);
    if (tiles === null || level >= picture.overview.halvings) return;
    const step = 2 ** level;
    const side = TILE_SIDE * step;
    for (let row = Math.floor(part[1] / side); row * side < part[3]; row++) {
      for (let column = Math.floor(part[0] / side); column * side < part[2]; column++) {
        const tile = tiles.get(picture.imageId, level, column, row);
        if (tile !== null) paintBitmap(context, tile, column * side, row * side, step, part, t);
      }
    }
  });
}

/** Paints what a mask leaves out over its image. */
export function paintMask(context: CanvasRenderingContext2D, { overlay, width, height }: MaskImage, t: Transform, clip: Rect): void {
  within(context, clip, () => {
    context.imageSmoothingEnabled = false;
    context.drawImage(overlay, t.x, t.y, t.scale * width, t.scale * height);
  });
}
