/**
 * Points that were rejected by hand, or that edits leave without two rays that meet, beside those of the block that is held: they stay in sight, so that they
 * can be restored, or moved back, where they were.
 */
import type { BlockEdit, FinishedBlock, HandMeasurement, ObservationDetail, PointColumns, PointDetail, PointSource } from '../../../pkg/wasm/tiepoint.js';
import { codeOfSource, standingOf } from '../state/edits';
import { addedPoints } from '../state/added';
import type { AddedPoint } from '../state/added';
import type { ImagePoints } from '../state/facts';
import type { BlockView, ViewPoints, ViewSurveyed } from '../state/view';

/** How `ImagePoints` has what the adjustment rejected, and what was rejected by hand. */
const REJECTED = 1;
const BY_HAND = 2;

/** A block as it was found, of which edits leave something out. */
export class Found {
  readonly sources: readonly PointSource[];
  private readonly places: ReadonlyMap<number, number>;
  private readonly columns: PointColumns;
  private readonly surveyed: ReadonlyMap<number, ViewSurveyed>;

  /** `surveyed`, `givenControl`: as its view has them. */
  constructor(
    readonly block: FinishedBlock,
    surveyed: readonly ViewSurveyed[],
    readonly givenControl: number,
  ) {
    this.sources = block.point_ids();
    this.places = new Map(this.sources.map((id, point) => [codeOfSource(id), point]));
    this.columns = block.overview().points;
    this.surveyed = new Map(surveyed.map((known) => [known.control, known]));
  }

  /** Index of a point; -1 of one that was not found. */
  indexOf(code: number): number {
    return this.places.get(code) ?? -1;
  }

  /** What a column has of a point. */
  column(name: 'numbers' | 'positions' | 'rays' | 'confidence', index: number): number {
    return this.columns[name][index] ?? NaN;
  }

  surveyedPoint(control: number): ViewSurveyed | undefined {
    return this.surveyed.get(control);
  }
}

/** A point that takes no part. */
interface Gone {
  source: PointSource;
  isLost: boolean;
  /** In the block as it was found; -1 for one that was added by hand. */
  index: number;
}

/** What a block does not use after edits by hand, as long as it is held with these edits. */
export class Rejected {
  private readonly gone: readonly Gone[];
  /** By the codes of points. */
  private readonly byHand: ReadonlyMap<number, Hands>;
  /** Places among them by their indices in the block as it was found. */
  private readonly byIndex: ReadonlyMap<number, number>;

  constructor(
    private readonly found: Found,
    private readonly edits: readonly BlockEdit[],
    /** Points that the edited block has. */
    private readonly taking: number,
    sources: Float64Array,
  ) {
    const { points, unused, observations } = standingOf(edits);
    const named = [...points.values(), ...[...unused].map((control) => ({ ground_control: control })), ...[...observations.values()].map(({ point }) => point)];
    const rejected = new Set(named.map(codeOfSource));
    const has = new Set(sources);
    const codes = new Map([...named, ...tiePoints(found, edits)].map((source) => [codeOfSource(source), source]));
    this.gone = [...codes].filter(([code]) => !has.has(code)).map(([code, source]) => ({ source, isLost: !rejected.has(code), index: found.indexOf(code) }));
    this.byHand = measuredByHand(edits);
    this.byIndex = new Map(this.gone.flatMap(({ index }, place) => (index < 0 ? [] : [[index, place] as const])));
  }

  /** The view of the edited block, and behind its points those that take no part. */
  inView(view: BlockView): BlockView {
    const { gone, taking, found } = this;
    if (gone.length === 0) return view;
    const { points } = view;
    const all: ViewPoints = {
      ...points,
      count: taking + gone.length,
      lost: new Set(gone.flatMap(({ isLost }, place) => (isLost ? [taking + place] : []))),
      sources: longer(points.sources, gone.length),
      numbers: longer(points.numbers, gone.length),
      rays: longer(points.rays, gone.length),
      rmsePx: longer(points.rmsePx, gone.length),
      positions: longer(points.positions, 3 * gone.length),
      errors: longer(points.errors, 3 * gone.length),
      confidence: longer(points.confidence, gone.length),
    };
    gone.forEach(({ source, index }, place) => {
      const at = taking + place;
      all.sources[at] = codeOfSource(source);
      all.numbers[at] = index < 0 ? (found.block.point_number(source) ?? 0) : found.column('numbers', index);
      all.rays[at] = index < 0 ? this.handsOf(source).size : found.column('rays', index);
      all.rmsePx[at] = NaN;
      all.confidence[at] = index < 0 ? 1 : found.column('confidence', index);
      const met = index < 0 ? this.meetingOf(source) : null;
      for (const axis of [0, 1, 2]) {
        all.positions[3 * at + axis] = index < 0 ? (met?.[axis] ?? NaN) : found.column('positions', 3 * index + axis);
        all.errors[3 * at + axis] = NaN;
      }
    });
    return { ...view, points: all, surveyed: [...view.surveyed, ...this.surveyed(taking)] };
  }

  /** The observations of an image, with those of rejected points. */
  inImage(of: ImagePoints, image: number): ImagePoints {
    const { gone, byIndex, taking } = this;
    if (gone.length === 0) return of;
    const found = new Map<number, readonly [number, number]>();
    const before = this.found.block.image_points(image);
    before.points.forEach((index, row) => {
      const place = byIndex.get(index);
      if (place !== undefined) found.set(place, [before.places[2 * row] ?? NaN, before.places[2 * row + 1] ?? NaN]);
    });
    gone.forEach(({ source }, place) => {
      const own = this.handsOf(source).get(image);
      if (own !== undefined) found.set(place, [own.x_px, own.y_px]);
    });
    const points = [...found.keys()];
    const places = [...found.values()].flat();
    const rows = of.points.length;
    const all: ImagePoints = {
      points: longer(of.points, points.length),
      places: longer(of.places, places.length),
      residuals: longer(of.residuals, places.length).fill(NaN, 2 * rows),
      redundancy: longer(of.redundancy, places.length).fill(NaN, 2 * rows),
      w: longer(of.w, places.length).fill(NaN, 2 * rows),
      detectable: longer(of.detectable, places.length).fill(NaN, 2 * rows),
      parts: longer(of.parts, points.length).fill(BY_HAND, rows),
    };
    points.forEach((place, row) => {
      if (gone[place]?.isLost === true) all.parts[rows + row] = REJECTED;
    });
    all.points.set(
      points.map((place) => taking + place),
      rows,
    );
    all.places.set(places, 2 * rows);
    return all;
  }

  /** What is known of a point that takes no part; null of one that does. */
  detail(point: number): PointDetail | null {
    const gone = this.gone[point - this.taking];
    if (gone === undefined) return null;
    const { source, isLost, index } = gone;
    // What the adjustment had rejected before stays so.
    const partOf = (part: ObservationDetail['part']) => (part !== 'accepted' ? part : isLost ? 'lost_point' : 'rejected_by_hand');
    const known = index < 0 ? null : this.found.block.point(index);
    const observations = new Map(known?.observations.map((one) => [one.image, one]));
    for (const [image, one] of this.handsOf(source)) observations.set(image, { ...UNADJUSTED, ...one, part: 'accepted', by_hand: true });
    return {
      id: source,
      name: known?.name ?? this.added(source)?.edit.name ?? null,
      role: null,
      position: known?.position ?? this.meetingOf(source),
      errors: null,
      rmse_px: null,
      confidence: known?.confidence ?? 1,
      observations: [...observations.values()].map(({ part, image, x_px, y_px, by_hand }) => ({
        ...UNADJUSTED,
        part: partOf(part),
        image,
        x_px,
        y_px,
        by_hand,
      })),
      elsewhere: [],
    };
  }

  /** Surveyed points that are not used, where the block was found with them. */
  private surveyed(taking: number): ViewSurveyed[] {
    return this.gone.flatMap(({ source }, place) => {
      const known = 'ground_control' in source ? (this.found.surveyedPoint(source.ground_control) ?? this.surveyedByHand(source)) : undefined;
      return known === undefined
        ? []
        : [{ ...known, rays: 0, difference_m: [NaN, NaN, NaN], standard_errors_m: [null, null, null], point: taking + place, isUsed: false }];
    });
  }

  /** A surveyed point that was added by hand. */
  private added(source: PointSource): AddedPoint | undefined {
    if (!('ground_control' in source)) return undefined;
    return [...addedPoints(this.edits, this.found.givenControl).values()].find(({ control }) => control === source.ground_control);
  }

  /** One as it stands in a table, without figures. */
  private surveyedByHand(source: PointSource): ViewSurveyed | undefined {
    const added = this.added(source);
    if (added === undefined) return undefined;
    const { name, position, use } = added.edit;
    const none = { standard_errors_m: [null, null, null], detectable_m: [null, null, null], difference_m: [NaN, NaN, NaN] } satisfies Partial<ViewSurveyed>;
    return { ...none, name, role: use ?? 'control', rays: 0, position, control: added.control, point: -1, isUsed: false, byHand: true };
  }

  /** Where its measurements by hand meet; null where they do not. */
  private meetingOf(source: PointSource): [number, number, number] | null {
    const measurements = [...this.handsOf(source).values()].map(({ image, x_px, y_px }) => ({ image, x_px, y_px }));
    const [x, y, z] = this.found.block.meeting_place(measurements) ?? [];
    return x === undefined || y === undefined || z === undefined ? null : [x, y, z];
  }

  /** Where a point was measured by hand, by image. */
  private handsOf(source: PointSource): Hands {
    return this.byHand.get(codeOfSource(source)) ?? NO_HANDS;
  }
}

/** Where a point was measured by hand, by image. */
type Hands = ReadonlyMap<number, Pick<ObservationDetail, 'image' | 'x_px' | 'y_px'>>;

const NO_HANDS: Hands = new Map();

/** The same of all points that were, by their codes. */
function measuredByHand(edits: readonly BlockEdit[]): ReadonlyMap<number, Hands> {
  const added = edits
    .filter((edit) => edit.kind === 'add_point')
    .flatMap(({ observations }, manual) => observations.map((one) => ({ ...one, point: { manual } })));
  const hands = new Map<number, Map<number, HandMeasurement>>();
  for (const { point, ...one } of [...added, ...edits.filter((edit) => edit.kind === 'measure')]) {
    const code = codeOfSource(point);
    hands.set(code, (hands.get(code) ?? new Map<number, HandMeasurement>()).set(one.image, one));
  }
  return hands;
}

/** The points that were found and added, without surveyed ones: what is not adjusted of these stands among those that were given. */
function tiePoints(found: Found, edits: readonly BlockEdit[]): PointSource[] {
  const added = edits.filter((edit) => edit.kind === 'add_point').map((_, manual) => ({ manual }));
  return [...found.sources.filter((source) => !('ground_control' in source)), ...added];
}

const UNADJUSTED: Omit<ObservationDetail, 'image' | 'x_px' | 'y_px'> = {
  part: 'rejected_by_hand',
  by_hand: false,
  residual_px: null,
  redundancy: null,
  w: null,
  detectable_px: [null, null],
  predicted_px: null,
};

/** A copy with room for more at its end. */
function longer<A extends Float64Array | Uint32Array | Uint16Array | Uint8Array>(of: A, more: number): A {
  const copy = new (of.constructor as new (length: number) => A)(of.length + more);
  copy.set(of);
  return copy;
}
