/** What a mask leaves out: how much, as it is shown over its image, and areas that are painted. */
import type { Area } from '../state/state';

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

/** Gives the pixels whose middles lie in an outline a value; where it crosses itself, what it goes round at all. `corners`: x and y in px. */
export function fill(grey: Uint8Array, width: number, height: number, corners: Area['corners'], value: number): void {
  for (const [row, crossings] of crossingsOf(corners, height)) {
    crossings.sort(([a], [b]) => a - b);
    let winding = 0;
    for (const [i, [from, turn]] of crossings.entries()) {
      winding += turn;
      const to = crossings[i + 1]?.[0] ?? from;
      if (winding !== 0) grey.fill(value, row * width + columnAfter(from, width), row * width + columnAfter(to, width));
    }
  }
}

/** Where an outline crosses the middles of rows, and whether downwards (1) or upwards (-1). A mask may be made of thousands of areas: only the rows of each side are gone through. */
function crossingsOf(corners: Area['corners'], height: number): Map<number, [x: number, turn: number][]> {
  const rows = new Map<number, [x: number, turn: number][]>();
  for (const [i, [x, y]] of corners.entries()) {
    const [u, v] = corners[i + 1] ?? corners[0] ?? [x, y];
    const [top, bottom] = [Math.min(y, v), Math.max(y, v)];
    for (let row = Math.max(0, Math.floor(top - 0.5)); row < Math.min(height, bottom); row++) {
      const middle = row + 0.5;
      if (middle < top || middle >= bottom) continue;
      const crossings = rows.get(row) ?? [];
      crossings.push([x + ((middle - y) / (v - y)) * (u - x), y < v ? 1 : -1]);
      rows.set(row, crossings);
    }
  }
  return rows;
}

/** The first column whose middle lies at a place or to the right of it. */
const columnAfter = (x: number, width: number): number => Math.min(width, Math.max(0, Math.ceil(x - 0.5)));
