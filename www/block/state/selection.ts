/** What is chosen, pointed at and filtered: one for all views of a block. Pure: the same selection and action give the same selection. */
import type { Filter } from '../../shared/state/rows';
import type { BlockView } from './view';

/** Points and images of observations, side by side, in ascending order of points, then of images; none twice. */
export interface Observations {
  points: Uint32Array;
  images: Uint32Array;
}

/** What is looked at. Numbers are those of the `BlockView`; each kind names what it is about, so that a view shows the kinds that it knows. */
export type Choice =
  | { kind: 'image'; image: number }
  /** Two or more images, in ascending order. */
  | { kind: 'images'; images: readonly number[] }
  | { kind: 'pair'; images: [number, number] }
  /** Two or more pairs of images, both in ascending order. */
  | { kind: 'pairs'; pairs: readonly (readonly [number, number])[] }
  | { kind: 'point'; point: number }
  /** A tie point as one image shows it. */
  | { kind: 'observation'; point: number; image: number }
  /** Two or more of them. */
  | ({ kind: 'observations' } & Observations)
  /** Two or more tie points, in ascending order. */
  | { kind: 'points'; points: Uint32Array }
  /** A control or check point that was given and is not in the block. */
  | { kind: 'given'; name: string };

/** What rows of a table are. */
export type Subject = 'images' | 'pairs' | 'points' | 'observations' | 'surveyed';

export interface Selection {
  chosen: Choice | null;
  pointed: Choice | null;
  filters: Readonly<Partial<Record<Subject, Filter>>>;
}

export type SelectionAction =
  | { type: 'choose'; choice: Choice | null }
  /** The pointer, or the row with the keyboard, is over something, or has left. */
  | { type: 'point'; choice: Choice | null }
  /** What is not kept by the filter is shown in no view. */
  | { type: 'filter'; subject: Subject; filter: Filter };

export const NOTHING_SELECTED: Selection = { chosen: null, pointed: null, filters: {} };

export function reduceSelection(selection: Selection, action: SelectionAction): Selection {
  switch (action.type) {
    case 'choose':
      return isSame(selection.chosen, action.choice) ? selection : { ...selection, chosen: action.choice };
    case 'point':
      return isSame(selection.pointed, action.choice) ? selection : { ...selection, pointed: action.choice };
    case 'filter':
      return { ...selection, filters: { ...selection.filters, [action.subject]: action.filter } };
  }
}

/** Points as they are chosen together: none, one, or several. */
export function choiceOfPoints(points: Iterable<number>): Choice | null {
  const given = Uint32Array.from(points);
  // Of many thousands a set takes longer than all else.
  const sorted = given.every((point, i) => i === 0 || point > (given[i - 1] ?? 0)) ? given : Uint32Array.from(new Set(given)).sort();
  const [first] = sorted;
  if (first === undefined) return null;
  return sorted.length === 1 ? { kind: 'point', point: first } : { kind: 'points', points: sorted };
}

/** Points chosen beside those that are; one alone is taken from them where it is chosen. */
export function withMore(chosen: Choice | null, points: readonly number[]): Choice | null {
  const before = new Set(pointsOf(chosen));
  const [only] = points;
  if (points.length === 1 && only !== undefined && before.has(only)) before.delete(only);
  else for (const point of points) before.add(point);
  return choiceOfPoints(before);
}

/** Images as they are chosen together: none, one, or several. */
export function choiceOfImages(images: Iterable<number>): Choice | null {
  const sorted = [...new Set(images)].sort((a, b) => a - b);
  const [first] = sorted;
  if (first === undefined) return null;
  return sorted.length === 1 ? { kind: 'image', image: first } : { kind: 'images', images: sorted };
}

/** Images chosen beside those that are, as with points. */
export function withMoreImages(chosen: Choice | null, images: readonly number[]): Choice | null {
  const before = new Set(chosen?.kind === 'image' || chosen?.kind === 'images' ? imagesOf(chosen) : []);
  const [only] = images;
  if (only === undefined) return chosen;
  if (images.length === 1 && before.has(only)) before.delete(only);
  else for (const image of images) before.add(image);
  return choiceOfImages(before);
}

/** Pairs as they are chosen together: none, one, or several. */
export function choiceOfPairs(pairs: Iterable<readonly [number, number]>): Choice | null {
  const ascending = new Map([...pairs].map(([a, b]) => [keyOfPair([a, b]), a < b ? ([a, b] as const) : ([b, a] as const)]));
  const sorted = [...ascending.values()].sort(([a, b], [c, d]) => a - c || b - d);
  const [first] = sorted;
  if (first === undefined) return null;
  return sorted.length === 1 ? { kind: 'pair', images: [...first] } : { kind: 'pairs', pairs: sorted };
}

/** Pairs chosen beside those that are, as with points. */
export function withMorePairs(chosen: Choice | null, pairs: readonly (readonly [number, number])[]): Choice | null {
  const before = new Map(pairsOf(chosen).map((pair) => [keyOfPair(pair), pair]));
  const [only] = pairs;
  if (only === undefined) return chosen;
  if (pairs.length === 1 && before.has(keyOfPair(only))) before.delete(keyOfPair(only));
  else for (const pair of pairs) before.set(keyOfPair(pair), pair);
  return choiceOfPairs(before.values());
}

/** A name of a pair: the same either way round. */
export function keyOfPair([a, b]: readonly [number, number]): string {
  return a < b ? `${String(a)},${String(b)}` : `${String(b)},${String(a)}`;
}

/** The pairs of images that a choice names. */
export function pairsOf(choice: Choice | null): readonly (readonly [number, number])[] {
  if (choice?.kind === 'pairs') return choice.pairs;
  return choice?.kind === 'pair' ? [choice.images] : [];
}

/** The images that a choice names. */
export function imagesOf(choice: Choice | null): readonly number[] {
  switch (choice?.kind) {
    case 'image':
    case 'observation':
      return [choice.image];
    case 'images':
    case 'pair':
      return choice.images;
    case 'pairs':
      return [...new Set(choice.pairs.flat())].sort((a, b) => a - b);
    default:
      return [];
  }
}

const NO_POINTS = new Uint32Array();

/** The tie points that a choice names. */
export function pointsOf(choice: Choice | null): Uint32Array {
  switch (choice?.kind) {
    case 'point':
    case 'observation':
      return Uint32Array.of(choice.point);
    case 'observations':
      // They are in order.
      return choice.points.filter((point, i) => point !== choice.points[i - 1]);
    case 'points':
      return choice.points;
    default:
      return NO_POINTS;
  }
}

/** Whether both say the same; a pair is the same either way round. */
export function isSame(a: Choice | null, b: Choice | null): boolean {
  if (a === b) return true;
  if (a === null || b === null || a.kind !== b.kind) return false;
  if (a.kind === 'given' && b.kind === 'given') return a.name === b.name;
  if (a.kind === 'observations' && b.kind === 'observations') return isSameList(a.points, b.points) && isSameList(a.images, b.images);
  if (a.kind === 'pairs') return pairsOf(a).map(keyOfPair).join(' ') === pairsOf(b).map(keyOfPair).join(' ');
  const [images, others] = [imagesOf(a), imagesOf(b)];
  const [points, others_] = [pointsOf(a), pointsOf(b)];
  return images.length === others.length && images.every((image) => others.includes(image)) && isSameList(points, others_);
}

const isSameList = (a: Uint32Array, b: Uint32Array): boolean => a.length === b.length && a.every((value, i) => value === b[i]);

/** The selection as another view of the same images has it: images by their names. Points are numbered anew, so that none stays chosen. */
export function inOtherView(selection: Selection, before: BlockView | null, after: BlockView): Selection {
  const { chosen, filters } = selection;
  return { chosen: before === null ? null : moved(chosen, before, after), pointed: null, filters };
}

function moved(choice: Choice | null, before: BlockView, after: BlockView): Choice | null {
  if (choice?.kind === 'given') return choice;
  if (choice?.kind !== 'image' && choice?.kind !== 'images' && choice?.kind !== 'pair' && choice?.kind !== 'pairs') return null;
  const place = (image: number) => after.images.findIndex(({ name }) => name === before.images[image]?.name);
  if (choice.kind === 'images') return choiceOfImages(choice.images.map(place).filter((image) => image >= 0));
  if (choice.kind === 'image') return place(choice.image) < 0 ? null : { kind: 'image', image: place(choice.image) };
  const there = pairsOf(choice).map(([a, b]) => [place(a), place(b)] as const);
  const kept = there.filter((pair) => !pair.includes(-1));
  // A pair by itself keeps its left image.
  return choice.kind === 'pair' && kept[0] !== undefined ? { kind: 'pair', images: [...kept[0]] } : choiceOfPairs(kept);
}
