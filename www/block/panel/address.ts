/** The address of the page names the view of the block and what is chosen in it, or the pair of it that is shown; an address that is opened, or gone back to, shows them. */
import type { Modes } from '../../shared/state/mode';
import type { BlockStore } from '../engine/engine';
import type { PairBeside } from './back';
import { addressOf, addressOfPair, asked, askedPair, isOtherPage } from '../state/address';
import { editsInForce, isSameList } from '../state/editing';

export function mountAddress(store: BlockStore, modes: Modes, pair: PairBeside): void {
  /** Of an address that was opened before its block was there, or gone to; null where none waits. */
  let waiting = window.location.hash === '' ? null : window.location.hash;
  /** Whether its view is shown, which waits for no edits: who has gone on to another one meanwhile stays there. */
  let isViewed = false;
  /** What is shown on the way there is no page to go back to. */
  let isFollowing = false;
  let isOpening = false;
  /** A block that arrives, or is gone, does so by itself: its address takes the place of the one before. */
  let hadBlock = false;
  /** The pair that was opened last is there still, with what was done to it, or is about to be, after a reload. */
  const show = async (images: [number, number]) => {
    const isThere = isShown(store, pair) || pair.names().every((name) => name === null);
    if (String(store.state.opened) === String(images) && isThere) {
      modes.dispatch('pair');
      return;
    }
    isOpening = true;
    try {
      await pair.open(images);
    } finally {
      isOpening = false;
      // Where it cannot be shown, its address is given up.
      tell(false);
    }
  };
  const follow = (address: string) => {
    const { shown, history } = store.state;
    if (address === '') {
      waiting = null;
      // So is a pair that is none of the block.
      if (shown !== null) modes.dispatch('pair');
      return;
    }
    // Edits number the points anew: the address is of the block with them.
    if (shown === null || shown.view.partial) return;
    const wanted = asked(address, shown.view);
    if (wanted !== null && !isViewed) {
      isViewed = true;
      modes.dispatch('block');
      store.dispatch({ type: 'stage', view: wanted.view });
    }
    if (!isSameList(editsInForce(history), shown.edits)) return;
    const images = askedPair(address, shown.view);
    waiting = null;
    if (images !== null) void show(images);
    if (wanted !== null) store.dispatch({ type: 'choose', choice: wanted.choice });
  };
  const tell = (turns = true) => {
    if (isFollowing) return;
    const address = waiting;
    if (address !== null) {
      isFollowing = true;
      follow(address);
      isFollowing = false;
    }
    if (waiting !== null || isOpening) return;
    const hasBlock = store.state.shown !== null;
    write(modes.state.mode === 'block' ? addressOf(store.state) : addressNow(store, pair), turns && address === null && hadBlock && hasBlock);
    hadBlock = hasBlock;
  };
  window.addEventListener('hashchange', () => {
    waiting = window.location.hash;
    isViewed = false;
    tell();
  });
  store.watch(['shown', 'onStage', 'selection', 'history', 'opened'], () => tell());
  modes.watch(['mode'], () => tell());
  pair.watch(() => tell());
}

/** Puts an address in the bar of the browser. `turns`: another view, or pair, is a page of its own, to which *Back* comes back. */
function write(address: string, turns: boolean): void {
  const { hash, pathname, search } = window.location;
  if (hash === (address === '' ? '' : `#${address}`)) return;
  const to = address === '' ? pathname + search : `#${address}`;
  // Each point that is pressed is none, nor are other photos in the place of a pair: going back would put that in their place.
  if (turns && isOtherPage(hash, address)) window.history.pushState(null, '', to);
  else window.history.replaceState(window.history.state, '', to);
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
