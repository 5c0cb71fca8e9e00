/** What came of images on an orthophoto, beside what would come of them now. */
import { remember } from '../../shared/state/remember';
import type { GivenPosition } from '../../../pkg/wasm/tiepoint.js';
import { filmOf } from './film';
import type { FilmTexts, GivenFilm } from './film';
import { givenPositions } from './given-positions';
import type { Placed } from './placing';
import type { BlockFile, BlockState } from './state';

type Placing = Pick<BlockState, 'placing' | 'options' | 'files'>;

/** Names what placing images now would be made from, whatever is known of each. */
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

/** What is given of single images, by their names. */
export interface GivenOfImages {
  film: GivenFilm;
  positions: ReadonlyMap<string, GivenPosition>;
}

/** The same of one image, by its name: with the position that a table has of it and, of a scan of film, its camera and marks. */
export function placingKeyOf(key: string, { film, positions }: GivenOfImages, image: string): string {
  return keyWith(key, filmOf(film, image), positions.get(image) ?? null);
}

/** With what is given of one image; null: nothing. */
export function keyWith(key: string, film: FilmTexts | null, position: GivenPosition | null): string {
  return film === null && position === null ? key : JSON.stringify([key, film, position]);
}

/** An image with what came of it. */
export interface PlacedFile extends Placed {
  file: BlockFile;
  /** Other settings, heights or cameras made it. */
  isStale: boolean;
}

/** The images that were tried, in their order; the same list while nothing of it has changed. */
export function placedFiles(state: Placing): readonly PlacedFile[] {
  return listed(state.files, state.placing.placed, placingKey(state), state.placing.film, givenPositions(state));
}

const listed = remember(
  (files: readonly BlockFile[], all: ReadonlyMap<number, Placed>, key: string, film: GivenFilm, positions: GivenOfImages['positions']): readonly PlacedFile[] =>
    files.flatMap((file): PlacedFile[] => {
      const placed = all.get(file.id);
      return placed === undefined ? [] : [{ ...placed, file, isStale: placed.key !== placingKeyOf(key, { film, positions }, file.name) }];
    }),
);

/** The images that are not placed yet, or by other settings. */
export function unplacedFiles(state: Placing): readonly BlockFile[] {
  const key = placingKey(state);
  const given = { film: state.placing.film, positions: givenPositions(state) };
  return state.files.filter(({ id, name }) => state.placing.placed.get(id)?.key !== placingKeyOf(key, given, name));
}
