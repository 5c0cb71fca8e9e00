/**
 * What an edit of the choice is about: of several that are chosen those that are listed. A filter leaves what it does not keep out of the table, the map
 * and the images alike, and who filters means what is left. The choice itself stays as it is: the half of a limit that is being typed would take it away
 * for good, and it is whole again without the filter. What is chosen alone is named where it is edited, and stands in other lists too, as a control point
 * among the points and in a table of its own, so that it is edited whatever leaves it out of one of them.
 */
import { remember } from '../../shared/state/remember';
import { keeping } from '../../shared/state/rows';
import { keptBy, observationRows } from './columns';
import type { ViewObservations } from './facts';
import { among, choiceOfObservations, observationsKept } from './observations';
import { choiceOfImages, choiceOfPairs, choiceOfPoints, keyOfPair } from './selection';
import type { Choice, Selection } from './selection';
import type { BlockView } from './view';

export interface ListedChoice {
  choice: Choice | null;
  /** So many are chosen and not listed. */
  others: number;
}

const places = remember(({ connections }: BlockView): ReadonlyMap<string, number> => new Map(connections.map(({ images }, row) => [keyOfPair(images), row])));

/** Tells whether a pair is listed. One that was never tried is in no table. */
function keepsPair(view: BlockView, filters: Selection['filters']): (pair: readonly [number, number]) => boolean {
  const keeps = keptBy('pairs', view, { filters });
  return (pair) => keeps(places(view).get(keyOfPair(pair)) ?? -1);
}

/** Tells whether an observation is listed; with a filter none is before their figures are there. */
function keepsObservation(view: BlockView, filters: Selection['filters'], of: ViewObservations | null): (point: number, image: number) => boolean {
  const { observations: filter = {} } = filters;
  if (Object.keys(filter).length === 0) return () => true;
  const meets = of === null ? () => false : keeping(observationRows(view, of).columns, filter);
  if (of === null || meets === null) return meets ?? (() => true);
  return among(observationsKept(of, meets));
}

const listed = remember((view: BlockView, chosen: Choice | null, filters: Selection['filters'], observations: ViewObservations | null): ListedChoice => {
  const of = <T>(all: Iterable<T>, keeps: (one: T) => boolean, choiceOf: (kept: readonly T[]) => Choice | null): ListedChoice => {
    const [every, kept] = [[...all], [] as T[]];
    for (const one of every) if (keeps(one)) kept.push(one);
    const others = every.length - kept.length;
    return { choice: others === 0 ? chosen : choiceOf(kept), others };
  };
  switch (chosen?.kind) {
    case 'points':
      return of(chosen.points, keptBy('points', view, { filters }), choiceOfPoints);
    case 'images':
      return of(chosen.images, keptBy('images', view, { filters }), choiceOfImages);
    case 'pairs':
      return of(chosen.pairs, keepsPair(view, filters), choiceOfPairs);
    case 'observations': {
      const keeps = keepsObservation(view, filters, observations);
      const kept = observationsKept(chosen, (i) => keeps(chosen.points[i] ?? -1, chosen.images[i] ?? -1));
      const others = chosen.points.length - kept.points.length;
      return { choice: others === 0 ? chosen : choiceOfObservations(kept), others };
    }
    default:
      return { choice: chosen, others: 0 };
  }
});

/** What is chosen and listed, and how many more are chosen. `observations`: all of the block, null while they are on their way. */
export function listedChoice({ chosen, filters }: Selection, view: BlockView, observations: () => ViewObservations | null): ListedChoice {
  // They are asked for where some are chosen: of a large block that takes a while.
  return listed(view, chosen, filters, chosen?.kind === 'observations' ? observations() : null);
}
