/** Edits by hand carried to a block that was found anew, as the crate carries them. */
import { carried_steps } from '../../../pkg/wasm/tiepoint.js';
import type { EditNames, PlaceAgain } from '../../../pkg/wasm/tiepoint.js';
import type { History } from '../../shared/state/history';
import type { EditStep } from './edits';
import type { Names } from './naming';

/** What is left of a history there. */
export interface CarriedOver {
  /** Steps stay steps: what was done at once is undone at once. */
  history: History<EditStep>;
  /** Of the first so many former steps so many are left. */
  left: readonly number[];
  /** So many edits held and do not there. */
  lost: number;
  /** Something that edits in force do to so many places of an orthophoto, or to observations of them, holds; something done to so many does not. `edits`: of the lost ones those that are lost for these. */
  places: { held: number; lost: number; edits: number };
  /** Former steps that were undone and cannot be done again there. */
  aside: readonly EditStep[];
}

export const NO_PLACES_AGAIN = { held: 0, lost: 0, edits: 0 };

/** The edits that hold there; `again`: which places of the orthophoto lie where they lay. */
export function carriedOver(
  { edits, done }: History<EditStep>,
  before: Names,
  after: Names,
  sameTiePoints = false,
  again: readonly PlaceAgain[] = [],
): CarriedOver {
  const steps = edits.map((step) => [...step]);
  const carried = carried_steps({ steps, done, before: numbered(before), after: numbered(after), same_tie_points: sameTiePoints, again: [...again] });
  return {
    history: { edits: carried.steps, done: carried.left[done] ?? carried.steps.length },
    left: carried.left,
    lost: carried.lost,
    places: { held: carried.places_held, lost: carried.places_lost, edits: carried.lost_for_places },
    aside: carried.aside.flatMap((step) => edits.slice(step, step + 1)),
  };
}

function numbered({ images, surveyed, connected, givenControl, system }: Names): EditNames {
  const pairs = [...connected].map((pair): [number, number] => {
    const [a = -1, b = -1] = pair.split(',').map(Number);
    return [a, b];
  });
  return { images: [...images], surveyed: [...surveyed], connected: pairs, found: givenControl, system };
}
