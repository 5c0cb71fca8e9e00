/** Images that were taken out of a block: they stay beside it, and come back when that is undone. Pure. */
import type { History } from '../../shared/state/history';
import { remember } from '../../shared/state/remember';
import type { BlockFile } from './file';
import type { MarkStep } from './marks';
import { imagesOf } from './selection';
import type { Choice } from './selection';

/** So few images are no block any more. */
const LEAST_IMAGES = 2;

export interface WithRemoved {
  /** The images of the block, by their names. */
  files: readonly BlockFile[];
  /** Those that were taken out. */
  removed: readonly BlockFile[];
  marks: History<MarkStep>;
}

const idsRemoved = remember(
  ({ edits, done }: History<MarkStep>): ReadonlySet<number> =>
    new Set(edits.slice(0, done).flatMap((step) => (step.kind === 'remove_images' ? step.files : []))),
);

/** Whether other images are out by one history than by another. */
export function removesOthers(before: History<MarkStep>, after: History<MarkStep>): boolean {
  const [a, b] = [idsRemoved(before), idsRemoved(after)];
  return a.size !== b.size || [...a].some((id) => !b.has(id));
}

/** The images as the history has them; the same lists where nothing of them changes. An image that was given meanwhile keeps its name. */
export function withRemoved<S extends WithRemoved>(state: S): S {
  const { files, removed, marks } = state;
  const out = idsRemoved(marks);
  const stay = files.filter(({ id }) => !out.has(id));
  const names = new Set(stay.map(({ name }) => name));
  const back = removed.filter(({ id, name }) => !out.has(id) && !names.has(name));
  if (stay.length === files.length && back.length === 0) return state;
  const aside = [...files.filter(({ id }) => out.has(id)), ...removed.filter((file) => !back.includes(file))];
  return { ...state, files: [...stay, ...back].sort((a, b) => (a.name < b.name ? -1 : 1)), removed: aside };
}

/** The files of the images that are chosen, which can be taken out; none where a file is not there, or too few would be left. */
export function removable(files: readonly BlockFile[], choice: Choice | null, names: readonly { name: string }[]): readonly BlockFile[] {
  if (choice?.kind !== 'image' && choice?.kind !== 'images') return [];
  return removableFiles(files, new Set(imagesOf(choice).map((image) => names[image]?.name ?? '')));
}

/** The files of these names, which can be taken out; none where one is not there, or too few would be left. */
export function removableFiles(files: readonly BlockFile[], names: ReadonlySet<string>): readonly BlockFile[] {
  const found = files.filter(({ name }) => names.has(name));
  return found.length === names.size && files.length - found.length >= LEAST_IMAGES ? found : [];
}
