/** How the columns of tables are made: of numbers and of words. */
import { count, fixed } from '../text/format';
import type { Column, Total } from './rows';

interface Told {
  total?: Total;
}

/** A column of numbers with so many decimals; none where there is no number. */
export function numbers(
  key: string,
  label: string,
  unit: string,
  digits: number,
  value: (row: number) => number | null | undefined,
  help: string,
  told: Told = {},
): Column {
  const known = (row: number) => value(row) ?? NaN;
  const text = digits === 0 ? (row: number) => count(Number.isNaN(known(row)) ? null : known(row)) : (row: number) => fixed(known(row), digits);
  return { key, label, unit, help, value: known, text, ...told };
}

export function words(key: string, label: string, value: (row: number) => string, help: string): Column {
  return { key, label, unit: '', help, value, text: value, words: true };
}
