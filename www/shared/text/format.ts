/** Numbers as the panels write them. */

/** A number with its minus sign as typography has it; a dash where there is none. */
export function fixed(value: number | null | undefined, digits: number): string {
  if (value == null || Number.isNaN(value)) return '–';
  if (!Number.isFinite(value)) return value > 0 ? '∞' : '−∞';
  const text = value.toFixed(digits);
  // What is rounded to nothing has no sign.
  return Number(text) === 0 ? text.replace('-', '') : text.replace('-', '−');
}

/** Decimals that show two significant digits of a standard error or a half-width: those of the value that it belongs to. */
export function decimalsOfError(error: number | null | undefined, otherwise: number): number {
  return error != null && error > 0 && Number.isFinite(error) ? Math.min(9, Math.max(0, 1 - Math.floor(Math.log10(error)))) : otherwise;
}

/** A whole number in groups of three, set apart by narrow spaces. */
export function count(value: number | null | undefined): string {
  return value == null ? '–' : String(value).replace(/\B(?=(\d{3})+$)/gu, '\u202f');
}

/** A sentence with its whole numbers in such groups; digits of names and of decimals stay as they are. */
export function grouped(text: string): string {
  return text.replaceAll(/(?<![\p{L}\d_.,−-])\d{4,}(?![\p{L}\d_-]|[.,]\d|\.\p{L})/gu, (digits) => count(Number(digits)));
}

/** A sentence with the minus signs of its numbers as typography has them; hyphens in names and between digits stay. */
export function withMinus(text: string): string {
  return text.replaceAll(/(?<![\p{L}\p{N}_.,)−-])-(?=\d)/gu, '−');
}

/** With all of its digits. */
export function plain(value: number): string {
  return String(value).replace('-', '−');
}

/** Four significant digits, with a power of ten where the number is very small or large. */
export function significant(value: number): string {
  if (value === 0) return '0';
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 1e5) return fixed(value, Math.max(0, 3 - Math.floor(Math.log10(size))));
  const [mantissa = '', exponent = ''] = value.toExponential(3).split('e');
  const power = [...exponent.replace('+', '')].map((c) => (c === '-' ? '⁻' : '⁰¹²³⁴⁵⁶⁷⁸⁹'.charAt(Number(c)))).join('');
  return `${mantissa.replace('-', '−')}·10${power}`;
}

export function percent(share: number): string {
  return `${(100 * share).toFixed(1)} %`;
}

/** With one full stop at its end. */
export function sentence(text: string): string {
  return `${text.replace(/\.$/u, '')}.`;
}
