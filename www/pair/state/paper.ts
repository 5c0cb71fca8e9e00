/** Whether what the paper printed of its own pair can be set beside the results. */
import { pairCameras } from './cameras';
import type { State } from './state';

/** Whether the images are of the paper's camera, which the flight of that name has: other pairs have nothing in common with the paper's. */
export function hasPaperCamera(state: State): boolean {
  const paper = state.catalogue?.flights.find(({ name }) => name === 'paper');
  const cameras = pairCameras(state);
  return paper !== undefined && !('missing' in cameras) && cameras.left.focal_mm === paper.flight.focal_mm;
}
