/** Which points the picture shows. */
import { GROSS_ERROR, MATCHED, REFUSALS, UNDECIDED, codeOf } from './codes';
import type { Display } from './state';

type Shown = Pick<Display, 'points' | 'hidden'>;

/** Whether points of a code are shown: accepted matches, and the others only where they are asked for. */
export function isCodeShown({ points, hidden }: Shown, code: number): boolean {
  if (hidden.includes(code)) return false;
  return points === 'all' || (points === 'matched' && code === MATCHED);
}

/** Codes of points that are no accepted matches. */
const REJECTED: readonly number[] = [...REFUSALS.map(codeOf), GROSS_ERROR, UNDECIDED];

/** Shows or hides the points of one code. Where only matches were shown, those of other codes stay hidden. */
export function withCode(display: Shown, code: number, on: boolean): Shown {
  const { points } = display;
  const before = points === 'all' ? display.hidden : [...(points === 'none' ? [MATCHED] : display.hidden), ...REJECTED];
  const others = before.filter((other) => other !== code);
  return { points: on ? 'all' : points, hidden: on ? others : [...display.hidden.filter((other) => other !== code), code] };
}
