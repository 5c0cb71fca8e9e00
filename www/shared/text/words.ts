/** Texts of the page itself, from the catalogue of the crate. */
import { message } from '../crate';

/** What a text writes; null where there is nothing to write. */
export type Figures = Readonly<Record<string, number | string | boolean | object | null>>;

/** The text of a kind, with the minus sign that typography has. Numbers that are not finite are none. */
export function page(kind: string, figures: Figures = {}): string {
  const known = Object.entries(figures).map(([name, value]) => [name, typeof value === 'number' && !Number.isFinite(value) ? null : value] as const);
  return message('page', { kind, ...Object.fromEntries(known) }).replace(/(?<!\w)-(?=\d)/gu, '−');
}
