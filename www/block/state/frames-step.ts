/** What is to be done with scans of film before a block is run. */
import { say } from '../../shared/text/words';
import { awaitsFrames } from './film';
import { purposeOf } from './purpose';
import type { BlockState } from './state';

/** What the user does next where scans are to become images of one camera first; nothing where there are none, or they are placed as they are. */
export function framesStep(state: BlockState): string {
  const { film } = state.placing;
  if (purposeOf(state) === 'images' || !awaitsFrames(film, state.files)) return '';
  return film.camera === null ? say('marks-need-their-camera') : say('press-frames', { make: say('make-frames') });
}
