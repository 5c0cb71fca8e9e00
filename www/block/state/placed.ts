/** What came of images on an orthophoto, beside what would come of them now. */
import { remember } from '../../shared/state/remember';
import { filmOf } from './film';
import type { GivenFilm } from './film';
import type { Placed } from './placing';
import type { BlockFile, BlockState } from './state';

/** Names what placing images now would be made from, whatever is known of each. */
export function placingKey({
  placing: { orthophoto, heights, options },
  options: { cameras, positions },
}: {
  placing: BlockState['placing'];
  options: Pick<BlockState['options'], 'cameras' | 'positions'>;
}): string {
  const ground = heights.kind === 'level' ? heights.height : `file ${String(heights.model.id)}`;
  return JSON.stringify([orthophoto?.raster.id ?? null, ground, options, cameras, ...(positions === null ? [] : [positions])]);
}

/** The same of one image, by its name: of a scan of film its camera and marks, too. */
export function placingKeyOf(key: string, film: GivenFilm, image: string): string {
  const own = filmOf(film, image);
  return own === null ? key : JSON.stringify([key, own]);
}

/** An image with what came of it. */
export interface PlacedFile extends Placed {
  file: BlockFile;
  /** Other settings, heights or cameras made it. */
  isStale: boolean;
}

/** The images that were tried, in their order; the same list while nothing of it has changed. */
export function placedFiles(state: Pick<BlockState, 'placing' | 'options' | 'files'>): readonly PlacedFile[] {
  return listed(state.files, state.placing.placed, placingKey(state), state.placing.film);
}

const listed = remember((files: readonly BlockFile[], all: ReadonlyMap<number, Placed>, key: string, film: GivenFilm): readonly PlacedFile[] =>
  files.flatMap((file): PlacedFile[] => {
    const placed = all.get(file.id);
    return placed === undefined ? [] : [{ ...placed, file, isStale: placed.key !== placingKeyOf(key, film, file.name) }];
  }),
);

/** The images that are not placed yet, or by other settings. */
export function unplacedFiles(state: Pick<BlockState, 'placing' | 'options' | 'files'>): readonly BlockFile[] {
  const key = placingKey(state);
  return state.files.filter(({ id, name }) => state.placing.placed.get(id)?.key !== placingKeyOf(key, state.placing.film, name));
}
