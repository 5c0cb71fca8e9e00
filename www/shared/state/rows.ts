/** Rows of a table as figures and words: which are kept, in which order they are shown, and their text in a file. */
import { withoutParts } from '../text/direction';
import { unitText } from '../text/units';

export interface Column {
  key: string;
  label: string;
  unit: string;
  /** What the figure is, in a sentence. */
  help: string;
  /** What rows are sorted by; NaN comes last either way. */
  value: (row: number) => number | string;
  text: (row: number) => string;
  /** Holds words: is searched for a text, where others are kept by limits. */
  words?: boolean;
  /** What the foot of the table says of the rows that are shown; figures are those of `value`. */
  total?: Total;
  /** The foot has a line for each of these parts of the rows, with its name in this column; rows of no part are in none. */
  parts?: readonly Part[];
}

export interface Part {
  label: string;
  has: (row: number) => boolean;
}

export type Total = 'sum' | 'mean' | 'rms';

export interface Order {
  /** Of the column; the rows keep their own order where there is no such column. */
  key: string;
  descending: boolean;
}

/** What a column must hold: a text, in any case of letters; or a number within limits, null where there is none. */
export type Condition = { kind: 'contains'; text: string } | { kind: 'range'; from: number | null; to: number | null };

/** By the key of the column. */
export type Filter = Readonly<Record<string, Condition>>;

/** All rows in order of a column. Equal values keep their order. */
export function ordered(count: number, columns: readonly Column[], { key, descending }: Order): Uint32Array {
  const rows = Uint32Array.from({ length: count }, (_, row) => row);
  const column = columns.find((candidate) => candidate.key === key);
  if (column === undefined) return rows;
  const sign = descending ? -1 : 1;
  const values = Array.from(rows, column.value);
  if (values.some((value) => typeof value === 'string')) {
    const words = new Intl.Collator('en', { numeric: true });
    return rows.sort((a, b) => sign * words.compare(String(values[a]), String(values[b])) || a - b);
  }
  // A comparison of numbers alone, with those that are not there behind them: 100,000 rows are in order before the next frame.
  const keys = Float64Array.from(values, (value) => (typeof value === 'number' && !Number.isNaN(value) ? sign * value : Infinity));
  return rows.sort((a, b) => ((keys[a] ?? 0) < (keys[b] ?? 0) ? -1 : (keys[a] ?? 0) > (keys[b] ?? 0) ? 1 : a - b));
}

/** Those of the rows that are kept, in their order. */
export function keptOf(rows: Uint32Array, keep: (row: number) => boolean): Uint32Array {
  const kept = new Uint32Array(rows.length);
  let length = 0;
  for (const row of rows) if (keep(row)) kept[length++] = row;
  return kept.subarray(0, length);
}

/** Tells the rows that meet all conditions; null where there is no condition. What has no number meets no limits. */
export function keeping(columns: readonly Column[], filter: Filter): ((row: number) => boolean) | null {
  const tests = columns.flatMap(({ key, value, text, words }) => {
    const condition = filter[key];
    if (condition === undefined || (condition.kind === 'contains') !== (words === true)) return [];
    if (condition.kind === 'contains') {
      const wanted = condition.text.toLowerCase();
      return [(row: number) => text(row).toLowerCase().includes(wanted)];
    }
    const [from, to] = [condition.from ?? -Infinity, condition.to ?? Infinity];
    return [
      (row: number) => {
        const number = Number(value(row));
        return number >= from && number <= to;
      },
    ];
  });
  const [only = null] = tests;
  return tests.length < 2 ? only : (row) => tests.every((test) => test(row));
}

/** Of each row 1 where it meets all conditions; null where there is no condition. */
export function maskOf(count: number, columns: readonly Column[], filter: Filter): Uint8Array | null {
  const meets = keeping(columns, filter);
  if (meets === null) return null;
  const mask = new Uint8Array(count);
  for (let row = 0; row < count; row++) mask[row] = Number(meets(row));
  return mask;
}

const NUMBER = String.raw`[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?`;
const BETWEEN = new RegExp(`^(${NUMBER})\\s*(?:\\.\\.+|…|–|-|to)\\s*(${NUMBER})$`, 'iu');
const LIMIT = new RegExp(`^(>=|<=|≥|≤|>|<)\\s*(${NUMBER})$`, 'iu');
const EQUAL = new RegExp(`^=?\\s*(${NUMBER})$`, 'iu');

/** What is typed over a column of numbers: `2..5`, `>2`, `≤0.5`, or a number as it is shown. Null: nothing; undefined: it cannot be read. */
export function conditionOf(typed: string, words: boolean): Condition | null | undefined {
  const text = typed.trim();
  if (text === '') return null;
  if (words) return { kind: 'contains', text };
  const plain = text.replaceAll('−', '-').replaceAll(/[\u202f ](?=\d{3})/gu, '');
  const between = BETWEEN.exec(plain);
  if (between !== null) return { kind: 'range', from: Number(between[1]), to: Number(between[2]) };
  const limit = LIMIT.exec(plain);
  if (limit !== null) return limited(limit[1] ?? '', Number(limit[2]));
  const equal = EQUAL.exec(plain)?.[1];
  if (equal === undefined) return undefined;
  // A number stands for all that are written so.
  const half = /e/iu.test(equal) ? 0 : 0.5 * 10 ** -(equal.split('.')[1]?.length ?? 0);
  return { kind: 'range', from: Number(equal) - half, to: Number(equal) + half };
}

function limited(sign: string, number: number): { kind: 'range'; from: number | null; to: number | null } {
  const next = Math.max(Math.abs(number) * Number.EPSILON, Number.MIN_VALUE);
  if (sign === '>') return { kind: 'range', from: number + next, to: null };
  if (sign === '<') return { kind: 'range', from: null, to: number - next };
  return sign === '>=' || sign === '≥' ? { kind: 'range', from: number, to: null } : { kind: 'range', from: null, to: number };
}

/** A condition as it could be typed. */
export function conditionText(condition: Condition | undefined): string {
  if (condition === undefined) return '';
  if (condition.kind === 'contains') return condition.text;
  const { from, to } = condition;
  if (from !== null && to !== null) return `${String(from)}..${String(to)}`;
  if (from !== null) return limitText('>', '≥', from);
  return to === null ? '' : limitText('<', '≤', to);
}

/** Limits beyond a number are kept as the next one: they are written as they were typed. */
function limitText(beyond: '>' | '<', up: string, limit: number): string {
  const typed = Math.abs(limit) === Number.MIN_VALUE ? 0 : Number(limit.toPrecision(15));
  const { from, to } = limited(beyond, typed);
  return (from ?? to) === limit ? `${beyond}${String(typed)}` : `${up}${String(limit)}`;
}

/** Sum, mean or root mean square of what a column has for these rows; NaN where it has nothing. */
export function totalOf(column: Column, rows: Iterable<number>): number {
  let [sum, squares, count] = [0, 0, 0];
  for (const row of rows) {
    const value = column.value(row);
    if (typeof value !== 'number' || Number.isNaN(value)) continue;
    sum += value;
    squares += value * value;
    count += 1;
  }
  if (count === 0) return NaN;
  return column.total === 'sum' ? sum : column.total === 'mean' ? sum / count : Math.sqrt(squares / count);
}

/** The head of a column in a file: as it is shown, with its unit, and without marks of direction, which nobody could type who asks for the column. */
function headText({ label, unit }: Column): string {
  const text = withoutParts(label).replaceAll(/[\u200e\u200f]/gu, '');
  return unit === '' ? text : `${text} [${unitText(unit)}]`;
}

/**
 * A text as a cell or a head of a file holds it: with an apostrophe in front where a spreadsheet would run it as a formula. The crate writes its
 * tables so, and takes the apostrophe away when it reads them (`guarded` in `src/text.rs`).
 */
function guarded(text: string): string {
  return /^'*[=+\-@\t\r]/u.test(text) ? `'${text}` : text;
}

/** A figure as programs read it: without groups of digits, signs of typography and dashes. What is no number is a text. */
function plain(column: Column, row: number): string {
  const text = withoutParts(column.text(row));
  if (column.words === true) return guarded(text);
  const figure = text.replaceAll('\u202f', '').replaceAll('−', '-').replace(/^–$/u, '');
  return Number.isNaN(Number(figure)) ? guarded(figure) : figure;
}

/** The rows as lines of comma-separated values (RFC 4180), under their heads. */
export function csvOf(columns: readonly Column[], rows: Iterable<number>): string {
  const field = (text: string) => (/[",\r\n]/u.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  return linesOf(columns, rows, field, ',');
}

/** The rows as a spreadsheet takes them from the clipboard. */
export function tabbedOf(columns: readonly Column[], rows: Iterable<number>): string {
  return linesOf(columns, rows, (text) => text.replaceAll(/[\t\r\n]/gu, ' '), '\t');
}

function linesOf(columns: readonly Column[], rows: Iterable<number>, field: (text: string) => string, between: string): string {
  const lines = [columns.map((column) => field(guarded(headText(column)))).join(between)];
  for (const row of rows) lines.push(columns.map((column) => field(plain(column, row))).join(between));
  return `${lines.join('\n')}\n`;
}
