/** Images on the orthophoto: the outline of what each shows, and its projection centre. */
import type { Colours } from '../../../shared/view/colours';
import { toCanvas, toPosition } from '../../../shared/view/transform';
import type { Transform } from '../../../shared/view/transform';
import { haloed } from '../map/frame';

type Place = readonly [number, number];

/** An image as it lies on the orthophoto, X and Y of its system. */
export interface Footprint {
  name: string;
  /** Empty where it is not known. */
  outline: readonly Place[];
  centre: Place;
  colour: string;
  /** Other settings or heights placed it. */
  isStale: boolean;
}

/** How near a projection centre is pointed at, CSS px. */
const REACH = 12;
/** More images than these have their names only where they are chosen. */
const MOST_NAMES = 60;

/** The image whose centre is near a place of the canvas, else the one on whose ground it lies, the nearest centre first, with its distance; null where there is none. */
export function footprintAt<F extends Footprint>(all: readonly F[], t: Transform, x: number, y: number): { of: F; distance: number } | null {
  const [east, south] = toPosition(t, x, y);
  const [first] = all
    .map((of) => {
      const [cx, cy] = toCanvas(t, of.centre[0], -of.centre[1]);
      return { of, distance: Math.hypot(cx - x, cy - y) };
    })
    .filter(({ of, distance }) => distance < REACH || isInside(of.outline, east, -south))
    .sort((a, b) => a.distance - b.distance);
  return first ?? null;
}

/** Whether an outline goes about a place. */
function isInside(outline: readonly Place[], x: number, y: number): boolean {
  let inside = false;
  outline.forEach(([ax, ay], i) => {
    const [bx, by] = outline[(i + 1) % outline.length] ?? [ax, ay];
    if (ay > y !== by > y && x < ax + ((bx - ax) * (y - ay)) / (by - ay)) inside = !inside;
  });
  return inside;
}

export function paintFootprint(
  context: CanvasRenderingContext2D,
  t: Transform,
  { outline, colour, isStale }: Footprint,
  chosen: boolean,
  pointed: boolean,
): void {
  context.save();
  context.beginPath();
  for (const [x, y] of outline) context.lineTo(...toCanvas(t, x, -y));
  context.closePath();
  // A dark line under it is seen on any ground.
  context.strokeStyle = 'rgb(0 0 0 / 0.55)';
  context.lineWidth = chosen ? 5 : 3;
  context.stroke();
  context.strokeStyle = colour;
  context.lineWidth = chosen ? 2.5 : pointed ? 2 : 1.2;
  if (isStale) context.setLineDash([6, 4]);
  context.stroke();
  // What is chosen shows its links.
  if (pointed && !chosen) {
    context.fillStyle = colour;
    context.globalAlpha = 0.1;
    context.fill();
  }
  context.restore();
}

/** The projection centres, with their names where there is room; that of what is chosen always has one. */
export function paintCentres<F extends Footprint>(
  context: CanvasRenderingContext2D,
  colours: Colours,
  t: Transform,
  all: readonly F[],
  isChosen: (of: F) => boolean,
): void {
  for (const of of all) paintCentre(context, colours, t, of, isChosen(of), all.length <= MOST_NAMES);
}

function paintCentre(context: CanvasRenderingContext2D, colours: Colours, t: Transform, of: Footprint, chosen: boolean, hasName: boolean): void {
  const [x, y] = toCanvas(t, of.centre[0], -of.centre[1]);
  context.save();
  context.beginPath();
  context.arc(x, y, chosen ? 7 : 5, 0, 2 * Math.PI);
  context.fillStyle = of.colour;
  context.fill();
  context.lineWidth = 2;
  context.strokeStyle = colours.surface;
  context.stroke();
  if (hasName || chosen) {
    context.font = chosen ? '600 12px system-ui, sans-serif' : '11px system-ui, sans-serif';
    context.textAlign = 'center';
    haloed(context, colours, of.name, x, y + 20);
  }
  context.restore();
}
