/** Edits of a pair, and the match that is being measured, as the browser keeps them. */
import { likeOf, listOf, objectOf, orNull, positionFrom } from '../../shared/files/keepable';
import { say } from '../../shared/text/words';
import type { Edit, Place, Target } from '../state/edits';
import type { Draft, Side } from '../state/state';

/** About what a match takes in an edit, in bytes. */
export const OF_MATCH = 40;

/** About what an edit takes, in bytes. */
export function bytesOf(edit: Edit): number {
  return OF_MATCH * (edit.kind === 'reject' || edit.kind === 'restore' ? edit.of.length : 2);
}

/** @throws Error naming the field that is damaged */
export function editFrom(value: unknown, name: string): Edit {
  const edit = objectOf(value, name);
  const kind: string = likeOf<string>(edit.kind, '', `${name}.kind`);
  switch (kind) {
    case 'reject':
    case 'restore':
      return { kind, of: listOf(edit.of, `${name}.of`, targetFrom) };
    case 'add':
      return { kind, id: likeOf(edit.id, 0, `${name}.id`), at: placeFrom(edit.at, `${name}.at`) };
    case 'move':
      return { kind, of: targetFrom(edit.of, `${name}.of`), to: placeFrom(edit.to, `${name}.to`) };
    default:
      throw new Error(say('the-field-kind-is-damaged', { name }));
  }
}

function targetFrom(value: unknown, name: string): Target {
  return typeof value === 'number' ? likeOf(value, 0, name) : placeFrom(value, name);
}

function placeFrom(value: unknown, name: string): Place {
  const [xl = NaN, yl = NaN, xr = NaN, yr = NaN, ...more] = listOf(value, name, (number, at) => likeOf(number, 0, at));
  if (more.length > 0 || [xl, yl, xr, yr].some(Number.isNaN)) throw new Error(say('the-field-is-damaged', { name }));
  return [xl, yl, xr, yr];
}

/** @throws Error naming the field that is damaged */
export function draftFrom(value: unknown, name: string): Draft {
  const { of, places, side } = objectOf(value, name);
  const { left, right } = objectOf(places, `${name}.places`);
  const placed = (at: unknown, own: Side) => orNull(at, (given) => positionFrom(given, `${name}.places.${own}`));
  if (side !== 'left' && side !== 'right') throw new Error(say('the-field-is-damaged', { name: `${name}.side` }));
  return {
    of: orNull(of, (given) => targetFrom(given, `${name}.of`)),
    places: { left: placed(left, 'left'), right: placed(right, 'right') },
    side,
  };
}
