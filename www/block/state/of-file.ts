/** What the block of a project file that is opened takes over, and what it replaces. Pure. */
import type { BlockFile, BlockOptions, BlockState } from './state';
import { BLOCK_INITIAL } from './state';
import type { BlockView } from './view';
import type { Placing } from './placing';
import { NO_PLACING } from './placing';

/** How project files are named. */
export const PROJECT_FILE = /\.tiepoint$/iu;

type Given = Pick<BlockState, 'catalogue' | 'options'>;

/** Options as they are before anything is given. */
export function defaultOptions({ catalogue }: Pick<BlockState, 'catalogue'>): BlockOptions {
  return { ...BLOCK_INITIAL.options, settings: catalogue?.defaults ?? null };
}

/** Whether no option was set and nothing given beside images. */
export function areDefault({ catalogue, options: { settings, gps, cameras, control, marks, positions, masks, geoid } }: Given): boolean {
  const noFile = cameras === null && control === null && marks === null && positions === null && masks.length === 0 && geoid === null;
  return (settings === null || settings === catalogue?.defaults) && gps === 'use' && noFile;
}

/** Whether options are those of a project file, and go with its block: with those of another one nothing would say that they are not its own. */
export function areOfFile({ shown, options }: Pick<BlockState, 'shown' | 'options'>): boolean {
  const { cameras, control, marks, positions } = options;
  return shown?.files.length === 0 || [cameras, control, marks, positions].some((text) => text !== null && PROJECT_FILE.test(text.name));
}

/** The images on the page that are those of a block that is opened. Images of a block that is shown are its own, whatever they are called: cameras count from 1. */
export function imagesFor({ shown, files }: Pick<BlockState, 'shown' | 'files'>, view: BlockView): readonly BlockFile[] {
  const named = new Set(view.images.map(({ name }) => name));
  return shown === null ? files.filter(({ name }) => named.has(name)) : [];
}

/** Whether a block that is opened takes the place of something that was given or found. */
export function isReplaced(state: BlockState, view: BlockView): boolean {
  return state.shown !== null || !areDefault(state) || imagesFor(state, view).length < state.files.length;
}

/** What is placed beside a block that is opened with these images: what was made of the former block, and what its images showed, is not of this one. */
export function placingFor({ placing }: Pick<BlockState, 'placing'>, files: readonly BlockFile[]): Placing {
  const { orthophoto, placed, film, options } = placing;
  const stay = new Set(files.map(({ id }) => id));
  if (orthophoto !== null && orthophoto.ofBlock !== null) return { ...NO_PLACING, film, options };
  return { ...placing, placed: new Map([...placed].filter(([id]) => stay.has(id))), chosen: NO_PLACING.chosen, pointed: NO_PLACING.pointed, draft: null };
}
