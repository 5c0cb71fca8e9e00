/** The cameras of the pair on the screen, and what of its photos tells them. */
import { pair_cameras } from '../../shared/crate';
import type { CameraMm, NoOrientation, PairCameras, PhotoFacts } from '../../shared/crate';
import { remember } from '../../shared/state/remember';
import { wholeMarks } from './marks';
import type { Side, StageValues, State } from './state';

type Info = StageValues['openLeft']['info'] | undefined;

const factsOf = remember((left: Info, right: Info, areMarksLeft: boolean, areMarksRight: boolean): [PhotoFacts, PhotoFacts] => {
  // One that is not open is taken to be as large as the other.
  const facts = (info: Info, other: Info, has_marks: boolean): PhotoFacts => {
    const { width, height } = info ?? other ?? { width: 1, height: 1 };
    return { width_px: width, height_px: height, exif: info?.camera ?? null, has_marks };
  };
  return [facts(left, right, areMarksLeft), facts(right, left, areMarksRight)];
});

/** What of both photos tells their cameras; the same object while nothing of it has changed. */
export function photoFacts({ photos, results: { openLeft, openRight } }: State): [PhotoFacts, PhotoFacts] {
  const areMarks = (side: Side) => wholeMarks(photos[side]).length > 0;
  return factsOf(openLeft?.value.info, openRight?.value.info, areMarks('left'), areMarks('right'));
}

const camerasOf = remember((given: CameraMm | null, facts: [PhotoFacts, PhotoFacts]) => pair_cameras(given, ...facts));

/** The camera of both images where one is given, else that of each image's EXIF, with what speaks against them; or what is missing. */
export function pairCameras(state: State): PairCameras | { missing: NoOrientation } {
  return camerasOf(state.camera, photoFacts(state));
}
