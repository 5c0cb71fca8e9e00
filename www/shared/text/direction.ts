/** Which way parts of a text run in a language from right to left, by marks of direction (Unicode UAX 9). */
import { LANGUAGE, LANGUAGES } from './language';

const IS_FROM_RIGHT = LANGUAGES[LANGUAGE].direction === 'rtl';

/** The beginning of a part from left to right, of one from right to left, and the end of either. */
const [LRI, RLI, PDI] = ['\u2066', '\u2067', '\u2069'];
/** The beginning of a part that runs as its first letter does. */
const FSI = '\u2068';
const ISOLATE = /[\u2066-\u2068]/u;
const LETTER = /\p{L}/u;
const FROM_RIGHT = /\p{Script=Arabic}/u;

/** A number that is set apart, with its degree sign. */
const NUMBER = /\u2068([^\u2066-\u2069]+)\u2069(°?)/u.source;
/** "1.5° ± 0.2°" is one figure: it runs from left to right as a whole, or its parts would change places. */
const WITH_ERROR = new RegExp(`${NUMBER}([ \\u00a0]±[ \\u00a0])${NUMBER}`, 'gu');

/** What a text writes is set apart as its first letter runs. A clause, which a space or a comma begins, goes on as the sentence does, also where that stands in a part of its own. */
export function asClauses(text: string, isFromRight = IS_FROM_RIGHT): string {
  if (!isFromRight) return text;
  const figures = text.replaceAll(WITH_ERROR, `${LRI}$1$2$3$4$5${PDI}`).replaceAll(`${PDI}°`, `°${PDI}`);
  return ofParts(figures.replaceAll(/\u2068(?=[\u2067\u2068]*[\s،؛,;:·(])/gu, RLI));
}

/** Parts within a part say nothing of its direction: where all its letters stand in such ones, as in "reject" "452 matches", it would run from left to right. With words of the language among them it is a text of it. */
function ofParts(text: string): string {
  const letters = [...text];
  const open: { at: number; isOwn: boolean; hasWords: boolean }[] = [];
  letters.forEach((letter, at) => {
    const part = open.at(-1);
    if (ISOLATE.test(letter)) open.push({ at, isOwn: false, hasWords: false });
    else if (letter === PDI && part !== undefined) {
      open.pop();
      if (letters[part.at] === FSI && !part.isOwn && part.hasWords) letters[part.at] = RLI;
    } else if (part !== undefined && LETTER.test(letter)) {
      part.isOwn = true;
      if (FROM_RIGHT.test(letter)) for (const around of open) around.hasWords = true;
    }
  });
  return letters.join('');
}

/** A sentence on a canvas, which itself runs from left to right. */
export function asSentence(text: string): string {
  return IS_FROM_RIGHT ? `${RLI}${text}${PDI}` : text;
}

/** A figure with its sign, or the name of a file, which may begin with a number, among words from right to left. */
export function asFigure(text: string): string {
  return IS_FROM_RIGHT ? `${LRI}${text}${PDI}` : text;
}

/** Without the marks that set parts of a text apart: other programs have nothing to do with them. */
export function withoutParts(text: string): string {
  return text.replaceAll(/[\u2066-\u2069]/gu, '');
}
