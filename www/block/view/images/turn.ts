/** How one image lies to another about a place. Pure. */
import type { Position } from '../../../shared/state/pane';
import type { Turn } from '../../engine/match';
import { inOtherImage } from '../../state/observed';
import type { Pane } from './scene';

/** How far apart places are that say how one image lies to another, px. */
const STEP = 20;
const STRAIGHT: Turn = [1, 0, 0, 1];

/** How steps in one image lie in another, by the points around a place that both show. */
export function turnOf(from: Pane, to: Pane, [x, y]: Position): Turn {
  const { points: own } = from;
  const { points: other } = to;
  if (own === null || other === null) return STRAIGHT;
  const [middle, across, down] = [
    [x, y],
    [x + STEP, y],
    [x, y + STEP],
  ].map(([u = 0, v = 0]) => inOtherImage(own, other, [u, v]));
  if (middle == null || across == null || down == null) return STRAIGHT;
  return [(across[0] - middle[0]) / STEP, (across[1] - middle[1]) / STEP, (down[0] - middle[0]) / STEP, (down[1] - middle[1]) / STEP];
}
