/** Masks between a block and the pairs of it: each opens with those of its images, and what is painted there can be that of the block. */
import { masks_of_images } from '../../shared/crate';
import type { BlockFile } from './file';

/** A mask of an image of the block, as the pair has it. */
export interface PairMask {
  image: string;
  file: Blob;
}

/** The mask of an image, by its name; null for one without. */
export function maskOf(masks: readonly BlockFile[], image: string): BlockFile | null {
  const [index = -1] = masks_of_images(
    [image],
    masks.map(({ name }) => name),
  );
  return masks[index] ?? null;
}

/** Those of a pair that the block has not. */
export function otherMasks(masks: readonly BlockFile[], ofPair: readonly PairMask[]): readonly PairMask[] {
  return ofPair.filter(({ image, file }) => maskOf(masks, image)?.file !== file);
}

/** The masks of a block with these in the place of those of the same images. `newId`: for each of them. */
export function withMasks(masks: readonly BlockFile[], others: readonly PairMask[], newId: () => number): BlockFile[] {
  const former = new Set(others.map(({ image }) => maskOf(masks, image)));
  return [...masks.filter((mask) => !former.has(mask)), ...others.map(({ image, file }) => ({ id: newId(), name: `${image}.png`, file }))];
}
