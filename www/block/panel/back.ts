/** The line over the pair that leads from it to the block and from the block to it: which pair of the block it shows; while it shows none, which one it could. */
import { button, fill, h } from '../../shared/panel/dom';
import { passFocus } from '../../shared/panel/focus';
import type { Modes } from '../../shared/state/mode';
import type { BlockStore } from '../engine/engine';
import type { Facts } from '../engine/facts';
import { otherMasks } from '../state/masks';
import type { PairMask } from '../state/masks';
import { isBusy } from '../state/state';
import { strongestPair } from '../state/strongest';
import { describe } from '../state/words';
import { say } from '../../shared/text/words';
import { makeFromPair } from './from-pair';
import type { MatchesBeside } from './from-pair';

/** What the line needs of the pair. */
export interface PairBeside extends MatchesBeside {
  /** The masks of these. */
  masks: () => readonly PairMask[];
  /** Calls back whenever that may have changed. */
  watch: (changed: () => void) => void;
  /** Calls back whenever its matches may have changed. */
  watchMatches: (changed: () => void) => void;
  /** Shows two images of the block as a pair; resolves once they are there, or cannot be shown. */
  open: (images: [number, number]) => Promise<void>;
}

/** `takeMasks`: of a pair into the block. */
export function mountBack(store: BlockStore, facts: Facts, modes: Modes, pair: PairBeside, takeMasks: (masks: readonly PairMask[]) => void): HTMLElement {
  const [ofPair, ofMatches] = [h('span'), h('span', { role: 'status' })];
  const text = h('span', { testid: 'of-block' }, ofPair, ' ', ofMatches);
  const back = button(say('back-to-the-block'), 'back-to-block', () => {
    modes.dispatch('block');
    document.getElementById('block-view')?.focus({ preventScroll: true });
  });
  const open = button(say('open-this-pair'), 'open-strongest', () => {
    const images = strongestPair(store.state);
    if (images !== null) void pair.open(images);
  });
  const masks = button(say('use-masks-in-the-block'), 'masks-to-block', () => takeMasks(othersOf(store, pair)), say('what-they-mask-holds-no'));
  const matches = makeFromPair(store, facts, pair);
  const line = h('div', { class: 'of-block', role: 'region', aria: { label: say('pair-and-its-block') } }, back, text, ...matches.buttons, masks, open);
  const draw = () => {
    const held = document.activeElement;
    const offered = pair.names().every((name) => name === null) ? strongestPair(store.state) : null;
    const said = offered === null ? saidOf(store) : say('pairs-of-the-block-open-here', { names: namesOf(store, offered) });
    line.hidden = said === null || modes.state.mode !== 'pair';
    const saidOfMatches = matches.draw(!line.hidden && offered === null);
    fill(ofPair, said ?? '');
    // The same text again would be read out again.
    if (ofMatches.textContent !== saidOfMatches) fill(ofMatches, saidOfMatches);
    back.hidden = offered !== null;
    open.hidden = offered === null;
    masks.hidden = offered !== null || othersOf(store, pair).length === 0;
    open.disabled = masks.disabled = isBusy(store.state);
    // What was pressed is gone once it is done. Another press is to do nothing else to the block.
    if (line.contains(held)) passFocus(held, [back]);
  };
  store.watch(['opened', 'shown', 'files', 'options', 'running', 'notice', 'placing', 'history', 'adjusting'], draw);
  modes.watch(['mode'], draw);
  pair.watch(draw);
  pair.watchMatches(draw);
  facts.watch(draw);
  return line;
}

/** What is masked otherwise in the pair of the block that is shown than in the block. */
function othersOf({ state: { opened, options } }: BlockStore, pair: PairBeside): readonly PairMask[] {
  return opened === null ? [] : otherMasks(options.masks, pair.masks());
}

/** Of the pair of the block that is shown. */
function saidOf({ state: { opened, shown } }: BlockStore): string | null {
  return opened === null || shown === null ? null : describe(shown, { kind: 'pair', images: opened });
}

function namesOf({ state: { shown } }: BlockStore, images: readonly [number, number]): string {
  return images.map((image) => shown?.view.images[image]?.name ?? '').join(' – ');
}
