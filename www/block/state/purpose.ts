/** What is done with the orthophoto that is given, and whether it is done. */
import { isLookedAtAlone } from './placing';
import type { Purpose } from './placing';
import { placingKey } from './placed';
import { isOutdated } from './state';
import type { BlockState, Shown } from './state';

type Given = Pick<BlockState, 'placing' | 'options' | 'files' | 'shown'>;

/** A finished block whose images are oriented. */
function orientedBlock({ shown }: Pick<BlockState, 'shown'>): Shown | null {
  return shown === null || shown.view.partial || shown.view.oriented === 0 ? null : shown;
}

/** A block that was opened in the system of an orthophoto: what it was before is not known. */
function cameOnGround({ view, ground }: Shown): boolean {
  return ground === null && view.orthophoto?.kind === 'linked';
}

/** Whether places that were measured by hand hold the block in the system of the orthophoto: it can be placed on it, too, and lies there already. */
export function isHeldByHand({ shown }: Pick<BlockState, 'shown'>): boolean {
  return shown?.view.orthophoto?.kind === 'by_hand';
}

/** What is done with the orthophoto; null where none is given, or the user is to say it. */
export function purposeOf({ placing, shown, files }: Given): Purpose | null {
  const { orthophoto, purpose, placed, heights } = placing;
  if (orthophoto === null) return null;
  if (isLookedAtAlone(orthophoto)) return 'map';
  if (purpose !== null) return purpose;
  // One that was made of a block lies under it, and places other images.
  if (orthophoto.ofBlock !== null || placed.size > 0) return 'images';
  const block = orientedBlock({ shown });
  if (block !== null) return cameOnGround(block) ? 'map' : null;
  // A block that could not be oriented is none.
  const isTried = shown !== null && !shown.view.partial;
  return !isTried && heights.kind === 'model' && files.length >= 2 ? 'block' : 'images';
}

/** Whether the user is to say what is done with the orthophoto. */
export function asksPurpose(state: Given): boolean {
  return state.placing.orthophoto !== null && purposeOf(state) === null;
}

/** Names what placing the block now would be made from; its cameras are its own. */
export function groundKey({ placing }: Pick<BlockState, 'placing'>): string {
  return placingKey({ placing, options: { cameras: null } });
}

/** Whether the block is to be placed on the orthophoto and is not, or by other settings or heights. */
export function isOffGround(state: Given): boolean {
  const block = orientedBlock(state);
  return block !== null && purposeOf(state) === 'block' && block.ground?.key !== groundKey(state);
}

/** Whether the block on the screen is the one that is wanted, but for its place. One that was opened in the system of an orthophoto is run anew. */
export function lacksPlaceAlone(state: BlockState): boolean {
  return isOffGround(state) && !isOutdated(state) && state.shown !== null && !cameOnGround(state.shown);
}

/** Whether the block lies elsewhere than it is to lie. */
export function liesElsewhere(state: Given): boolean {
  return isOffGround(state) && !isHeldByHand(state);
}

/** Whether other files, options or ground made the block on the screen. */
export function isStale(state: BlockState): boolean {
  return isOutdated(state) || liesElsewhere(state);
}
