/** Grey values on a turned and scaled grid around a place of an image. */
import { greyAt } from '../../shared/engine/tiles';
import type { PatchInput } from './calls';

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
