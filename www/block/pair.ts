/** From a pair of the block to the pair's part of the page, and back. */
import type { Engine } from '../pair/engine/engine';
import type { CameraMm } from '../shared/crate';
import type { Modes } from '../shared/state/mode';
import { SIDES } from '../pair/state/state';
import type { GivenImage, Side } from '../pair/state/state';
import type { Store } from '../pair/state/store';
import { cameraOfImages } from './state/pair-camera';
import type { BlockFile } from './state/state';
import type { BlockStore } from './engine/engine';
import { say } from '../shared/text/words';
import { messageOf } from '../shared/text/messages';

/** The pair's own images count up from 1: those of blocks count down. */
let nextId = -1;

/** Opens both images with the strategy that the block used; where one cannot be opened the block stays. */
export async function openPair(block: BlockStore, modes: Modes, store: Store, engine: Engine, [a, b]: [number, number]): Promise<void> {
  const { shown } = block.state;
  if (shown === null) return;
  const files = [a, b].map((image) => fileOf(block, shown.view.images[image]?.name));
  const [left, right] = files;
  if (left === undefined || right === undefined) {
    tell(block, say('the-files-of-these-images'));
    return;
  }
  const images: Record<Side, GivenImage> = { left: given(left), right: given(right) };
  let camera: CameraMm | null;
  try {
    camera = cameraOfImages(shown.view, a, b);
    await Promise.all([engine.open('left', images.left), engine.open('right', images.right)]);
  } catch (error) {
    tell(block, say('the-pair-cannot-be-shown', { error: messageOf(error) }));
    return;
  }
  readyFor(store, block, camera);
  store.dispatch({ type: 'images', images });
  block.dispatch({ type: 'openedPair', images: [a, b] });
  modes.dispatch('pair');
}

/** The block's settings of features and its camera, in place of whatever the pair before had. */
function readyFor(store: Store, block: BlockStore, camera: CameraMm | null): void {
  const { settings } = store.state;
  const features = block.state.options.settings?.features;
  if (settings !== null && features !== undefined) {
    const { points, matching } = settings;
    store.dispatch({
      type: 'settings',
      settings: { ...settings, ...features, points: { ...points, operator: null }, matching: { ...matching, strategy: 'gradient' } },
    });
  }
  store.dispatch({ type: 'camera', camera });
  store.dispatch({ type: 'offset', offset: null });
  for (const side of SIDES) {
    store.dispatch({ type: 'photo', side, photo: { fiducials: [], origin: null } });
    store.dispatch({ type: 'mask', side, mask: null });
  }
}

function fileOf(block: BlockStore, name: string | undefined): BlockFile | undefined {
  const { shown, files } = block.state;
  return [...(shown?.files ?? []), ...files].find((file) => file.name === name);
}

function given({ name, file }: BlockFile): GivenImage {
  return { id: nextId--, name, source: { kind: 'file', file } };
}

function tell(block: BlockStore, text: string): void {
  block.dispatch({ type: 'notice', notice: { kind: 'problem', text } });
}
