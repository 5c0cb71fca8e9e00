/** What edits of a block by hand are called, as in "Undo: reject 14 observations". */
import type { BlockEdit } from '../../../pkg/wasm/tiepoint.js';
import type { EditStep } from './edits';
import type { MarkStep } from './marks';
import { keyOfPair } from './selection';
import type { BlockView } from './view';
import { say } from '../../shared/text/words';

/** Names of what edits are about; what has none here is counted. */
export interface Names {
  images: readonly string[];
  /** Of surveyed points, by their numbers. */
  surveyed: ReadonlyMap<number, string>;
  /** Keys of the pairs that matches connect. */
  connected: ReadonlySet<string>;
  /** How many surveyed points the block was found with. */
  givenControl: number;
  /** The coordinate reference system that was chosen for it; null where none was. */
  system: string | null;
}

export const NO_NAMES: Names = { images: [], surveyed: new Map(), connected: new Set(), givenControl: 0, system: null };

/** The names of a block as it was found: the same whatever is edited. */
export function namesOf({ images, surveyed, connections, givenControl, crs }: BlockView): Names {
  const connected = connections.filter(({ outcome }) => outcome.kind === 'connected').map((pair) => keyOfPair(pair.images));
  return {
    images: images.map(({ name }) => name),
    surveyed: new Map(surveyed.map(({ control, name }) => [control, name])),
    connected: new Set(connected),
    givenControl,
    system: crs,
  };
}

/** Whether a surveyed point is a place of an orthophoto that was found on it, as the crate names these. */
export const isPlace = (name: string): boolean => /^orthophoto_\d+$/u.test(name);

/** Names without those of places of an orthophoto, which are others on another one. */
export function withoutPlaces({ surveyed, ...names }: Names): Names {
  return { ...names, surveyed: new Map([...surveyed].filter(([, name]) => !isPlace(name))) };
}

/** What a step did. */
export function nameOfStep(step: EditStep, names: Names = NO_NAMES): string {
  const [first, ...more] = step;
  if (first === undefined) return say('nothing');
  if (more.length === 0) return nameOfEdit(first, names);
  if (step.every((edit) => edit.kind === 'measure')) return nameOfMeasures(step, names);
  const added = step.filter(({ kind }) => kind === 'add_point').length;
  const surveyed = first.kind === 'reject_points' && more.every((edit) => edit.kind === 'measure') ? more[0] : undefined;
  if (first.kind === 'reject_points' && surveyed !== undefined) return say('step-join', { points: first.points.length + 1 });
  if (first.kind === 'reject_points' && added === more.length) {
    if (added === 1) return say('step-join', { points: first.points.length });
    if (first.points.length === 1) return say('step-split', { added });
  }
  return say('step-edits', { edits: step.length });
}

/** What was done to measurements of control points, or to the images. */
export function nameOfMarks(step: MarkStep): string {
  if (step.kind === 'remove_images') return say('step-remove-images', { images: step.files.length });
  if (step.kind === 'make_frames') return say('step-make-frames', { scans: step.scans.images.length });
  const { kind, marks } = step;
  const [first] = marks;
  // Their places are beside the images that were made of scans.
  if (first === undefined) return say('step-beside-images');
  const images = marks.length === 1 ? first.image : say('so-many-images', { images: marks.length });
  return kind === 'measure' ? say('step-measure-in', { verb: 'measure', what: first.point, images }) : say('step-unmark', { what: first.point, images });
}

type Measure = Extract<BlockEdit, { kind: 'measure' }>;

function nameOfMeasures(step: readonly Measure[], names: Names): string {
  const [first, ...more] = step;
  const verb = step.every(({ by }) => by === 'least_squares') ? 'match' : 'measure';
  if (first === undefined) return say('nothing');
  const what = 'ground_control' in first.point ? names.surveyed.get(first.point.ground_control) : undefined;
  if (what !== undefined)
    return say('step-measure-in', { verb, what, images: more.length === 0 ? imageName(first.image, names) : say('so-many-images', { images: step.length }) });
  return say('step-measure', { verb, observations: step.length, place: more.length === 0 ? inImage(first.image, names) : '' });
}

/** What an edit did. */
export function nameOfEdit(edit: BlockEdit, names: Names = NO_NAMES): string {
  switch (edit.kind) {
    case 'reject_observations':
    case 'restore_observations': {
      const [only, ...more] = edit.observations;
      return say('step-observations', {
        verb: verbOf(edit.kind),
        observations: edit.observations.length,
        place: only === undefined || more.length > 0 ? '' : inImage(only.image, names),
      });
    }
    case 'reject_points':
    case 'restore_points': {
      const [only, ...more] = edit.points;
      const name = only !== undefined && more.length === 0 && 'ground_control' in only ? names.surveyed.get(only.ground_control) : undefined;
      return name === undefined
        ? say('step-points', { verb: verbOf(edit.kind), points: edit.points.length })
        : say('step-named', { verb: verbOf(edit.kind), name });
    }
    case 'reject_images':
    case 'restore_images': {
      const [only, ...more] = edit.images;
      return say('step-named', {
        verb: verbOf(edit.kind),
        name: only === undefined || more.length > 0 ? say('so-many-images', { images: edit.images.length }) : imageName(only, names),
      });
    }
    case 'reject_pairs':
    case 'restore_pairs': {
      const [only, ...more] = edit.pairs;
      const named = only === undefined || more.length > 0 ? null : only.map((image) => names.images[image]);
      return say('step-named', {
        verb: verbOf(edit.kind),
        name: named === null || named.includes(undefined) ? say('so-many-pairs', { pairs: edit.pairs.length }) : named.join(' – '),
      });
    }
    case 'measure':
      return nameOfMeasures([edit], names);
    case 'add_point':
      return say('step-add-point', { images: edit.observations.length });
    case 'add_control':
      return say('step-add-place', { name: edit.name });
    case 'set_use': {
      const name = names.surveyed.get(edit.point) ?? say('one-surveyed-point');
      return say('step-use', { name, use: edit.use ?? 'none' });
    }
  }
}

const verbOf = (kind: string) => (kind.startsWith('reject') ? 'reject' : 'restore');

function imageName(image: number, { images }: Names): string {
  return images[image] ?? say('so-many-images', { images: 1 });
}

function inImage(image: number, { images }: Names): string {
  const name = images[image];
  return name === undefined ? '' : say('in-image', { name });
}
