/** An image that is chosen in a view of the block is chosen on the orthophoto too, where it is placed there, and the other way round. Pure. */
import { NOTHING_LOOKED_AT, reducePlacing } from './placing';
import type { Placing } from './placing';
import { imagesOf, reduceSelection } from './selection';
import type { Selection } from './selection';
import type { BlockState } from './state';

/** The state after a choice in one of them, with the other one after it. */
export function together(before: BlockState, after: BlockState): BlockState {
  if (after.shown === null || after.placing.placed.size === 0) return after;
  const [was, is] = [before.selection.chosen, after.selection.chosen];
  if (is !== was) return { ...after, placing: placedAfter(after, before) };
  if (after.placing.chosen.image !== before.placing.chosen.image) return { ...after, selection: selectedAfter(after, before) };
  return after;
}

function placedAfter({ selection: { chosen }, ...after }: BlockState, before: BlockState): Placing {
  const { placing } = after;
  const id = chosen?.kind === 'image' || chosen?.kind === 'observation' ? fileOf(after, chosen.image) : null;
  if (id !== null && placing.placed.has(id))
    return id === placing.chosen.image ? placing : reducePlacing(placing, { type: 'choosePlaced', looked: { image: id, link: null } });
  const leaves = chosen === null && imagesOf(before.selection.chosen).some((image) => fileOf(after, image) === placing.chosen.image);
  return leaves ? reducePlacing(placing, { type: 'choosePlaced', looked: NOTHING_LOOKED_AT }) : placing;
}

function selectedAfter({ selection, placing, ...after }: BlockState, before: BlockState): Selection {
  const { chosen } = selection;
  const now = imageOf(after, placing.chosen.image);
  if (now !== null) return imagesOf(chosen).includes(now) ? selection : reduceSelection(selection, { type: 'choose', choice: { kind: 'image', image: now } });
  const former = imageOf(after, before.placing.chosen.image);
  return chosen?.kind === 'image' && chosen.image === former ? reduceSelection(selection, { type: 'choose', choice: null }) : selection;
}

type Images = Pick<BlockState, 'shown' | 'files'>;

/** The number of the file of an image of the block; null where it is not given. */
function fileOf({ shown, files }: Images, image: number): number | null {
  const name = shown?.view.images[image]?.name;
  return files.find((file) => file.name === name)?.id ?? null;
}

/** The image of the block that a file is; null where it is none. */
function imageOf({ shown, files }: Images, id: number | null): number | null {
  const name = files.find((file) => file.id === id)?.name;
  const image = shown?.view.images.findIndex((own) => own.name === name) ?? -1;
  return image < 0 ? null : image;
}
