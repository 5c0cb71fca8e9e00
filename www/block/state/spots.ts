/** Where the images of a block show its places of an orthophoto, as another block numbers these images. Pure. */
import type { BlockPlaces } from '../../../pkg/wasm/tiepoint.js';
import type { BlockView } from './view';

/** The same places in the images that the other block has, by their names; one that none of them shows is seen nowhere. `images`: those of the other block. */
export function amongImages(before: BlockPlaces, images: readonly Pick<BlockView['images'][number], 'name'>[]): BlockPlaces {
  const names = images.map(({ name }) => name);
  const indices = new Map(names.map((name, index) => [name, index]));
  const places = before.places.map(({ seen }) => ({
    seen: seen.flatMap((one) => {
      const image = indices.get(before.images[one.image] ?? '');
      return image === undefined ? [] : [{ ...one, image }];
    }),
  }));
  return { ...before, images: names, places };
}
