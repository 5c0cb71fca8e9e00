/** The address of the page names the view of the block and what is chosen in it, or the pair of it that is shown; an address that is opened, or gone back to, shows them. */
import type { Modes } from '../../shared/state/mode';
import type { BlockStore } from '../engine/engine';
import type { PairBeside } from './back';
import { addressOf, addressOfPair, asked, askedPair } from '../state/address';
import { editsInForce, isSameList } from '../state/editing';

export function mountAddress(store: BlockStore, modes: Modes, pair: PairBeside): void {
  /** Of an address that was opened before its block was there. */
  let waiting = window.location.hash;
  /** Whether its view is shown, which waits for no edits: who has gone on to another one meanwhile stays there. */
  let isViewed = false;
  /** The pair that was opened last is there still, with what was done to it, or is about to be, after a reload. */
  const show = (images: [number, number]) => {
    const isThere = isShown(store, pair) || pair.names().every((name) => name === null);
    if (String(store.state.opened) === String(images) && isThere) modes.dispatch('pair');
    else pair.open(images);
  };
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
    const images = askedPair(waiting, shown.view);
    waiting = '';
    if (images !== null) show(images);
    if (wanted !== null) store.dispatch({ type: 'choose', choice: wanted.choice });
  };
  window.addEventListener('hashchange', () => {
    waiting = window.location.hash;
    isViewed = false;
    follow();
  });
  const tell = () => {
    follow();
    if (waiting !== '') return;
    const address = modes.state.mode === 'block' ? addressOf(store.state) : addressNow(store, pair);
    if (window.location.hash === (address === '' ? '' : `#${address}`)) return;
    // Each point that is pressed is no page of its own to go back to.
    window.history.replaceState(window.history.state, '', address === '' ? window.location.pathname + window.location.search : `#${address}`);
  };
  store.watch(['shown', 'onStage', 'selection', 'history', 'opened'], tell);
  modes.watch(['mode'], tell);
  pair.watch(tell);
}

/** Of the pair on the page; empty where it is none of the block. */
function addressNow(store: BlockStore, pair: PairBeside): string {
  const { shown, opened } = store.state;
  return shown === null || opened === null || !isShown(store, pair) ? '' : addressOfPair(shown.view, opened);
}

/** Whether the pair on the page is the one that was opened last. */
function isShown({ state: { shown, opened } }: BlockStore, pair: PairBeside): boolean {
  const names = opened?.map((image) => shown?.view.images[image]?.name) ?? [];
  return names.length > 0 && names.every((name, i) => name === pair.names()[i]);
}
