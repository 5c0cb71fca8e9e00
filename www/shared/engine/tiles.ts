/** Grey values to bitmaps, whole or in tiles of a reduced image, and between pixels. */

/** A bitmap of a grey image. */
export function bitmapOf(grey: Uint8Array, width: number, height: number): Promise<ImageBitmap> {
  const pixels = new Uint32Array(width * height);
  for (let i = 0; i < pixels.length; i++) {
    pixels[i] = 0xff000000 | ((grey[i] ?? 0) * 0x010101);
  }
  return createImageBitmap(new ImageData(new Uint8ClampedArray(pixels.buffer), width, height));
}

/**
 * The tile of `side` px at `column`, `row` (counted in tiles) of the image reduced by 2^level: each pixel is the mean of a block.
 * Tiles at the right and lower edge are smaller.
 */
export function tileOf(grey: Uint8Array, width: number, height: number, level: number, column: number, row: number, side: number): Promise<ImageBitmap> {
  const step = 2 ** level;
  const left = column * side * step;
  const top = row * side * step;
  const columns = Math.min(side, Math.ceil((width - left) / step));
  const rows = Math.min(side, Math.ceil((height - top) / step));
  const tile = new Uint8Array(columns * rows);
  for (let r = 0; r < rows; r++) {
    for (let c = 0; c < columns; c++) {
      tile[r * columns + c] = blockMean(grey, width, height, left + c * step, top + r * step, step);
    }
  }
  return bitmapOf(tile, columns, rows);
}

function blockMean(grey: Uint8Array, width: number, height: number, x: number, y: number, step: number): number {
  const right = Math.min(x + step, width);
  const bottom = Math.min(y + step, height);
  let sum = 0;
  for (let row = y; row < bottom; row++) {
    for (let col = x; col < right; col++) sum += grey[row * width + col] ?? 0;
  }
  return Math.round(sum / ((right - x) * (bottom - y)));
}

/** Bilinear between the centres of pixels; beyond the border counts what lies nearest to it. */
export function greyAt(grey: Uint8Array, width: number, height: number, x: number, y: number): number {
  const [px, py] = [Math.min(width - 1, Math.max(0, x - 0.5)), Math.min(height - 1, Math.max(0, y - 0.5))];
  const [col, row] = [Math.min(Math.floor(px), Math.max(0, width - 2)), Math.min(Math.floor(py), Math.max(0, height - 2))];
  const [right, below] = [Math.min(1, width - 1), height > 1 ? width : 0];
  const at = row * width + col;
  const [a = 0, b = 0, c = 0, d = 0] = [grey[at], grey[at + right], grey[at + below], grey[at + below + right]];
  const [fx, fy] = [px - col, py - row];
  return (a * (1 - fx) + b * fx) * (1 - fy) + (c * (1 - fx) + d * fx) * fy;
}
