/** How the state of the block changes. Pure: the same state and action give the same state. */
import type { Step } from '../../../pkg/block/index.js';
import type { BlockFlight, BlockModel } from '../../../pkg/wasm/tiepoint.js';
import type { Notice } from '../../shared/state/notice';
import type { BlockCatalogue, BlockFile, BlockOptions, BlockState, Choice, Mode } from './state';
import { BLOCK_INITIAL } from './state';
import type { RestoredBlock } from './kept';
import type { BlockView } from './view';

export type BlockAction =
  | { type: 'ready'; catalogue: BlockCatalogue }
  | { type: 'mode'; mode: Mode }
  | { type: 'files'; files: readonly BlockFile[]; truth: BlockModel | null }
  | { type: 'options'; options: Partial<BlockOptions> }
  /** The field of a setting holds a value that is not allowed. */
  | { type: 'refused'; label: string }
  | { type: 'flight'; flight: BlockFlight }
  | { type: 'started'; key: string }
  | { type: 'step'; step: Step }
  /** What the run has found so far: it is shown where no finished block is. */
  | { type: 'part'; view: BlockView; files: readonly BlockFile[] }
  | { type: 'done'; key: string; view: BlockView; files: readonly BlockFile[]; seconds: number }
  /** `failure`: null where the user ended it. */
  | { type: 'ended'; failure: string | null }
  | { type: 'openedFile'; view: BlockView }
  /** What the browser kept. */
  | { type: 'restored'; restored: RestoredBlock }
  /** Nothing is on the page any more, and all options have their defaults. */
  | { type: 'cleared' }
  | { type: 'clear' }
  | { type: 'choose'; choice: Choice | null }
  | { type: 'openedPair'; images: [number, number] | null }
  | { type: 'notice'; notice: Notice | null };

export function reduceBlock(state: BlockState, action: BlockAction): BlockState {
  switch (action.type) {
    case 'ready':
      return { ...state, catalogue: action.catalogue, options: { ...state.options, settings: action.catalogue.defaults }, flight: action.catalogue.flight };
    case 'mode':
      return { ...state, mode: action.mode };
    case 'files':
      return { ...state, files: action.files, truth: action.truth, running: onOtherInput(state.running) };
    case 'options':
      return {
        ...state,
        options: { ...state.options, ...action.options },
        running: onOtherInput(state.running),
        notice: null,
        refused: action.options.settings === undefined ? state.refused : null,
      };
    case 'refused':
      return { ...state, refused: action.label, notice: state.notice?.kind === 'busy' ? state.notice : null };
    case 'flight':
      return { ...state, flight: action.flight };
    case 'choose':
      return { ...state, choice: action.choice };
    case 'openedPair':
      return { ...state, opened: action.images };
    case 'notice':
      return { ...state, notice: action.notice };
    case 'openedFile':
      return { ...state, ...blank(state), running: { kind: 'no' }, shown: { key: '', view: action.view, files: [], steps: {}, seconds: 0 } };
    case 'restored':
      return { ...BLOCK_INITIAL, mode: state.mode, catalogue: state.catalogue, ...action.restored };
    case 'cleared':
      return state.catalogue === null ? state : reduceBlock({ ...BLOCK_INITIAL, mode: state.mode }, { type: 'ready', catalogue: state.catalogue });
    case 'clear':
      return { ...BLOCK_INITIAL, mode: state.mode, catalogue: state.catalogue, options: state.options, flight: state.flight };
    default:
      return withRun(state, action);
  }
}

/** A run that goes on keeps what it was given; of one that was ended nothing is left to take up as it was. */
function onOtherInput(running: BlockState['running']): BlockState['running'] {
  return running.kind === 'yes' ? running : { kind: 'no' };
}

/** What refers to the images of a block that is no longer shown. */
function blank(state: BlockState): Pick<BlockState, 'choice' | 'opened' | 'notice'> {
  return { choice: null, opened: null, notice: state.notice?.kind === 'busy' ? null : state.notice };
}

/** What was chosen, by the names of its images in another view of them; null where they are not in it. */
function sameChoice({ shown, choice }: BlockState, view: BlockView): Choice | null {
  if (shown === null || choice === null) return null;
  const place = (image: number) => view.images.findIndex(({ name }) => name === shown.view.images[image]?.name);
  if (choice.kind === 'image') return place(choice.image) < 0 ? null : { kind: 'image', image: place(choice.image) };
  const images: [number, number] = [place(choice.images[0]), place(choice.images[1])];
  return images.includes(-1) ? null : { kind: 'pair', images };
}

type RunAction = Extract<BlockAction, { type: 'started' | 'step' | 'part' | 'done' | 'ended' }>;

/** What a run reports. */
function withRun(state: BlockState, action: RunAction): BlockState {
  const { running } = state;
  switch (action.type) {
    case 'started':
      return { ...state, running: { kind: 'yes', key: action.key, steps: {} }, notice: null };
    case 'step':
      return running.kind === 'yes' ? { ...state, running: { ...running, steps: { ...running.steps, [action.step.stage]: action.step } } } : state;
    case 'part': {
      if (running.kind !== 'yes' || (state.shown !== null && !state.shown.view.partial)) return state;
      const { view, files } = action;
      const shown = { key: running.key, view, files, seconds: 0, steps: {} };
      return { ...state, shown, opened: null, choice: sameChoice(state, view) };
    }
    case 'done': {
      const { key, view, files, seconds } = action;
      return {
        ...state,
        ...blank(state),
        choice: sameChoice(state, view),
        running: { kind: 'no' },
        shown: { key, view, files, seconds, steps: running.kind === 'yes' ? running.steps : {} },
      };
    }
    case 'ended':
      return running.kind === 'yes' ? { ...state, running: { kind: 'ended', steps: running.steps, failure: action.failure } } : state;
  }
}
