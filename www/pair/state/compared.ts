/** What the latest edit did to the orientation. */
import type { OrientedPair } from '../../shared/crate';
import { isCurrent, runKey } from './keys';
import { whyNone } from './no-orientation';
import type { State } from './state';

export interface Compared {
  before: OrientedPair;
  /** Null while it is on its way, and where none will come. */
  now: OrientedPair | null;
  comes: boolean;
}

/** Null where nothing was edited, and where the orientation before the edit is of another run: what settings changed would be taken for the edit's doing. */
export function comparedEdit(state: State): Compared | null {
  const { before, history, results } = state;
  if (history.edits.length === 0 || before === null || before.run !== runKey(state)) return null;
  const now = isCurrent(state, 'orientation') ? (results.orientation?.value ?? null) : null;
  return { before: before.orientation, now, comes: now === null && whyNone(state) === null };
}
