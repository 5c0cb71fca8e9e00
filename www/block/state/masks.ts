/** Masks between a block and the pairs of it: each opens with those of its images, and what is painted there can be that of the block. */
import { masks_of_images } from '../../shared/crate';
import type { BlockFile } from './file';
import { isLacking } from './lacking';

/** A mask of an image of the block, as the pair has it; null where it was taken away. */
export interface PairMask {
  image: string;
  file: Blob | null;
}

/** The mask of an image, by its name; null for one without. */
export function maskOf(masks: readonly BlockFile[], image: string): BlockFile | null {
  const [index = -1] = masks_of_images(
    [image],
    masks.map(({ name }) => name),
  );
  return masks[index] ?? null;
}

/** What a pair has other than the block. One that a project file names and does not hold the pair never had. */
export function otherMasks(masks: readonly BlockFile[], ofPair: readonly PairMask[]): readonly PairMask[] {
  return ofPair.filter(({ image, file }) => {
    const own = maskOf(masks, image);
    return file === null ? own !== null && !isLacking(own) : own?.file !== file;
  });
}

/** The masks of a block with these in the place of those of the same images. `newId`: for each of them. */
export function withMasks(masks: readonly BlockFile[], others: readonly PairMask[], newId: () => number): BlockFile[] {
  const former = new Set(others.map(({ image }) => maskOf(masks, image)));
  const given = others.flatMap(({ image, file }) => (file === null ? [] : [{ id: newId(), name: `${image}.png`, file }]));
  return [...masks.filter((mask) => !former.has(mask)), ...given];
}
