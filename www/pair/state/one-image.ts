/** Whether both images are of one: one photo twice, or parts of one image. */
import { one_image } from '../../shared/crate';
import type { NoOrientation } from '../../shared/crate';
import { remember } from '../../shared/state/remember';
import { wholeMarks } from './marks';
import { SIDES } from './state';
import type { StageValues, State } from './state';

const reasonOf = remember(({ matches }: StageValues['match'], { info: left }: StageValues['openLeft'], { info: right }: StageValues['openRight']) =>
  one_image(matches, left.width, left.height, right.width, right.height),
);

/** Why such images have no base; null where they are no such images, or nothing tells yet. */
export function oneImage({ photos, results: { match, openLeft, openRight } }: State): NoOrientation | null {
  // Scans with fiducial marks on both sides are of two photographs.
  if (SIDES.every((side) => wholeMarks(photos[side]).length > 0)) return null;
  return match === undefined || openLeft === undefined || openRight === undefined ? null : reasonOf(match.value, openLeft.value, openRight.value);
}
