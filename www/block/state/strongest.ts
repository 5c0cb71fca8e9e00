/** Which two images of a block are worth a look by themselves. */
import { imagesOfBlock } from './state';
import type { BlockState } from './state';
import { matchesOf } from './words';

/** The connected images with most matches, of those whose files are there and that were not rejected as a pair; null where there are none. */
export function strongestPair(state: Pick<BlockState, 'shown' | 'files'>): [number, number] | null {
  const { shown } = state;
  if (shown === null || shown.view.partial) return null;
  const there = new Set(imagesOfBlock(state).map(({ name }) => name));
  const isThere = (image: number) => there.has(shown.view.images[image]?.name ?? '');
  const open = shown.view.connections.filter((connection) => matchesOf(connection) > 0 && !connection.rejected && connection.images.every(isThere));
  const [first, ...others] = open;
  return first === undefined ? null : others.reduce((best, other) => (matchesOf(other) > matchesOf(best) ? other : best), first).images;
}
