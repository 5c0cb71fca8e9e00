/** The axes of a plot: their ends, ticks of round values, and how values lie between them. */
import type { Axis, PlotData } from '../../state/plots';
import { asSentence } from '../../../shared/text/direction';
import { unitText } from '../../../shared/text/units';
import { say } from '../../../shared/text/words';

/** Room of labels and ticks about the values, CSS px. */
export const ROOM = { left: 64, right: 16, top: 14, bottom: 40 } as const;

/** Names that stand upright are no longer than this, and no nearer to each other, CSS px. */
const UPRIGHT = { most: 96, apart: 13 } as const;
/** Between names that lie beside each other, CSS px. */
const BETWEEN = 8;
/** A line of the legend, what stands before each of its entries, and between them, CSS px. */
export const LEGEND = { line: 16, mark: 16, between: 14 } as const;

export interface Entry {
  text: string;
  /** Index of its group; that of the whiskers is beyond all. */
  group: number;
  x: number;
  line: number;
}

/** How the values lie in a picture: the room about them, whether names stand upright, and where the entries of the legend are. */
export interface Laid {
  room: { left: number; right: number; top: number; bottom: number };
  upright: boolean;
  legend: readonly Entry[];
}

/** `measure`: how long a text is, CSS px. */
export function laidOut({ x, groups, whiskers }: PlotData, width: number, measure: (text: string) => number): Laid {
  const across = Math.max(1, width - ROOM.left - ROOM.right);
  const widest = (x.names ?? []).reduce((most, name) => Math.max(most, measure(name)), 0);
  const upright = x.names !== undefined && widest + BETWEEN > across / Math.max(1, x.names.length);
  const texts = groups === undefined ? [] : [...groups.kinds.map(({ label }) => label), ...(whiskers === undefined ? [] : [say('whiskers-of-95')])];
  let [at, line] = [0, 0];
  const legend = texts.map((text, group) => {
    const wide = LEGEND.mark + measure(text);
    if (at > 0 && at + wide > across) [at, line] = [0, line + 1];
    const entry = { text, group, x: ROOM.left + at, line };
    at += wide + LEGEND.between;
    return entry;
  });
  const lines = legend.length === 0 ? 0 : line + 1;
  return {
    room: { ...ROOM, top: ROOM.top + LEGEND.line * lines, bottom: ROOM.bottom + (upright ? Math.min(UPRIGHT.most, widest) - 10 : 0) },
    upright,
    legend,
  };
}

/** The names that are written beside an axis with so many px between them: all that have room; else every third, fifth and so on, so that what comes in turns has its names in turns. */
export function namesWritten([from, to]: Ends, names: readonly string[], apart: number): number[] {
  const needed = Math.ceil(UPRIGHT.apart / Math.max(1e-9, apart));
  const step = needed % 2 === 0 ? needed + 1 : needed;
  return Array.from(names.keys()).filter((at) => at % step === 0 && at >= from && at <= to);
}

/** Longest name that stands upright, CSS px. */
export const UPRIGHT_MOST = UPRIGHT.most;

/** Values at the two ends of an axis. */
export type Ends = readonly [from: number, to: number];

/** Beyond the farthest values, in shares of their span. */
const BESIDE = 0.04;

/** The ends of both axes: bars stand on zero, places of a list have room on both sides, logarithmic ones are powers of ten. */
export function endsOf({ x, y, bars, square, groups, whiskers }: PlotData, width: number, height: number): { x: Ends; y: Ends } {
  const across: Ends = x.names === undefined ? spread(x.values) : [-0.5, Math.max(0, x.names.length - 1) + 0.5];
  const values = whiskers === undefined ? y.values : Float64Array.from([...y.values, ...whiskers.from, ...whiskers.to]);
  // Differences of groups are compared with zero.
  const up = spread(y.logarithmic === true ? values.map(Math.log10) : values, bars || groups !== undefined);
  if (!square) return { x: across, y: up };
  // The same length of both for the same value, about zero.
  const most = Math.max(...across.map(Math.abs), ...up.map(Math.abs));
  const [wide, high] = [Math.max(1, width - ROOM.left - ROOM.right), Math.max(1, height - ROOM.top - ROOM.bottom)];
  const least = Math.min(wide, high);
  return { x: [(-most * wide) / least, (most * wide) / least], y: [(-most * high) / least, (most * high) / least] };
}

function spread(values: Float64Array, zero = false): Ends {
  let [low, high] = zero ? [0, 0] : [Infinity, -Infinity];
  // What is infinite stands over all others, wherever the axis ends.
  for (const value of values) if (Number.isFinite(value)) [low, high] = [Math.min(low, value), Math.max(high, value)];
  if (!(high > low)) return Number.isFinite(low) && low !== 0 ? [low - Math.abs(low) / 2, low + Math.abs(low) / 2] : [0, 1];
  const beside = BESIDE * (high - low);
  return [zero && low === 0 ? 0 : low - beside, zero && high === 0 ? 0 : high + beside];
}

/** Round values between two ends, about so many. */
export function ticksBetween([from, to]: Ends, about: number): number[] {
  const step = roundStep((to - from) / Math.max(1, about));
  if (!(step > 0) || !Number.isFinite(step)) return [];
  const first = Math.ceil(from / step - 1e-9);
  const last = Math.floor(to / step + 1e-9);
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => Number(((first + i) * step).toPrecision(12)));
}

/** Less than so many powers of ten has ticks that are equally far apart. */
const FEW_POWERS = 0.7;

/** Round values between two powers of ten: 1, 2 and 5 of each, or the powers alone where many of them lie between. */
export function ticksOfPowers([from, to]: Ends, about: number): number[] {
  if (to - from < FEW_POWERS) return ticksBetween([10 ** from, 10 ** to], about);
  const digits = (to - from) * 3 <= about ? [1, 2, 5] : [1];
  const powers = Array.from({ length: Math.max(0, Math.floor(to) - Math.floor(from) + 1) }, (_, i) => Math.floor(from) + i);
  const all = powers.flatMap((power) => digits.map((digit) => Number((digit * 10 ** power).toPrecision(12))));
  return all.filter((tick) => Math.log10(tick) >= from && Math.log10(tick) <= to);
}

/** 1, 2 or 5 times a power of ten, no smaller than a length. */
function roundStep(length: number): number {
  const power = 10 ** Math.floor(Math.log10(length));
  return ([1, 2, 5, 10].find((digit) => digit * power >= length * (1 - 1e-9)) ?? 10) * power;
}

/** Decimals that tell ticks apart. */
export function decimalsOf(ticks: readonly number[]): number {
  const [first = 0, second = first + 1] = ticks;
  return Math.max(0, Math.min(9, Math.ceil(-Math.log10(Math.abs(second - first)) - 1e-9)));
}

/** The title of an axis, with its unit. */
export function titleOf({ label, unit }: Axis): string {
  return unit === '' ? asSentence(label) : asSentence(say('axis-title', { label, unit: unitText(unit) }));
}

/** Titles keep so far from the edges of the picture, CSS px. */
const EDGE = 4;

/** Where the middle of a title stands along a side of the picture: at that of its axis, or as near to it as the whole title is in sight. `most`: a longer one is drawn so narrow. */
export function titleWithin(length: number, axis: number, side: number): { middle: number; most: number } {
  const most = Math.max(1, side - 2 * EDGE);
  const half = Math.min(length, most) / 2;
  return { middle: Math.min(Math.max(axis, EDGE + half), side - EDGE - half), most };
}
