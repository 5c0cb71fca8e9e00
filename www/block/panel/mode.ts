/** The switch between the pair and the block, and the way back from a pair of the block. */
import { button, fill, h } from '../../shared/panel/dom';
import type { BlockStore } from '../engine/engine';
import type { Mode } from '../state/state';
import { describe } from '../state/words';

const MODES: readonly (readonly [Mode, string])[] = [
  ['pair', 'Pair'],
  ['block', 'Block'],
];

/** `parts`: what is shown in each mode alone. */
export function mountMode(store: BlockStore, parts: Readonly<Record<Mode, readonly HTMLElement[]>>): HTMLElement {
  const buttons = MODES.map(([mode, text]) => ({ mode, press: button(text, `mode-${mode}`, () => store.dispatch({ type: 'mode', mode })) }));
  store.watch(['mode'], ([mode]) => {
    for (const { mode: own, press } of buttons) press.setAttribute('aria-pressed', String(own === mode));
    for (const [own] of MODES) for (const part of parts[own]) part.hidden = own !== mode;
    document.querySelector('.skip')?.setAttribute('href', mode === 'pair' ? '#view' : '#block-view');
    document.body.dataset.mode = mode;
  });
  return h('div', { class: 'mode', role: 'group', aria: { label: 'What is matched' } }, ...buttons.map(({ press }) => press));
}

/** A line over the pair that says which pair of the block it is. */
export function mountBack(store: BlockStore): HTMLElement {
  const text = h('span', { testid: 'of-block' });
  const back = button('← Back to the block', 'back-to-block', () => {
    store.dispatch({ type: 'mode', mode: 'block' });
    document.getElementById('block-view')?.focus();
  });
  const line = h('div', { class: 'of-block' }, back, text);
  store.watch(['opened', 'shown'], ([opened, shown]) => {
    line.hidden = opened === null || shown === null;
    fill(text, opened === null || shown === null ? '' : describe(shown.view, { kind: 'pair', images: opened }));
  });
  return line;
}
