/** Which points the picture shows. */
import { remember } from '../../shared/state/remember';
import { BY_HAND, GROSS_ERROR, LEFT_OUT, MANUAL, MATCHED, REFUSALS, UNDECIDED, codeOf } from './codes';
import type { Display } from './state';

export type Shown = Pick<Display, 'points' | 'hidden'>;

/** Shown at first: accepted matches, and those that the user rejected, who may want them back. */
const MATCHES: readonly number[] = [MATCHED, MANUAL, BY_HAND];

/** Whether points of a code are shown: the others than these only where they are asked for. */
export function isCodeShown({ points, hidden }: Shown, code: number): boolean {
  if (code === LEFT_OUT || hidden.includes(code)) return false;
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

/** While a filter stands, gross errors that it keeps are shown beside the other matches: they are in the table, too. */
export const withListed = remember((display: Shown): Shown => {
  return display.points === 'matched' && !display.hidden.includes(GROSS_ERROR) ? withCode(display, GROSS_ERROR, true) : display;
});
