/** Where given coordinates lie in the system of a block: known where the block is on an orthophoto, or has some of the points already. Pure. */
import { remember } from '../../shared/state/remember';
import type { GroundControlRow } from '../../../pkg/wasm/tiepoint.js';
import type { Position } from '../../shared/state/pane';
import { pointsOfFile } from './marks';
import type { TextFile } from './file';
import type { BlockView } from './view';

/** From x, y as they are given to those of the block. */
type ToBlock = (at: Position) => Position;

const SAME: ToBlock = (at) => at;

/** Null where block and coordinates share no system. */
export const toBlock = remember((view: BlockView, control: TextFile | null): ToBlock | null => {
  if (view.orthophoto?.kind === 'linked') return SAME;
  const inBlock = new Map(view.surveyed.map(({ name, position }) => [name, position]));
  const known = pointsOfFile(control).flatMap(({ name, position }: GroundControlRow): [Position, Position][] => {
    const own = inBlock.get(name);
    return own === undefined
      ? []
      : [
          [
            [position[0], position[1]],
            [own[0], own[1]],
          ],
        ];
  });
  return similarity(known);
});

/** The similarity in plan by least squares; null where fewer than two different places determine it. */
function similarity(pairs: readonly (readonly [Position, Position])[]): ToBlock | null {
  const mean = (of: 0 | 1, axis: 0 | 1) => pairs.reduce((sum, pair) => sum + pair[of][axis], 0) / pairs.length;
  const [mx, my, mu, mv] = [mean(0, 0), mean(0, 1), mean(1, 0), mean(1, 1)];
  let [along, across, squares] = [0, 0, 0];
  for (const [from, to] of pairs) {
    const [x, y, u, v] = [from[0] - mx, from[1] - my, to[0] - mu, to[1] - mv];
    along += x * u + y * v;
    across += x * v - y * u;
    squares += x * x + y * y;
  }
  if (!(squares > 0)) return null;
  const [a, b] = [along / squares, across / squares];
  return ([x, y]) => [mu + a * (x - mx) - b * (y - my), mv + b * (x - mx) + a * (y - my)];
}
