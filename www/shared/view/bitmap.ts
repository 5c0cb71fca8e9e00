/** Paints bitmaps of parts of an image, each pixel where it lies in the image. */
import { toPosition } from './transform';
import type { Rect, Transform } from './transform';

/** The part of the image that a rectangle of the canvas shows: left, top, right, bottom in px, within the image. */
export function visiblePart(picture: { width: number; height: number }, t: Transform, clip: Rect): [number, number, number, number] {
  const [left, top] = toPosition(t, clip.left, clip.top);
  const [right, bottom] = toPosition(t, clip.left + clip.width, clip.top + clip.height);
  return [Math.max(0, left), Math.max(0, top), Math.min(picture.width, right), Math.min(picture.height, bottom)];
}

/** The reduction whose pixels are nearest to, and not larger than, device pixels. */
export function wantedLevel(scale: number, ratio: number): number {
  return Math.max(0, Math.floor(Math.log2(1 / (scale * ratio))));
}

/** Draws the part of a bitmap that is seen. `step`: image px of one bitmap px; `x`, `y`: image position of its corner. */
export function paintBitmap(
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

/** Enlarged pixels are shown as they are; reduced ones are smoothed. `ratio`: device px per CSS px. */
export function smooth(context: CanvasRenderingContext2D, scale: number, ratio: number): void {
  context.imageSmoothingEnabled = scale * ratio < 2;
  context.imageSmoothingQuality = 'medium';
}
