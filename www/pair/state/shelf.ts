/** What was done by hand in pairs that are not on the page: a pair that is opened again, as one of a block, has its edits again, and the match that was being measured. */
import { NO_HISTORY } from '../../shared/state/history';
import type { Draft, GivenImage, Side, State, Tool } from './state';

/** A match that is to be measured on, with the tool that measures it; `tool`: where there is none. */
export function measuredOn(draft: Draft | null, tool: Tool): Pick<State, 'draft' | 'tool'> {
  return { draft, tool: draft === null ? tool : 'measure' };
}

/** The same for the same two files, in this order; null where an image is no file. */
function keyOfPair(images: Record<Side, GivenImage | null>): string | null {
  const parts = [images.left, images.right].map((image) => {
    if (image?.source.kind !== 'file') return null;
    const { file } = image.source;
    return [image.name, file.size, file instanceof File ? file.lastModified : 0];
  });
  return parts.includes(null) ? null : JSON.stringify(parts);
}

/** What was done in a pair that leaves goes to the shelf, what was done in the one that comes leaves it. */
export function exchangedPair(state: State, images: State['images']): Pick<State, 'history' | 'draft' | 'tool' | 'shelf'> {
  const [before, next] = [keyOfPair(state.images), keyOfPair(images)];
  const shelf = new Map(state.shelf);
  const { history: left, draft: leaves } = state;
  if (before !== null && (left.edits.length > 0 || leaves !== null)) shelf.set(before, { ...left, draft: leaves });
  const comes = next === null ? undefined : shelf.get(next);
  const history = comes === undefined ? NO_HISTORY : { edits: comes.edits, done: comes.done };
  if (next !== null) shelf.delete(next);
  const same = shelf.size === 0 && state.shelf.size === 0;
  return { history, ...measuredOn(comes?.draft ?? null, state.tool), shelf: same ? state.shelf : shelf };
}
