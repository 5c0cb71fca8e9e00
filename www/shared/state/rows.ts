/** Rows of a table as figures and words, and the order in which they are shown. */

export interface Column {
  key: string;
  label: string;
  unit: string;
  /** What the figure is, in a sentence. */
  help: string;
  /** What rows are sorted by; NaN comes last either way. */
  value: (row: number) => number | string;
  text: (row: number) => string;
}

export interface Order {
  /** Of the column; the rows keep their own order where there is no such column. */
  key: string;
  descending: boolean;
}

/** The rows that are kept, in order of a column. Equal values keep their order. */
export function ordered(count: number, columns: readonly Column[], { key, descending }: Order, keep: (row: number) => boolean): number[] {
  const kept = Array.from({ length: count }, (_, row) => row).filter(keep);
  const column = columns.find((candidate) => candidate.key === key);
  if (column === undefined) return kept;
  const values = new Map(kept.map((row) => [row, column.value(row)]));
  return kept.sort((a, b) => compared(values.get(a) ?? NaN, values.get(b) ?? NaN, descending) || a - b);
}

function compared(a: number | string, b: number | string, descending: boolean): number {
  const sign = descending ? -1 : 1;
  if (typeof a === 'string' || typeof b === 'string') return sign * String(a).localeCompare(String(b), 'en', { numeric: true });
  if (Number.isNaN(a) || Number.isNaN(b)) return Number(Number.isNaN(a)) - Number(Number.isNaN(b));
  return sign * (a - b);
}
