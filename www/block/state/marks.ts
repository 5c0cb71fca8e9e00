/** Image measurements of control and check points that are collected by hand, beside those of a file: which hold, and whether they take the points into a run. Pure. */
import { image_measurement_table, parse_ground_control_points, parse_image_measurements } from '../../../pkg/wasm/tiepoint.js';
import type { GroundControlRow, ImageMeasurementRow } from '../../../pkg/wasm/tiepoint.js';
import type { History } from '../../shared/state/history';
import type { Position } from '../../shared/state/pane';
import { remember } from '../../shared/state/remember';
import type { BlockFile, TextFile } from './file';
import type { GivenFilm } from './film';
import type { Purpose } from './placing';
import type { BlockView } from './view';

/** So many control points place a block, each measured in so many images. Where something else places it one point is of use, whatever it is for. */
const LEAST_POINTS = 3;
const LEAST_PLACED = 1;
const LEAST_IMAGES = 2;

/** What is done and undone at once to what a run is given. `after`: so many edits of the block held then; what was done last is undone first. */
export type MarkStep =
  /** Measurements of a point that are taken, or taken away. Images and points by their names. */
  | { kind: 'measure' | 'remove'; marks: readonly ImageMeasurementRow[]; after: number }
  /** Images that are taken out of the block, by the ids of their files. */
  | { kind: 'remove_images'; files: readonly number[]; after: number }
  | FramesStep;

/** What a block has of scans, or of the images that were made of them. */
export interface Framing {
  images: readonly BlockFile[];
  /** All of the block. */
  masks: readonly BlockFile[];
  cameras: TextFile | null;
  marks: TextFile | null;
  film: GivenFilm;
  /** The steps before this one, with their measurements in these images. */
  steps: readonly MarkStep[];
}

export interface FramesStep {
  kind: 'make_frames';
  scans: Framing;
  frames: Framing;
  /** So many edits of the block held then. */
  after: number;
}

export const isFramesStep = (step: MarkStep): step is FramesStep => step.kind === 'make_frames';

/** A step on measurements alone. */
type MeasureStep = Extract<MarkStep, { marks: unknown }>;

const isMeasureStep = (step: MarkStep): step is MeasureStep => 'marks' in step;

interface Named {
  name: string;
}

interface Given {
  control: TextFile | null;
  marks: TextFile | null;
}

/** The points of a file; none of one that cannot be read, which is said where it is given. */
export const pointsOfFile = remember((control: TextFile | null): readonly GroundControlRow[] => readOr(control, parse_ground_control_points));

/** Coordinates of points by their names. */
export type Coordinates = ReadonlyMap<string, readonly [number, number, number]>;

/** The coordinates of a table, as that has them. */
export const coordinatesOf = remember((control: TextFile | null): Coordinates => new Map(pointsOfFile(control).map(({ name, position }) => [name, position])));

/** With the names of the images that the file means. */
const marksOfFile = remember((marks: TextFile | null, images: readonly Named[]): readonly ImageMeasurementRow[] => {
  const names = images.map(({ name }) => name);
  return readOr(marks, (text) => parse_image_measurements(text, names));
});

function readOr<T>(file: TextFile | null, read: (text: string) => T[]): readonly T[] {
  try {
    return file === null ? [] : read(file.text);
  } catch {
    return [];
  }
}

const keyOf = ({ image, point }: ImageMeasurementRow): string => JSON.stringify([image, point]);

/** The measurements by hand that hold. */
export const marksByHand = remember(({ edits, done }: History<MarkStep>): readonly ImageMeasurementRow[] => {
  const held = new Map<string, ImageMeasurementRow>();
  for (const step of edits.slice(0, done)) {
    if (!isMeasureStep(step)) continue;
    for (const mark of step.marks) {
      held.delete(keyOf(mark));
      if (step.kind === 'measure') held.set(keyOf(mark), mark);
    }
  }
  return [...held.values()];
});

/** All measurements, those by hand in place of those of the file. */
export const allMarks = remember((file: TextFile | null, history: History<MarkStep>, images: readonly Named[]): readonly ImageMeasurementRow[] => {
  const all = [...marksOfFile(file, images), ...marksByHand(history)];
  return [...new Map(all.map((mark) => [keyOf(mark), mark])).values()];
});

interface Collected {
  /** Of the points that count, those that are measured in two images or more. */
  twice: number;
  /** So many points are needed. */
  needed: number;
  /** The texts of a run; null where the points take no part in it. */
  run: { points: string; marks: string } | null;
  /** Nothing was measured by hand: files are taken as they are, and refused where they cannot be. */
  asGiven: boolean;
}

const collected = remember(
  (control: TextFile | null, file: TextFile | null, history: History<MarkStep>, files: readonly Named[], isPlaced: boolean): Collected => {
    const byHand = marksByHand(history);
    const needed = isPlaced ? LEAST_PLACED : LEAST_POINTS;
    if (control === null) return { twice: 0, needed, run: null, asGiven: true };
    if (file !== null && byHand.length === 0) return { twice: 0, needed, run: { points: control.text, marks: file.text }, asGiven: true };
    const points = pointsOfFile(control);
    const [names, images] = [new Set(points.map(({ name }) => name)), new Set(files.map(({ name }) => name))];
    // What is of points or images that are there no longer waits for them; a file says so by itself.
    const ofHand = new Set(byHand);
    const marks = allMarks(file, history, files).filter((mark) => !ofHand.has(mark) || (names.has(mark.point) && images.has(mark.image)));
    const seen = new Map<string, number>();
    for (const { point, image } of marks) if (images.has(image)) seen.set(point, (seen.get(point) ?? 0) + 1);
    const counts = ({ role }: GroundControlRow) => role === 'control' || (isPlaced && role === 'check');
    const twice = points.filter((point) => counts(point) && (seen.get(point.name) ?? 0) >= LEAST_IMAGES).length;
    return { twice, needed, run: twice < needed ? null : { points: control.text, marks: image_measurement_table(marks) }, asGiven: false };
  },
);

/** What of control points a state has. */
export interface WithMarks {
  files: readonly Named[];
  options: Given;
  marks: History<MarkStep>;
  shown: { found: Pick<BlockView, 'crs' | 'geoidM' | 'origin'>; ground: object | null } | null;
  placing: { purpose: Purpose | null };
}

/**
 * Whether a block is placed without control points: on an orthophoto, or by GNSS positions in the coordinate system of the points, with heights that count
 * from where theirs do.
 */
function isPlaced({ shown, placing }: Pick<WithMarks, 'shown' | 'placing'>): boolean {
  if (placing.purpose === 'block' || (shown !== null && shown.ground !== null)) return true;
  return shown !== null && shown.found.origin !== null && shown.found.crs !== null && shown.found.geoidM !== null;
}

/** How far the measurements are. */
export function collectedOf(state: WithMarks): Collected {
  const { files, options, marks } = state;
  return collected(options.control, options.marks, marks, files, isPlaced(state));
}

/** Whether control points are given that take no part in a run yet. */
export function waitsForMarks(state: WithMarks): boolean {
  return state.options.control !== null && collectedOf(state).run === null;
}

/** The files of control points and measurements as a run has them. */
export function givenToRun(state: WithMarks): Given {
  const { control, marks } = state.options;
  const { run, asGiven } = collectedOf(state);
  if (control === null || (asGiven && run !== null)) return { control, marks };
  return run === null ? { control: null, marks: null } : { control, marks: { name: marks?.name ?? '', text: run.marks } };
}

/** Where images show a given point, by their indices in the view. */
export const placesOfGiven = remember((name: string, view: BlockView, file: TextFile | null, history: History<MarkStep>): ReadonlyMap<number, Position> => {
  const index = new Map(view.images.map((image, i) => [image.name, i]));
  return new Map(
    allMarks(file, history, view.images).flatMap(({ point, image, x_px, y_px }): [number, Position][] => {
      const at = index.get(image);
      return point === name && at !== undefined ? [[at, [x_px, y_px]]] : [];
    }),
  );
});

/** The steps beside other edits of the block: `place` says after how many of them each was made, of after how many before. */
export function besideEdits(marks: History<MarkStep>, place: (after: number, at: number) => number): History<MarkStep> {
  const places = marks.edits.map(({ after }, at) => place(after, at));
  if (marks.edits.every(({ after }, at) => after === places[at])) return marks;
  return { ...marks, edits: marks.edits.map((step, at) => ({ ...step, after: places[at] ?? step.after })) };
}

/** The steps with other measurements in place of theirs; one that has none left is still a step. */
export function withMeasurements(
  steps: readonly MarkStep[],
  other: (marks: readonly ImageMeasurementRow[]) => readonly ImageMeasurementRow[],
): readonly MarkStep[] {
  return steps.map((step) => (isMeasureStep(step) ? { ...step, marks: other(step.marks) } : step));
}
