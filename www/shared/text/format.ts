/** Numbers as the panels write them. */

/** A number with its minus sign as typography has it; a dash where there is none. */
export function fixed(value: number | null | undefined, digits: number): string {
  if (value == null || Number.isNaN(value)) return '–';
  if (!Number.isFinite(value)) return value > 0 ? '∞' : '−∞';
  return value.toFixed(digits).replace('-', '−');
}

/** A whole number in groups of three, set apart by narrow spaces. */
export function count(value: number | null | undefined): string {
  return value == null ? '–' : String(value).replace(/\B(?=(\d{3})+$)/gu, '\u202f');
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

/** What is said while a field holds a value that is not allowed. */
export function refusedText(label: string): string {
  return `${label}: this value is not allowed. The last valid one stays in use.`;
}

/** What is said of whatever was thrown. */
export function messageOf(error: unknown): string {
  return error instanceof Error ? error.message : String(error);
}
