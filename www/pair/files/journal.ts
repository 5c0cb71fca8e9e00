/** The journal of the edits by hand, kept in pieces: an edit writes the last piece alone. */
import type { Kept } from '../../shared/files/database';
import { likeOf, listOf, objectOf } from '../../shared/files/keepable';
import { NO_HISTORY } from '../state/edits';
import type { Edit, History, Place, Target } from '../state/edits';
import type { State } from '../state/state';

const HEAD = 'pair/edits';
const PIECE = 'pair/edits/';
/** Edits of pairs that are not on the page. */
const SHELF = 'pair/shelf';
/** Edits of a piece. */
const SIDE = 64;
/** About what a match takes in an edit, in bytes. */
const OF_MATCH = 40;

export class Journal {
  private head: { done: number; pieces: number } = { done: 0, pieces: 0 };
  private pieces: readonly (readonly Edit[])[] = [];

  /** What is kept of the edits; what has not changed is the same value as before. Nothing where there are none. */
  parts({ history: { edits, done }, shelf }: Pick<State, 'history' | 'shelf'>): Map<string, Kept> {
    const parts = new Map<string, Kept>();
    if (shelf.size > 0) parts.set(SHELF, { value: shelf, bytes: [...shelf.values()].reduce((sum, other) => sum + bytesOf(other.edits), 0) });
    const pieces = Math.ceil(edits.length / SIDE);
    this.pieces = Array.from({ length: pieces }, (_, i) => same(this.pieces[i], edits, i * SIDE));
    if (this.head.done !== done || this.head.pieces !== pieces) this.head = { done, pieces };
    if (pieces === 0) return parts;
    parts.set(HEAD, { value: this.head, bytes: OF_MATCH });
    for (const [i, piece] of this.pieces.entries()) parts.set(PIECE + String(i), { value: piece, bytes: bytesOf(piece) });
    return parts;
  }

  /** @throws Error naming what is damaged */
  read(parts: ReadonlyMap<string, unknown>): Pick<State, 'history' | 'shelf'> {
    return { history: historyFrom(parts), shelf: shelfFrom(parts.get(SHELF)) };
  }
}

function historyFrom(parts: ReadonlyMap<string, unknown>): History {
  const value = parts.get(HEAD);
  if (value === undefined) return NO_HISTORY;
  const { done, pieces } = objectOf(value, 'edits');
  const list = Array.from({ length: likeOf(pieces, 0, 'edits.pieces') }, (_, i) => parts.get(PIECE + String(i)));
  const edits = list.flatMap((piece, i) => listOf(piece, `edits[${String(i)}]`, editFrom));
  return { edits, done: doneFrom(done, edits, 'edits.done') };
}

function doneFrom(value: unknown, edits: readonly Edit[], name: string): number {
  return Math.min(edits.length, Math.max(0, Math.trunc(likeOf(value, 0, name))));
}

function shelfFrom(value: unknown): State['shelf'] {
  if (value === undefined) return new Map();
  if (!(value instanceof Map)) throw new Error('the edits of other pairs are damaged');
  const entry = ([key, kept]: [unknown, unknown]): [string, History] => {
    const { edits, done } = objectOf(kept, 'shelf');
    const list = listOf(edits, 'shelf.edits', editFrom);
    return [likeOf(key, '', 'shelf'), { edits: list, done: doneFrom(done, list, 'shelf.done') }];
  };
  return new Map([...value].map(entry));
}

/** The piece that begins at an edit; the earlier one where it holds the same edits. */
function same(earlier: readonly Edit[] | undefined, edits: readonly Edit[], from: number): readonly Edit[] {
  const length = Math.min(SIDE, edits.length - from);
  const stays = earlier?.length === length && earlier.every((edit, i) => edit === edits[from + i]);
  return stays ? earlier : edits.slice(from, from + length);
}

function bytesOf(piece: readonly Edit[]): number {
  return piece.reduce((sum, edit) => sum + OF_MATCH * (edit.kind === 'reject' || edit.kind === 'restore' ? edit.of.length : 2), 0);
}

/** @throws Error naming the field that is damaged */
function editFrom(value: unknown, name: string): Edit {
  const edit = objectOf(value, name);
  const kind: string = likeOf<string>(edit['kind'], '', `${name}.kind`);
  switch (kind) {
    case 'reject':
    case 'restore':
      return { kind, of: listOf(edit['of'], `${name}.of`, targetFrom) };
    case 'add':
      return { kind, id: likeOf(edit['id'], 0, `${name}.id`), at: placeFrom(edit['at'], `${name}.at`) };
    case 'move':
      return { kind, of: targetFrom(edit['of'], `${name}.of`), to: placeFrom(edit['to'], `${name}.to`) };
    default:
      throw new Error(`the field ${name}.kind is damaged`);
  }
}

function targetFrom(value: unknown, name: string): Target {
  return typeof value === 'number' ? likeOf(value, 0, name) : placeFrom(value, name);
}

function placeFrom(value: unknown, name: string): Place {
  const [xl = NaN, yl = NaN, xr = NaN, yr = NaN, ...more] = listOf(value, name, (number, at) => likeOf(number, 0, at));
  if (more.length > 0 || [xl, yl, xr, yr].some(Number.isNaN)) throw new Error(`the field ${name} is damaged`);
  return [xl, yl, xr, yr];
}
