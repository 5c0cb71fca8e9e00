/** The score of matches where the truth is known: only the built-in sample has it. */
import type { MatchResult } from '../engine/wasm';
import { remember } from './select';
import type { SampleTruth, State } from './state';

/** A match is right when its right point lies this near to where the surface is seen, in px. */
export const TOLERANCE_PX = 1.5;

export interface Score {
  matches: number;
  right: number;
  /** Share of right matches, 0..1; NaN without matches. */
  precision: number;
}

/**
 * Edge precision: a match is right when its right point lies within 1.5 px of where the surface at the left pixel, or at one of its
 * eight neighbours, is seen. The neighbours count because points lie on edges, where the surface may jump between two pixels.
 */
export const score = remember((match: MatchResult, truth: SampleTruth): Score => {
  const matches = match.matches.length / 5;
  let right = 0;
  for (let i = 0; i < matches; i++) {
    const [xl = 0, yl = 0, xr = 0, yr = 0] = match.matches.subarray(5 * i, 5 * i + 4);
    if (isRight(truth, xl, yl, xr, yr)) right += 1;
  }
  return { matches, right, precision: right / matches };
});

function isRight(truth: SampleTruth, xl: number, yl: number, xr: number, yr: number): boolean {
  const col = Math.floor(xl);
  const row = Math.floor(yl);
  // Where the point lies between pixel centres, the place where the pixel is seen moves with it.
  const x = xr - (xl - col - 0.5);
  const y = yr - (yl - row - 0.5);
  for (let r = Math.max(row - 1, 0); r <= Math.min(row + 1, truth.leftHeight - 1); r++) {
    for (let c = Math.max(col - 1, 0); c <= Math.min(col + 1, truth.leftWidth - 1); c++) {
      const at = 2 * (r * truth.leftWidth + c);
      const dx = (truth.rightPosition[at] ?? NaN) - x;
      const dy = (truth.rightPosition[at + 1] ?? NaN) - y;
      if (dx * dx + dy * dy <= TOLERANCE_PX * TOLERANCE_PX) return true;
    }
  }
  return false;
}

/** The truth of the images on the screen; null where they are not the sample in its own order. */
export function truthOf(state: State): SampleTruth | null {
  const { truth, images } = state;
  return truth !== null && images.left?.id === truth.leftId && images.right?.id === truth.rightId ? truth : null;
}
