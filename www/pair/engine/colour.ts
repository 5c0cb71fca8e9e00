/** The colours of an image as the browser decodes it, where they lie exactly over the crate's grey values. */
import type { ReducedImage } from '../../shared/crate';

/** Larger images are shown in grey: their colours would take more memory than a tab has to spare. */
const MOST_PIXELS = 50e6;

/** Pixels of the reduced image that are looked at, one in so many. */
const STRIDE = 7;

/** Channels that differ by no more are grey, but for the noise of compression. */
const GREY = 6;
/** A share of pixels that differ by more makes an image coloured. */
const LEAST_COLOURED = 0.001;

/** The decoded pixels lie as the crate's do where their brightness correlates so well. */
const LEAST_CORRELATION = 0.9;

/** The coloured copy of a reduced image; null where it has no colours, or other pixels than the crate decoded. */
export function reducedColour(colour: ImageBitmap, grey: ReducedImage, width: number, height: number): ImageBitmap | null {
  if (colour.width !== width || colour.height !== height || width * height > MOST_PIXELS) return null;
  const canvas = new OffscreenCanvas(grey.width, grey.height);
  const context = canvas.getContext('2d');
  if (context === null) return null;
  const step = 2 ** grey.halvings;
  context.imageSmoothingQuality = 'high';
  context.drawImage(colour, 0, 0, width / step, height / step);
  const { data } = context.getImageData(0, 0, grey.width, grey.height);
  return isColoured(data) && correlation(data, grey.grey) >= LEAST_CORRELATION ? canvas.transferToImageBitmap() : null;
}

/** The tile that `tileOf` gives of grey values. */
export function colourTile(colour: ImageBitmap, level: number, column: number, row: number, side: number): ImageBitmap {
  const step = 2 ** level;
  const [left, top] = [column * side * step, row * side * step];
  const [width, height] = [Math.min(side * step, colour.width - left), Math.min(side * step, colour.height - top)];
  const canvas = new OffscreenCanvas(Math.ceil(width / step), Math.ceil(height / step));
  const context = canvas.getContext('2d');
  if (context === null) throw new Error('no canvas can be drawn on here');
  context.imageSmoothingQuality = 'high';
  context.drawImage(colour, left, top, width, height, 0, 0, width / step, height / step);
  return canvas.transferToImageBitmap();
}

function isColoured(data: Uint8ClampedArray): boolean {
  let coloured = 0;
  for (let i = 0; i < data.length; i += 4 * STRIDE) {
    const [r, g, b] = [data[i] ?? 0, data[i + 1] ?? 0, data[i + 2] ?? 0];
    if (Math.max(r, g, b) - Math.min(r, g, b) > GREY) coloured += 1;
  }
  return coloured > (LEAST_COLOURED * data.length) / (4 * STRIDE);
}

/** Of brightness and grey values. */
function correlation(data: Uint8ClampedArray, grey: Uint8Array): number {
  let [n, x, y, xx, yy, xy] = [0, 0, 0, 0, 0, 0];
  for (let i = 0; i < grey.length; i += STRIDE) {
    const bright = 0.299 * (data[4 * i] ?? 0) + 0.587 * (data[4 * i + 1] ?? 0) + 0.114 * (data[4 * i + 2] ?? 0);
    const own = grey[i] ?? 0;
    n += 1;
    x += bright;
    y += own;
    xx += bright * bright;
    yy += own * own;
    xy += bright * own;
  }
  return (n * xy - x * y) / Math.sqrt((n * xx - x * x) * (n * yy - y * y));
}
