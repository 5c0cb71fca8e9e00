/** Edits by hand carried to a block that was found anew: what they name must be there, by the names of images and surveyed points. */
import type { BlockEdit, HandMeasurement, PlaceAgain, PointSource } from '../../../pkg/wasm/tiepoint.js';
import type { History } from '../../shared/state/history';
import type { EditStep } from './edits';
import { isPlace } from './naming';
import type { Names } from './naming';
import { keyOfPair } from './selection';

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

/** The edits that hold there, places of the orthophoto by `again`: those of images and their pairs, of surveyed points, and of points that were measured by hand; those of tie points where these are the same. A step that was undone stays where all of its edits do. */
export function carriedOver(
  { edits: steps, done }: History<EditStep>,
  before: Names,
  after: Names,
  sameTiePoints = false,
  again: readonly PlaceAgain[] = [],
): CarriedOver {
  const carrier = new Carrier(before, after, sameTiePoints, again);
  const edits: EditStep[] = [];
  const left = [0];
  const aside: EditStep[] = [];
  let lost = 0;
  let places: CarriedOver['places'] | null = null;
  steps.forEach((step, place) => {
    if (place === done) places = carrier.ofPlaces();
    const own = carrier.step(step, place >= done);
    if (own.length > 0) edits.push(own);
    else if (place >= done) aside.push(step);
    if (place < done) lost += step.length - own.length;
    left.push(edits.length);
  });
  return { history: { edits, done: left[done] ?? edits.length }, left, lost, places: places ?? carrier.ofPlaces(), aside };
}

class Carrier {
  private readonly places: ReadonlyMap<string, number>;
  private readonly surveyed: ReadonlyMap<string, number>;
  /** The new numbers of the points that were added; -1 of those that are gone. */
  private readonly numbers: number[] = [];
  private added = 0;
  /** The new numbers of the surveyed points that were added; -1 of those that are gone. */
  private readonly controls: number[] = [];
  private placed = 0;
  /** Places of the orthophoto by their former numbers. */
  private readonly again: ReadonlyMap<number, PlaceAgain>;
  /** Observations of them that edits added, by their former numbers and images. */
  private readonly measured = new Set<string>();
  /** Places of the orthophoto of which something holds, and of which something does not, by their former numbers. */
  private readonly held = new Set<number>();
  private readonly notHeld = new Set<number>();
  /** So many edits were lost for these. */
  private lostForPlaces = 0;
  /** Whether something of the edit at hand was. */
  private isPlaceLost = false;

  constructor(
    private readonly before: Names,
    private readonly after: Names,
    private readonly sameTiePoints: boolean,
    again: readonly PlaceAgain[],
  ) {
    this.again = new Map(again.map((one) => [one.before, one]));
    this.places = new Map(after.images.map((name, image) => [name, image]));
    this.surveyed = new Map([...after.surveyed].map(([control, name]) => [name, control]));
  }

  ofPlaces(): CarriedOver['places'] {
    return { held: this.held.size, lost: this.notHeld.size, edits: this.lostForPlaces };
  }

  /** `whole`: nothing of it where an edit is lost. */
  step(step: EditStep, whole: boolean): EditStep {
    const [first, added, firstControl, placed] = [this.numbers.length, this.added, this.controls.length, this.placed];
    const own = step.flatMap((edit) => {
      this.isPlaceLost = false;
      const there = this.carried(edit);
      if (there.length === 0 && this.isPlaceLost) this.lostForPlaces += 1;
      return there;
    });
    if (!whole || own.length === step.length) return own;
    // Later steps find none of its points.
    this.numbers.fill(-1, first);
    this.added = added;
    this.controls.fill(-1, firstControl);
    this.placed = placed;
    return [];
  }

  private carried(edit: BlockEdit): BlockEdit[] {
    switch (edit.kind) {
      case 'reject_images':
      case 'restore_images': {
        const images = edit.images.map((image) => this.image(image)).filter((image) => image >= 0);
        return images.length === 0 ? [] : [{ ...edit, images }];
      }
      case 'reject_pairs':
      case 'restore_pairs': {
        const pairs = edit.pairs.map(([a, b]): [number, number] => [this.image(a), this.image(b)]).filter((pair) => this.after.connected.has(keyOfPair(pair)));
        return pairs.length === 0 ? [] : [{ ...edit, pairs }];
      }
      case 'add_point':
        return this.add(edit.observations);
      case 'measure': {
        const [[point], image] = [this.points([edit.point], (place) => place.is_same_spot), this.image(edit.image)];
        if (point === undefined || image < 0) return [];
        if ('ground_control' in edit.point) this.measured.add(keyOf(edit.point.ground_control, image));
        return [{ ...edit, point, image }];
      }
      case 'reject_points':
      case 'restore_points': {
        const points = this.points(edit.points);
        return points.length === 0 ? [] : [{ ...edit, points }];
      }
      case 'reject_observations':
      case 'restore_observations': {
        const observations = edit.observations.flatMap((one) => {
          const image = this.image(one.image);
          const [point] = this.points([one.point], (place) => place.images.includes(image) || this.measured.has(keyOf(place.before, image)));
          return point === undefined || image < 0 ? [] : [{ point, image }];
        });
        return observations.length === 0 ? [] : [{ ...edit, observations }];
      }
      case 'add_control':
        this.controls.push(this.after.givenControl + this.placed);
        this.placed += 1;
        return [edit];
      case 'set_use': {
        const [point] = this.points([{ ground_control: edit.point }]);
        return point !== undefined && 'ground_control' in point ? [{ ...edit, point: point.ground_control }] : [];
      }
    }
  }

  private add(measurements: readonly HandMeasurement[]): BlockEdit[] {
    const observations = measurements.map((one) => ({ ...one, image: this.image(one.image) })).filter(({ image }) => image >= 0);
    const stays = observations.length >= 2;
    this.numbers.push(stays ? this.added : -1);
    if (!stays) return [];
    this.added += 1;
    return [{ kind: 'add_point', observations }];
  }

  private image(image: number): number {
    return this.places.get(this.before.images[image] ?? '') ?? -1;
  }

  private control(control: number): number {
    if (control >= this.before.givenControl) return this.controls[control - this.before.givenControl] ?? -1;
    return this.surveyed.get(this.before.surveyed.get(control) ?? '') ?? -1;
  }

  /** `holds`: whether what is done to a place of the orthophoto that lies there again holds. */
  private points(points: readonly PointSource[], holds: (place: PlaceAgain) => boolean = () => true): PointSource[] {
    return points.flatMap((point): PointSource[] => {
      if ('tie_point' in point) return this.sameTiePoints ? [point] : [];
      if ('manual' in point) {
        const number = this.numbers[point.manual] ?? -1;
        return number < 0 ? [] : [{ manual: number }];
      }
      if (isPlace(this.before.surveyed.get(point.ground_control) ?? '')) return this.place(point.ground_control, holds);
      const control = this.control(point.ground_control);
      return control < 0 ? [] : [{ ground_control: control }];
    });
  }

  private place(control: number, holds: (place: PlaceAgain) => boolean): PointSource[] {
    const place = this.again.get(control);
    const isHeld = place !== undefined && holds(place);
    (isHeld ? this.held : this.notHeld).add(control);
    if (!isHeld) this.isPlaceLost = true;
    return isHeld ? [{ ground_control: place.now }] : [];
  }
}

const keyOf = (control: number, image: number) => `${String(control)} ${String(image)}`;
