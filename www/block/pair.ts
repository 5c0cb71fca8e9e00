/** From a pair of the block to the pair's part of the page, and back. */
import type { Engine } from '../pair/engine/engine';
import type { CameraMm, Fiducial } from '../shared/crate';
import { doHere } from '../shared/files/leaving';
import type { Here } from '../shared/files/leaving';
import type { Modes } from '../shared/state/mode';
import { remember } from '../shared/state/remember';
import { hasData, isWorthKeeping } from '../pair/state/kept';
import { BY_HAND } from '../pair/state/codes';
import { placeOfLeft, targetOfLeft } from '../pair/state/edited';
import type { Edited } from '../pair/state/edited';
import { isNothing, placesByHand, standingOf } from '../pair/state/edits';
import type { Standing } from '../pair/state/edits';
import { shownPair } from '../pair/state/select';
import { SIDES } from '../pair/state/state';
import { MASK_SIDE } from '../pair/files/beside';
import type { GivenImage, GivenMask, Side, State } from '../pair/state/state';
import type { Store } from '../pair/state/store';
import { isLacking } from './state/lacking';
import { cameraOfImages } from './state/pair-camera';
import { maskOf } from './state/masks';
import type { PairMask } from './state/masks';
import type { MatchPlace, PairMatches } from './state/pair-matches';
import type { BlockFile } from './state/state';
import type { BlockStore } from './engine/engine';
import { titleOf } from '../shared/text/project';
import { say } from '../shared/text/words';
import { messageOf } from '../shared/text/messages';

/** The pair's own images count up from 1: those of blocks count down. */
let nextId = -1;

/** What the user gives a pair by hand, as a pair of a block had it when it was opened: of that nothing is lost to the next one. */
type Given = Pick<State, 'camera' | 'offset' | 'photos' | 'masks'>;

const GIVEN_PARTS = ['camera', 'offset', 'photos', 'masks'] as const;

let given: Given | null = null;

/** From now on nothing that the pair has by hand is lost to the next one. */
export function isAsGiven({ camera, offset, photos, masks }: Given): void {
  given = { camera, offset, photos, masks };
}

/** Whether the pair on the page has what the next one would take away. Edits of its matches are kept by themselves; a simulated pair has its fiducial marks again. */
function isOwn(state: State): boolean {
  const before = given;
  if (before !== null && GIVEN_PARTS.every((part) => state[part] === before[part])) return false;
  const { photos, masks, truth } = state;
  return isWorthKeeping(state) || SIDES.some((side) => masks[side] !== null || (truth === null && hasData(photos[side])));
}

/** Leaves the pair on the page in the list of projects; its title where it is there now, null where it cannot be and the user keeps it. */
async function leave(block: BlockStore, state: State, putAside: () => Promise<boolean>, here: Here): Promise<string | null> {
  block.dispatch({ type: 'notice', notice: { kind: 'busy', text: say('keeping-the-pair') } });
  const stays = await putAside();
  here();
  block.dispatch({ type: 'notice', notice: null });
  if (stays) return titleOf({ name: null, images: SIDES.flatMap((side) => state.images[side]?.name ?? []) });
  return window.confirm(say('cannot-be-kept-in-this', { edits: say('the-pair-with-its-marks'), step: say('open-the-pair-of-the-block'), length: 1 }))
    ? ''
    : null;
}

export interface Pair {
  store: Store;
  engine: Engine;
}

export interface Projects {
  /** Leaves the pair on the page in the list of projects; false where it cannot be. */
  putAside: () => Promise<boolean>;
  /** Waits for the project that is being left: a pair is opened of the block that is shown now. */
  stays: () => Promise<Here>;
}

/** Opens both images with the strategy that the block used; where one cannot be opened the block stays. A pair that the user worked on stays in the list of projects. */
export function openPair(block: BlockStore, modes: Modes, pair: Pair, { putAside, stays }: Projects, images: [number, number]): Promise<void> {
  return doHere(stays, (here) => opened(block, modes, pair, putAside, images, here));
}

async function opened(block: BlockStore, modes: Modes, pair: Pair, putAside: () => Promise<boolean>, [a, b]: [number, number], here: Here): Promise<void> {
  const { shown } = block.state;
  if (shown === null) return;
  const files = [a, b].map((image) => fileOf(block, shown.view.images[image]?.name));
  const [left, right] = files;
  if (left === undefined || right === undefined) {
    tell(block, modes, say('the-files-of-these-images'));
    return;
  }
  await showFiles(block, modes, pair, putAside, { left, right, camera: () => cameraOfImages(shown.view, a, b), opened: [a, b] }, here);
}

/** What is shown in place of the pair on the page. */
interface ToShow {
  left: BlockFile;
  /** Null: one image alone. */
  right: BlockFile | null;
  camera: () => CameraMm | null;
  /** The marks of a side, which are measured before the images are matched. */
  marks?: (side: Side) => Fiducial[];
  /** The pair of the block that these are. */
  opened: [number, number] | null;
}

/** Shows images of the block; false where they cannot be opened, or the user keeps the pair that is there. */
export async function showFiles(
  block: BlockStore,
  modes: Modes,
  { store, engine }: Pair,
  putAside: () => Promise<boolean>,
  { left, right, camera: cameraOf, marks, opened: ofBlock }: ToShow,
  here: Here,
): Promise<boolean> {
  const images: Record<Side, GivenImage | null> = { left: imageOf(left), right: right && imageOf(right) };
  let camera: CameraMm | null;
  let masks: Record<Side, GivenMask | null>;
  try {
    camera = cameraOf();
    await Promise.all(SIDES.map((side) => images[side] && engine.open(side, images[side])));
    masks = { left: await maskFor(engine, block, left), right: right && (await maskFor(engine, block, right)) };
    here();
  } catch (error) {
    here();
    tell(block, modes, say('the-pair-cannot-be-shown', { error: messageOf(error) }));
    return false;
  }
  const stays = isOwn(store.state) ? await leave(block, store.state, putAside, here) : '';
  if (stays === null) return false;
  store.dispatch({ type: 'images', images });
  // Of the images before them nothing is to be computed with it.
  readyFor(store, block, camera);
  for (const side of SIDES) {
    if (masks[side] !== null) store.dispatch({ type: 'mask', side, mask: masks[side] });
    if (marks !== undefined && images[side] !== null) store.dispatch({ type: 'photo', side, photo: { fiducials: marks(side) } });
  }
  if (marks !== undefined) store.dispatch({ type: 'wait' });
  isAsGiven(store.state);
  if (stays !== '') store.dispatch({ type: 'notice', notice: { kind: 'info', text: say('stay-under-projects', { title_of: stays }) } });
  block.dispatch({ type: 'openedPair', images: ofBlock });
  modes.dispatch('pair');
  return true;
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
  }
}

/** The mask that the block has for an image. */
async function maskFor(engine: Engine, { state }: BlockStore, image: BlockFile): Promise<GivenMask | null> {
  const mask = maskOf(state.options.masks, image.name);
  // Of a project file the masks are not there.
  if (mask === null || isLacking(mask)) return null;
  const read = await engine.client('pair').call('mask', { file: mask.file, overlaySide: MASK_SIDE });
  return { ...read, id: nextId--, name: mask.name, source: { kind: 'file', file: mask.file } };
}

/** The masks of the images of a pair, as far as they are files, and which ones were undone or removed. */
export function masksOf({ images, masks, maskSteps }: State): PairMask[] {
  return SIDES.flatMap((side): PairMask[] => {
    const [image, mask] = [images[side], masks[side]];
    if (image === null) return [];
    if (mask === null) return maskSteps.edits.some((step) => step.side === side) ? [{ image: image.name, file: null }] : [];
    return mask.source.kind === 'file' ? [{ image: image.name, file: mask.source.file }] : [];
  });
}

/** What was done to the matches of a pair by hand; null where nothing was, and while they are matched. */
export function matchesOf(state: State): PairMatches | null {
  const standing = standingOf(state.history.edits, state.history.done);
  if (isNothing(standing)) return null;
  const { edited } = shownPair(state);
  return edited === null ? null : byHandOf(edited, standing, placesByHand(state.history.edits));
}

const byHandOf = remember((edited: Edited, standing: Standing, places: ReadonlyMap<string, readonly MatchPlace[]>): PairMatches => {
  const rejected: MatchPlace[] = [];
  edited.match.rules.forEach((rule, left) => {
    if (rule !== BY_HAND) return;
    const target = targetOfLeft(edited, left);
    // One that was moved before is where it was found; what was measured by hand alone is where it was measured.
    rejected.push(target === null || typeof target === 'number' ? placeOfLeft(edited, left) : target);
  });
  const measured = [...standing.placed].filter(([key]) => !standing.rejected.has(key));
  return {
    rejected,
    used: edited.match.matches,
    measured: measured.map(([key, { target, at }]) => ({ at, of: typeof target === 'number' ? null : target, had: places.get(key) ?? [] })),
  };
});

function fileOf(block: BlockStore, name: string | undefined): BlockFile | undefined {
  const { shown, files } = block.state;
  return [...(shown?.files ?? []), ...files].find((file) => file.name === name);
}

function imageOf({ name, file }: BlockFile): GivenImage {
  return { id: nextId--, name, source: { kind: 'file', file } };
}

/** It is said of the block, wherever the pair was asked for. */
function tell(block: BlockStore, modes: Modes, text: string): void {
  modes.dispatch('block');
  block.dispatch({ type: 'notice', notice: { kind: 'problem', text } });
}
