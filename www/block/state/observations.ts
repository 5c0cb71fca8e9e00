/** Observations as they are chosen together: each is a tie point as one image shows it. Pure. */
import type { Choice, Observations } from './selection';

/** More images than any block has: so that one number names an observation. */
const IMAGES = 2 ** 20;

const keyOf = (point: number, image: number): number => point * IMAGES + image;

const keysOf = ({ points, images }: Observations): Float64Array => Float64Array.from(points, (point, i) => keyOf(point, images[i] ?? 0));

/** The observations that a choice names one by one. */
export function observationsIn(choice: Choice | null): Observations {
  if (choice?.kind === 'observations') return choice;
  const one = choice?.kind === 'observation' ? choice : null;
  return { points: Uint32Array.from(one === null ? [] : [one.point]), images: Uint32Array.from(one === null ? [] : [one.image]) };
}

/** Observations by their keys as they are chosen together: none, one, or several. */
function choiceOfKeys(keys: Iterable<number>): Choice | null {
  const sorted = Float64Array.from(new Set(keys)).sort();
  const points = Uint32Array.from(sorted, (key) => Math.floor(key / IMAGES));
  const images = Uint32Array.from(sorted, (key) => key % IMAGES);
  const [point, image] = [points[0], images[0]];
  if (point === undefined || image === undefined) return null;
  return sorted.length === 1 ? { kind: 'observation', point, image } : { kind: 'observations', points, images };
}

export const choiceOfObservations = (of: Observations): Choice | null => choiceOfKeys(keysOf(of));

/** Observations chosen beside those that are; one alone is taken from them where it is chosen. */
export function withMoreObservations(chosen: Choice | null, more: Observations): Choice | null {
  const keys = new Set(keysOf(observationsIn(chosen)));
  const added = keysOf(more);
  const [only] = added;
  if (added.length === 1 && only !== undefined && keys.has(only)) keys.delete(only);
  else for (const key of added) keys.add(key);
  return choiceOfKeys(keys);
}

/** Those of the observations that a test keeps. */
export function observationsKept(of: Observations, keeps: (i: number) => boolean): Observations {
  const at = Uint32Array.from(of.points.keys()).filter(keeps);
  return { points: Uint32Array.from(at, (i) => of.points[i] ?? 0), images: Uint32Array.from(at, (i) => of.images[i] ?? 0) };
}

/** Tells whether an observation is among these. */
export function among(of: Observations): (point: number, image: number) => boolean {
  const keys = new Set(keysOf(of));
  return (point, image) => keys.has(keyOf(point, image));
}
