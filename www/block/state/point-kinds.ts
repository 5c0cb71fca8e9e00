/** Which points of a block are tie points, and which are ground control and check points: these are called by their names, and are not counted as tie points. Pure. */
import { numbers } from '../../shared/state/columns';
import { remember } from '../../shared/state/remember';
import type { Column } from '../../shared/state/rows';
import { count } from '../../shared/text/format';
import { say } from '../../shared/text/words';
import type { BlockView, ViewSurveyed } from './view';

type WithPoints = Pick<BlockView, 'points' | 'surveyed'>;

export interface PointCount {
  points: number;
  /** Observations of these points, without rejected ones. */
  observations: number;
}

/** The ground control and check points by the indices of their points. */
const surveyedOf = remember((surveyed: BlockView['surveyed']): ReadonlyMap<number, ViewSurveyed> => new Map(surveyed.map((known) => [known.point, known])));

/** The ground control or check point that a point is; undefined of a tie point. */
export function surveyedAt({ surveyed }: Pick<BlockView, 'surveyed'>, point: number): ViewSurveyed | undefined {
  return surveyedOf(surveyed).get(point);
}

/** Whether a point may be measured anew: what was rejected is restored first, what is lost may be moved back. */
export function isMeasurable({ points: { taking, lost } }: Pick<BlockView, 'points'>, point: number): boolean {
  return point < taking || lost.has(point);
}

/** The name of a ground control or check point, the number of a tie point. */
export function pointText(view: WithPoints, point: number): string {
  return surveyedAt(view, point)?.name ?? count(view.points.numbers[point] ?? null);
}

/** A column of points, sorted by their numbers. `point`: that of a row. */
export function pointColumn(view: WithPoints, key: string, point: (row: number) => number | undefined, help: string): Column {
  const index = (row: number) => point(row) ?? NaN;
  return { ...numbers(key, say('point'), '', 0, (row) => view.points.numbers[index(row)], help), text: (row) => pointText(view, index(row)) };
}

/** How many tie points take part, and how many ground control and check points; `gone`: tie points that were rejected by hand. */
export const countedPoints = remember(({ points, surveyed }: WithPoints): { tie: PointCount; surveyed: PointCount; gone: number } => {
  const all = [...surveyedOf(surveyed).keys()].filter((point) => point >= 0);
  const known = all.filter((point) => point < points.taking);
  const observations = points.rays.subarray(0, points.taking).reduce((sum, rays) => sum + rays, 0);
  const own = known.reduce((sum, point) => sum + (points.rays[point] ?? 0), 0);
  return {
    tie: { points: points.taking - known.length, observations: observations - own },
    surveyed: { points: known.length, observations: own },
    gone: points.count - points.taking - points.lost.size - (all.length - known.length),
  };
});
