/** What is to be done with scans of film before a block is run. */
import { say } from '../../shared/text/words';
import { awaitsFrames, framesOf } from './film';
import { countedScans } from './scan-marks';
import { purposeOf } from './purpose';
import type { BlockState } from './state';

/** What the user does next where scans are to become images of one camera first; nothing where there are none, or they are placed as they are. */
export function framesStep(state: BlockState): string {
  const { film } = state.placing;
  if (purposeOf(state) === 'images' || !awaitsFrames(film, state.files)) return '';
  const { measured, scans } = countedScans(film, state.files);
  if (framesOf(film, state.files).length === 0) return say('press-measure-marks', { measure: say('measure-marks') });
  const step = film.camera === null ? say('marks-need-their-camera') : say('press-frames', { make: say('make-frames') });
  return measured === scans ? step : `${step} ${say('marks-of-some-scans', { measured, scans })}`;
}
