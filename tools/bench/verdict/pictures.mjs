/** What is done to grey pictures to make pairs of them: positions in px, the centre of the top-left pixel at (0.5, 0.5). */

import { normal } from '../dice.mjs';

/**
 * @typedef {import('../../../pkg/node.js').ExifImage} ExifImage
 * @typedef {{ width: number, height: number, grey: Uint8Array, exif?: ExifImage }} Picture
 */

/** @param {number} width @param {number} height @param {(col: number, row: number) => number} grey @returns {Picture} */
export function drawn(width, height, grey) {
  const values = new Uint8Array(width * height);
  for (let row = 0, i = 0; row < height; row++) for (let col = 0; col < width; col++, i++) values[i] = level(grey(col, row));
  return { width, height, grey: values };
}

/** @param {Picture} picture @param {(col: number, row: number) => number} grey @returns {Picture} */
const redrawn = (picture, grey) => ({ ...picture, ...drawn(picture.width, picture.height, grey) });

/** @param {Picture} picture @param {number} col @param {number} row */
export const greyAt = ({ width, grey }, col, row) => grey[row * width + col] ?? 0;

/** @param {Picture} picture @param {number} x @param {number} y @param {number} width @param {number} height @returns {Picture} */
export const cropped = (picture, x, y, width, height) => ({ ...picture, ...drawn(width, height, (col, row) => greyAt(picture, col + x, row + y)) });

/** @param {Picture} picture @param {'columns' | 'rows'} what is put in the other order */
export function mirrored(picture, what) {
  const { width, height } = picture;
  return redrawn(picture, (col, row) => (what === 'columns' ? greyAt(picture, width - 1 - col, row) : greyAt(picture, col, height - 1 - row)));
}

/** Turned clockwise.  @param {Picture} picture @param {90 | 180} deg @returns {Picture} */
export function turned(picture, deg) {
  const { width, height } = picture;
  if (deg === 180) return redrawn(picture, (col, row) => greyAt(picture, width - 1 - col, height - 1 - row));
  return { ...picture, ...drawn(height, width, (col, row) => greyAt(picture, row, height - 1 - col)) };
}

/** Means of `by` x `by` pixels.  @param {Picture} picture @param {number} by @returns {Picture} */
export function reduced(picture, by) {
  const mean = (/** @type {number} */ col, /** @type {number} */ row) => {
    let sum = 0;
    for (let r = 0; r < by; r++) for (let c = 0; c < by; c++) sum += greyAt(picture, col * by + c, row * by + r);
    return sum / (by * by);
  };
  return { ...picture, ...drawn(Math.floor(picture.width / by), Math.floor(picture.height / by), mean) };
}

/** @param {Picture} picture @param {number} sigma in grey values @param {number} seed */
export function noisy(picture, sigma, seed) {
  const random = normal(seed);
  return redrawn(picture, (col, row) => greyAt(picture, col, row) + sigma * random());
}

/** @param {Picture} picture @param {number} gain @param {number} offset */
export const brightened = (picture, gain, offset) => redrawn(picture, (col, row) => gain * greyAt(picture, col, row) + offset);

/** The same through another camera position: `map` by rows takes its positions to those of `picture`; black where that has none.  @param {Picture} picture @param {number[][]} map */
export function warped(picture, map) {
  const { width, height } = picture;
  return redrawn(picture, (col, row) => {
    const [u = 0, v = 0, w = 1] = map.map(([a = 0, b = 0, c = 0]) => a * (col + 0.5) + b * (row + 0.5) + c);
    const [x, y] = [u / w - 0.5, v / w - 0.5];
    if (w <= 0 || x < 0 || y < 0 || x > width - 1 || y > height - 1) return 0;
    const [c, r] = [Math.min(width - 2, Math.floor(x)), Math.min(height - 2, Math.floor(y))];
    const [dx, dy] = [x - c, y - r];
    const top = (1 - dx) * greyAt(picture, c, r) + dx * greyAt(picture, c + 1, r);
    const bottom = (1 - dx) * greyAt(picture, c, r + 1) + dx * greyAt(picture, c + 1, r + 1);
    return (1 - dy) * top + dy * bottom;
  });
}

const BLOCK = 8;

/** Compressed with loss: the cosine transform of blocks of 8 x 8 px, its coefficients rounded to multiples that grow with their frequency.  @param {Picture} picture @param {number} step of the lowest frequencies, in grey values */
export function compressed(picture, step) {
  const basis = Array.from({ length: BLOCK }, (_, k) =>
    Array.from({ length: BLOCK }, (_, i) => Math.sqrt((k === 0 ? 1 : 2) / BLOCK) * Math.cos(((2 * i + 1) * k * Math.PI) / (2 * BLOCK))),
  );
  const whole = (/** @type {number} */ side) => Math.ceil(side / BLOCK) * BLOCK;
  const [width, height] = [whole(picture.width), whole(picture.height)];
  const clamped = (/** @type {number} */ col, /** @type {number} */ row) =>
    greyAt(picture, Math.min(col, picture.width - 1), Math.min(row, picture.height - 1));
  const decoded = new Float64Array(width * height);
  for (let top = 0; top < height; top += BLOCK) {
    for (let left = 0; left < width; left += BLOCK) {
      const block = Array.from({ length: BLOCK }, (_, r) => Array.from({ length: BLOCK }, (_, c) => clamped(left + c, top + r)));
      const coefficients = both(block, basis).map((row, k) => row.map((v, l) => rounded(v, step * (1 + k + l))));
      for (const [r, row] of both(coefficients, transposed(basis)).entries()) decoded.set(row, (top + r) * width + left);
    }
  }
  return redrawn(picture, (col, row) => decoded[row * width + col] ?? 0);
}

/** The transform of rows and columns.  @param {number[][]} block @param {number[][]} basis */
const both = (block, basis) => transposed(multiplied(basis, transposed(multiplied(basis, block))));

/** @param {number[][]} a @param {number[][]} b */
export const multiplied = (a, b) => a.map((row) => (b[0] ?? []).map((_, c) => row.reduce((sum, v, k) => sum + v * (b[k]?.[c] ?? 0), 0)));

/** @param {number[][]} a */
export const transposed = (a) => (a[0] ?? []).map((_, c) => a.map((row) => row[c] ?? 0));

/** @param {number} value @param {number} step */
const rounded = (value, step) => Math.round(value / step) * step;

/** @param {number} value */
const level = (value) => Math.min(255, Math.max(0, Math.round(value)));
