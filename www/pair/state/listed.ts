/** Which matches are listed: what the filter leaves out of their table, no picture shows. */
import type { MatchResult } from '../../shared/crate';
import { words } from '../../shared/state/columns';
import { remember } from '../../shared/state/remember';
import { maskOf } from '../../shared/state/rows';
import type { Column } from '../../shared/state/rows';
import { count } from '../../shared/text/format';
import { say } from '../../shared/text/words';
import { BY_HAND, GROSS_ERROR, LEFT_OUT, MANUAL, MATCHED } from './codes';
import { shownPair } from './select';
import type { Places } from './select';
import { statisticsOfState } from './statistics';
import type { Statistics } from './statistics';
import type { MatchFilter, MatchKind, State } from './state';

/** What became of a match, in a word. */
const STATES: Readonly<Record<number, string>> = { [GROSS_ERROR]: say('gross-error'), [BY_HAND]: say('rejected-by-hand-2'), [MANUAL]: say('by-hand') };
const RIGHTNESS = [say('wrong'), say('at-an-edge'), say('correct')];

/** The columns of the table: the number of a match, its figures, what became of it. */
export const columnsOf = remember(({ columns, codes, rightness }: Statistics): readonly Column[] => [
  { key: 'match', label: say('match-2'), unit: '', help: say('number-of-the-match-in'), value: (match) => match + 1, text: (match) => count(match + 1) },
  ...columns,
  words('state', say('state-2'), (match) => STATES[codes[match] ?? 0] ?? say('used'), say('whether-the-adjustment-used-the')),
  ...(rightness === null ? [] : [words('truth', say('truth'), (match) => RIGHTNESS[rightness[match] ?? 0] ?? '', say('whether-the-match-is-right'))]),
]);

/** The kind that is listed: without a truth nothing is wrong by it. */
export function kindOf(statistics: Statistics | null, { kind }: MatchFilter): MatchKind {
  return kind === 'wrong' && statistics?.rightness == null ? 'all' : kind;
}

/** Whether a match is of a kind. */
export function isOf({ codes, rightness }: Statistics, kind: MatchKind, match: number): boolean {
  switch (kind) {
    case 'all':
      return true;
    case 'used':
      return codes[match] === MATCHED || codes[match] === MANUAL;
    case 'rejected':
      return codes[match] === GROSS_ERROR;
    case 'by-hand':
      return codes[match] === BY_HAND || codes[match] === MANUAL;
    case 'wrong':
      return rightness?.[match] === 0;
  }
}

/** What the filter leaves out: 1 for each left point, right point and match that is not shown for it. */
export interface LeftOut {
  left: Uint8Array;
  right: Uint8Array;
  matches: Uint8Array;
}

const leftOutOf = remember((statistics: Statistics, filter: MatchFilter, match: MatchResult, rights: number): LeftOut | null => {
  const kind = kindOf(statistics, filter);
  const meets = maskOf(statistics.count, columnsOf(statistics), filter.conditions);
  if (kind === 'all' && meets === null) return null;
  const matches = Uint8Array.from({ length: statistics.count }, (_, row) => Number(!isOf(statistics, kind, row) || meets?.[row] === 0));
  const [left, right] = [new Uint8Array(match.rules.length), new Uint8Array(rights)];
  const used = match.matches.length / 5;
  const rightOf = (row: number) => (row < used ? match.indices[2 * row + 1] : match.best[statistics.lefts[row] ?? -1]) ?? -1;
  matches.forEach((out, row) => {
    left[statistics.lefts[row] ?? -1] = out;
    if (out === 1) right[rightOf(row)] = 1;
  });
  // A right point may be that of several matches, of which one is rejected.
  matches.forEach((out, row) => {
    if (out === 0) right[rightOf(row)] = 0;
  });
  return { left, right, matches };
});

/** What the filter leaves out of the matches that are shown; null where it keeps all. */
export function leftOut(state: State): LeftOut | null {
  const { filter } = state;
  if (filter.kind === 'all' && Object.keys(filter.conditions).length === 0) return null;
  const statistics = statisticsOfState(state);
  const { match, right } = shownPair(state);
  return statistics === null || match === null ? null : leftOutOf(statistics, filter, match, (right?.length ?? 0) / 3);
}

/** Codes with those of what is left out. */
export function makeListed(): (codes: Uint8Array, out: Uint8Array | null) => Uint8Array {
  return remember((codes, out) => (out === null ? codes : codes.map((code, i) => (out[i] === 1 ? LEFT_OUT : code))));
}

/** The same of matched places that are no points. */
export const listedPlaces = remember((places: Places, out: LeftOut | null): Places => {
  return out === null ? places : { ...places, codes: places.codes.map((code, i) => (out.left[places.lefts[i] ?? -1] === 1 ? LEFT_OUT : code)) };
});
