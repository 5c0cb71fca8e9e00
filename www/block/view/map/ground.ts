/** Footprints of images, GNSS positions, and surveyed points with their differences, on the map. */
import type { Colours } from '../../../shared/view/colours';
import { toCanvas } from '../../../shared/view/transform';
import type { Transform } from '../../../shared/view/transform';
import { say } from '../../../shared/text/words';
import type { System, ViewGround } from '../../state/ground';
import type { BlockView } from '../../state/view';
import { haloed, lengthText, niceBelow } from './frame';

/** Of GNSS positions, and of surveyed points: told apart with any colour vision (Okabe & Ito). */
const GNSS = '#e69f00';
const SURVEYED = '#cc79a7';

/** The longest difference is drawn about so long, CSS px. */
const LONGEST = 46;

/** Of more control and check points in sight than these marks are small, without names and ellipses: an orthophoto gives hundreds. */
const MOST_NAMED = 30;

/** Something measured beside what was adjusted: where it is, and how far it lies from there. */
interface Offset {
  x: number;
  y: number;
  dx: number;
  dy: number;
  /** Not drawn; NaN where the height is not known. */
  dz: number;
}

/** The longest differences, in units of the block; 0 where there are none. */
export interface Longest {
  plan: number;
  height: number;
}

const ALL = () => true;

export interface Offsets {
  gnss: readonly Offset[];
  surveyed: readonly (Offset & { name: string; isUsed: boolean; isCheck: boolean; sigma: readonly [number, number] | null })[];
  /** Of each kind. */
  longest: { gnss: Longest; surveyed: Longest };
}

/** Those of images and surveyed points that are kept. */
export function offsetsOf(
  view: BlockView,
  ground: ViewGround | null,
  keepsImage: (image: number) => boolean = ALL,
  keepsSurveyed: (point: number) => boolean = ALL,
): Offsets {
  const gnss = view.images.flatMap(({ position }, i): Offset[] => {
    const [x = NaN, y = NaN, z = NaN] = ground?.gnss.subarray(3 * i, 3 * i + 3) ?? [];
    if (position === null || Number.isNaN(x) || !keepsImage(i)) return [];
    return [{ x: position[0], y: position[1], dx: x - position[0], dy: y - position[1], dz: z - position[2] }];
  });
  const surveyed = view.surveyed
    .filter((_, i) => keepsSurveyed(i))
    .map(({ name, role, isUsed, position: [x, y], difference_m: [dx, dy, dz], standard_errors_m: [sx, sy] }) => ({
      name,
      isUsed,
      isCheck: role === 'check',
      x,
      y,
      dx,
      dy,
      dz,
      sigma: sx === null || sy === null ? null : ([sx, sy] as const),
    }));
  const most = (lengths: readonly number[]) => lengths.reduce((high, length) => (length > high ? length : high), 0);
  const longest = (offsets: readonly Offset[]): Longest => ({
    plan: most(offsets.map(({ dx, dy }) => Math.hypot(dx, dy))),
    height: most(offsets.map(({ dz }) => Math.abs(dz))),
  });
  return { gnss, surveyed, longest: { gnss: longest(gnss), surveyed: longest(surveyed) } };
}

/** The longest differences in words: "14 cm in plan, 1.2 m in height". */
export function longestText({ plan, height }: Longest, system: System): string {
  return say('in-plan-and-height', { plan: lengthText(plan, system), height: height > 0 ? lengthText(height, system) : null });
}

/** How much longer than they are differences are drawn: 1, 2, 5, 10 … times. */
export function factorOf(longest: number, t: Transform): number {
  return longest > 0 ? Math.max(1, niceBelow(LONGEST / (longest * t.scale))) : 1;
}

/** The outline of each image on the ground; of those that are marked its surface too. */
export function paintFootprints(
  context: CanvasRenderingContext2D,
  colours: Colours,
  { footprints }: ViewGround,
  t: Transform,
  all: (image: number) => boolean,
  marked: (image: number) => boolean,
): void {
  context.save();
  for (let image = 0; 8 * image < footprints.length; image++) {
    const on = marked(image);
    const corners = footprints.subarray(8 * image, 8 * image + 8);
    if ((!on && !all(image)) || Number.isNaN(corners[0])) continue;
    context.beginPath();
    for (let corner = 0; corner < 8; corner += 2) context.lineTo(...toCanvas(t, corners[corner] ?? 0, -(corners[corner + 1] ?? 0)));
    context.closePath();
    context.fillStyle = context.strokeStyle = on ? colours.accent : colours.bars;
    context.globalAlpha = on ? 0.14 : 0.05;
    context.fill();
    context.globalAlpha = on ? 1 : 0.5;
    context.lineWidth = on ? 1.5 : 0.8;
    context.stroke();
  }
  context.restore();
}

/** A small copy of an image on the ground that it shows, as if that were level. */
export function paintOnGround(context: CanvasRenderingContext2D, thumb: ImageBitmap, { footprints }: ViewGround, t: Transform, image: number): void {
  const [x0 = NaN, y0 = NaN, x1 = NaN, y1 = NaN, , , x3 = NaN, y3 = NaN] = footprints.subarray(8 * image, 8 * image + 8);
  if (Number.isNaN(x0)) return;
  const [left, top] = toCanvas(t, x0, -y0);
  const across = [(t.scale * (x1 - x0)) / thumb.width, (-t.scale * (y1 - y0)) / thumb.width] as const;
  const down = [(t.scale * (x3 - x0)) / thumb.height, (-t.scale * (y3 - y0)) / thumb.height] as const;
  context.save();
  context.transform(...across, ...down, left, top);
  context.drawImage(thumb, 0, 0);
  context.restore();
}

/** GNSS positions as lines from the adjusted ones, drawn longer by a factor. */
export function paintGnss(context: CanvasRenderingContext2D, { gnss }: Offsets, t: Transform, factor: number): void {
  context.save();
  context.strokeStyle = context.fillStyle = GNSS;
  context.lineWidth = 2;
  for (const offset of gnss) {
    const end = arrow(context, t, offset, factor);
    context.beginPath();
    context.arc(...end, 2.5, 0, 2 * Math.PI);
    context.fill();
  }
  context.restore();
}

/** Control points as triangles, check points as squares; their differences, and the ellipses of one standard error, longer by the same factor. */
export function paintSurveyed(
  context: CanvasRenderingContext2D,
  colours: Colours,
  { surveyed }: Offsets,
  t: Transform,
  factor: number,
  offsets: boolean,
  size: readonly [number, number],
): void {
  const inSight = surveyed
    .map((point) => ({ point, at: toCanvas(t, point.x, -point.y) }))
    .filter(({ at }) => at.every((coordinate, axis) => coordinate > -LONGEST && coordinate < (size[axis] ?? 0) + LONGEST));
  const isCrowded = inSight.length > MOST_NAMED;
  const side = isCrowded ? 0.5 : 1;
  context.save();
  context.font = '11px system-ui, sans-serif';
  context.textAlign = 'start';
  for (const {
    point,
    at: [x, y],
  } of inSight) {
    context.strokeStyle = SURVEYED;
    context.lineWidth = 2;
    if (offsets && point.isUsed) {
      const [ex, ey] = arrow(context, t, point, factor);
      if (point.sigma !== null && !isCrowded) {
        const [a, b] = point.sigma.map((sigma) => sigma * factor * t.scale);
        context.lineWidth = 1;
        context.beginPath();
        context.ellipse(ex, ey, Math.max(1, a ?? 0), Math.max(1, b ?? 0), 0, 0, 2 * Math.PI);
        context.stroke();
      }
    }
    context.beginPath();
    if (point.isCheck) context.rect(x - 5 * side, y - 5 * side, 10 * side, 10 * side);
    else
      for (const [dx, dy] of [
        [0, -7],
        [6, 4],
        [-6, 4],
      ] as const)
        context.lineTo(x + dx * side, y + dy * side);
    context.closePath();
    context.fillStyle = SURVEYED;
    if (point.isUsed) context.fill();
    context.lineWidth = isCrowded ? 1 : 1.5;
    context.strokeStyle = point.isUsed ? colours.surface : SURVEYED;
    context.stroke();
    if (!isCrowded) haloed(context, colours, point.name, x + 9, y + 4);
  }
  context.restore();
}

/** Draws a line as long as the offset times the factor; gives where it ends. */
function arrow(context: CanvasRenderingContext2D, t: Transform, { x, y, dx, dy }: Offset, factor: number): [number, number] {
  const end = toCanvas(t, x + factor * dx, -(y + factor * dy));
  context.beginPath();
  context.moveTo(...toCanvas(t, x, -y));
  context.lineTo(...end);
  context.stroke();
  return end;
}
