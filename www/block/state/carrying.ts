/** Edits by hand carried to a block that was found anew: what they name must be there, by the names of images and surveyed points. */
import type { BlockEdit, HandMeasurement, PointSource } from '../../../pkg/wasm/tiepoint.js';
import type { History } from '../../shared/state/history';
import type { EditStep } from './edits';
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
  /** Former steps that were undone and cannot be done again there. */
  aside: readonly EditStep[];
}

/** The edits that hold there: those of images and their pairs, of surveyed points, and of points that were measured by hand; those of tie points where these are the same. A step that was undone stays where all of its edits do. */
export function carriedOver({ edits: steps, done }: History<EditStep>, before: Names, after: Names, sameTiePoints = false): CarriedOver {
  const carrier = new Carrier(before, after, sameTiePoints);
  const edits: EditStep[] = [];
  const left = [0];
  const aside: EditStep[] = [];
  let lost = 0;
  steps.forEach((step, place) => {
    const own = carrier.step(step, place >= done);
    if (own.length > 0) edits.push(own);
    else if (place >= done) aside.push(step);
    if (place < done) lost += step.length - own.length;
    left.push(edits.length);
  });
  return { history: { edits, done: left[done] ?? edits.length }, left, lost, aside };
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

  constructor(
    private readonly before: Names,
    private readonly after: Names,
    private readonly sameTiePoints: boolean,
  ) {
    this.places = new Map(after.images.map((name, image) => [name, image]));
    this.surveyed = new Map([...after.surveyed].map(([control, name]) => [name, control]));
  }

  /** `whole`: nothing of it where an edit is lost. */
  step(step: EditStep, whole: boolean): EditStep {
    const [first, added, firstControl, placed] = [this.numbers.length, this.added, this.controls.length, this.placed];
    const own = step.flatMap((edit) => this.carried(edit));
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
        const [[point], image] = [this.points([edit.point]), this.image(edit.image)];
        return point === undefined || image < 0 ? [] : [{ ...edit, point, image }];
      }
      case 'reject_points':
      case 'restore_points': {
        const points = this.points(edit.points);
        return points.length === 0 ? [] : [{ ...edit, points }];
      }
      case 'reject_observations':
      case 'restore_observations': {
        const observations = edit.observations.flatMap((one) => {
          const [[point], image] = [this.points([one.point]), this.image(one.image)];
          return point === undefined || image < 0 ? [] : [{ point, image }];
        });
        return observations.length === 0 ? [] : [{ ...edit, observations }];
      }
      case 'add_control':
        this.controls.push(this.after.givenControl + this.placed);
        this.placed += 1;
        return [edit];
      case 'set_use': {
        const point = this.control(edit.point);
        return point < 0 ? [] : [{ ...edit, point }];
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

  private points(points: readonly PointSource[]): PointSource[] {
    return points.flatMap((point): PointSource[] => {
      if ('tie_point' in point) return this.sameTiePoints ? [point] : [];
      if ('manual' in point) {
        const number = this.numbers[point.manual] ?? -1;
        return number < 0 ? [] : [{ manual: number }];
      }
      const control = this.control(point.ground_control);
      return control < 0 ? [] : [{ ground_control: control }];
    });
  }
}
