/** The texts of the page in its language. Its parts learn theirs before they are made (`parts.ts`). */
import { Catalogue } from './catalogue';
import type { Figures } from './catalogue';
import { asClauses } from './direction';
import { LANGUAGE } from './language';

export type { Figures };

const CATALOGUE = new Catalogue(LANGUAGE, LANGUAGE !== 'en');

/** Texts that are said from now on. */
export function learn(texts: readonly string[]): void {
  CATALOGUE.add(texts);
}

/** The text of a name, with its figures. Numbers that are not finite are none. */
export function say(name: string, figures: Figures = {}): string {
  return asClauses(CATALOGUE.text(name, figures) ?? name);
}

/** The text of a name, or what belongs to it by another; null where the language of the page has none. */
export function known(name: string, attribute: string | null = null): string | null {
  return CATALOGUE.text(name, {}, attribute);
}

/** What is said while a field holds a value that is not allowed. */
export function refusedText(label: string): string {
  return say('this-value-is-not-allowed', { label });
}
