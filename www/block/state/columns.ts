/** The tables of a block: their rows, their columns, and what a row is about. */
import { remember } from '../../shared/state/remember';
import { numbers, words } from '../../shared/state/columns';
import { maskOf } from '../../shared/state/rows';
import type { Column, Filter } from '../../shared/state/rows';
import { imagesOf, keyOfPair, pairsOf, pointsOf } from './selection';
import type { ViewObservations } from './facts';
import { judgedOf, ratioOf } from './judged';
import type { Coordinates } from './marks';
import type { Choice, Selection, Subject } from './selection';
import type { Listed } from './state';
import { pointColumn, surveyedAt } from './point-kinds';
import { headOf, imageCoordinates, pointCoordinates, resultSystem, surveyedCoordinates, unitOn } from './result-system';
import type { ResultSystem } from './result-system';
import { unitOf } from './scale';
import type { BlockView, ViewGiven } from './view';
import { geometryText, givenUse, matchesOf, outcomeText } from './words';
import { say } from '../../shared/text/words';

/** Tables whose rows are known as soon as the block is. */
export type Tabled = Exclude<Subject, 'observations'>;

export interface Rows {
  count: number;
  columns: readonly Column[];
}

export const NO_ROWS: Rows = { count: 0, columns: [] };

const moreOn = ({ more }: ResultSystem, axis: number) => (axis < 2 ? more : 0);

/** `own`: what is said of it in the system of the adjustment. */
function helpOf({ name }: ResultSystem, axis: string, own: string): string {
  return name === '' ? own : say('coordinate-in-system', { axis, name });
}

function imageRows(view: BlockView): Rows {
  const { images, leftOut, cameras } = view;
  const system = resultSystem(view);
  const axis = (key: string, i: number) =>
    numbers(
      key,
      headOf(system, key),
      unitOn(system, i),
      2 + moreOn(system, i),
      (row) => imageCoordinates(view)[3 * row + i],
      helpOf(system, key, say('projection-centre-in-m-where', { key })),
    );
  return {
    count: images.length + leftOut.length,
    columns: [
      words('name', say('image-2'), (i) => images[i]?.name ?? leftOut[i - images.length]?.name ?? '', say('file-name-press-it-to')),
      numbers('number', say('no'), '', 0, (i) => (i < images.length ? i + 1 : NaN), say('row-and-column-in-the')),
      numbers('features', say('features'), '', 0, (i) => images[i]?.features, say('points-detected-and-described'), { total: 'sum' }),
      numbers('rays', say('obs'), '', 0, (i) => images[i]?.rays, say('observations-of-selected-tie-points'), { total: 'sum' }),
      numbers('places', say('cov'), '', 0, (i) => images[i]?.places, say('coverage-how-many-of-the'), {
        total: 'mean',
      }),
      numbers('rmse', 'RMSE', 'px', 2, (i) => images[i]?.rmsePx, say('root-mean-square-length-of-the'), { total: 'rms' }),
      ...(cameras.length > 1
        ? [
            numbers(
              'camera',
              say('camera'),
              '',
              0,
              (i) => (images[i]?.camera ?? NaN) + 1,
              say('images-of-one-camera-are', { join: cameras.map(({ label }, c) => `${String(c + 1)} ${label}`).join('; ') }),
            ),
          ]
        : []),
      words(
        'state',
        say('state'),
        (i) => stateOf(i < images.length ? images[i]?.why : leftOut[i - images.length]?.reason),
        say('whether-the-image-is-oriented'),
      ),
      axis('X', 0),
      axis('Y', 1),
      axis('Z', 2),
    ],
  };
}

function stateOf(why: string | null | undefined): string {
  return why === '' ? say('oriented') : (why ?? say('not-oriented-yet'));
}

function pairRows({ images, connections }: BlockView): Rows {
  const name = (row: number, side: 0 | 1) => images[connections[row]?.images[side] ?? -1]?.name ?? '';
  const matches = (row: number) => {
    const connection = connections[row];
    return connection?.outcome.kind === 'connected' ? matchesOf(connection) : NaN;
  };
  const outcome = (row: number) => (connections[row] === undefined ? '' : outcomeText(connections[row]));
  return {
    count: connections.length,
    columns: [
      words('first', say('image-2'), (i) => name(i, 0), say('the-image-of-the-pair')),
      words('second', say('with'), (i) => name(i, 1), say('the-other-image-of-the')),
      numbers('matches', say('matches-2'), '', 0, matches, say('verified-matches-of-a-connected'), { total: 'sum' }),
      numbers('shared', say('common'), '', 0, (i) => connections[i]?.shared, say('tie-points-that-both-images'), { total: 'sum' }),
      numbers('chosen', say('selected'), '', 0, (i) => connections[i]?.chosen, say('of-them-those-that-were'), { total: 'sum' }),
      words('geometry', say('geometry-2'), (i) => geometryText(connections[i]?.geometry ?? null), say('what-relates-the-two-views')),
      words('reason', say('outcome'), outcome, say('why-the-images-are-connected')),
    ],
  };
}

function pointRows(view: BlockView): Rows {
  const { points } = view;
  const system = resultSystem(view);
  const unit = unitOf(view);
  const axis = (label: string, offset: number) => [
    numbers(
      label.toLowerCase(),
      headOf(system, label),
      unitOn(system, offset),
      2 + moreOn(system, offset),
      (i) => pointCoordinates(view)[3 * i + offset] ?? NaN,
      helpOf(system, label, say('object-coordinate-in-m-where')),
    ),
    numbers(`sigma-${label.toLowerCase()}`, `σ ${label}`, unit, 3, (i) => points.errors[3 * i + offset] ?? NaN, say('standard-error-of-from-the', { label }), {
      total: 'rms',
    }),
  ];
  // Rejected points are in no total.
  const parts = points.count === points.taking ? [] : [{ label: say('accepted'), has: (row: number) => row < points.taking }];
  const kindOf = (point: number) => KINDS[surveyedAt(view, point)?.role ?? 'tie'];
  return {
    count: points.count,
    columns: [
      pointColumn(view, 'point', (i) => i, say('number-of-the-point-press')),
      ...(view.surveyed.length === 0 ? [] : [words('point-kind', say('kind'), kindOf, say('tie-point-or-control'))]),
      numbers('point-rays', say('rays-2'), '', 0, (i) => points.rays[i] ?? NaN, say('observations-of-the-point'), { total: 'mean' }),
      numbers('point-rmse', 'RMSE', 'px', 2, (i) => points.rmsePx[i] ?? NaN, say('root-mean-square-length-of-the'), { total: 'rms' }),
      ...axis('X', 0),
      ...axis('Y', 1),
      ...axis('Z', 2),
      numbers('confidence', say('probability'), '', 3, (i) => points.confidence[i] ?? NaN, say('probability-that-all-its-observations'), { total: 'mean' }),
      { ...words('point-part', say('part'), (i) => partOfPoint(points, i), say('whether-the-point-takes-part')), parts },
    ],
  };
}

function partOfPoint({ taking, lost }: BlockView['points'], point: number): string {
  if (point < taking) return say('accepted');
  return say(lost.has(point) ? 'too-few-rays' : 'rejected-by-hand-2');
}

const KINDS = { tie: say('tie-point-2'), control: say('control-point'), check: say('check-point') } as const;

const NO_COORDINATES: Coordinates = new Map();

/** Coordinates that differ by less are shown as the same, m. */
const SAME_COORDINATE = 0.001;

function surveyedRows(view: BlockView, given: readonly ViewGiven[], asGiven: Coordinates = NO_COORDINATES): Rows {
  const { surveyed } = view;
  const axes = ['X', 'Y', 'Z'];
  const system = resultSystem(view);
  // What was given in the system of the results stands there as it was given, to the last digit that is shown.
  const within = system.name === '' ? 0 : SAME_COORDINATE;
  const differs = (value: number, other: number | undefined) => !(Math.abs(value - (other ?? NaN)) <= within);
  const own = surveyedCoordinates(view);
  const places = given.map(({ place }) => (place === null ? null : system.coordinates(Float64Array.from(place))));
  const isOther = (row: number, name: string) => asGiven.get(name)?.some((value, k) => differs(value, own[3 * row + k])) === true;
  const areElsewhere = given.some(({ position }, i) => places[i] == null || position.some((value, k) => differs(value, places[i]?.[k])));
  const areOthers = areElsewhere || surveyed.some(({ name }, row) => isOther(row, name));
  const judged = surveyed.map(judgedOf);
  const parts = (['control', 'check'] as const).map((role) => ({
    label: roleText(role),
    has: (row: number) => surveyed[row]?.isUsed === true && surveyed[row].role === role,
  }));
  // What was given and is not in the block comes last.
  const beside = (row: number) => given[row - surveyed.length];
  const useText = (row: number) => {
    const own = beside(row);
    const use = own === undefined ? (surveyed[row]?.isUsed === false ? say('not-used') : roleText(surveyed[row]?.role)) : givenUse(own);
    return (own ?? surveyed[row])?.byHand === true ? say('use-by-hand', { use }) : use;
  };
  return {
    count: surveyed.length + given.length,
    columns: [
      words('surveyed', say('point'), (i) => surveyed[i]?.name ?? beside(i)?.name ?? '', say('name-of-the-surveyed-point')),
      // What places the block and what judges it have no root mean square together.
      { ...words('use', say('use'), useText, say('control-points-place-the-block')), parts },
      numbers('surveyed-rays', say('rays-2'), '', 0, (i) => surveyed[i]?.rays ?? NaN, say('image-measurements-that-took-part'), { total: 'sum' }),
      // Where the block has a system of its own, they stand as the surveyor has them, too.
      ...(areOthers
        ? axes.map((axis, k) =>
            numbers(
              `given-${axis}`,
              say('as-given', { axis }),
              '',
              3,
              (i) => beside(i)?.position[k] ?? asGiven.get(surveyed[i]?.name ?? '')?.[k] ?? NaN,
              say('in-the-unit-and-the', { axis }),
            ),
          )
        : []),
      ...axes.map((axis, k) =>
        numbers(
          `surveyed-${axis}`,
          headOf(system, axis),
          system.name === '' ? 'm' : unitOn(system, k),
          3 + moreOn(system, k),
          (i) => (i < surveyed.length ? own[3 * i + k] : places[i - surveyed.length]?.[k]) ?? NaN,
          helpOf(system, axis, say('surveyed-in-the-system-of', { axis })),
        ),
      ),
      ...axes.map((axis, k) =>
        numbers(`difference-${axis}`, `Δ${axis}`, 'm', 3, (i) => surveyed[i]?.difference_m[k] ?? NaN, say('adjusted-minus-surveyed', { axis }), {
          total: 'rms',
        }),
      ),
      ...axes.map((axis, k) =>
        numbers(`difference-sigma-${axis}`, `σ Δ${axis}`, 'm', 3, (i) => surveyed[i]?.standard_errors_m[k], say('standard-error-of', { axis }), {
          total: 'rms',
        }),
      ),
      ...axes.map((axis, k) =>
        numbers(`difference-ratio-${axis}`, `Δ/σ ${axis}`, '', 1, (i) => judged[i] && ratioOf(judged[i], k), say('difference-by-standard-error', { axis }), {
          total: 'rms',
        }),
      ),
      ...axes.map((axis, k) =>
        numbers(
          `left-out-${axis}`,
          say('difference-left-out', { axis }),
          'm',
          3,
          (i) => surveyed[i]?.left_out?.difference[k],
          say('where-the-other-observations-have', { axis }),
          { total: 'rms' },
        ),
      ),
      ...axes.map((axis, k) =>
        numbers(
          `left-out-sigma-${axis}`,
          say('standard-error-left-out', { axis }),
          'm',
          3,
          (i) => surveyed[i]?.left_out?.standard_errors[k],
          say('standard-error-of-where-the', { axis }),
          { total: 'rms' },
        ),
      ),
    ],
  };
}

function roleText(role: 'control' | 'check' | undefined): string {
  return role === undefined ? '' : say('role', { role });
}

const AXES = ['x', 'y'];

const PARTS = [say('accepted'), say('rejected-2'), say('rejected-by-hand-2')];

/** All observations of a block; the same object while both are the same. */
export const observationRows = remember((view: BlockView, of: ViewObservations): Rows => {
  const { images, points } = view;
  // What the adjustment did not take has no root mean square together with what it took.
  const parts = PARTS.map((label, part) => ({ label, has: (row: number) => of.parts[row] === part }));
  const residual = (row: number) => Math.hypot(of.residuals[2 * row] ?? NaN, of.residuals[2 * row + 1] ?? NaN);
  return {
    count: of.points.length,
    columns: [
      { ...words('observation-image', say('image-2'), (i) => images[of.images[i] ?? -1]?.name ?? '', say('the-image-that-shows-the')), parts },
      pointColumn(view, 'observation-point', (i) => of.points[i], say('number-of-the-point')),
      numbers('observation-x', 'x', 'px', 2, (i) => of.places[2 * i] ?? NaN, say('column-the-centre-of-the')),
      numbers('observation-y', 'y', 'px', 2, (i) => of.places[2 * i + 1] ?? NaN, say('row')),
      numbers('observation-vx', 'vx', 'px', 2, (i) => of.residuals[2 * i] ?? NaN, say('residual-in-x-observed-minus'), { total: 'rms' }),
      numbers('observation-vy', 'vy', 'px', 2, (i) => of.residuals[2 * i + 1] ?? NaN, say('residual-in-y-observed-minus'), { total: 'rms' }),
      numbers('observation-v', say('residual'), 'px', 2, residual, say('length-of-the-residual'), { total: 'rms' }),
      numbers('observation-rays', say('rays-2'), '', 0, (i) => points.rays[of.points[i] ?? -1] ?? NaN, say('observations-of-the-point')),
      ...AXES.flatMap((axis, k) => [
        numbers(`observation-r${axis}`, `r ${axis}`, '', 2, (i) => of.redundancy[2 * i + k] ?? NaN, say('redundancy-number-of-an-observation', { axis }), {
          total: 'mean',
        }),
        numbers(`observation-w${axis}`, `w ${axis}`, '', 2, (i) => of.w[2 * i + k] ?? NaN, say('w-statistic-of-an-observation', { axis }), { total: 'rms' }),
        numbers(`observation-mdb${axis}`, `MDB ${axis}`, 'px', 2, (i) => of.detectable[2 * i + k] ?? NaN, say('mdb-of-an-observation', { axis })),
      ]),
      words('observation-part', say('part'), (i) => PARTS[of.parts[i] ?? 0] ?? '', say('whether-the-adjustment-accepted-the')),
    ],
  };
});

/** Whether an observation belongs to what is chosen: to its points in any image, to its images, or to common points of its pairs. Everything where nothing is. */
export function observationsOf(of: ViewObservations, choice: Choice | null): (row: number) => boolean {
  if (choice === null) return () => true;
  if (choice.kind === 'image' || choice.kind === 'images') {
    const images = new Set(imagesOf(choice));
    return (row) => images.has(of.images[row] ?? -1);
  }
  if (choice.kind === 'pair' || choice.kind === 'pairs') {
    const seen = pairsOf(choice).map((pair) => ({ pair, points: commonPoints(of, pair) }));
    return (row) => seen.some(({ pair, points }) => pair.includes(of.images[row] ?? -1) && points.has(of.points[row] ?? -1));
  }
  const points = new Set(pointsOf(choice));
  return (row) => points.has(of.points[row] ?? -1);
}

function commonPoints({ images, points }: ViewObservations, [a, b]: readonly [number, number]): ReadonlySet<number> {
  const first = new Set(points.filter((_, row) => images[row] === a));
  return new Set(points.filter((point, row) => images[row] === b && first.has(point)));
}

const COLUMNS: Readonly<Record<Tabled, (view: BlockView, given: readonly ViewGiven[]) => Rows>> = {
  images: imageRows,
  pairs: pairRows,
  points: pointRows,
  surveyed: surveyedRows,
};

const ofView = { images: remember(imageRows), pairs: remember(pairRows), points: remember(pointRows) };
const withGiven = remember(surveyedRows);

/** The rows of a table of the block; the same object for the same view, and the same points beside it where it lists them. */
export function rowsOf(subject: Tabled, { view, given, asGiven }: Listed): Rows {
  return subject === 'surveyed' ? withGiven(view, given, asGiven) : ofView[subject](view);
}

/** What a row is about; null where it is nothing that can be chosen. */
export function choiceOfRow(subject: Subject, { view, given }: Listed, row: number): Choice | null {
  if (subject === 'images') return row < view.images.length ? { kind: 'image', image: row } : null;
  if (subject === 'points') return { kind: 'point', point: row };
  if (subject === 'surveyed') {
    const beside = given[row - view.surveyed.length];
    if (beside !== undefined) return { kind: 'given', name: beside.name };
    return (view.surveyed[row]?.point ?? -1) < 0 ? null : { kind: 'point', point: view.surveyed[row]?.point ?? -1 };
  }
  const images = subject === 'pairs' ? view.connections[row]?.images : undefined;
  return images === undefined ? null : { kind: 'pair', images };
}

/** The rows that a choice is about. */
export function rowsOfChoice(subject: Subject, { view, given }: Listed, choice: Choice | null): Uint32Array {
  if (subject === 'points') return pointsOf(choice);
  if (subject === 'surveyed') {
    if (choice?.kind === 'given') return Uint32Array.from(given.flatMap(({ name }, i) => (name === choice.name ? [view.surveyed.length + i] : [])));
    const points = new Set(pointsOf(choice));
    return Uint32Array.from(view.surveyed.flatMap(({ point }, row) => (points.has(point) ? [row] : [])));
  }
  if (subject === 'images') return Uint32Array.from(imagesOf(choice));
  if (subject !== 'pairs') return new Uint32Array();
  const pairs = new Set(pairsOf(choice).map(keyOfPair));
  return Uint32Array.from(view.connections.flatMap(({ images }, row) => (pairs.has(keyOfPair(images)) ? [row] : [])));
}

const EMPTY: Filter = {};

/** The rows of a table that a filter keeps. */
function kept(subject: Tabled, view: BlockView, filter: Filter): Uint8Array | null {
  // No view shows the points beside the block.
  const { count: rows, columns } = COLUMNS[subject](view, []);
  return maskOf(rows, columns, filter);
}

/** The test of a subject; the same function while view and filters are the same. */
function testOf(subject: Tabled): (view: BlockView, own: Filter, ofImages: Filter) => (row: number) => boolean {
  return remember((view: BlockView, own: Filter, ofImages: Filter) => {
    const mask = kept(subject, view, own);
    const images = subject === 'pairs' ? kept('images', view, ofImages) : null;
    if (mask === null && images === null) return () => true;
    const keeps = (row: number) => mask === null || mask[row] === 1;
    return images === null ? keeps : (row) => keeps(row) && view.connections[row]?.images.every((image) => images[image] === 1) === true;
  });
}

const TESTS = { images: testOf('images'), pairs: testOf('pairs'), points: testOf('points'), surveyed: testOf('surveyed') };

/** Whether an image, pair, point or surveyed point is shown: what the filter of its table leaves out, no view shows; nor a pair of such an image. */
export function keptBy(subject: Tabled, view: BlockView, { filters }: Pick<Selection, 'filters'>): (row: number) => boolean {
  return TESTS[subject](view, filters[subject] ?? EMPTY, subject === 'pairs' ? (filters.images ?? EMPTY) : EMPTY);
}
