/** How the state of the block changes. Pure: the same state and action give the same state. */
import type { Step } from '../../../pkg/block/index.js';
import type { BlockEdit, BlockFlight, BlockModel, Parameter, PlaceAgain } from '../../../pkg/wasm/tiepoint.js';
import { NO_HISTORY } from '../../shared/state/history';
import type { Notice } from '../../shared/state/notice';
import type { BlockCatalogue, BlockFile, BlockOptions, BlockState, Shown, ViewName } from './state';
import { BLOCK_INITIAL, openedKey, withoutRunUnderWay } from './state';
import { UNEDITED } from './edited';
import { choiceOfSamePoints } from './edits';
import type { EditStep } from './edits';
import { nameOfTiePoints } from './former';
import { awaitingAgain, carried, carriedToGround, reduceEdits } from './editing';
import type { EditsAction } from './editing';
import { givenBeside, NONE_GIVEN } from './given-points';
import { coordinatesOf } from './marks';
import { panesInOtherView, reducePanes } from './panes';
import type { PanesAction } from './panes';
import type { RestoredBlock } from './kept';
import { areOfFile, defaultOptions, imagesFor, placingFor } from './of-file';
import { draftInOtherView } from './draft';
import { NO_PLACING, reducePlacing } from './placing';
import type { OnGround, PlacingAction } from './placing';
import { resumed } from './resumed';
import { inOtherView, NOTHING_SELECTED, reduceSelection } from './selection';
import type { SelectionAction } from './selection';
import { together } from './together';
import type { BlockView } from './view';

export type BlockAction =
  | { type: 'ready'; catalogue: BlockCatalogue }
  | { type: 'files'; files: readonly BlockFile[]; truth: BlockModel | null }
  /** Files were given that are no images. */
  | { type: 'skipped'; names: readonly string[] }
  | { type: 'options'; options: Partial<BlockOptions> }
  /** The field of a setting holds a value that is not allowed. */
  | { type: 'refused'; parameter: Parameter }
  | { type: 'flight'; flight: BlockFlight }
  | { type: 'started'; key: string }
  | { type: 'step'; step: Step }
  /** What the run has found so far: it is shown where no finished block is. */
  | { type: 'part'; view: BlockView; files: readonly BlockFile[] }
  | { type: 'done'; key: string; view: BlockView; files: readonly BlockFile[]; seconds: number }
  /** `failure`: null where the user ended it. */
  | { type: 'ended'; failure: string | null }
  /** The block on the screen in the system of an orthophoto, or as it was before; `edits`: those that it has there. */
  | { type: 'onGround'; view: BlockView; edits: readonly BlockEdit[]; ground: OnGround | null; again?: readonly PlaceAgain[] }
  /** `steps`: the edits that it was saved with; `options`: those that it was made with. */
  | { type: 'openedFile'; view: BlockView; steps: readonly EditStep[]; options: BlockOptions }
  /** What the browser kept. */
  | { type: 'restored'; restored: RestoredBlock }
  /** Nothing is on the page any more, and all options have their defaults. */
  | { type: 'cleared' }
  | { type: 'clear' }
  | SelectionAction
  | PanesAction
  | EditsAction
  | PlacingAction
  | { type: 'stage'; view: ViewName }
  | { type: 'openedPair'; images: [number, number] | null }
  | { type: 'notice'; notice: Notice | null };

export function reduceBlock(state: BlockState, action: BlockAction): BlockState {
  const after = withGivenPoints(reduced(state, action));
  return action.type === 'choose' || action.type === 'choosePlaced' ? together(state, after) : after;
}

/** Tables list the points that were given, whether they are in the block or not. */
function withGivenPoints(state: BlockState): BlockState {
  const { shown, selection } = state;
  if (shown === null) return state;
  const { chosen } = selection;
  const given = givenBeside(shown.view, state);
  // One that was taken into the block, or is given no longer, is chosen no longer.
  const stays = chosen?.kind !== 'given' || given.some(({ name }) => name === chosen.name);
  const asGiven = coordinatesOf(state.options.control);
  if (given === shown.given && asGiven === shown.asGiven && stays) return state;
  return { ...state, shown: { ...shown, given, asGiven }, selection: stays ? selection : { ...selection, chosen: null } };
}

function reduced(state: BlockState, action: BlockAction): BlockState {
  switch (action.type) {
    case 'ready':
      return {
        ...state,
        catalogue: action.catalogue,
        options: { ...state.options, settings: action.catalogue.defaults },
        flight: action.catalogue.flight,
        placing: { ...state.placing, options: action.catalogue.placing },
      };
    case 'files':
      return { ...state, files: action.files, truth: action.truth, running: withoutRunUnderWay(state.running) };
    case 'skipped':
      return { ...state, skipped: [...new Set([...state.skipped, ...action.names])] };
    case 'options':
      return {
        ...state,
        options: { ...state.options, ...action.options },
        running: withoutRunUnderWay(state.running),
        notice: null,
        refused: action.options.settings === undefined ? state.refused : null,
      };
    case 'refused':
      return { ...state, refused: action.parameter, notice: state.notice?.kind === 'busy' ? state.notice : null };
    case 'flight':
      return { ...state, flight: action.flight };
    case 'choose':
    case 'point':
    case 'filter': {
      const selection = reduceSelection(state.selection, action);
      if (selection === state.selection) return state;
      // A point that is measured is the chosen one: what was placed of it is not lost with the choice.
      const before = action.type === 'choose' && state.draft?.of != null ? reduceEdits(state, { type: 'accept', leaves: true }) : state;
      return { ...before, selection };
    }
    case 'showImages':
    case 'moveViews':
    case 'wholeImages':
    case 'activeImage':
    case 'look':
      return { ...state, panes: reducePanes(state.panes, action) };
    case 'stage':
      return { ...state, onStage: action.view };
    case 'edit':
    case 'goto':
    case 'adjusting':
    case 'edited':
    case 'editRefused':
    case 'draft':
    case 'accept':
    case 'mark':
    case 'gotoMark':
      return reduceEdits(state, action);
    case 'placed':
      // One of a project that was left, or that was removed meanwhile.
      return state.files.includes(action.image) ? { ...state, placing: reducePlacing(state.placing, action) } : state;
    case 'orthophoto':
    case 'heights':
    case 'film':
    case 'placingOptions':
    case 'purpose':
    case 'placing':
    case 'elsewhere':
    case 'choosePlaced':
    case 'pointPlaced':
    case 'picksPlace':
    case 'addsPlace':
    case 'linkDraft':
    case 'adjustsLinks':
    case 'showLinks': {
      const placing = reducePlacing(state.placing, action);
      if (placing === state.placing) return state;
      // What was said is of what was set before.
      const isAnother = action.type === 'placingOptions' || action.type === 'purpose' || (action.type === 'orthophoto' && action.orthophoto === null);
      return {
        ...state,
        placing,
        notice: isAnother && state.notice?.kind !== 'busy' ? null : state.notice,
        refused: action.type === 'placingOptions' ? null : state.refused,
      };
    }
    case 'openedPair':
      return { ...state, opened: action.images };
    case 'notice':
      return { ...state, notice: action.notice };
    case 'onGround':
      return state.shown === null ? state : onGround(state, state.shown, action);
    case 'openedFile': {
      const files = imagesFor(state, action.view);
      const opened: BlockState = {
        ...state,
        ...blank(state),
        files,
        placing: placingFor(state, files),
        options: action.options,
        refused: null,
        panes: panesInOtherView(state.panes, null, action.view),
        ...UNEDITED,
        history: { edits: action.steps, done: action.steps.length },
        marks: NO_HISTORY,
        removed: [],
        skipped: [],
        // The truth is that of the photos that were simulated, not of this block.
        truth: null,
        running: { kind: 'no' },
        shown: {
          key: '',
          view: action.view,
          given: NONE_GIVEN,
          found: action.view,
          tiePoints: '',
          edits: action.steps.flat(),
          files: [],
          steps: {},
          seconds: 0,
          ground: null,
        },
      };
      return { ...opened, shown: opened.shown && { ...opened.shown, key: openedKey(opened) } };
    }
    case 'restored': {
      const { draft, ...restored } = action.restored;
      const { former, history, shown } = restored;
      const awaiting = awaitingAgain(former, history, shown);
      return { ...BLOCK_INITIAL, catalogue: state.catalogue, ...restored, awaiting, onStage: viewOf(restored), ...resumed(draft, shown?.view ?? null) };
    }
    case 'cleared':
      return state.catalogue === null ? state : reduceBlock(BLOCK_INITIAL, { type: 'ready', catalogue: state.catalogue });
    case 'clear':
      return {
        ...BLOCK_INITIAL,
        catalogue: state.catalogue,
        options: areOfFile(state) ? defaultOptions(state) : state.options,
        flight: state.flight,
        placing: { ...NO_PLACING, options: state.placing.options },
      };
    default:
      return withRun(state, action);
  }
}

/** The view that shows what was kept: images on an orthophoto are no block, whose views would have nothing, and a link is measured on there. */
function viewOf({ shown, placing }: Omit<RestoredBlock, 'draft'>): ViewName {
  return placing.draft !== null || (shown === null && placing.orthophoto !== null) ? 'orthophoto' : BLOCK_INITIAL.onStage;
}

/** What refers to the images of a block that is no longer shown. */
function blank(state: BlockState): Pick<BlockState, 'selection' | 'opened' | 'notice'> {
  return { selection: NOTHING_SELECTED, opened: null, notice: state.notice?.kind === 'busy' ? null : state.notice };
}

/** What refers to the images of a block, in another view of them, and to its points where these are the same ones. */
function inOther({ selection, panes, shown }: BlockState, view: BlockView, hasSamePoints: boolean): Pick<BlockState, 'selection' | 'panes'> {
  const before = shown?.view ?? null;
  const other = inOtherView(selection, before, view);
  const points = before !== null && hasSamePoints ? choiceOfSamePoints(selection.chosen, before, view) : null;
  return { selection: { ...other, chosen: points ?? other.chosen }, panes: panesInOtherView(panes, before, view) };
}

function onGround(state: BlockState, shown: Shown, { view, edits: own, ground, again = [] }: Extract<BlockAction, { type: 'onGround' }>): BlockState {
  const { edits, said } = carriedToGround(state, view, ground === null, again);
  const { orthophoto } = state.placing;
  // One that was made of the block in another system does not lie under it.
  const given = orthophoto?.ofBlock === shown.key ? { ...state.placing, orthophoto: { ...orthophoto, ofBlock: '' } } : state.placing;
  // A block that was taken off it is not to lie there.
  const placing = ground === null ? reducePlacing(given, { type: 'purpose', purpose: 'map' }) : given;
  return {
    ...state,
    ...blank(state),
    ...inOther(state, view, true),
    ...edits,
    ...(said === '' ? {} : { notice: { kind: 'info', text: said, beside: true } }),
    placing,
    shown: { ...shown, view, found: view, edits: own, ground },
  };
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
      const shown = { key: running.key, view, given: NONE_GIVEN, found: view, tiePoints: '', edits: [], files, seconds: 0, steps: {}, ground: null };
      return { ...state, shown, opened: null, ...inOther(state, view, false) };
    }
    case 'done': {
      const { key, view, files, seconds } = action;
      const { edits, said } = carried(state, view);
      const tiePoints = nameOfTiePoints(view);
      const draft = draftInOtherView(state.draft, state.shown?.view, view);
      return {
        ...state,
        ...blank(state),
        ...inOther(state, view, tiePoints === state.shown?.tiePoints),
        ...edits,
        draft,
        ...(said === '' ? {} : { notice: { kind: 'info', text: said, beside: true } }),
        running: { kind: 'no' },
        shown: {
          key,
          view,
          given: NONE_GIVEN,
          found: view,
          tiePoints,
          edits: [],
          files,
          seconds,
          steps: running.kind === 'yes' ? running.steps : {},
          ground: null,
        },
      };
    }
    case 'ended':
      return running.kind === 'yes' ? { ...state, running: { kind: 'ended', steps: running.steps, failure: action.failure } } : state;
  }
}
