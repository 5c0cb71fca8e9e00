/** The way back from a pair of the block: a line over the pair that says which one it is. */
import { button, fill, h } from '../../shared/panel/dom';
import type { Modes } from '../../shared/state/mode';
import type { BlockStore } from '../engine/engine';
import { describe } from '../state/words';
import { say } from '../../shared/text/words';

export function mountBack(store: BlockStore, modes: Modes): HTMLElement {
  const text = h('span', { testid: 'of-block' });
  const back = button(say('back-to-the-block'), 'back-to-block', () => {
    modes.dispatch('block');
    document.getElementById('block-view')?.focus({ preventScroll: true });
  });
  const line = h('div', { class: 'of-block' }, back, text);
  const draw = () => {
    const { opened, shown } = store.state;
    const of = opened === null || shown === null ? null : describe(shown, { kind: 'pair', images: opened });
    line.hidden = of === null || modes.state.mode !== 'pair';
    fill(text, of ?? '');
  };
  store.watch(['opened', 'shown'], draw);
  modes.watch(['mode'], draw);
  return line;
}
