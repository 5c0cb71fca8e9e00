/** The address of the page names the view of the block and what is chosen in it; an address that is opened, or gone back to, shows them. */
import type { Modes } from '../../shared/state/mode';
import type { BlockStore } from '../engine/engine';
import { addressOf, asked } from '../state/address';
import { editsInForce, isSameList } from '../state/editing';

export function mountAddress(store: BlockStore, modes: Modes): void {
  /** Of an address that was opened before its block was there. */
  let waiting = window.location.hash;
  /** Whether its view is shown, which waits for no edits: who has gone on to another one meanwhile stays there. */
  let isViewed = false;
  const follow = () => {
    const { shown, history } = store.state;
    // Edits number the points anew: the address is of the block with them.
    if (shown === null || shown.view.partial || waiting === '') return;
    const wanted = asked(waiting, shown.view);
    if (wanted !== null && !isViewed) {
      isViewed = true;
      modes.dispatch('block');
      store.dispatch({ type: 'stage', view: wanted.view });
    }
    if (!isSameList(editsInForce(history), shown.edits)) return;
    waiting = '';
    if (wanted !== null) store.dispatch({ type: 'choose', choice: wanted.choice });
  };
  window.addEventListener('hashchange', () => {
    waiting = window.location.hash;
    isViewed = false;
    follow();
  });
  const tell = () => {
    follow();
    if (waiting !== '' || modes.state.mode !== 'block') return;
    const address = addressOf(store.state);
    if (window.location.hash === (address === '' ? '' : `#${address}`)) return;
    // Each point that is pressed is no page of its own to go back to.
    window.history.replaceState(window.history.state, '', address === '' ? window.location.pathname + window.location.search : `#${address}`);
  };
  store.watch(['shown', 'onStage', 'selection', 'history'], tell);
  modes.watch(['mode'], tell);
}
