/** Edits by hand in their order: those that hold, and those that were undone. */

/** All edits; the first `done` of them hold, the others were undone and can be done again. */
export interface History<E> {
  edits: readonly E[];
  done: number;
}

export const NO_HISTORY: History<never> = { edits: [], done: 0 };

/** The history after one more edit: what was undone before is given up. */
export function recorded<E>({ edits, done }: History<E>, edit: E): History<E> {
  return { edits: [...edits.slice(0, done), edit], done: done + 1 };
}

/** The history with the first `done` edits. */
export function wentTo<E>({ edits }: History<E>, done: number): History<E> {
  return { edits, done: Math.min(edits.length, Math.max(0, done)) };
}

/** The names of the edit that undo takes back, and of the one that redo makes again; null where there is none. */
export function steps<E>({ edits, done }: History<E>, nameOf: (edit: E) => string): { undo: string | null; redo: string | null } {
  const [last, next] = [edits[done - 1], edits[done]];
  return { undo: last === undefined ? null : nameOf(last), redo: next === undefined ? null : nameOf(next) };
}

/** The edits listed about the present state: so many before it and after it. From the first up to and without the last. */
export function inSight({ edits, done }: History<unknown>, reach: number): { from: number; to: number } {
  return { from: Math.max(0, done - reach), to: Math.min(edits.length, done + reach) };
}
