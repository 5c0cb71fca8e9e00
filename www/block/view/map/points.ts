/** Tie points of the map, written pixel by pixel: 100,000 of them take a few milliseconds, on any machine. */
import { remember } from '../../../shared/state/remember';
import { REJECTED_BY_HAND } from '../../../shared/view/palette';
import { toCanvas } from '../../../shared/view/transform';
import type { Transform } from '../../../shared/view/transform';
import type { ViewPoints } from '../../state/view';
import { WORDS } from './colouring';
import type { Coloured } from './colouring';

/** Up to so many points are drawn larger. */
const FEW = 5000;
/** How near the pointer must be to a point, CSS px. */
const REACH = 7;

/** The points that are drawn: those that are kept and have a place. */
const drawnPoints = remember((points: ViewPoints, keeps: (point: number) => boolean): Uint32Array => {
  const drawn = new Uint32Array(points.count);
  let count = 0;
  for (let point = 0; point < points.count; point++) if (!Number.isNaN(points.positions[3 * point]) && keeps(point)) drawn[count++] = point;
  return drawn.subarray(0, count);
});

/** Where a point lies on the canvas. */
export function pointPlace({ positions }: ViewPoints, t: Transform, point: number): [number, number] {
  return toCanvas(t, positions[3 * point] ?? NaN, -(positions[3 * point + 1] ?? NaN));
}

/** The point nearest to a place, within reach; -1 where there is none. */
export function pointAt(points: ViewPoints, keeps: (point: number) => boolean, t: Transform, x: number, y: number): number {
  let [nearest, least] = [-1, REACH * REACH];
  for (const point of drawnPoints(points, keeps)) {
    const [px, py] = [t.scale * (points.positions[3 * point] ?? 0) + t.x - x, t.y - t.scale * (points.positions[3 * point + 1] ?? 0) - y];
    const distance = px * px + py * py;
    if (distance < least) [nearest, least] = [point, distance];
  }
  return nearest;
}

/** The points within an outline on the canvas, which closes itself; where it crosses itself, within an odd number of its turns. */
export function pointsWithin(points: ViewPoints, keeps: (point: number) => boolean, t: Transform, outline: readonly (readonly [number, number])[]): number[] {
  const xs = outline.map(([x]) => x);
  const ys = outline.map(([, y]) => y);
  const reduced = (values: readonly number[], of: (a: number, b: number) => number) => values.reduce((a, b) => of(a, b), values[0] ?? 0);
  const [left, right, top, bottom] = [reduced(xs, Math.min), reduced(xs, Math.max), reduced(ys, Math.min), reduced(ys, Math.max)];
  const inside: number[] = [];
  for (const point of drawnPoints(points, keeps)) {
    const x = t.scale * (points.positions[3 * point] ?? 0) + t.x;
    const y = t.y - t.scale * (points.positions[3 * point + 1] ?? 0);
    if (x >= left && y >= top && x <= right && y <= bottom && isWithin(xs, ys, x, y)) inside.push(point);
  }
  return inside;
}

/** Whether a line from a place to the right crosses the outline an odd number of times. */
function isWithin(xs: readonly number[], ys: readonly number[], x: number, y: number): boolean {
  let odd = false;
  for (let i = 0, before = xs.length - 1; i < xs.length; before = i++) {
    const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = [xs[before], ys[before], xs[i], ys[i]];
    if (y0 > y !== y1 > y && x < x0 + ((y - y0) / (y1 - y0)) * (x1 - x0)) odd = !odd;
  }
  return odd;
}

/** A colour of a style sheet as a word of a bitmap. */
function wordOf(colour: string): number {
  const [red = 0, green = 0, blue = 0] = (colour.match(/[\d.]+/gu) ?? []).map(Number);
  return new Uint32Array(Uint8Array.of(red, green, blue, 255).buffer)[0] ?? 0;
}

const GONE = wordOf([1, 3, 5].map((at) => String(Number.parseInt(REJECTED_BY_HAND.colour.slice(at, at + 2), 16))).join(' '));

export interface Painted {
  points: ViewPoints;
  coloured: Coloured;
  keeps: (point: number) => boolean;
  chosen: Uint32Array;
  pointed: Uint32Array;
  /** Colours of what is chosen, and of what lies about points. */
  mark: string;
  edge: string;
}

export class PointBitmap {
  private readonly canvas = document.createElement('canvas');
  private image: ImageData | null = null;
  private words = new Uint32Array();

  /** Paints the points over what is on the canvas; `ratio`: device px per CSS px. */
  paint(context: CanvasRenderingContext2D, t: Transform, width: number, height: number, ratio: number, painted: Painted): void {
    const [columns, rows] = [Math.max(1, Math.round(width * ratio)), Math.max(1, Math.round(height * ratio))];
    const own = this.canvas.getContext('2d');
    if (own === null) return;
    if (this.image === null || this.image.width !== columns || this.image.height !== rows) {
      Object.assign(this.canvas, { width: columns, height: rows });
      this.image = own.createImageData(columns, rows);
      this.words = new Uint32Array(this.image.data.buffer);
    } else this.words.fill(0);
    const { points, coloured, keeps, chosen, pointed, mark, edge } = painted;
    const drawn = drawnPoints(points, keeps);
    const few = drawn.length <= FEW;
    const side = Math.max(2, Math.round((few ? 4 : 2.4) * ratio));
    const device: Transform = { scale: t.scale * ratio, x: t.x * ratio, y: t.y * ratio };
    const canvas = { words: this.words, columns, rows };
    const [edged, marked] = [wordOf(edge), wordOf(mark)];
    const [kept, under] = [chosen.filter(keeps), pointed.filter(keeps)];
    if (few) squares(canvas, points, device, drawn, side + 2, () => edged);
    squares(canvas, points, device, drawn, side, (point) => (point < points.taking ? (WORDS[coloured.steps[point] ?? 0] ?? 0) : GONE));
    // Of what was rejected by hand the edges alone.
    const firstGone = drawn.findIndex((point) => point >= points.taking);
    if (firstGone >= 0) squares(canvas, points, device, drawn.subarray(firstGone), side - 2, () => edged);
    // A choice of many is seen by its colour.
    const isLarge = kept.length <= FEW;
    if (isLarge) squares(canvas, points, device, kept, side + 6, () => edged);
    squares(canvas, points, device, kept, isLarge ? side + 4 : side, () => marked);
    squares(canvas, points, device, under, side + 4, () => marked);
    own.putImageData(this.image, 0, 0);
    context.save();
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.drawImage(this.canvas, 0, 0);
    context.restore();
  }
}

/** Writes a square for each point. It is called for 100,000 of them a frame: plain loops, no call a row. */
function squares(
  { words, columns, rows }: { words: Uint32Array; columns: number; rows: number },
  { positions }: ViewPoints,
  t: Transform,
  points: Uint32Array,
  size: number,
  colour: (point: number) => number,
): void {
  for (const point of points) {
    const left = Math.floor(t.scale * (positions[3 * point] ?? 0) + t.x - size / 2);
    const top = Math.floor(t.y - t.scale * (positions[3 * point + 1] ?? 0) - size / 2);
    if (left <= -size || top <= -size || left >= columns || top >= rows) continue;
    const word = colour(point);
    const right = Math.min(columns, left + size);
    const bottom = Math.min(rows, top + size);
    for (let row = Math.max(0, top); row < bottom; row++) for (let column = Math.max(0, left); column < right; column++) words[row * columns + column] = word;
  }
}
