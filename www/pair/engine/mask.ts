/** What a mask leaves out: how much, and as it is shown over its image. */

/** Red, half transparent: `ImageData` keeps bytes in the order red, green, blue, alpha. */
const LEFT_OUT = 0x99_28_28_d8;

/** The pixels that a mask leaves out (its zeros), in colour, in a bitmap of at most `most` px a side. */
export function overlayOf(grey: Uint8Array, width: number, height: number, most: number): Promise<ImageBitmap> {
  const step = Math.max(1, Math.ceil(Math.max(width, height) / most));
  const [columns, rows] = [Math.ceil(width / step), Math.ceil(height / step)];
  const pixels = new Uint32Array(columns * rows);
  for (let i = 0; i < pixels.length; i++) {
    const at = Math.floor(i / columns) * step * width + (i % columns) * step;
    pixels[i] = grey[at] === 0 ? LEFT_OUT : 0;
  }
  return createImageBitmap(new ImageData(new Uint8ClampedArray(pixels.buffer), columns, rows));
}

/** The share of the pixels that a mask leaves out. */
export function shareLeftOut(grey: Uint8Array): number {
  let zeros = 0;
  for (const value of grey) if (value === 0) zeros += 1;
  return zeros / grey.length;
}
