/** Paints an image into a pane: its reduced copy at once, detail tiles as they come. */
import { within } from '../../shared/view/layers';
import type { MaskImage, Overview } from '../state/data';
import type { Rect, Transform } from '../../shared/view/transform';
import { paintBitmap, smooth, visiblePart, wantedLevel } from '../../shared/view/bitmap';
import { TILE_SIDE } from './tilecache';
import type { TileCache } from './tilecache';

export interface Picture {
  imageId: number;
  width: number;
  height: number;
  overview: Overview;
}

/** Paints what a rectangle of the canvas shows of an image. `ratio`: device px per CSS px. */
export function paintPicture(context: CanvasRenderingContext2D, picture: Picture, t: Transform, clip: Rect, ratio: number, tiles: TileCache | null): void {
  within(context, clip, () => {
    smooth(context, t.scale, ratio);
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
