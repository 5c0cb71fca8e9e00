/** The texts of the page in its language. Its parts learn theirs before they are made (`parts.ts`). */
import { Catalogue } from './catalogue';
import type { Figures } from './catalogue';
import { asClauses } from './direction';
import { LANGUAGE } from './language';

export type { Figures };

const CATALOGUE = new Catalogue(LANGUAGE, LANGUAGE !== 'en');

/** What is said in another language than English, by its text: whatever has no figures, as most heads of tables, and what was said by `sayNamed`. */
const named = new Map<string, Named>();

/** The name of a text, with its figures. */
interface Named {
  name: string;
  figures: Figures;
}

/** Texts that are said from now on. */
export function learn(texts: readonly string[]): void {
  CATALOGUE.add(texts);
}

/** The text of a name, with its figures. Numbers that are not finite are none. */
export function say(name: string, figures: Figures = {}): string {
  const text = asClauses(CATALOGUE.text(name, figures) ?? name);
  if (LANGUAGE !== 'en' && Object.keys(figures).length === 0 && !named.has(text)) named.set(text, { name, figures });
  return text;
}

/** A text of few, with its figures: files for other programs have it in English. */
export function sayNamed(name: string, figures: Figures): string {
  const text = say(name, figures);
  if (LANGUAGE !== 'en') named.set(text, { name, figures });
  return text;
}

/** What a text says; null where that is not known, or English. */
export function nameOfText(text: string): Named | null {
  return named.get(text) ?? null;
}

/** The text of a name, or what belongs to it by another; null where the language of the page has none. */
export function known(name: string, attribute: string | null = null): string | null {
  return CATALOGUE.text(name, {}, attribute);
}

/** What is said while a field holds a value that is not allowed. */
export function refusedText(label: string): string {
  return say('this-value-is-not-allowed', { label });
}
