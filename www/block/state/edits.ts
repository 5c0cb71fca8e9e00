/** Edits of a finished block by hand: what they are about, and what stands after some of them. */
import type { BlockEdit, PointImage, PointSource } from '../../../pkg/wasm/tiepoint.js';
import { remember } from '../../shared/state/remember';
import { choiceOfObservations } from './observations';
import type { Choice, Observations } from './selection';
import { imagesOf, keyOfPair, pairsOf, pointsOf } from './selection';
import type { BlockView } from './view';

/** What is done and undone at once: one edit, or the observations of a point that were measured together. */
export type EditStep = readonly BlockEdit[];

/** A name of a point: the same for the same one. */
function keyOfPoint(point: PointSource): string {
  const [[kind, number] = []] = Object.entries(point);
  return `${kind ?? ''} ${String(number)}`;
}

const SOURCES = ['tie_point', 'ground_control', 'manual'] as const;

/** A number for what a point is: a block has many. */
export function codeOfSource(source: PointSource): number {
  const kind = SOURCES.findIndex((name) => name in source);
  const [number = 0] = Object.values(source) as number[];
  return SOURCES.length * number + kind;
}

/** What a point of a block is; null for one that is not oriented. */
export function sourceOf({ points }: BlockView, point: number): PointSource | null {
  const code = points.sources[point];
  const kind = code === undefined ? undefined : SOURCES[code % SOURCES.length];
  if (code === undefined || kind === undefined) return null;
  return { [kind]: Math.floor(code / SOURCES.length) } as PointSource;
}

const places = remember((sources: Float64Array): ReadonlyMap<number, number> => new Map([...sources].map((code, point) => [code, point])));

/** The index of a point; -1 where the block has none such. */
export function indexOfSource({ points }: BlockView, source: PointSource): number {
  return places(points.sources).get(codeOfSource(source)) ?? -1;
}

/** What is chosen, in the same block after other edits: points by what they are. */
export function choiceAfterEdit(choice: Choice | null, before: BlockView, after: BlockView): Choice | null {
  if (choice === null || choice.kind === 'given') return choice;
  if (choice.kind === 'image' || choice.kind === 'images' || choice.kind === 'pair' || choice.kind === 'pairs') return choice;
  if (choice.kind === 'observations') return choiceOfObservations(observationsAfter(choice, before, after));
  const moved = [...pointsOf(choice)].flatMap((point) => {
    const source = sourceOf(before, point);
    const index = source === null ? -1 : indexOfSource(after, source);
    return index < 0 ? [] : [index];
  });
  const [first] = moved;
  if (first === undefined) return null;
  if (choice.kind === 'observation') return { ...choice, point: first };
  return moved.length === 1 ? { kind: 'point', point: first } : { kind: 'points', points: Uint32Array.from(moved).sort() };
}

function observationsAfter({ points, images }: Observations, before: BlockView, after: BlockView): Observations {
  const places = Array.from(points, (point) => {
    const source = sourceOf(before, point);
    return source === null ? -1 : indexOfSource(after, source);
  });
  const stays = (_: number, i: number) => (places[i] ?? -1) >= 0;
  return { points: Uint32Array.from(places.filter(stays)), images: images.filter(stays) };
}

/** Points that are chosen, in a block that was found anew with the same tie points; null where a surveyed one among them may be another. */
export function choiceOfSamePoints(choice: Choice | null, before: BlockView, after: BlockView): Choice | null {
  const points = pointsOf(choice);
  const nameOf = ({ surveyed }: BlockView, number: number) => surveyed.find(({ control }) => control === number)?.name;
  const isSame = (point: number) => {
    const source = sourceOf(before, point);
    return source !== null && (!('ground_control' in source) || nameOf(before, source.ground_control) === nameOf(after, source.ground_control));
  };
  return points.length > 0 && points.every(isSame) ? choiceAfterEdit(choice, before, after) : null;
}

/** What was rejected by hand and not restored, and what was measured by hand. */
export interface Standing {
  observations: ReadonlyMap<string, PointImage>;
  points: ReadonlyMap<string, PointSource>;
  images: ReadonlySet<number>;
  pairs: ReadonlyMap<string, [number, number]>;
  /** Surveyed points that were left out, by their numbers. */
  unused: ReadonlySet<number>;
  /** Codes of the points that were measured by hand, by image. */
  measured: ReadonlyMap<number, ReadonlySet<number>>;
}

const keyOfObservation = ({ point, image }: PointImage) => `${keyOfPoint(point)} ${String(image)}`;

export const standingOf = remember((edits: readonly BlockEdit[]): Standing => {
  const observations = new Map<string, PointImage>();
  const points = new Map<string, PointSource>();
  const images = new Set<number>();
  const pairs = new Map<string, [number, number]>();
  const unused = new Set<number>();
  const measured = new Map<number, Set<number>>();
  const measure = (image: number, point: PointSource) => {
    measured.set(image, (measured.get(image) ?? new Set()).add(codeOfSource(point)));
    observations.delete(keyOfObservation({ point, image }));
  };
  let added = 0;
  for (const edit of edits) {
    switch (edit.kind) {
      case 'reject_observations':
        for (const one of edit.observations) observations.set(keyOfObservation(one), one);
        break;
      case 'restore_observations':
        for (const one of edit.observations) observations.delete(keyOfObservation(one));
        break;
      case 'reject_points':
        for (const point of edit.points) points.set(keyOfPoint(point), point);
        break;
      case 'restore_points':
        for (const point of edit.points) {
          points.delete(keyOfPoint(point));
          // A surveyed point that was left out comes back with the use that it had.
          if ('ground_control' in point) unused.delete(point.ground_control);
        }
        break;
      case 'reject_images':
        for (const image of edit.images) images.add(image);
        break;
      case 'restore_images':
        for (const image of edit.images) images.delete(image);
        break;
      case 'reject_pairs':
        for (const pair of edit.pairs) pairs.set(keyOfPair(pair), pair);
        break;
      case 'restore_pairs':
        for (const pair of edit.pairs) pairs.delete(keyOfPair(pair));
        break;
      case 'measure':
        measure(edit.image, edit.point);
        break;
      case 'add_point':
        for (const { image } of edit.observations) measure(image, { manual: added });
        added += 1;
        break;
      case 'add_control':
        break;
      case 'set_use':
        if (edit.use == null) unused.add(edit.point);
        else unused.delete(edit.point);
    }
  }
  return { observations, points, images, pairs, unused, measured };
});

const connectedPairs = remember(
  ({ connections }: BlockView): ReadonlySet<string> =>
    new Set(connections.filter(({ outcome }) => outcome.kind === 'connected').map(({ images }) => keyOfPair(images))),
);

/** Rejects what is chosen, or uses it again; null where there is nothing of it. `whole`: of an observation its point with all others. */
export function editOfChoice(kind: 'reject' | 'restore', choice: Choice | null, view: BlockView, standing: Standing, whole = false): BlockEdit | null {
  const rejects = kind === 'reject';
  switch (choice?.kind) {
    case 'image':
    case 'images': {
      const images = imagesOf(choice).filter((image) => standing.images.has(image) !== rejects);
      return images.length === 0 ? null : { kind: `${kind}_images`, images };
    }
    case 'pair':
    case 'pairs': {
      // What was never oriented has no observations that could be left out.
      const isInBlock = (image: number) => view.images[image]?.oriented !== false || standing.images.has(image);
      const connected = pairsOf(choice).filter((pair) => connectedPairs(view).has(keyOfPair(pair)) && pair.every(isInBlock));
      const pairs = connected.filter((pair) => standing.pairs.has(keyOfPair(pair)) !== rejects).map(([a, b]): [number, number] => [a, b]);
      return pairs.length === 0 ? null : { kind: `${kind}_pairs`, pairs };
    }
    case 'observation': {
      const point = sourceOf(view, choice.point);
      if (point === null) return null;
      if (whole || isOut(point, standing)) return editOfPoints(kind, [point], standing);
      const one = { point, image: choice.image };
      return standing.observations.has(keyOfObservation(one)) === rejects ? null : { kind: `${kind}_observations`, observations: [one] };
    }
    case 'observations':
      return editOfObservations(kind, choice, view, standing);
    case 'point':
    case 'points':
      return editOfPoints(
        kind,
        [...pointsOf(choice)].flatMap((point) => sourceOf(view, point) ?? []),
        standing,
      );
    default:
      return null;
  }
}

/** Those of points that are out take no part, whatever is done to them. */
function editOfObservations(kind: 'reject' | 'restore', { points, images }: Observations, view: BlockView, standing: Standing): BlockEdit | null {
  const observations = [...points].flatMap((number, i) => {
    const point = sourceOf(view, number);
    const one = point === null ? null : { point, image: images[i] ?? 0 };
    return one === null || isOut(one.point, standing) || standing.observations.has(keyOfObservation(one)) === (kind === 'reject') ? [] : [one];
  });
  return observations.length === 0 ? null : { kind: `${kind}_observations`, observations };
}

/** Whether a point was rejected, or is a surveyed point that is not used. */
function isOut(point: PointSource, { points, unused }: Standing): boolean {
  return points.has(keyOfPoint(point)) || ('ground_control' in point && unused.has(point.ground_control));
}

function editOfPoints(kind: 'reject' | 'restore', all: readonly PointSource[], standing: Standing): BlockEdit | null {
  const points = all.filter((point) => isOut(point, standing) !== (kind === 'reject'));
  if (points.length > 0) return { kind: `${kind}_points`, points };
  if (kind === 'reject') return null;
  // A point can be out for its observations alone.
  const keys = new Set(all.map(keyOfPoint));
  const observations = [...standing.observations.values()].filter(({ point }) => keys.has(keyOfPoint(point)));
  return observations.length === 0 ? null : { kind: 'restore_observations', observations };
}
