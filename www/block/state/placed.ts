/** What came of images on an orthophoto, beside what would come of them now. */
import { remember } from '../../shared/state/remember';
import type { Placed } from './placing';
import type { BlockFile, BlockState } from './state';

/** Names what placing an image now would be made from. */
export function placingKey({
  placing: { orthophoto, heights, options },
  options: { cameras },
}: {
  placing: BlockState['placing'];
  options: Pick<BlockState['options'], 'cameras'>;
}): string {
  const ground = heights.kind === 'level' ? heights.height : `file ${String(heights.model.id)}`;
  return JSON.stringify([orthophoto?.raster.id ?? null, ground, options, cameras]);
}

/** An image with what came of it. */
export interface PlacedFile extends Placed {
  file: BlockFile;
  /** Other settings, heights or cameras made it. */
  isStale: boolean;
}

/** The images that were tried, in their order; the same list while nothing of it has changed. */
export function placedFiles(state: Pick<BlockState, 'placing' | 'options' | 'files'>): readonly PlacedFile[] {
  return listed(state.files, state.placing.placed, placingKey(state));
}

const listed = remember((files: readonly BlockFile[], all: ReadonlyMap<number, Placed>, key: string): readonly PlacedFile[] =>
  files.flatMap((file): PlacedFile[] => {
    const placed = all.get(file.id);
    return placed === undefined ? [] : [{ ...placed, file, isStale: placed.key !== key }];
  }),
);

/** The images that are not placed yet, or by other settings. */
export function unplacedFiles(state: Pick<BlockState, 'placing' | 'options' | 'files'>): readonly BlockFile[] {
  const key = placingKey(state);
  return state.files.filter(({ id }) => state.placing.placed.get(id)?.key !== key);
}
