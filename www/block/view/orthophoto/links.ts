/** Links between an image and an orthophoto, drawn alike on both. */
import type { LinkUse } from '../../../../pkg/wasm/tiepoint.js';
import { draw_points, draw_vectors } from '../../../shared/crate';
import { ACCEPTED, CANDIDATE, MEASURED, REJECTED, RESIDUAL, RESIDUAL_REJECTED, SELECTED, SHAPES } from '../../../shared/view/palette';
import type { PointStyle } from '../../../shared/view/palette';
import { drawView } from '../../../shared/view/panes';
import { toCanvas } from '../../../shared/view/transform';
import type { Rect, Transform } from '../../../shared/view/transform';
import { USES } from '../../state/links';
import type { Links } from '../../state/links';
import { say } from '../../../shared/text/words';

/** Told apart by shape as well. */
export const LINK_STYLES: Readonly<Record<LinkUse, PointStyle & { name: string }>> = {
  used: { ...ACCEPTED, name: say('link-use', { use: 'used' }) },
  check: { colour: CANDIDATE, shape: SHAPES.square, name: say('link-use', { use: 'check' }) },
  rejected: { ...REJECTED, name: say('link-use', { use: 'rejected' }) },
};

const STYLES: readonly PointStyle[] = [...USES.map((use) => LINK_STYLES[use]), MEASURED];

function useOf(code: number): LinkUse {
  return USES[code] ?? 'used';
}

/** How near a link is pointed at, CSS px. */
const REACH = 12;

/** Links of an image as one picture has them. */
export interface DrawnLinks {
  /** Positions in the picture; stride 3. */
  points: Float64Array;
  codes: Uint8Array;
  /** From a position along its residual; stride 4. Empty where the picture has no residuals. */
  vectors: Float64Array;
  /** How far they spread, across and down. */
  box: readonly [number, number];
}

/** Of the image. */
export function linksOnImage({ count, at, residuals, uses, byHand }: Links): DrawnLinks {
  const points = new Float64Array(3 * count);
  const vectors = new Float64Array(4 * count);
  for (let i = 0; i < count; i++) {
    const place = at.subarray(2 * i, 2 * i + 2);
    points.set(place, 3 * i);
    vectors.set(place, 4 * i);
    vectors.set(residuals.subarray(2 * i, 2 * i + 2), 4 * i + 2);
  }
  return { points, box: spreadOf(points), codes: codesOf(uses, byHand), vectors };
}

/** Of the ground, whose Y goes down on the canvas. */
export function linksOnGround({ places, uses, byHand }: Links): DrawnLinks {
  return pointsOnGround(places, codesOf(uses, byHand));
}

/** Places of the ground, X, Y, Z, with the codes of their uses. */
export function pointsOnGround(places: Iterable<number>, codes: Iterable<number>): DrawnLinks {
  const points = Float64Array.from(places, (value, i) => (i % 3 === 0 ? value : i % 3 === 1 ? -value : 0));
  return { points, box: spreadOf(points), codes: Uint8Array.from(codes), vectors: new Float64Array() };
}

/** Of those that take part, the ones by hand have a code of their own. */
const BY_HAND = USES.length;

/** The code of one. */
export function codeOfUse(use: LinkUse, byHand: boolean): number {
  return use === 'used' && byHand ? BY_HAND : USES.indexOf(use);
}

function codesOf(uses: Uint8Array, byHand: Uint8Array): Uint8Array {
  return uses.map((use, i) => (use === 0 && byHand[i] === 1 ? BY_HAND : use));
}

function spreadOf(points: Float64Array): [number, number] {
  const box = [Infinity, Infinity, -Infinity, -Infinity] as [number, number, number, number];
  for (let i = 0; i < points.length; i += 3) {
    const [x = 0, y = 0] = points.subarray(i, i + 2);
    box[0] = Math.min(box[0], x);
    box[1] = Math.min(box[1], y);
    box[2] = Math.max(box[2], x);
    box[3] = Math.max(box[3], y);
  }
  return points.length === 0 ? [0, 0] : [box[2] - box[0], box[3] - box[1]];
}

/** The link nearest to a place of the canvas, within reach; -1 where there is none. */
export function linkAt({ points, codes }: DrawnLinks, uses: ReadonlySet<LinkUse>, t: Transform, x: number, y: number): number {
  let [found, least] = [-1, REACH];
  for (let link = 0; 3 * link < points.length; link++) {
    if (!uses.has(useOf(codes[link] ?? 0))) continue;
    const [px, py] = toCanvas(t, points[3 * link] ?? 0, points[3 * link + 1] ?? 0);
    const distance = Math.hypot(px - x, py - y);
    if (distance < least) [found, least] = [link, distance];
  }
  return found;
}

export function drawLinks(context: CanvasRenderingContext2D, links: DrawnLinks, t: Transform, clip: Rect, uses: ReadonlySet<LinkUse>): void {
  const half = markSize(links, t);
  const styles = Float64Array.from(STYLES.flatMap(({ shape }, code) => [shape, code === BY_HAND ? LARGEST : half, Math.min(1.6, 0.6 + 0.35 * half)]));
  draw_points(
    context,
    links.points,
    shownCodes(links, uses),
    styles,
    STYLES.map(({ colour }) => colour),
    drawView(t, clip),
  );
}

const [SMALLEST, LARGEST] = [1, 4.5];

/** Half the size of a mark, CSS px: small where links lie close together. */
function markSize({ points, box: [width, height] }: DrawnLinks, { scale }: Transform): number {
  const apart = scale * Math.sqrt((width * height) / Math.max(1, points.length / 3));
  return Math.min(LARGEST, Math.max(SMALLEST, 0.3 * apart));
}

const NOT_DRAWN = 255;

function shownCodes({ codes }: DrawnLinks, uses: ReadonlySet<LinkUse>): Uint8Array {
  const shown = STYLES.map((_, code) => uses.has(useOf(code)));
  return codes.map((code) => (shown[code] === true ? code : NOT_DRAWN));
}

/** Residuals, so many times longer than they are. */
export function drawLinkResiduals(
  context: CanvasRenderingContext2D,
  links: DrawnLinks,
  factor: number,
  t: Transform,
  clip: Rect,
  uses: ReadonlySet<LinkUse>,
): void {
  draw_vectors(
    context,
    links.vectors,
    shownCodes(links, uses),
    Float64Array.of(1.2, 1.2, 1.2, 1.2),
    [RESIDUAL, CANDIDATE, RESIDUAL_REJECTED, RESIDUAL],
    factor,
    drawView(t, clip),
  );
}

/** A cross where an end of a link is measured, or is predicted. */
export function drawCross(context: CanvasRenderingContext2D, [x, y]: readonly [number, number], colour: string): void {
  context.save();
  for (const [stroke, width] of [
    ['rgb(0 0 0 / 0.6)', 4],
    [colour, 2],
  ] as const) {
    context.strokeStyle = stroke;
    context.lineWidth = width;
    context.beginPath();
    for (const [dx, dy] of [
      [1, 0],
      [0, 1],
    ] as const) {
      context.moveTo(x - 12 * dx, y - 12 * dy);
      context.lineTo(x - 3 * dx, y - 3 * dy);
      context.moveTo(x + 3 * dx, y + 3 * dy);
      context.lineTo(x + 12 * dx, y + 12 * dy);
    }
    context.stroke();
  }
  context.restore();
}

/** A ring about a link that is chosen, a thinner one about what is pointed at. */
export function drawRing(context: CanvasRenderingContext2D, { points }: DrawnLinks, link: number, t: Transform, chosen: boolean): void {
  const [x, y] = points.subarray(3 * link, 3 * link + 2);
  if (x === undefined || y === undefined) return;
  const [cx, cy] = toCanvas(t, x, y);
  context.save();
  for (const [colour, width] of [
    ['rgb(0 0 0 / 0.6)', chosen ? 5 : 3.5],
    [SELECTED, chosen ? 2.5 : 1.5],
  ] as const) {
    context.strokeStyle = colour;
    context.lineWidth = width;
    context.beginPath();
    context.arc(cx, cy, 10, 0, 2 * Math.PI);
    context.stroke();
  }
  context.restore();
}
