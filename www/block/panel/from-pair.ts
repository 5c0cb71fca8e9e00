/** Over a pair of the block: what was done to its matches by hand can be done in the block, too, each kind as one step of its edits. */
import { button } from '../../shared/panel/dom';
import { say } from '../../shared/text/words';
import type { BlockStore } from '../engine/engine';
import type { Facts } from '../engine/facts';
import { comparedText, figuresOf } from '../state/edited';
import { isEditable } from '../state/editing';
import type { EditStep } from '../state/edits';
import { nameOfStep } from '../state/naming';
import { forBlock } from '../state/pair-matches';
import type { ForBlock, PairMatches } from '../state/pair-matches';
import { isBusy } from '../state/state';
import type { BlockState } from '../state/state';
import type { BlockView } from '../state/view';
import { namesIn } from './edits';

/** What it needs of the pair. */
export interface MatchesBeside {
  /** Of its images, left and right; null where there is none. */
  names: () => readonly (string | null)[];
  /** Null where nothing was done to them by hand, and while they are matched. */
  matches: () => PairMatches | null;
}

export interface FromPair {
  buttons: readonly HTMLElement[];
  /** Shows what there is to be done, of a pair of the block; what is said of it. */
  draw: (isOfBlock: boolean) => string;
}

/** The step that was given last, and the block that it was given to. */
interface Given {
  step: EditStep;
  to: BlockView | null;
  /** Those that it was made of: once others are done or undone in the pair, what it did is no news. */
  of: PairMatches | null;
}

const NOTHING: ForBlock = { rejection: [], matches: 0, without: 0, addition: [], measured: 0 };

export function makeFromPair(store: BlockStore, facts: Facts, pair: MatchesBeside): FromPair {
  let given: Given | null = null;
  const give = (step: EditStep) => {
    // What is placed of a point that is being measured in the block is no less wanted for this.
    if (store.state.draft !== null) store.dispatch({ type: 'accept', leaves: true });
    given = { step, to: store.state.shown?.found ?? null, of: pair.matches() };
    store.dispatch({ type: 'edit', edits: step });
  };
  const now = () => ofPair(store, facts, pair);
  const reject = button('', 'matches-to-block', () => give(now().rejection), say('rejects-their-observations'));
  const add = button('', 'measured-to-block', () => give(now().addition), say('they-become-tie-points'));
  const draw = (isOfBlock: boolean) => {
    const { matches, without, measured } = isOfBlock ? now() : NOTHING;
    reject.textContent = say('reject-matches-in-the-block', { matches });
    add.textContent = say('measured-matches-into-the-block', { matches: measured });
    reject.hidden = matches === 0;
    add.hidden = measured === 0;
    reject.disabled = add.disabled = isBusy(store.state);
    const rejected = isOfBlock ? (pair.matches()?.rejected.length ?? 0) : 0;
    const lacking = without === 0 ? '' : say('rejected-without-tie-point', { without, rejected });
    const isNews = isOfBlock && given?.of === pair.matches();
    return [isNews ? saidOf(store.state, given) : '', lacking].filter((part) => part !== '').join(' ');
  };
  return { buttons: [reject, add], draw };
}

/** What the block has not of the pair; nothing while it is adjusted, and while its observations are on their way. */
function ofPair(store: BlockStore, facts: Facts, pair: MatchesBeside): ForBlock {
  const { shown, adjusting } = store.state;
  const matches = pair.matches();
  if (shown === null || matches === null || adjusting || !isEditable(store.state)) return NOTHING;
  // The user may have exchanged the images.
  const [a = -1, b = -1] = pair.names().map((name) => shown.view.images.findIndex((image) => image.name === name));
  if (a < 0 || b < 0 || a === b) return NOTHING;
  const [left, right] = [facts.points(a), facts.points(b)];
  return left === null || right === null ? NOTHING : forBlock(shown.view, a, b, left, right, matches);
}

/** What became of the step that was given, as long as it is the latest one. */
function saidOf(state: BlockState, given: Given | null): string {
  const { history, shown, before, adjusting, notice } = state;
  if (given === null || shown === null || shown.found !== given.to) return '';
  // The block refused it.
  if (!history.edits.includes(given.step)) return notice?.kind === 'problem' ? notice.text : '';
  if (history.edits[history.done - 1] !== given.step) return '';
  if (adjusting || before === null) return say('adjusting-the-block');
  return say('edit-and-figures', { edit: nameOfStep(given.step, namesIn(state)), figures: comparedText(before, figuresOf(shown.view)) });
}
