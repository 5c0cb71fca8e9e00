/** From a pair of the block to the pair's part of the page, and back. */
import type { Engine } from '../engine/engine';
import type { GivenImage, Side } from '../state/state';
import type { Store } from '../state/store';
import type { BlockFile } from './calls';
import type { BlockStore } from './engine';

/** The pair's own images count up from 1: those of blocks count down. */
let nextId = -1;

/** Opens both images with the strategy that the block used; where one cannot be opened the block stays. */
export async function openPair(block: BlockStore, store: Store, engine: Engine, [a, b]: [number, number]): Promise<void> {
  const { shown } = block.state;
  if (shown === null) return;
  const files = [a, b].map((image) => fileOf(block, shown.view.images[image]?.name));
  const [left, right] = files;
  if (left === undefined || right === undefined) {
    say(block, 'The files of these images are not open: drop them, and try again.');
    return;
  }
  const images: Record<Side, GivenImage> = { left: given(left), right: given(right) };
  try {
    await Promise.all([engine.open('left', images.left), engine.open('right', images.right)]);
  } catch (error) {
    say(block, `The pair cannot be shown: ${error instanceof Error ? error.message : String(error)}.`);
    return;
  }
  store.dispatch({ type: 'images', images });
  block.dispatch({ type: 'openedPair', images: [a, b] });
  block.dispatch({ type: 'mode', mode: 'pair' });
}

function fileOf(block: BlockStore, name: string | undefined): BlockFile | undefined {
  const { shown, files } = block.state;
  return [...(shown?.files ?? []), ...files].find((file) => file.name === name);
}

function given({ name, file }: BlockFile): GivenImage {
  return { id: nextId--, name, source: { kind: 'file', file } };
}

function say(block: BlockStore, text: string): void {
  block.dispatch({ type: 'notice', notice: { kind: 'problem', text } });
}
