/** Messages of the crate in the language of the page. */
import { message as written } from '../crate';
import { asClauses } from './direction';
import { grouped, withMinus } from './format';
import { LANGUAGE } from './language';

/** Families whose numbers are figures. Those of others may belong to names, or be what was typed. */
const WITH_FIGURES = /verdict$|^(?:warning|no_geometry|no_orientation|connection)$/u;

type Written = Parameters<typeof written>;

/** The text of a message, or, by its name, another text that belongs to it, as its `label`; its figures as the page writes them. */
export function message(family: Written[0], of: Written[1], attribute: string | null = null): string {
  const text = written(family, of, attribute, LANGUAGE).replaceAll('σ0', 'σ₀').replaceAll('± ', '±\u00a0');
  return asClauses(WITH_FIGURES.test(family) ? grouped(withMinus(text)) : text);
}

/** What is said of whatever was thrown. Errors of the crate come with their figures; some of the browser have a name alone. */
export function messageOf(thrown: unknown): string {
  if (!(thrown instanceof Error)) return String(thrown);
  const error = 'error' in thrown && LANGUAGE !== 'en' ? (thrown.error as { kind?: unknown } | null) : null;
  return typeof error?.kind === 'string' ? message('error', { ...error, kind: error.kind }) : thrown.message || thrown.name;
}
