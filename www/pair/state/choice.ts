/** The matches that an edit would change: those chosen together that are listed, else that of the selected point. */
import { remember } from '../../shared/state/remember';
import { BY_HAND, MATCHED } from './codes';
import { editedPair, leftsByTarget, placeOfLeft, targetOfLeft } from './edited';
import type { Edited } from './edited';
import { keyOfTarget } from './edits';
import type { Sorting } from './edits';
import { leftOut } from './listed';
import type { LeftOut } from './listed';
import { leftIndexOf } from './selected';
import type { Side, State } from './state';
import { say } from '../../shared/text/words';

const NONE: readonly number[] = [];

const leftsOf = remember((edited: Edited, chosen: readonly string[]): readonly number[] => {
  const lefts = leftsByTarget(edited);
  return chosen.flatMap((key) => lefts.get(key) ?? []);
});

/** The left points of the matches that are chosen together. */
export function chosenLefts(state: State): readonly number[] {
  const edited = editedPair(state);
  return edited === null || state.chosen.length === 0 ? NONE : leftsOf(edited, state.chosen);
}

const listedOf = remember((lefts: readonly number[], out: LeftOut | null): readonly number[] =>
  out === null ? lefts : lefts.filter((left) => out.left[left] !== 1),
);

/**
 * The left points of the chosen matches that are listed, which is what an edit of several is about: who filters means what is left, in the list and in
 * the pictures. The choice itself stays, and is whole again without the filter: the half of a limit that is being typed would take it away for good.
 */
function listedLefts(state: State): readonly number[] {
  const lefts = chosenLefts(state);
  return lefts.length === 0 ? lefts : listedOf(lefts, leftOut(state));
}

/** How many matches are chosen together and not listed. */
export function notListed(state: State): number {
  return chosenLefts(state).length - listedLefts(state).length;
}

/** The left points whose matches an edit would change. */
function concerned(state: State, edited: Edited): readonly number[] {
  if (chosenLefts(state).length > 0) return listedLefts(state);
  const left = leftIndexOf(state, edited.match.best, edited.match.rules);
  return left < 0 ? NONE : [left];
}

/** What rejects or restores the chosen matches; null where none of them is there for it. */
export function editOfChoice(state: State, kind: 'reject' | 'restore'): Sorting | null {
  const edited = editedPair(state);
  if (edited === null) return null;
  const rule = kind === 'reject' ? MATCHED : BY_HAND;
  // A place is a list itself, which must stay one.
  const of = concerned(state, edited).flatMap((left) => {
    const target = edited.match.rules[left] === rule ? targetOfLeft(edited, left) : null;
    return target === null ? [] : [target];
  });
  return of.length === 0 ? null : { kind, of };
}

/** Why nothing can be done to matches; empty where there are some. */
export const lackOfMatches = (state: State): string => (editedPair(state) === null ? say('needs-matches') : '');

/** Why nothing can be done to the selected match; empty where a point is selected. */
export const lackOfSelected = (state: State): string => (state.selection === null ? say('no-point-is-selected') : '');

/** Why nothing can be given up; empty where something is begun or chosen. */
export function lackOfBegun({ tool, draft, outline, chosen, selection }: State): string {
  const isAtRest = tool === 'look' && draft === null && outline === null && chosen.length === 0 && selection === null;
  return isAtRest ? say('nothing-is-chosen') : '';
}

/** Why an edit of the chosen matches would do nothing; empty where it does something. */
export const lackOfEdit = (state: State, kind: 'reject' | 'restore'): string => (editOfChoice(state, kind) === null ? say('no-such-match-is-chosen') : '');

/** The keys of the matches of left points; points without one have none. */
export function keysOfLefts(edited: Edited, lefts: Iterable<number>): string[] {
  return [...lefts].flatMap((left) => {
    const target = targetOfLeft(edited, left);
    return target === null ? [] : [keyOfTarget(target)];
  });
}

/** The keys of matches whose point of a side lies in a rectangle of its image. */
export function keysWithin(
  edited: Edited,
  side: Side,
  [left, top, right, bottom]: readonly [number, number, number, number],
  isShown: (left: number) => boolean,
): string[] {
  const inside: number[] = [];
  const first = side === 'left' ? 0 : 2;
  edited.match.rules.forEach((rule, index) => {
    if ((rule !== MATCHED && rule !== BY_HAND) || !isShown(index)) return;
    const place = placeOfLeft(edited, index);
    const [x, y] = [place[first] ?? NaN, place[first + 1] ?? NaN];
    if (x >= left && x <= right && y >= top && y <= bottom) inside.push(index);
  });
  return keysOfLefts(edited, inside);
}

/** The choice with matches added, or taken out where all of them were in it. */
export function toggled(chosen: readonly string[], keys: readonly string[]): string[] {
  const own = new Set(chosen);
  const all = keys.every((key) => own.has(key));
  for (const key of keys) {
    if (all) own.delete(key);
    else own.add(key);
  }
  return [...own];
}
