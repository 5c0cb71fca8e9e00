/** Where a place that was measured by hand lies on the orthophoto, as it is chosen in the images. Pure. */
import { isPlaceByHand } from './added';
import { surveyedAt } from './point-kinds';
import { pointsOf } from './selection';
import { toSystemOf } from './showing';
import type { BlockState } from './state';
import { mapped } from '../../shared/state/plane-map';

type Given = Pick<BlockState, 'placing' | 'shown' | 'selection'>;

/** X, Y in the system of the orthophoto; null where none is chosen alone, or nothing leads there. */
export function placeOnOrthophoto({ placing: { orthophoto }, shown, selection: { chosen } }: Given): readonly [number, number] | null {
  if (orthophoto === null || orthophoto.ofBlock !== null || shown === null || chosen === null) return null;
  const { view, given } = shown;
  const [point, ...more] = pointsOf(chosen);
  const known = point === undefined || more.length > 0 ? undefined : surveyedAt(view, point);
  const waits = chosen.kind === 'given' ? given.find(({ name }) => name === chosen.name) : undefined;
  if (!isPlaceByHand(known?.name ?? waits?.name ?? '')) return null;
  // Before the block lies there its coordinates are those of the orthophoto, unless they are led into another system.
  if (waits !== undefined && view.crs === null) return [waits.position[0], waits.position[1]];
  const place = known?.position ?? waits?.place ?? null;
  const to = toSystemOf(orthophoto, view);
  return place === null || to === null ? null : mapped(to, place[0], place[1]);
}
