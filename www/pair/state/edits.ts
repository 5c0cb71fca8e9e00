/** Edits of the matches by hand: records of what was done to which match, and what stands after some of them. */
import { NO_HISTORY } from '../../shared/state/history';
import type { History } from '../../shared/state/history';
import { remember } from '../../shared/state/remember';
import { say } from '../../shared/text/words';

/** Where a match lies: x and y in the left, x and y in the right image, px. */
export type Place = readonly [xLeft: number, yLeft: number, xRight: number, yRight: number];

/** A match that an edit is about: by the place where the matching found it, or by the number that it got when it was measured by hand. */
export type Target = Place | number;

/** Matches are taken out of the orientation, or used again. */
export interface Sorting {
  kind: 'reject' | 'restore';
  of: readonly Target[];
}

export type Edit = Sorting | { kind: 'add'; id: number; at: Place } | { kind: 'move'; of: Target; to: Place };

/** What stands after the edits: by the keys of their targets. */
export interface Standing {
  rejected: ReadonlyMap<string, Target>;
  /** Matches whose place was measured by hand. */
  placed: ReadonlyMap<string, { target: Target; at: Place }>;
}

const NOTHING: Standing = { rejected: new Map(), placed: new Map() };

/** Keys that were made: an edit of many matches is looked at again and again. */
const keys = new WeakMap<Place, string>();

export function keyOfTarget(target: Target): string {
  if (typeof target === 'number') return `#${String(target)}`;
  const key = keys.get(target) ?? target.join(' ');
  keys.set(target, key);
  return key;
}

/** Of each list of edits what stood after so many of them when it was asked last. */
const stood = new WeakMap<readonly Edit[], { done: number; standing: Standing }>();

/** What stands after the edits that hold: the same object each time, whatever else is asked between, as of the pair without its edits. */
export function standingOf(edits: readonly Edit[], done: number): Standing {
  if (done === 0) return NOTHING;
  const known = stood.get(edits);
  if (known?.done === done) return known.standing;
  const standing = after(edits.slice(0, done));
  stood.set(edits, { done, standing });
  return standing;
}

function after(edits: readonly Edit[]): Standing {
  const rejected = new Map<string, Target>();
  const placed = new Map<string, { target: Target; at: Place }>();
  for (const edit of edits) {
    switch (edit.kind) {
      case 'reject':
        for (const target of edit.of) rejected.set(keyOfTarget(target), target);
        break;
      case 'restore':
        for (const target of edit.of) rejected.delete(keyOfTarget(target));
        break;
      case 'add':
        placed.set(keyOfTarget(edit.id), { target: edit.id, at: edit.at });
        break;
      case 'move':
        placed.set(keyOfTarget(edit.of), { target: edit.of, at: edit.to });
    }
  }
  return rejected.size === 0 && placed.size === 0 ? NOTHING : { rejected, placed };
}

/** All places that matches were given by hand, in their order, by the keys of their targets; undone ones too. */
export const placesByHand = remember((edits: readonly Edit[]): ReadonlyMap<string, readonly Place[]> => {
  const places = new Map<string, Place[]>();
  for (const edit of edits) {
    if (edit.kind !== 'add' && edit.kind !== 'move') continue;
    const [target, place] = edit.kind === 'add' ? [edit.id, edit.at] : [edit.of, edit.to];
    const key = keyOfTarget(target);
    places.set(key, [...(places.get(key) ?? []), place]);
  }
  return places;
});

export function isNothing({ rejected, placed }: Standing): boolean {
  return rejected.size === 0 && placed.size === 0;
}

/** A number that no match measured by hand has yet. */
export function freshNumber({ edits }: History<Edit>): number {
  return edits.reduce((most, edit) => (edit.kind === 'add' ? Math.max(most, edit.id) : most), 0) + 1;
}

/** What an edit did, as in "Undo: reject 14 matches". */
export function nameOfEdit(edit: Edit): string {
  switch (edit.kind) {
    case 'reject':
    case 'restore':
      return say('step-matches', { kind: edit.kind, matches: edit.of.length });
    case 'add':
      return say('step-add-match');
    case 'move':
      return say('step-move-match');
  }
}

const exchangedPlace = ([xl, yl, xr, yr]: Place): Place => [xr, yr, xl, yl];

/** The match of exchanged images that an edit is about. */
export function exchangedTarget(of: Target): Target {
  return typeof of === 'number' ? of : exchangedPlace(of);
}

/** The edits of exchanged images. */
export function exchanged({ edits, done }: History<Edit>): History<Edit> {
  if (edits.length === 0) return NO_HISTORY;
  const other = (edit: Edit): Edit => {
    switch (edit.kind) {
      case 'reject':
      case 'restore':
        return { kind: edit.kind, of: edit.of.map(exchangedTarget) };
      case 'add':
        return { ...edit, at: exchangedPlace(edit.at) };
      case 'move':
        return { kind: 'move', of: exchangedTarget(edit.of), to: exchangedPlace(edit.to) };
    }
  };
  return { edits: edits.map(other), done };
}
