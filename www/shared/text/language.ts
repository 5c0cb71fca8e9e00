/** The language of the page: the one that was chosen, or the first of the browser's that there are texts in. */
import { keepChoice, keptChoice } from '../choices';

/** By their tags: how each calls itself, and which way it runs. */
export const LANGUAGES = { en: { name: 'English', direction: 'ltr' }, ar: { name: 'العربية', direction: 'rtl' } } as const;

export type Language = keyof typeof LANGUAGES;

const NAME = 'tiepoint-language';

function isLanguage(tag: string | null | undefined): tag is Language {
  return typeof tag === 'string' && Object.hasOwn(LANGUAGES, tag);
}

/** The one that all texts are written in, as long as the document lasts. A worker is told it at the end of its name. */
export const LANGUAGE: Language = typeof document === 'undefined' ? told() : preferred(keptChoice(NAME), navigator.languages);

/** The name of a worker that writes in the language of the page. */
export function namedInLanguage(worker: string): string {
  return `${worker} ${LANGUAGE}`;
}

function told(): Language {
  const tag = String((globalThis as { name?: unknown }).name ?? '')
    .split(' ')
    .at(-1);
  return isLanguage(tag) ? tag : 'en';
}

/** A choice comes before what the browser is set to, in whose order the languages are liked. */
export function preferred(chosen: string | null, liked: readonly string[]): Language {
  if (isLanguage(chosen)) return chosen;
  return liked.map((tag) => tag.split('-')[0]).find(isLanguage) ?? 'en';
}

/** Keeps a choice for the next document. */
export function keepLanguage(language: Language): void {
  keepChoice(NAME, language);
}
