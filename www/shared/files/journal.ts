/** The journal of edits by hand, kept in pieces: an edit writes the last piece alone. */
import { NO_HISTORY } from '../state/history';
import type { History } from '../state/history';
import type { Kept } from './database';
import { likeOf, listOf, objectOf } from './keepable';

/** Edits of a piece. */
const SIDE = 64;
/** Of what says how many edits there are, in bytes. */
const OF_HEAD = 40;

export class Journal<E> {
  private head: { done: number; pieces: number } = { done: 0, pieces: 0 };
  private pieces: readonly (readonly E[])[] = [];

  constructor(
    /** Of what is kept. */
    private readonly name: string,
    /** Reads an edit. @throws Error naming the field that is damaged */
    private readonly editFrom: (value: unknown, name: string) => E,
    /** About what an edit takes, in bytes. */
    private readonly bytesOf: (edit: E) => number,
  ) {}

  /** What is kept of the edits; what has not changed is the same value as before. Nothing where there are none. */
  parts({ edits, done }: History<E>): Map<string, Kept> {
    const parts = new Map<string, Kept>();
    const pieces = Math.ceil(edits.length / SIDE);
    this.pieces = Array.from({ length: pieces }, (_, i) => same(this.pieces[i], edits, i * SIDE));
    if (this.head.done !== done || this.head.pieces !== pieces) this.head = { done, pieces };
    if (pieces === 0) return parts;
    parts.set(this.name, { value: this.head, bytes: OF_HEAD });
    for (const [i, piece] of this.pieces.entries()) parts.set(`${this.name}/${String(i)}`, { value: piece, bytes: this.size(piece) });
    return parts;
  }

  /** @throws Error naming what is damaged */
  read(parts: ReadonlyMap<string, unknown>): History<E> {
    const value = parts.get(this.name);
    if (value === undefined) return NO_HISTORY;
    const { done, pieces } = objectOf(value, 'edits');
    const list = Array.from({ length: likeOf(pieces, 0, 'edits.pieces') }, (_, i) => parts.get(`${this.name}/${String(i)}`));
    const edits = list.flatMap((piece, i) => listOf(piece, `edits[${String(i)}]`, this.editFrom));
    return { edits, done: doneFrom(done, edits.length, 'edits.done') };
  }

  /** About what some edits take, in bytes. */
  size(edits: readonly E[]): number {
    return edits.reduce((sum, edit) => sum + this.bytesOf(edit), 0);
  }
}

/** How many of some edits hold. @throws Error where that is no number */
export function doneFrom(value: unknown, edits: number, name: string): number {
  return Math.min(edits, Math.max(0, Math.trunc(likeOf(value, 0, name))));
}

/** The piece that begins at an edit; the earlier one where it holds the same edits. */
function same<E>(earlier: readonly E[] | undefined, edits: readonly E[], from: number): readonly E[] {
  const length = Math.min(SIDE, edits.length - from);
  const stays = earlier?.length === length && earlier.every((edit, i) => edit === edits[from + i]);
  return stays ? earlier : edits.slice(from, from + length);
}
