/** Which way parts of a text run in a language from right to left, by marks of direction (Unicode UAX 9). */
import { LANGUAGE, LANGUAGES } from './language';

const IS_FROM_RIGHT = LANGUAGES[LANGUAGE].direction === 'rtl';

/** The beginnings of parts from right to left and from left to right, and the end of either. */
const [RLI, LRI, PDI] = ['\u2067', '\u2066', '\u2069'];

/** What a text writes is set apart as its first letter runs. A clause, which a space or a comma begins, goes on as the sentence does, also where that stands in a part of its own. */
export function asClauses(text: string, isFromRight = IS_FROM_RIGHT): string {
  return isFromRight ? text.replaceAll(/\u2068(?=[\u2067\u2068]*[\s،؛,;:·(])/gu, RLI) : text;
}

/** A sentence on a canvas, which itself runs from left to right. */
export function asSentence(text: string): string {
  return IS_FROM_RIGHT ? `${RLI}${text}${PDI}` : text;
}

/** A figure with its sign among words from right to left. */
export function asFigure(text: string): string {
  return IS_FROM_RIGHT ? `${LRI}${text}${PDI}` : text;
}
