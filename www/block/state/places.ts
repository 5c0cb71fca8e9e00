/** Whether places of an orthophoto can be measured by hand for the block. Pure. */
import { isLookedAtAlone } from './placing';
import { purposeOf } from './purpose';
import { blockOnOrthophoto } from './showing';
import type { BlockState } from './state';

/** Whether places of the orthophoto can be added to the block: to one that lies on it, and to one that was to be placed on it. */
export function takesPlaces(state: BlockState): boolean {
  const { orthophoto } = state.placing;
  if (
    orthophoto === null ||
    isLookedAtAlone(orthophoto) ||
    orthophoto.ofBlock !== null ||
    state.shown === null ||
    state.shown.view.partial ||
    state.shown.view.oriented === 0
  )
    return false;
  return blockOnOrthophoto(state) !== null || purposeOf(state) === 'block';
}
