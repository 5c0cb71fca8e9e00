/** The address of the page names the view of the block and what is chosen in it, or the pair of it that is shown; an address that is opened, or gone back to, shows them. */
import { isMode } from '../../shared/state/mode';
import type { Mode, Modes } from '../../shared/state/mode';
import type { BlockStore } from '../engine/engine';
import type { PairBeside } from './back';
import { addressOf, addressOfPair, asked, askedPair, isOtherPage, viewNamed } from '../state/address';
import { editsInForce, isSameList } from '../state/editing';

/** What is to be shown. `part`: of the page, as the browser's history has it; null of an address that was opened by itself. */
interface Wanted {
  address: string;
  part: Mode | null;
}

export function mountAddress(store: BlockStore, modes: Modes, pair: PairBeside): void {
  /** Of an address that was opened before its block was there, or gone to; null where none waits. */
  let waiting: Wanted | null = window.location.hash === '' ? null : { address: window.location.hash, part: null };
  /** Whether its view is shown, which waits for no edits: who has gone on to another one meanwhile stays there. */
  let isViewed = false;
  /** What is shown on the way there is no page to go back to. */
  let isFollowing = false;
  /** Whether something changed meanwhile. */
  let isMissed = false;
  let isOpening = false;
  /** What was gone to while a pair was being opened, which then takes the place of it. */
  let later: Wanted | null = null;
  /** A block that arrives, or is gone, does so by itself: its address takes the place of the one before. So does the first one. */
  let hadBlock: boolean | null = null;
  const goTo = (wanted: Wanted) => {
    if (isOpening) later = wanted;
    waiting = wanted;
    isViewed = false;
    tell();
  };
  /** The pair that was opened last is there still, with what was done to it, or is about to be, after a reload. */
  const show = async (images: [number, number]) => {
    if (isOpening) return;
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
      const next = later;
      later = null;
      // Where it cannot be shown, its address is given up.
      if (next === null) tell(false);
      else goTo(next);
    }
  };
  const follow = ({ address, part }: Wanted) => {
    const { shown, history, draft } = store.state;
    if (address === '') {
      waiting = null;
      // So is a pair that is none of the block.
      modes.dispatch(part ?? 'pair');
      return;
    }
    if (shown === null || shown.view.partial) {
      // One that is gone back to is not waited for: its block may have been left.
      if (part !== null) showPart(part, address);
      return;
    }
    // Points that edits add are there once these hold.
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
    // A point that is measured on after a reload is the chosen one.
    if (wanted !== null && (draft === null || part !== null)) store.dispatch({ type: 'choose', choice: wanted.choice });
  };
  const showPart = (part: Mode, address: string) => {
    waiting = null;
    modes.dispatch(part);
    const view = viewNamed(address);
    if (view !== undefined) store.dispatch({ type: 'stage', view });
  };
  const tell = (turns = true) => {
    if (isFollowing) isMissed = true;
    else if (waiting === null) put(turns);
    else {
      isFollowing = true;
      isMissed = false;
      follow(waiting);
      // What a listener dispatches comes once all of them have been told.
      queueMicrotask(() => {
        isFollowing = false;
        if (waiting !== null && isMissed) tell(false);
        else put(false);
      });
    }
  };
  const put = (turns: boolean) => {
    if (waiting !== null || isOpening) return;
    const hasBlock = store.state.shown !== null;
    const { mode } = modes.state;
    write(mode, mode === 'block' ? addressOf(store.state) : addressNow(store, pair), turns && hadBlock === hasBlock);
    hadBlock = hasBlock;
  };
  window.addEventListener('popstate', ({ state }) => {
    const part = partOf(state);
    if (part !== null) goTo({ address: window.location.hash, part });
  });
  window.addEventListener('hashchange', () => {
    // What is gone back to was shown above.
    if (partOf(window.history.state) === null) goTo({ address: window.location.hash, part: null });
  });
  store.watch(['shown', 'onStage', 'selection', 'history', 'opened'], () => tell());
  modes.watch(['mode'], () => tell(!modes.state.isKept));
  pair.watch(() => tell());
}

/** The part of the page that an entry of the browser's history shows; null where another page, or an address that was typed, made it. */
function partOf(entry: unknown): Mode | null {
  const part: unknown = typeof entry === 'object' && entry !== null && 'part' in entry ? entry.part : null;
  return typeof part === 'string' && isMode(part) ? part : null;
}

/** Puts an address in the bar of the browser. `turns`: another part, view, or pair, is a page of its own, to which *Back* comes back. */
function write(part: Mode, address: string, turns: boolean): void {
  const { hash, pathname, search } = window.location;
  const before = partOf(window.history.state);
  if (hash === (address === '' ? '' : `#${address}`) && before === part) return;
  const to = address === '' ? pathname + search : `#${address}`;
  // Each point that is pressed is none, nor are other photos in the place of a pair: going back would put that in their place.
  const isOther = (before !== null && before !== part) || isOtherPage(hash, address);
  if (turns && isOther) window.history.pushState({ part }, '', to);
  else window.history.replaceState({ part }, '', to);
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
