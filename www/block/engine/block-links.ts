/** A block that is placed on an orthophoto, in a worker: its images one after the other, then all of it. */
import { BlockOnOrthophoto, FinishedBlock } from '../../../pkg/wasm/tiepoint.js';
import type { OrthophotoReference, PlacingVerdict } from '../../../pkg/wasm/tiepoint.js';
import { orthoReference } from './orthophoto';
import type { PlaceInput } from './orthophoto';

export interface LinksInput extends Pick<PlaceInput, 'ground' | 'options'> {
  /** The project file of the block. */
  project: Blob;
}

interface Placing {
  block: FinishedBlock;
  links: BlockOnOrthophoto;
  reference: OrthophotoReference;
}

/** The worker ends with the block: nothing of it is freed before. */
let placing: Placing | null = null;

/** Names of the images, null for those that are not oriented; refuses an orthophoto on which none can be sought. */
export async function linksOpen({ project, ground, options }: LinksInput): Promise<(string | null)[]> {
  const reference = await orthoReference({ ground, options });
  const block = FinishedBlock.open(new Uint8Array(await project.arrayBuffer()));
  placing = { block, links: new BlockOnOrthophoto(), reference };
  return block.model().images.map(({ name, pose }) => (pose == null ? null : name));
}

/** Places an image of the block, near where those that were placed before have it. */
export async function linksPlace({ index, file }: { index: number; file: Blob }): Promise<PlacingVerdict | null> {
  const { block, links, reference } = opened();
  return links.place(block, index, new Uint8Array(await file.arrayBuffer()), reference);
}

/** The project file of the block in the system of the orthophoto, or as it was, with the reason. */
export function linksFinish(): Uint8Array<ArrayBuffer> {
  const { block, links, reference } = opened();
  return new TextEncoder().encode(links.linked(block, reference).project());
}

function opened(): Placing {
  if (placing === null) throw new Error('no block is held');
  return placing;
}
