/** Which points the picture shows. */
import { BY_HAND, GROSS_ERROR, MANUAL, MATCHED, REFUSALS, UNDECIDED, codeOf } from './codes';
import type { Display } from './state';

type Shown = Pick<Display, 'points' | 'hidden'>;

/** Shown at first: accepted matches, and those that the user rejected, who may want them back. */
const MATCHES: readonly number[] = [MATCHED, MANUAL, BY_HAND];

/** Whether points of a code are shown: the others than these only where they are asked for. */
export function isCodeShown({ points, hidden }: Shown, code: number): boolean {
  if (hidden.includes(code)) return false;
  return points === 'all' || (points === 'matched' && MATCHES.includes(code));
}

/** Codes of all other points. */
const REJECTED: readonly number[] = [...REFUSALS.map(codeOf), GROSS_ERROR, UNDECIDED];

/** Shows or hides the points of one code. Where only matches were shown, those of other codes stay hidden. */
export function withCode(display: Shown, code: number, on: boolean): Shown {
  const { points } = display;
  const before = points === 'all' ? display.hidden : [...(points === 'none' ? MATCHES : display.hidden), ...REJECTED];
  const others = before.filter((other) => other !== code);
  return { points: on ? 'all' : points, hidden: on ? others : [...display.hidden.filter((other) => other !== code), code] };
}
