/** The plan of a block, which its map shows: where its images are drawn, which lines join them, and what lies at a place. Lengths are CSS px. */
import { toCanvas } from '../../../shared/view/transform';
import type { Transform } from '../../../shared/view/transform';
import type { BlockView } from '../../state/view';
import { matchesOf } from '../../state/words';

/** Room about the outermost images, whose names and photos are there, and about their footprints. */
const MARGIN = 62;
const MARGIN_OF_GROUND = 22;
const MARK_REACH = 12;
const LINE_REACH = 6;
const WIDEST = 7;

/** The view that shows all images and surveyed points, and what of `footprints` is known. The plan's y goes up, the canvas's down. */
export function fitPlan({ layout: { kind, places }, surveyed }: BlockView, footprints: Float64Array | null, width: number, height: number): Transform {
  const box = [Infinity, Infinity, -Infinity, -Infinity] as [number, number, number, number];
  const points = kind === 'oriented' ? surveyed.flatMap(({ position: [x, y] }) => [x, y]) : [];
  for (const flat of [places, points, ...(footprints === null ? [] : [footprints])]) {
    for (let i = 0; i < flat.length; i += 2) {
      const [x = NaN, y = NaN] = [flat[i], flat[i + 1]];
      if (Number.isNaN(x)) continue;
      box[0] = Math.min(box[0], x);
      box[1] = Math.min(box[1], y);
      box[2] = Math.max(box[2], x);
      box[3] = Math.max(box[3], y);
    }
  }
  if (box[0] > box[2]) return { scale: 1, x: 0, y: 0 };
  const margin = footprints === null ? MARGIN : MARGIN_OF_GROUND;
  const room = (length: number) => Math.max(10, length - 2 * margin);
  const spread = (low: number, high: number) => Math.max(high - low, 1e-9);
  const scale = Math.min(room(width) / spread(box[0], box[2]), room(height) / spread(box[1], box[3]));
  return { scale, x: width / 2 - (scale * (box[0] + box[2])) / 2, y: height / 2 + (scale * (box[1] + box[3])) / 2 };
}

export function placeOf(view: BlockView, plan: Transform, image: number): [number, number] {
  const [x = 0, y = 0] = view.layout.places.subarray(2 * image, 2 * image + 2);
  return toCanvas(plan, x, -y);
}

const SPACINGS = new WeakMap<BlockView, number>();

/** The least distance of two images, in units of the plan. */
function spacingOf(view: BlockView): number {
  const known = SPACINGS.get(view);
  if (known !== undefined) return known;
  const { places } = view.layout;
  const across = Array.from({ length: places.length / 2 }, (_, i): [number, number] => [places[2 * i] ?? NaN, places[2 * i + 1] ?? NaN])
    .filter(([x]) => !Number.isNaN(x))
    .sort(([a], [b]) => a - b);
  let least = Infinity;
  across.forEach(([x, y], i) => {
    // Those that are farther in x alone are farther.
    for (let j = i - 1; j >= 0; j -= 1) {
      const [u, v] = across[j] ?? [-Infinity, 0];
      if (x - u >= least) break;
      least = Math.min(least, Math.hypot(x - u, y - v));
    }
  });
  SPACINGS.set(view, least);
  return least;
}

/** At most so many of the images that are kept, those nearest to a place, nearest first; all in their order where they are no more. */
export function nearestImages(view: BlockView, plan: Transform, keeps: (image: number) => boolean, [x, y]: readonly [number, number], most: number): number[] {
  const kept = Array.from(view.images.keys()).filter(keeps);
  if (kept.length <= most) return kept;
  const far = kept.flatMap((image): [number, number][] => {
    const [px, py] = placeOf(view, plan, image);
    return Number.isNaN(px) ? [] : [[image, Math.hypot(px - x, py - y)]];
  });
  return far
    .sort(([, a], [, b]) => a - b)
    .slice(0, most)
    .map(([image]) => image);
}

const WIDEST_THUMB = 110;
const LEAST_THUMB = 26;

/** How wide images are drawn, CSS px, so that they do not cover each other; 0 where they are too near to be more than dots. */
export function thumbWidth(view: BlockView, plan: Transform): number {
  const width = Math.min(WIDEST_THUMB, 0.8 * spacingOf(view) * plan.scale);
  return width < LEAST_THUMB ? 0 : width;
}

/** A line for each connected pair: its width grows with the points in common, of matches where no points were made. */
export interface Line {
  /** Index of its connection. */
  pair: number;
  images: [number, number];
  width: number;
  strength: number;
  /** By hand: thin and dashed. */
  rejected: boolean;
}

const LINES = new WeakMap<BlockView, readonly Line[]>();

/** The lines of a block, the weakest first, so that the strong ones lie on top. */
export function linesOf(view: BlockView): readonly Line[] {
  const known = LINES.get(view);
  if (known !== undefined) return known;
  const connected = view.connections.map((connection, pair) => ({ ...connection, pair })).filter(({ outcome }) => outcome.kind === 'connected');
  const joined = connected.some(({ shared }) => shared > 0);
  const weight = (connection: (typeof connected)[number]) => (joined ? connection.shared : matchesOf(connection));
  const most = connected.reduce((high, connection) => Math.max(high, weight(connection)), 1);
  const made = connected
    .map((connection) => ({ ...connection, strength: Math.sqrt(weight(connection) / most) }))
    .map(({ pair, images, strength, rejected }) => ({ pair, images, strength, rejected, width: rejected ? 1 : 0.6 + (WIDEST - 0.6) * strength }))
    .sort((a, b) => a.width - b.width);
  LINES.set(view, made);
  return made;
}

/** The image at a place that is kept, drawn so wide; -1 where there is none. */
export function imageAt(view: BlockView, plan: Transform, keeps: (image: number) => boolean, width: number, x: number, y: number): number {
  let image = -1;
  let least = Math.max(MARK_REACH, width / 2);
  view.images.forEach((_, i) => {
    if (!keeps(i)) return;
    const [px, py] = placeOf(view, plan, i);
    const distance = Math.hypot(px - x, py - y);
    if (distance < least) [image, least] = [i, distance];
  });
  return image;
}

/** The pair that is kept whose line passes a place; null where none does. */
export function lineAt(view: BlockView, plan: Transform, keeps: (pair: number) => boolean, x: number, y: number): [number, number] | null {
  let found: Line | null = null;
  let nearest = Infinity;
  for (const line of linesOf(view)) {
    if (!keeps(line.pair)) continue;
    const distance = toSegment(placeOf(view, plan, line.images[0]), placeOf(view, plan, line.images[1]), x, y);
    if (distance <= Math.max(LINE_REACH, line.width / 2 + 2) && distance < nearest) [found, nearest] = [line, distance];
  }
  return found === null ? null : found.images;
}

/** The distance of a place from a line between two others. */
function toSegment([ax, ay]: [number, number], [bx, by]: [number, number], x: number, y: number): number {
  const [dx, dy] = [bx - ax, by - ay];
  const along = Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / Math.max(dx * dx + dy * dy, 1e-9)));
  return Math.hypot(ax + along * dx - x, ay + along * dy - y);
}
