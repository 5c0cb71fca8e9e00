/** The journal of the edits of a pair, and of pairs that are not on the page. */
import type { Kept } from '../../shared/files/database';
import { doneFrom, Journal as Edits } from '../../shared/files/journal';
import { likeOf, listOf, objectOf } from '../../shared/files/keepable';
import type { History } from '../../shared/state/history';
import type { Edit, Place, Target } from '../state/edits';
import type { State } from '../state/state';
import { say } from '../../shared/text/words';

/** Edits of pairs that are not on the page. */
const SHELF = 'pair/shelf';
/** About what a match takes in an edit, in bytes. */
const OF_MATCH = 40;

export class Journal {
  private readonly edits = new Edits('pair/edits', editFrom, bytesOf);

  /** What is kept of the edits; what has not changed is the same value as before. Nothing where there are none. */
  parts({ history, shelf }: Pick<State, 'history' | 'shelf'>): Map<string, Kept> {
    const parts = this.edits.parts(history);
    if (shelf.size > 0) parts.set(SHELF, { value: shelf, bytes: [...shelf.values()].reduce((sum, other) => sum + this.edits.size(other.edits), 0) });
    return parts;
  }

  /** @throws Error naming what is damaged */
  read(parts: ReadonlyMap<string, unknown>): Pick<State, 'history' | 'shelf'> {
    return { history: this.edits.read(parts), shelf: shelfFrom(parts.get(SHELF)) };
  }
}

function shelfFrom(value: unknown): State['shelf'] {
  if (value === undefined) return new Map();
  if (!(value instanceof Map)) throw new Error(say('the-edits-of-other-pairs'));
  const entry = ([key, kept]: [unknown, unknown]): [string, History<Edit>] => {
    const { edits, done } = objectOf(kept, 'shelf');
    const list = listOf(edits, 'shelf.edits', editFrom);
    return [likeOf(key, '', 'shelf'), { edits: list, done: doneFrom(done, list.length, 'shelf.done') }];
  };
  return new Map([...value].map(entry));
}

function bytesOf(edit: Edit): number {
  return OF_MATCH * (edit.kind === 'reject' || edit.kind === 'restore' ? edit.of.length : 2);
}

/** @throws Error naming the field that is damaged */
function editFrom(value: unknown, name: string): Edit {
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
