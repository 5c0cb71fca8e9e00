/**
 * What an edit of the choice is about: of several that are chosen those that are listed. A filter leaves what it does not keep out of the table, the map
 * and the images alike, and who filters means what is left. The choice itself stays as it is: the half of a limit that is being typed would take it away
 * for good, and it is whole again without the filter. What is chosen alone is named where it is edited, and stands in other lists too, as a control point
 * among the points and in a table of its own, so that it is edited whatever leaves it out of one of them.
 */
import { remember } from '../../shared/state/remember';
import { keptBy } from './columns';
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

const listed = remember((view: BlockView, chosen: Choice | null, filters: Selection['filters']): ListedChoice => {
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
    default:
      return { choice: chosen, others: 0 };
  }
});

/** What is chosen and listed, and how many more are chosen. */
export function listedChoice(selection: Selection, view: BlockView): ListedChoice {
  return listed(view, selection.chosen, selection.filters);
}
