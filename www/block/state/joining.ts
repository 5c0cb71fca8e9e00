/** Points that are one are joined, one that is two is split: what was found is rejected, and new points have its observations. */
import type { BlockEdit, HandMeasurement, PointDetail } from '../../../pkg/wasm/tiepoint.js';

/** The observations of a point that it would take with it. */
function placesOf({ observations }: PointDetail): HandMeasurement[] {
  return observations
    .filter(({ part }) => part !== 'rejected_by_hand')
    .map(({ image, x_px, y_px, by_hand }) => ({ image, x_px, y_px, by: by_hand ? 'hand' : 'least_squares' }));
}

/** Places of one point in an image lie no farther apart, in px: by so much matches of it differ. */
const ONE_PLACE_PX = 5;

/** The image in which points lie farthest apart, if farther than places of one point do, and how far in px; null where they may be one. */
export function apart(points: readonly PointDetail[]): { image: number; px: number } | null {
  let farthest: { image: number; px: number } | null = null;
  const seen = new Map<number, [number, number][]>();
  for (const point of points) {
    for (const { image, x_px, y_px } of placesOf(point)) {
      const others = seen.get(image) ?? [];
      for (const [x, y] of others) {
        const px = Math.hypot(x - x_px, y - y_px);
        if (px > (farthest?.px ?? ONE_PLACE_PX)) farthest = { image, px };
      }
      seen.set(image, [...others, [x_px, y_px]]);
    }
  }
  return farthest;
}

/**
 * The step that makes one of several points; null where they cannot be one. Where two have an observation in the same image, that of the one with more
 * rays stands. A surveyed point among them gets the observations of the others.
 */
export function joined(points: readonly PointDetail[]): BlockEdit[] | null {
  const [first, ...others] = [...points].sort((a, b) => rank(b) - rank(a));
  if (first?.id == null || others.length === 0 || others.some(isSurveyed)) return null;
  const rejected = (isSurveyed(first) ? others : [first, ...others]).flatMap(({ id }) => id ?? []);
  const places = new Map<number, HandMeasurement>();
  for (const point of [first, ...others]) for (const place of placesOf(point)) if (!places.has(place.image)) places.set(place.image, place);
  const reject: BlockEdit = { kind: 'reject_points', points: rejected };
  if (!isSurveyed(first)) return places.size < 2 ? null : [reject, { kind: 'add_point', observations: [...places.values()] }];
  const { id } = first;
  const own = new Set(first.observations.map(({ image }) => image));
  const measured = [...places.values()].filter(({ image }) => !own.has(image));
  return measured.length === 0 ? null : [reject, ...measured.map((place): BlockEdit => ({ kind: 'measure', point: id, ...place }))];
}

function isSurveyed({ id }: PointDetail): boolean {
  return id !== null && 'ground_control' in id;
}

/** A surveyed point comes first, then the one with most rays. */
function rank(point: PointDetail): number {
  return isSurveyed(point) ? Infinity : placesOf(point).length;
}

/**
 * The step that makes two of a point: one of its observations in some images, which is added last and so is the one that is chosen then, and one of the others;
 * null where either would have fewer than two.
 */
export function split(point: PointDetail, images: readonly number[]): BlockEdit[] | null {
  if (point.id === null || isSurveyed(point)) return null;
  const places = placesOf(point);
  const [within, beside] = [true, false].map((is) => places.filter(({ image }) => images.includes(image) === is));
  if (within === undefined || beside === undefined || within.length < 2 || beside.length < 2) return null;
  return [
    { kind: 'reject_points', points: [point.id] },
    { kind: 'add_point', observations: beside },
    { kind: 'add_point', observations: within },
  ];
}
