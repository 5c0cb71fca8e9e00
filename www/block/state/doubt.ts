/** What is said, before anything is matched, of images that record positions elsewhere than the orthophoto on which they are to be placed. */
import { isOffGround, purposeOf } from './purpose';
import { isInSystemOf } from './showing';
import type { BlockState } from './state';

/** The doubt as long as it is one: where GNSS positions take part, until images or the block have their place. Empty where there is none. */
export function doubtOf(state: BlockState): string {
  const purpose = purposeOf(state);
  const isUsed = purpose === 'images' || (purpose === 'block' && state.options.gps === 'use');
  return isUsed && !hasPlace(state) ? state.placing.elsewhere : '';
}

/** Whether an image is placed on the orthophoto, or the block is by what is given now. */
function hasPlace(state: BlockState): boolean {
  const { placing, shown } = state;
  if (purposeOf(state) === 'images') return [...placing.placed.values()].some(({ result }) => (result?.placement ?? null) !== null);
  return shown !== null && isInSystemOf(shown.view) && !isOffGround(state);
}
