/** Edits of pairs that are not on the page: a pair that is opened again, as one of a block, has its edits again. */
import { NO_HISTORY } from '../../shared/state/history';
import type { History } from '../../shared/state/history';
import type { Edit } from './edits';
import type { GivenImage, Side, State } from './state';

export type Shelf = ReadonlyMap<string, History<Edit>>;

/** The same for the same two files, in this order; null where an image is no file. */
function keyOfPair(images: Record<Side, GivenImage | null>): string | null {
  const parts = [images.left, images.right].map((image) => {
    if (image?.source.kind !== 'file') return null;
    const { file } = image.source;
    return [image.name, file.size, file instanceof File ? file.lastModified : 0];
  });
  return parts.includes(null) ? null : JSON.stringify(parts);
}

/** The edits of a pair that leaves go to the shelf, those of the one that comes leave it. */
export function exchangedPair(state: State, images: State['images']): Pick<State, 'history' | 'shelf'> {
  const [before, next] = [keyOfPair(state.images), keyOfPair(images)];
  const shelf = new Map(state.shelf);
  if (before !== null && state.history.edits.length > 0) shelf.set(before, state.history);
  const history = (next === null ? undefined : shelf.get(next)) ?? NO_HISTORY;
  if (next !== null) shelf.delete(next);
  const same = shelf.size === 0 && state.shelf.size === 0;
  return { history, shelf: same ? state.shelf : shelf };
}
