/** Grey values on a turned and scaled grid around a place of an image. */
import type { PatchInput } from './calls';

/** Bilinear between the centres of pixels; beyond the border counts what lies nearest to it. */
function greyAt(grey: Uint8Array, width: number, height: number, x: number, y: number): number {
  const [px, py] = [Math.min(width - 1, Math.max(0, x - 0.5)), Math.min(height - 1, Math.max(0, y - 0.5))];
  const [col, row] = [Math.min(Math.floor(px), Math.max(0, width - 2)), Math.min(Math.floor(py), Math.max(0, height - 2))];
  const [right, below] = [Math.min(1, width - 1), height > 1 ? width : 0];
  const at = row * width + col;
  const [a = 0, b = 0, c = 0, d = 0] = [grey[at], grey[at + right], grey[at + below], grey[at + below + right]];
  const [fx, fy] = [px - col, py - row];
  return (a * (1 - fx) + b * fx) * (1 - fy) + (c * (1 - fx) + d * fx) * fy;
}

/** The samples of a grid, row by row. Where they lie farther apart than pixels each is the mean of several. */
export function patchOf(grey: Uint8Array, width: number, height: number, { x, y, direction, reach, side }: PatchInput): Uint8Array {
  const fine = Math.max(1, Math.round(reach / side));
  const step = reach / (side * fine);
  const [cos, sin] = [Math.cos(direction) * step, Math.sin(direction) * step];
  const middle = (side * fine - 1) / 2;
  return Uint8Array.from({ length: side * side }, (_, i) => {
    let sum = 0;
    for (let k = 0; k < fine * fine; k++) {
      const u = (i % side) * fine + (k % fine) - middle;
      const v = Math.floor(i / side) * fine + Math.floor(k / fine) - middle;
      sum += greyAt(grey, width, height, x + u * cos - v * sin, y + u * sin + v * cos);
    }
    return Math.round(sum / (fine * fine));
  });
}
