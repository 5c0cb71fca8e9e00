/** What keys do on the orthophoto and in the image beside it: with the links of an image that was placed by itself, or with the block. */
import type { Command } from '../../../shared/view/commands';
import type { BlockStore } from '../../engine/engine';
import type { LinkHands } from '../../engine/link-hands';
import type { PlaceHands } from '../../engine/place-hands';
import { blockOnOrthophoto, chosenPlaced } from '../../state/showing';
import { NOTHING_LOOKED_AT } from '../../state/placing';
import { shownLinks } from '../../state/steps';
import { say } from '../../../shared/text/words';

/** Goes through the block on the orthophoto. */
export interface BlockSteps {
  step: (of: 'image' | 'place', by: 1 | -1) => void;
  leave: () => void;
}

/** While places of the orthophoto can be measured for the block. `middle`: takes the place under the cross. */
export function placeKeys(store: BlockStore, hands: PlaceHands, middle: () => void): Command[] {
  const adds = () => store.state.placing.adds;
  return [
    { keys: ['a'], does: say('adds-a-place-or'), can: () => adds() || (hands.can && chosenPlaced(store.state) === null), run: () => hands.toggle() },
    { keys: ['Enter'], does: say('takes-the-place-under-the-cross'), can: adds, run: middle },
    { keys: ['Escape'], does: say('adds-no-place'), can: adds, run: () => hands.toggle() },
  ];
}

/** While the block lies on the orthophoto. */
export function blockKeys(store: BlockStore, { step, leave }: BlockSteps): Command[] {
  const can = () => blockOnOrthophoto(store.state) !== null && !store.state.placing.picks;
  return [
    { keys: ['n'], does: say('chooses-the-next-place-of'), can, run: () => step('place', 1) },
    { keys: ['p'], does: say('chooses-the-previous-place-of'), can, run: () => step('place', -1) },
    { keys: ['PageDown'], does: say('chooses-the-next-image'), can, run: () => step('image', 1) },
    { keys: ['PageUp'], does: say('chooses-the-previous-image'), can, run: () => step('image', -1) },
    { keys: ['Escape'], does: say('chooses-nothing'), can, lacks: () => (store.state.selection.chosen === null ? say('nothing-is-chosen') : ''), run: leave },
  ];
}

export function linkKeys(store: BlockStore, hands: LinkHands): Command[] {
  const now = () => store.state.placing;
  const isImageChosen = () => chosenPlaced(store.state) !== null;
  const isLinkChosen = () => isImageChosen() && now().chosen.link !== null;
  const links = () => {
    const chosen = chosenPlaced(store.state);
    return chosen === null ? 0 : (shownLinks(chosen)?.count ?? 0);
  };
  const tried = () => store.state.files.filter(({ id }) => now().placed.has(id)).map(({ id }) => id);
  const toLink = (by: 1 | -1) => {
    const { image, link } = now().chosen;
    store.dispatch({ type: 'choosePlaced', looked: { image, link: stepped(link ?? -1, by, links()) } });
  };
  const toImage = (by: 1 | -1) => {
    const all = tried();
    store.dispatch({ type: 'choosePlaced', looked: { image: all[stepped(all.indexOf(now().chosen.image ?? -1), by, all.length)] ?? null, link: null } });
  };
  const leave = () => {
    const { draft, picks, chosen } = now();
    if (draft !== null) hands.measure();
    else if (picks) store.dispatch({ type: 'picksPlace', picks: false });
    else store.dispatch({ type: 'choosePlaced', looked: chosen.link === null ? NOTHING_LOOKED_AT : { image: chosen.image, link: null } });
  };
  const isAtWork = () => now().draft !== null || now().picks || now().chosen.image !== null;
  const hasLinks = () => links() > 0;
  const hasImages = () => tried().length > 0;
  return [
    { keys: ['n'], does: say('chooses-the-next-link-of'), can: hasLinks, run: () => toLink(1) },
    { keys: ['p'], does: say('chooses-the-previous-link-of'), can: hasLinks, run: () => toLink(-1) },
    { keys: ['PageDown'], does: say('chooses-the-next-image-that'), can: hasImages, run: () => toImage(1) },
    { keys: ['PageUp'], does: say('chooses-the-previous-image-that'), can: hasImages, run: () => toImage(-1) },
    { keys: ['Delete'], does: say('rejects-the-chosen-link'), can: isLinkChosen, run: () => hands.use('reject') },
    { keys: ['r'], does: say('uses-the-chosen-link-again'), can: isLinkChosen, run: () => hands.use('restore') },
    { keys: ['a'], does: say('measures-a-new-link-or'), can: isImageChosen, run: () => hands.measure() },
    { keys: ['Enter'], does: say('accepts-the-link-that-is'), can: () => now().draft !== null, run: () => hands.accept() },
    { keys: ['Escape'], does: say('gives-up-or-chooses-nothing'), lacks: () => (isAtWork() ? '' : say('nothing-is-chosen')), run: leave },
  ];
}

function stepped(now: number, by: number, count: number): number {
  return now < 0 ? (by > 0 ? 0 : count - 1) : (now + by + count) % count;
}
