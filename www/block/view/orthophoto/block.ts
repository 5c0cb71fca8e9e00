/** The block on the orthophoto that it was placed on: footprints and projection centres of its images, and the places of the ground that placed it. */
import type { LinkUse } from '../../../../pkg/wasm/tiepoint.js';
import { remember } from '../../../shared/state/remember';
import type { Colours } from '../../../shared/view/colours';
import { ACCEPTED } from '../../../shared/view/palette';
import { toCanvas } from '../../../shared/view/transform';
import type { Rect, Transform } from '../../../shared/view/transform';
import { isPlaceByHand } from '../../state/added';
import type { ViewGround } from '../../state/ground';
import { USES } from '../../state/links';
import { isPlace } from '../../state/naming';
import { imagesOf, pointsOf } from '../../state/selection';
import type { Choice } from '../../state/selection';
import { SAME } from '../../state/under';
import { mapped } from '../../../shared/state/plane-map';
import type { Affine } from '../../../shared/state/plane-map';
import type { BlockView, ViewSurveyed } from '../../state/view';
import { offsetsOf, paintSurveyed } from '../map/ground';
import { footprintAt, paintCentres, paintFootprint } from './footprints';
import type { Footprint } from './footprints';
import { codeOfUse, drawLinks, drawRing, linkAt, pointsOnGround } from './links';
import type { DrawnLinks } from './links';

type BlockFootprint = Footprint & { image: number };

/** Control and check points, by their rows in the table. */
interface Points {
  rows: readonly number[];
  drawn: DrawnLinks;
}

/** What of a block is drawn. */
export interface OnOrthophoto {
  view: BlockView;
  images: readonly BlockFootprint[];
  /** Places of the orthophoto, drawn as links are. */
  places: Points;
  /** Ground control and check points, drawn as on the map. */
  surveyed: Points;
}

type Keeps = (row: number) => boolean;

/** Whether a point is a place of the orthophoto, found on it or measured by hand. */
const isOnOrthophoto = (name: string) => isPlace(name) || isPlaceByHand(name);

/** What is drawn of a block, and its ground, in another system: places in plan, and the differences of surveyed points. */
export const inSystem = remember((view: BlockView, ground: ViewGround | null, to: Affine): { view: BlockView; ground: ViewGround | null } => {
  if (to === SAME) return { view, ground };
  const turn = { ...to, e: 0, f: 0 };
  const footprints = ground?.footprints.slice() ?? new Float64Array();
  for (let i = 0; i < footprints.length; i += 2) footprints.set(mapped(to, footprints[i] ?? NaN, footprints[i + 1] ?? NaN), i);
  return {
    view: {
      ...view,
      images: view.images.map((image) =>
        image.position === null ? image : { ...image, position: [...mapped(to, image.position[0], image.position[1]), image.position[2]] },
      ),
      surveyed: view.surveyed.map((point) => ({
        ...point,
        position: [...mapped(to, point.position[0], point.position[1]), point.position[2]],
        difference_m: [...mapped(turn, point.difference_m[0], point.difference_m[1]), point.difference_m[2]],
      })),
    },
    ground: ground === null ? null : { ...ground, footprints },
  };
});

/** Those of its images and points that filters keep. `isStale`: it was placed by other settings, or on another orthophoto. */
export const onOrthophoto = remember(
  (view: BlockView, ground: ViewGround | null, isStale: boolean, keepsImage: Keeps, keepsPoint: Keeps): OnOrthophoto => ({
    view,
    images: view.images.flatMap(({ name, position }, image): BlockFootprint[] =>
      position === null || !keepsImage(image)
        ? []
        : [{ image, name, isStale, colour: ACCEPTED.colour, centre: [position[0], position[1]], outline: outlineOf(ground, image) }],
    ),
    places: pointsWhere(view, (row, name) => isOnOrthophoto(name) && keepsPoint(row)),
    surveyed: pointsWhere(view, (row, name) => !isOnOrthophoto(name) && keepsPoint(row)),
  }),
);

function outlineOf(ground: ViewGround | null, image: number): [number, number][] {
  const corners = ground?.footprints.subarray(8 * image, 8 * image + 8) ?? [];
  return [0, 2, 4, 6].map((at): [number, number] => [corners[at] ?? NaN, corners[at + 1] ?? NaN]).filter(([x]) => !Number.isNaN(x));
}

function pointsWhere({ surveyed }: BlockView, keeps: (row: number, name: string) => boolean): Points {
  const rows = surveyed.flatMap(({ name }, row) => (keeps(row, name) ? [row] : []));
  const own = rows.flatMap((row) => surveyed[row] ?? []);
  return {
    rows,
    drawn: pointsOnGround(
      own.flatMap(({ position }) => position),
      own.map((point) => codeOfUse(useOf(point), point.byHand)),
    ),
  };
}

/** What a place is for the block, in the words of links. */
function useOf({ role, isUsed }: ViewSurveyed): LinkUse {
  return !isUsed ? 'rejected' : role === 'check' ? 'check' : 'used';
}

const ALL: ReadonlySet<LinkUse> = new Set(USES);

/** What lies at a place of the canvas: a point, unless the projection centre of an image is nearer, or an image. */
export function choiceAt(of: OnOrthophoto, uses: ReadonlySet<LinkUse>, t: Transform, x: number, y: number): Choice | null {
  const image = footprintAt(of.images, t, x, y);
  const near = [nearest(of.places, uses, t, x, y), nearest(of.surveyed, ALL, t, x, y)].filter((found) => found !== null);
  const [point] = near.sort((a, b) => a.distance - b.distance);
  if (point !== undefined && (image === null || point.distance < image.distance)) return choiceOf(of.view, point.row);
  return image === null ? null : { kind: 'image', image: image.of.image };
}

/** The row of the point nearest to a place of the canvas, within reach; null where there is none. */
function nearest({ rows, drawn }: Points, uses: ReadonlySet<LinkUse>, t: Transform, x: number, y: number): { row: number; distance: number } | null {
  const found = linkAt(drawn, uses, t, x, y);
  const row = rows[found];
  if (row === undefined) return null;
  const [px, py] = toCanvas(t, drawn.points[3 * found] ?? 0, drawn.points[3 * found + 1] ?? 0);
  return { row, distance: Math.hypot(px - x, py - y) };
}

/** As its row in the table is chosen. */
function choiceOf({ surveyed }: BlockView, row: number): Choice | null {
  const point = surveyed[row]?.point ?? -1;
  return point < 0 ? null : { kind: 'point', point };
}

/** The image or place after the one that is chosen, or before it, among those that are drawn and can be chosen. */
export function stepped(
  { view, images, places: { rows } }: OnOrthophoto,
  uses: ReadonlySet<LinkUse>,
  of: 'image' | 'place',
  chosen: Choice | null,
  by: 1 | -1,
): Choice | null {
  const isThere = (row: number) => {
    const own = view.surveyed[row];
    return own !== undefined && own.point >= 0 && uses.has(useOf(own));
  };
  const all = of === 'image' ? images.map(({ image }) => image) : rows.filter(isThere);
  const [point = -1] = pointsOf(chosen);
  const now = of === 'image' ? all.indexOf(imagesOf(chosen)[0] ?? -1) : all.findIndex((row) => view.surveyed[row]?.point === point);
  const next = all[now < 0 ? (by > 0 ? 0 : all.length - 1) : (now + by + all.length) % all.length];
  if (next === undefined) return null;
  return of === 'image' ? { kind: 'image', image: next } : choiceOf(view, next);
}

/** Where what is chosen lies, X and Y; null where it is none of what is drawn. */
export function placeOfChoice({ view, images }: OnOrthophoto, chosen: Choice | null): readonly [number, number] | null {
  if (chosen?.kind === 'image') return images.find(({ image }) => image === chosen.image)?.centre ?? null;
  const [point] = pointsOf(chosen);
  const [x, y] = view.surveyed.find((own) => point !== undefined && own.point === point)?.position ?? [];
  return x === undefined || y === undefined ? null : [x, y];
}

/** Draws it, with what is chosen and pointed at. */
export function paintBlock(
  context: CanvasRenderingContext2D,
  colours: Colours,
  t: Transform,
  clip: Rect,
  of: OnOrthophoto,
  uses: ReadonlySet<LinkUse>,
  { chosen, pointed }: { chosen: Choice | null; pointed: Choice | null },
): void {
  const isOf = (choice: Choice | null) => (own: BlockFootprint) => imagesOf(choice).includes(own.image);
  for (const own of of.images) paintFootprint(context, t, own, isOf(chosen)(own), isOf(pointed)(own));
  drawLinks(context, of.places.drawn, t, clip, uses);
  const isSurveyed = new Set(of.surveyed.rows);
  const surveyed = offsetsOf(
    of.view,
    null,
    () => false,
    (row) => isSurveyed.has(row),
  );
  paintSurveyed(context, colours, surveyed, t, 1, false, [clip.width, clip.height]);
  for (const points of [of.places, of.surveyed]) {
    paintRings(context, t, of.view, points, pointed, false);
    paintRings(context, t, of.view, points, chosen, true);
  }
  paintCentres(context, colours, t, of.images, isOf(chosen));
}

function paintRings(
  context: CanvasRenderingContext2D,
  t: Transform,
  { surveyed }: BlockView,
  { rows, drawn }: Points,
  of: Choice | null,
  isChosen: boolean,
): void {
  const points = new Set(pointsOf(of));
  if (points.size === 0) return;
  rows.forEach((row, i) => {
    if (points.has(surveyed[row]?.point ?? -1)) drawRing(context, drawn, i, t, isChosen);
  });
}
