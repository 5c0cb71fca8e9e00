/** Steps each of which is of one image of the pair: without those of an image, and of exchanged images. */
import { NO_HISTORY } from '../../shared/state/history';
import type { History } from '../../shared/state/history';
import { otherSide } from './state';
import type { Side } from './state';

/** The steps without those of some images, which are no longer there. */
export function withoutSides<S extends { side: Side }>({ edits, done }: History<S>, sides: readonly Side[]): History<S> {
  const stays = ({ side }: S) => !sides.includes(side);
  const all = edits.filter(stays);
  return all.length === 0 ? NO_HISTORY : { edits: all, done: edits.slice(0, done).filter(stays).length };
}

export function exchangedSides<S extends { side: Side }>({ edits, done }: History<S>): History<S> {
  return { edits: edits.map((step) => ({ ...step, side: otherSide(step.side) })), done };
}
