/** What frames the map: a grid with its coordinates, a scale bar, an arrow to the north. */
import type { Colours } from '../../../shared/view/colours';
import { asSentence } from '../../../shared/text/direction';
import { say } from '../../../shared/text/words';
import { toCanvas, toPosition } from '../../../shared/view/transform';
import type { Transform } from '../../../shared/view/transform';
import type { System } from '../../state/ground';
import type { LengthUnit } from '../../state/orthophoto-unit';
import { SAME, scaleOf } from '../../state/under';
import { inverse, mapped } from '../../../shared/state/plane-map';
import type { Affine } from '../../../shared/state/plane-map';
import { withUnit } from '../../../shared/text/units';

/** About so far apart are lines of the grid, CSS px; and so long is the scale bar at most. */
const GRID = 120;
const BAR = 130;

/** The largest of 1, 2, 5, 10, 20 … that is no larger. */
export function niceBelow(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  return ([5, 2].find((step) => step * power <= value) ?? 1) * power;
}

/** A length or coordinate at steps of a grid, without decimals that say nothing. */
export function stepText(value: number, step: number): string {
  return value.toFixed(Math.max(0, Math.min(6, -Math.floor(Math.log10(step) + 1e-9)))).replace('-', '−');
}

/** A length with two digits in the unit that it is said in; in units of the block where it has no scale. `unit`: its own. */
export function lengthText(length: number, system: System, unit: LengthUnit = 'm'): string {
  const twoDigits = (value: number) => String(Number(value.toPrecision(2)));
  if (unit === 'ft') return withUnit(twoDigits(length), unit);
  if (system === 'own') return say('length-in-units-of-the-block', { length: twoDigits(length) });
  const [factor, metric] = length >= 1000 ? [0.001, 'km'] : length >= 1 ? [1, 'm'] : length >= 0.01 ? [100, 'cm'] : [1000, 'mm'];
  return withUnit(twoDigits(length * factor), metric);
}

/** `toBlock`: from the system of the grid to that of the map, where it is another one. */
export function paintGrid(
  context: CanvasRenderingContext2D,
  colours: Colours,
  t: Transform,
  width: number,
  height: number,
  toBlock: Affine | null = null,
): void {
  const to = toBlock ?? SAME;
  const from = inverse(to);
  const corners = [
    [0, 0],
    [width, 0],
    [0, height],
    [width, height],
  ].map(([x = 0, y = 0]) => {
    const [left, down] = toPosition(t, x, y);
    return mapped(from, left, -down);
  });
  const [west, east] = rangeOf(corners.map(([x]) => x));
  const [south, north] = rangeOf(corners.map(([, y]) => y));
  const step = niceBelow((1.6 * GRID) / (t.scale * scaleOf(to)));
  const place = (x: number, y: number) => {
    const [u, v] = mapped(to, x, y);
    return toCanvas(t, u, -v);
  };
  const columns = ticks(west, east, step).map((x) => ({ at: x, ends: [place(x, south), place(x, north)] as const }));
  const rows = ticks(south, north, step).map((y) => ({ at: y, ends: [place(west, y), place(east, y)] as const }));
  context.save();
  context.strokeStyle = colours.muted;
  context.lineWidth = 0.5;
  context.globalAlpha = 0.35;
  context.beginPath();
  for (const {
    ends: [one, other],
  } of [...columns, ...rows]) {
    context.moveTo(...one);
    context.lineTo(...other);
  }
  context.stroke();
  context.globalAlpha = 1;
  context.font = '10px system-ui, sans-serif';
  context.textAlign = 'start';
  for (const { at, ends } of columns) haloed(context, colours, stepText(at, step), crossingOf(ends, 1, 0) + 3, 11);
  for (const { at, ends } of rows) {
    const y = crossingOf(ends, 0, 0);
    // Above are the labels of the columns, below the scale bar.
    if (y > 28 && y < height - 52) haloed(context, colours, stepText(at, step), 3, y - 3);
  }
  context.restore();
}

function rangeOf(values: readonly number[]): [number, number] {
  return [Math.min(...values), Math.max(...values)];
}

/** Where a line through two places crosses a line of one coordinate, by the other coordinate. */
function crossingOf([one, other]: readonly [readonly [number, number], readonly [number, number]], axis: 0 | 1, at: number): number {
  const share = (at - one[axis]) / (other[axis] - one[axis]);
  return one[(1 - axis) as 0 | 1] + share * (other[(1 - axis) as 0 | 1] - one[(1 - axis) as 0 | 1]);
}

function ticks(from: number, to: number, step: number): number[] {
  const first = Math.ceil(from / step);
  return Array.from({ length: Math.min(100, Math.max(0, Math.floor(to / step) - first + 1)) }, (_, i) => (first + i) * step);
}

/** A ground sample distance in m, as it is said of images. */
export function gsdText(gsd: number): string {
  return say('gsd', { gsd: lengthText(gsd, 'geographic') });
}

/** The bar at the lower left, and beside it what a pixel of the images shows; `gsd`: in m. */
export function paintScale(
  context: CanvasRenderingContext2D,
  colours: Colours,
  t: Transform,
  height: number,
  system: System,
  gsd: number | null = null,
  unit: LengthUnit = 'm',
): void {
  const length = niceBelow(BAR / t.scale);
  const wide = length * t.scale;
  const [left, base] = [12, height - 12];
  context.save();
  for (const [colour, line] of [
    [colours.ground, 5],
    [colours.text, 2],
  ] as const) {
    context.strokeStyle = colour;
    context.lineWidth = line;
    context.beginPath();
    context.moveTo(left, base - 5);
    context.lineTo(left, base);
    context.lineTo(left + wide, base);
    context.lineTo(left + wide, base - 5);
    context.stroke();
  }
  context.font = '11px system-ui, sans-serif';
  context.textAlign = 'center';
  haloed(context, colours, asSentence(lengthText(length, system, unit)), left + wide / 2, base - 6);
  context.textAlign = 'left';
  if (gsd !== null) haloed(context, colours, asSentence(gsdText(gsd)), left + wide + 12, base);
  context.restore();
}

/** An arrow at the upper right; it is true north at the origin of the block, and the direction of Y of other systems. */
export function paintNorth(context: CanvasRenderingContext2D, colours: Colours, width: number, system: System): void {
  const [x, y] = [width - 24, 18];
  context.save();
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(x + 6, y + 20);
  context.lineTo(x, y + 15);
  context.lineTo(x - 6, y + 20);
  context.closePath();
  context.lineWidth = 3;
  context.strokeStyle = colours.ground;
  context.stroke();
  context.fillStyle = colours.text;
  context.fill();
  context.font = '600 12px system-ui, sans-serif';
  context.textAlign = 'center';
  haloed(context, colours, system === 'geographic' ? 'N' : 'Y', x, y + 34);
  context.restore();
}

/** Text that is read over any picture. */
export function haloed(context: CanvasRenderingContext2D, colours: Colours, text: string, x: number, y: number): void {
  context.lineJoin = 'round';
  context.lineWidth = 3;
  context.strokeStyle = colours.ground;
  context.strokeText(text, x, y);
  context.fillStyle = colours.text;
  context.fillText(text, x, y);
}
