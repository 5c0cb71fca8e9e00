/** GNSS positions of images as their table has them, in place of those that their files record. */
import { positions_of_images } from '../../../pkg/wasm/tiepoint.js';
import type { GeoreferencingOptions, GivenPosition } from '../../../pkg/wasm/tiepoint.js';
import { remember } from '../../shared/state/remember';
import type { BlockFile, BlockState } from './state';

type OfTable = Pick<BlockState, 'files' | 'placing'> & { options: Pick<BlockState['options'], 'settings' | 'positions'> };

/** By the names of the images; none of a table that cannot be read, which is told where it stands. Coordinates in a plane are in the system of the block, or else in that of the orthophoto. */
export function givenPositions({ files, placing: { orthophoto }, options: { settings, positions } }: OfTable): ReadonlyMap<string, GivenPosition> {
  return read(positions?.text ?? null, files, settings?.placing ?? null, orthophoto?.info.epsg ?? null);
}

const NONE: ReadonlyMap<string, GivenPosition> = new Map();

const read = remember(
  (text: string | null, files: readonly BlockFile[], placing: GeoreferencingOptions | null, epsg: number | null): ReadonlyMap<string, GivenPosition> => {
    if (text === null || placing === null) return NONE;
    const names = files.map(({ name }) => name);
    try {
      const crs = placing.crs ?? (epsg === null ? null : `EPSG:${String(epsg)}`);
      const given = positions_of_images(text, names, { ...placing, crs });
      return new Map(names.flatMap((name, index) => (given[index] ? [[name, given[index]]] : [])));
    } catch {
      return NONE;
    }
  },
);
