/** The plots of a block: what they show of images, points and observations, and what each value is about. */
import { numbers, words } from '../../shared/state/columns';
import { remember } from '../../shared/state/remember';
import type { Column } from '../../shared/state/rows';
import type { ViewObservations } from './facts';
import type { ViewGround } from './ground';
import { judgedOf, planOf } from './judged';
import { normalQuantiles } from './normal';
import { pointColumn, surveyedAt } from './point-kinds';
import { headOf, pointCoordinates, resultSystem, unitOn } from './result-system';
import { unitOf } from './scale';
import { among } from './observations';
import { choiceOfImages, choiceOfPoints, imagesOf, pointsOf } from './selection';
import type { Choice } from './selection';
import type { BlockView } from './view';
import { say } from '../../shared/text/words';

export type PlotName = 'residuals' | 'w' | 'detectable' | 'images' | 'rays' | 'sigma-plan' | 'sigma-height' | 'gnss' | 'surveyed-plan' | 'surveyed-height';

export const PLOTS: readonly (readonly [PlotName, string])[] = [
  ['images', say('residuals-by-image')],
  ['residuals', say('residuals-of-observations')],
  ['w', say('w-against-the-normal-distribution')],
  ['detectable', say('minimal-detectable-biases-by-image')],
  ['rays', say('tie-points-by-rays')],
  ['sigma-plan', say('standard-errors-in-plan-along')],
  ['sigma-height', say('standard-errors-in-height-along')],
  ['gnss', say('gnss-positions')],
  ['surveyed-plan', say('control-and-check-points-plan')],
  ['surveyed-height', say('control-and-check-points-height')],
];

export interface Axis {
  label: string;
  unit: string;
  values: Float64Array;
  /** The values are places of a list, or about them: so many, with these names. */
  names?: readonly string[];
  /** Values above 0 that are told apart by their ratios; what is infinite stands over all others. */
  logarithmic?: boolean;
}

export interface PlotData {
  x: Axis;
  y: Axis;
  /** Bars from zero, one a value; else points. */
  bars: boolean;
  /** Both axes have one scale. */
  square: boolean;
  /** A line goes where both values are the same. */
  equal?: boolean;
  /** The ends of whiskers about the values: intervals of 95 %; NaN where none is known. */
  whiskers?: { from: Float64Array; to: Float64Array };
  /** What the values are of: drawn apart, with a legend. */
  groups?: Groups;
  /** Columns of its file that say what a value is about, where its axes do not. */
  about?: readonly Column[];
  /** Columns of its file that say more of the values. */
  more?: readonly Column[];
  /** What is said of a value under the pointer, where its axes do not say all. */
  said?: (row: number) => string;
  /** What a value is about. */
  choice: (row: number) => Choice | null;
  /** Tells the values that a choice is about. */
  chosen: (choice: Choice | null) => (row: number) => boolean;
  /** What several values together are about; null where nothing is all of it. */
  together: (rows: readonly number[]) => Choice | null;
}

export interface Groups {
  kinds: readonly { label: string; mark: 'square' | 'triangle' | 'outline' }[];
  of: (row: number) => number;
}

/** What of a block is asked of its worker. */
export interface PlotFacts {
  observations: () => ViewObservations | null;
  ground: () => ViewGround | null;
}

/** A plot; null while what it shows is on its way. Without a value where the block does not have that. */
export function plotOf(name: PlotName, view: BlockView, facts: PlotFacts): PlotData | null {
  switch (name) {
    case 'images':
      return byImage(view);
    case 'rays':
      return byRays(view);
    case 'sigma-plan':
    case 'sigma-height':
      return alongBlock(view, name === 'sigma-plan');
    case 'surveyed-plan':
    case 'surveyed-height':
      return surveyedPoints(view, name === 'surveyed-plan');
    case 'residuals':
    case 'w':
    case 'detectable': {
      const of = facts.observations();
      if (of === null) return null;
      return name === 'residuals' ? residuals(view, of) : name === 'w' ? sortedTests(view, of) : detectable(view, of);
    }
    case 'gnss': {
      const ground = facts.ground();
      return ground === null ? null : positions(view, ground);
    }
  }
}

/** Values of images. */
function ofImages({ images }: BlockView, y: Omit<Axis, 'values'>, value: (image: number) => number): PlotData {
  const rows = Array.from(images.keys()).filter((image) => !Number.isNaN(value(image)));
  const names = rows.map((image) => images[image]?.name ?? '');
  return {
    x: { label: say('image-2'), unit: '', values: Float64Array.from(rows.keys()), names },
    y: { ...y, values: Float64Array.from(rows, value) },
    bars: true,
    square: false,
    choice: (row) => (rows[row] === undefined ? null : { kind: 'image', image: rows[row] }),
    chosen: (choice) => {
      const chosen = new Set(imagesOf(choice));
      return (row) => chosen.has(rows[row] ?? -1);
    },
    together: (chosen) => choiceOfImages(chosen.flatMap((row) => rows[row] ?? [])),
  };
}

const byImage = remember((view: BlockView) =>
  ofImages(view, { label: say('rmse-of-the-residuals'), unit: 'px' }, (image) => view.images[image]?.rmsePx ?? NaN),
);

const positions = remember((view: BlockView, { gnss }: ViewGround) =>
  ofImages(view, { label: say('gnss-minus-adjusted-position'), unit: 'm' }, (image) => {
    const { position } = view.images[image] ?? {};
    return position == null ? NaN : Math.hypot(...position.map((value, axis) => (gnss[3 * image + axis] ?? NaN) - value));
  }),
);

/** Values of points, by their indices. */
function ofPoints(points: Uint32Array, x: Axis, y: Axis, bars = false): PlotData {
  return {
    x,
    y,
    bars,
    square: false,
    choice: (row) => (points[row] === undefined ? null : { kind: 'point', point: points[row] }),
    chosen: (choice) => {
      const chosen = new Set(pointsOf(choice));
      return (row) => chosen.has(points[row] ?? -1);
    },
    together: (rows) => choiceOfPoints(rows.flatMap((row) => points[row] ?? [])),
  };
}

/** Standard errors of points over their place along the longer side of the block, in the system of the results. */
const alongBlock = remember((view: BlockView, plan: boolean): PlotData => {
  const { points } = view;
  const system = resultSystem(view);
  const coordinate = (point: number, axis: number) => points.positions[3 * point + axis] ?? NaN;
  const error = (point: number) => {
    const [x = NaN, y = NaN, z = NaN] = points.errors.subarray(3 * point, 3 * point + 3);
    return plan ? Math.hypot(x, y) : z;
  };
  const rows = Uint32Array.from({ length: points.taking }, (_, point) => point).filter(
    (point) => !Number.isNaN(error(point)) && !Number.isNaN(coordinate(point, 0)),
  );
  const span = [0, 1].map((axis) => {
    let [low, high] = [Infinity, -Infinity];
    for (const point of rows) [low, high] = [Math.min(low, coordinate(point, axis)), Math.max(high, coordinate(point, axis))];
    return high - low;
  });
  const axis = (span[1] ?? 0) > (span[0] ?? 0) ? 1 : 0;
  const coordinates = pointCoordinates(view);
  const x = {
    label: headOf(system, axis === 0 ? 'X' : 'Y'),
    unit: unitOn(system, axis),
    values: Float64Array.from(rows, (point) => coordinates[3 * point + axis] ?? NaN),
  };
  const y = { label: plan ? say('standard-error-in-plan') : say('standard-error-in-height'), unit: unitOf(view), values: Float64Array.from(rows, error) };
  return { ...ofPoints(rows, x, y), about: [pointColumn(view, 'point', (row) => rows[row], '')] };
});

/** As the map draws them: control points are triangles, check points squares. */
const SURVEYED_KINDS = [
  { key: 'check', label: say('check-point'), mark: 'square' },
  { key: 'left_out', label: say('control-point-left-out'), mark: 'triangle' },
  { key: 'adjusted', label: say('control-point-adjusted'), mark: 'outline' },
] as const;

/** Normally distributed errors are within so many standard errors with a probability of 95 %. */
const WITHIN_95 = 1.96;

const surveyedPoints = remember(({ surveyed }: BlockView, plan: boolean): PlotData => {
  const used = surveyed.filter(({ isUsed }) => isUsed);
  const judged = used.map(judgedOf);
  const values = Float64Array.from(judged, (one) => (plan ? planOf(one).length : (one.difference[2] ?? NaN)));
  const errors = Float64Array.from(judged, (one) => (plan ? planOf(one).error : (one.errors[2] ?? NaN)));
  const ratio = (row: number) => ((errors[row] ?? NaN) > 0 ? (values[row] ?? NaN) / (errors[row] ?? NaN) : NaN);
  const groupOf = (row: number) => (used[row]?.role === 'check' ? 'check' : judged[row]?.isLeftOut === true ? 'left_out' : 'adjusted');
  const kinds = SURVEYED_KINDS.filter(({ key }) => used.some((_, row) => groupOf(row) === key));
  const kindText = (row: number) => kinds.find(({ key }) => key === groupOf(row))?.label ?? '';
  const role = (row: number) => say('role', { role: used[row]?.role ?? 'check' });
  const data = ofPoints(
    Uint32Array.from(used, ({ point }) => point),
    { label: say('point'), unit: '', values: Float64Array.from(used.keys()), names: used.map(({ name }) => name) },
    { label: plan ? say('adjusted-minus-surveyed-place') : say('adjusted-minus-surveyed-height'), unit: 'm', values },
  );
  return {
    ...data,
    // A length ends at 0.
    whiskers: {
      from: values.map((value, row) => Math.max(plan ? 0 : -Infinity, value - WITHIN_95 * (errors[row] ?? NaN))),
      to: values.map((value, row) => value + WITHIN_95 * (errors[row] ?? NaN)),
    },
    groups: { kinds, of: (row) => kinds.findIndex(({ key }) => key === groupOf(row)) },
    about: [words('use', say('use'), role, ''), words('kind', say('kind'), kindText, '')],
    more: [numbers('sigma', 'σ', 'm', 4, (row) => errors[row], ''), numbers('ratio', 'Δ/σ', '', 2, ratio, '')],
    said: (row) =>
      say('surveyed-value', {
        name: used[row]?.name ?? '',
        kind: kindText(row),
        difference: values[row] ?? NaN,
        error: errors[row] ?? NaN,
        ratio: ratio(row),
        known: Number.isNaN(ratio(row)) ? 'no' : 'yes',
      }),
  };
});

/** How many tie points have so many rays. */
const byRays = remember((view: BlockView): PlotData => {
  const { taking, rays: all } = view.points;
  const tied = Uint32Array.from({ length: taking }, (_, point) => point).filter((point) => surveyedAt(view, point) === undefined);
  const counts = new Map<number, number>();
  for (const point of tied) counts.set(all[point] ?? 0, (counts.get(all[point] ?? 0) ?? 0) + 1);
  const rays = [...counts.keys()].sort((a, b) => a - b);
  const withRays = (wanted: ReadonlySet<number | undefined>) => choiceOfPoints(tied.filter((point) => wanted.has(all[point])));
  return {
    x: { label: say('rays-2'), unit: '', values: Float64Array.from(rays.keys()), names: rays.map(String) },
    y: { label: say('tie-points'), unit: '', values: Float64Array.from(rays, (number) => counts.get(number) ?? 0) },
    bars: true,
    square: false,
    choice: (row) => withRays(new Set([rays[row]])),
    chosen: (choice) => {
      const chosen = new Set([...pointsOf(choice)].map((point) => all[point]));
      return (row) => chosen.has(rays[row]);
    },
    together: (rows) => withRays(new Set(rows.map((row) => rays[row]))),
  };
});

/** Values of observations, each of the one that `row` gives for it. */
function ofObservations(
  view: BlockView,
  of: ViewObservations,
  row: (value: number) => number,
  x: Axis,
  y: Axis,
  drawn: Pick<PlotData, 'square' | 'equal'>,
): PlotData {
  const pointAt = (value: number) => of.points[row(value)] ?? -1;
  const imageAt = (value: number) => of.images[row(value)] ?? -1;
  return {
    x,
    y,
    bars: false,
    about: [
      // Where the axis does not say it.
      ...(x.names === undefined ? [words('image', say('image-2'), (value) => view.images[imageAt(value)]?.name ?? '', '')] : []),
      pointColumn(view, 'point', pointAt, ''),
    ],
    ...drawn,
    choice: (value) => ({ kind: 'observation', point: pointAt(value), image: imageAt(value) }),
    chosen: (choice) => {
      if (choice?.kind === 'observations') {
        const isOne = among(choice);
        return (value) => isOne(pointAt(value), imageAt(value));
      }
      const [points, images] = [new Set(pointsOf(choice)), new Set(imagesOf(choice))];
      return (value) => (points.size === 0 || points.has(pointAt(value))) && (images.size === 0 || images.has(imageAt(value))) && points.size + images.size > 0;
    },
    together: (chosen) => choiceOfPoints(new Set(chosen.map(pointAt))),
  };
}

/** The observations that take part and have a value. */
function rowsWith(of: ViewObservations, value: (row: number) => number | undefined): Uint32Array {
  return Uint32Array.from(of.points.keys()).filter((row) => !Number.isNaN(value(row)) && of.parts[row] === 0);
}

const residuals = remember((view: BlockView, of: ViewObservations): PlotData => {
  const rows = rowsWith(of, (row) => of.residuals[2 * row]);
  const axis = (label: string, offset: number): Axis => ({
    label,
    unit: 'px',
    values: Float64Array.from(rows, (row) => of.residuals[2 * row + offset] ?? NaN),
  });
  return ofObservations(view, of, (value) => rows[value] ?? -1, axis(say('residual-vx'), 0), axis(say('residual-vy'), 1), { square: true });
});

/** The w-statistics of columns and rows over those that as many normally distributed ones would have. */
const sortedTests = remember((view: BlockView, of: ViewObservations): PlotData => {
  const places = Uint32Array.from(of.w.keys()).filter((place) => !Number.isNaN(of.w[place]) && of.parts[place >> 1] === 0);
  const values = Float64Array.from(places, (place) => of.w[place] ?? NaN);
  const sorted = values.slice().sort();
  const quantiles = normalQuantiles(sorted.length);
  // Equal ones stand at the first of their places.
  const expected = values.map((value) => quantiles[firstAt(sorted, value)] ?? NaN);
  const data = ofObservations(
    view,
    of,
    (value) => (places[value] ?? -2) >> 1,
    { label: say('w-of-normal-errors'), unit: '', values: expected },
    { label: say('w-statistic'), unit: '', values },
    { square: false, equal: true },
  );
  const axis = words('coordinate', say('image-coordinate'), (value) => ((places[value] ?? 0) % 2 === 0 ? 'x' : 'y'), '');
  return { ...data, about: [...(data.about ?? []), axis] };
});

/** The first place of a value among sorted ones. */
function firstAt(sorted: Float64Array, value: number): number {
  let [low, high] = [0, sorted.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((sorted[middle] ?? Infinity) < value) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** The width of an image among its neighbours. */
const BESIDE = 0.8;

/** The larger minimal detectable bias of column and row, image by image, each as far to the right as it lies in its image. An error of any size stays undetected where nothing checks a coordinate. */
const detectable = remember((view: BlockView, of: ViewObservations): PlotData => {
  const { images } = view;
  const larger = (row: number) => {
    const largest = Math.max(of.detectable[2 * row] ?? NaN, of.detectable[2 * row + 1] ?? NaN);
    return Number.isNaN(largest) ? Infinity : largest;
  };
  // What has no redundancy number was not tested at all.
  const rows = rowsWith(of, (row) => of.redundancy[2 * row]);
  const across = (row: number) => {
    const image = of.images[row] ?? -1;
    return image + BESIDE * ((of.places[2 * row] ?? NaN) / (images[image]?.width ?? NaN) - 0.5);
  };
  return ofObservations(
    view,
    of,
    (value) => rows[value] ?? -1,
    { label: say('image-2'), unit: '', values: Float64Array.from(rows, across), names: images.map(({ name }) => name) },
    { label: say('minimal-detectable-bias'), unit: 'px', values: Float64Array.from(rows, larger), logarithmic: true },
    { square: false },
  );
});
