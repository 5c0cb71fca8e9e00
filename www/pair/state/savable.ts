/** What of the pair on the screen can be saved now. */
import { isEdited } from './kept';
import { isCurrent } from './keys';
import { isBusy, progress, shownPair } from './select';
import type { State } from './state';

export const EXPORTS = ['csv', 'json', 'project', 'report', 'epipolar', 'png'] as const;

/** What is saved while a run goes on would be of two states: settings of the new one, results of the old one. */
export function savable(state: State): Record<(typeof EXPORTS)[number], boolean> {
  const { images, results } = state;
  const rests = images.left !== null && images.right !== null && !isBusy(state);
  const { wanted, done } = progress(state);
  // The report and epipolar images are made of pixels.
  const areThere = ![images.left, images.right].some((image) => image?.source.kind === 'project');
  const { match, orientation } = shownPair(state);
  return {
    csv: rests && match !== null,
    // It says the settings, too: a run that was cancelled has left results of others.
    json: rests && done === wanted && results.pointsLeft !== undefined,
    project: rests && isCurrent(state, 'match'),
    // It is of edited matches where there are edits.
    report: rests && areThere && (!isEdited(state) || isCurrent(state, 'match')),
    // They are made of the project, which has the orientation where both are up to date.
    epipolar: rests && areThere && orientation !== null && isCurrent(state, 'match') && isCurrent(state, 'orientation'),
    png: images.left !== null || images.right !== null,
  };
}
