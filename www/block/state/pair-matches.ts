/** What was done by hand to the matches of a pair of the block, and what the block makes of it: edits of its tie points. Pure. */
import type { BlockEdit, PointSource } from '../../../pkg/wasm/tiepoint.js';
import { remember } from '../../shared/state/remember';
import { sourceOf } from './edits';
import type { EditStep } from './edits';
import type { ImagePoints } from './facts';
import type { BlockView } from './view';

/** Where a match lies: x and y in the left, x and y in the right image of the pair, px. */
export type MatchPlace = readonly [xLeft: number, yLeft: number, xRight: number, yRight: number];

/** The matches of a pair, as far as they bear on its block. */
export interface PairMatches {
  /** Those that were rejected by hand, where the matching found them. */
  rejected: readonly MatchPlace[];
  /** Those in use, stride 5: the four coordinates and the measure. */
  used: Float64Array;
  measured: readonly MeasuredMatch[];
}

/** A match that was measured by hand. */
export interface MeasuredMatch {
  at: MatchPlace;
  /** Where the matching had found one that was moved. */
  of: MatchPlace | null;
  /** All places that it was given by hand, in their order: at one of them the block may have taken it. */
  had: readonly MatchPlace[];
}

/** What of it the block has not yet. */
export interface ForBlock {
  /** Rejects the observations of tie points that rejected matches joined; empty where there are none. */
  rejection: EditStep;
  /** So many matches are these. */
  matches: number;
  /** So many rejected matches are of no tie point of the block. */
  without: number;
  /** Takes in the matches that were measured by hand, so many; empty where the block has them. */
  addition: EditStep;
  measured: number;
}

/**
 * A match is that of a tie point where both of its ends lie this near to observations of the point, px. Pair and block find the same points in an image; block
 * positions differ by the rounding to 32 bits, and where least squares refined them by a part of the scale of the point: on simulated blocks by 0.2 px in
 * the median and 1.0 px at most, while the next match lay 2 px away or more, but for one of the same place at another scale.
 */
const SAME_PLACE_PX = 1.5;

/** By so much at most the rounding to 32 bits moves what was measured, px. */
const SAME_MEASUREMENT_PX = 0.01;

/** A tie point that both images of the pair show. */
interface Shared {
  source: PointSource;
  at: MatchPlace;
  /** Whether both observations take part. */
  isUsed: boolean;
  /** Whether one of them was rejected by hand. */
  isRejected: boolean;
}

/** The part of an observation that was rejected by hand. */
const REJECTED = 2;

type Cells = ReadonlyMap<string, readonly Shared[]>;

const cellOf = (x: number, y: number): readonly [number, number] => [Math.floor(x / SAME_PLACE_PX), Math.floor(y / SAME_PLACE_PX)];

/** The tie points that both images show, by where the left one does. What was measured of control and check points is no match. */
const sharedPoints = remember((view: BlockView, left: ImagePoints, right: ImagePoints): Cells => {
  const rows = new Map([...right.points].map((point, row) => [point, row]));
  const cells = new Map<string, Shared[]>();
  left.points.forEach((point, row) => {
    const [other, source] = [rows.get(point), sourceOf(view, point)];
    if (other === undefined || source === null || 'ground_control' in source) return;
    const [x = NaN, y = NaN] = left.places.subarray(2 * row, 2 * row + 2);
    const [xr = NaN, yr = NaN] = right.places.subarray(2 * other, 2 * other + 2);
    const key = cellOf(x, y).join(' ');
    const parts = [left.parts[row], right.parts[other]];
    const shared = { source, at: [x, y, xr, yr], isUsed: parts.every((part) => part === 0), isRejected: parts.includes(REJECTED) } as const;
    cells.set(key, [...(cells.get(key) ?? []), shared]);
  });
  return cells;
});

/** How far a match is from a tie point where it is farther, px. */
function apart([xl, yl, xr, yr]: MatchPlace, { at }: Shared): number {
  return Math.max(Math.hypot(xl - at[0], yl - at[1]), Math.hypot(xr - at[2], yr - at[3]));
}

const AROUND = [-1, 0, 1].flatMap((dy) => [-1, 0, 1].map((dx) => [dx, dy] as const));

/** The tie points that the left image shows about a place. */
function pointsAbout(cells: Cells, [x, y]: MatchPlace): Shared[] {
  const [column, row] = cellOf(x, y);
  return AROUND.flatMap(([dx, dy]) => cells.get(`${String(column + dx)} ${String(row + dy)}`) ?? []);
}

/** The tie points to which a match may belong, the nearest one first. */
function pointsAt(cells: Cells, place: MatchPlace): Shared[] {
  const near = pointsAbout(cells, place);
  return near.filter((point) => apart(place, point) <= SAME_PLACE_PX).sort((a, b) => apart(place, a) - apart(place, b));
}

/** The tie points that were measured where a match is. */
const measuredAt = (cells: Cells, place: MatchPlace) => pointsAt(cells, place).filter((point) => apart(place, point) <= SAME_MEASUREMENT_PX);

/** The tie points in use whose nearest match was rejected: where one that stays is nearer, that is the point's. */
function pointsOfRejected(cells: Cells, { rejected, used }: PairMatches): ReadonlySet<Shared> {
  const nearest = new Map<Shared, number>();
  for (const place of rejected)
    for (const point of pointsAt(cells, place)) if (point.isUsed) nearest.set(point, Math.min(nearest.get(point) ?? Infinity, apart(place, point)));
  for (let row = 0; nearest.size > 0 && 5 * row < used.length; row++) {
    const [xl = NaN, yl = NaN, xr = NaN, yr = NaN] = used.subarray(5 * row, 5 * row + 4);
    const place: MatchPlace = [xl, yl, xr, yr];
    for (const point of pointsAt(cells, place)) if (apart(place, point) < (nearest.get(point) ?? -Infinity)) nearest.delete(point);
  }
  return new Set(nearest.keys());
}

/**
 * The tie point that a match moves from where it was found, or from where the block took it, latest first. The left place alone names it where only the right one was
 * moved and the step that held its place is gone: of points by hand, since more than one found point may lie at a place.
 */
function movedPoint(cells: Cells, { of, had }: MeasuredMatch, isFree: (point: Shared) => boolean): Shared | undefined {
  const former = [...had].reverse();
  const isAtLeft = ({ source, at }: Shared, [x, y]: MatchPlace) => 'manual' in source && Math.hypot(x - at[0], y - at[1]) <= SAME_MEASUREMENT_PX;
  const taken = [
    ...former.flatMap((place) => measuredAt(cells, place)),
    ...former.flatMap((place) => pointsAbout(cells, place).filter((point) => isAtLeft(point, place))),
  ];
  return taken.find((point) => !point.isRejected && isFree(point)) ?? (of === null ? undefined : pointsAt(cells, of).find(({ isUsed }) => isUsed));
}

/** The edits for one match that was measured: the observations of its tie point are moved where it has one, else it is a new point. None where the block has it. */
function additionOf(cells: Cells, a: number, b: number, match: MeasuredMatch, isFree: (point: Shared) => boolean): BlockEdit[] {
  const { at } = match;
  if (measuredAt(cells, at).length > 0) return [];
  const places = [
    { image: a, x_px: at[0], y_px: at[1] },
    { image: b, x_px: at[2], y_px: at[3] },
  ];
  const moved = movedPoint(cells, match, isFree);
  if (moved === undefined) return pointsAt(cells, at).length > 0 ? [] : [{ kind: 'add_point', observations: places }];
  const isElsewhere = ({ x_px, y_px }: (typeof places)[number], end: number) =>
    Math.hypot(x_px - (moved.at[2 * end] ?? NaN), y_px - (moved.at[2 * end + 1] ?? NaN)) > SAME_MEASUREMENT_PX;
  return places.filter(isElsewhere).map((place): BlockEdit => ({ kind: 'measure', point: moved.source, ...place }));
}

/**
 * What the block makes of the matches of a pair. `a`, `b`: its left and its right image in the block, whose observations these are.
 *
 * Of a tie point that a rejected match joined both observations are rejected, however many rays it has: that they do not show the same place is known, which of
 * them is wrong is not. Residuals do not tell: what they could decide the tests of the adjustment have rejected already, and where three images see a point
 * from one line, an error along that line shows in all three alike. The other rays stay, and a point that has fewer than two left takes no part.
 */
export const forBlock = remember((view: BlockView, a: number, b: number, left: ImagePoints, right: ImagePoints, matches: PairMatches): ForBlock => {
  const cells = sharedPoints(view, left, right);
  const refused = pointsOfRejected(cells, matches);
  const observations = [...refused].flatMap(({ source }) => [a, b].map((image) => ({ point: source, image })));
  let [joined, without] = [0, 0];
  for (const place of matches.rejected) {
    const points = pointsAt(cells, place);
    if (points.some((point) => refused.has(point))) joined += 1;
    else if (points.every(({ isUsed }) => isUsed)) without += 1;
  }
  // Points of matches that the block has are those of no others.
  const had = new Set(matches.measured.flatMap(({ at }) => measuredAt(cells, at)));
  const added = matches.measured.map((one) => additionOf(cells, a, b, one, (point) => !had.has(point))).filter((edits) => edits.length > 0);
  return {
    rejection: observations.length === 0 ? [] : [{ kind: 'reject_observations', observations }],
    matches: joined,
    without,
    addition: added.flat(),
    measured: added.length,
  };
});
