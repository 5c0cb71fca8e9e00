/** The texts of the page in parts, each a file of its own: only those of the language that is chosen are loaded, and those of the block with it. */
import { LANGUAGE } from '../text/language';
import type { Language } from '../text/language';
import { learn } from '../text/words';
import { loadPart } from './parts';

type TextPart = 'program' | 'block';
type Load = () => Promise<{ TEXTS: readonly string[] }>;

const FILES: Readonly<Record<Language, Readonly<Record<TextPart, readonly [file: string, load: Load]>>>> = {
  en: { program: ['en.js', () => import('../text/en')], block: ['en-block.js', () => import('../text/en-block')] },
  ar: { program: ['ar.js', () => import('../text/ar')], block: ['ar-block.js', () => import('../text/ar-block')] },
};

/** What was learned. */
const learned: TextPart[] = [];

async function textsOf(language: Language, part: TextPart): Promise<readonly string[]> {
  const { TEXTS } = await loadPart(...FILES[language][part]);
  return TEXTS;
}

/** Loads the texts of a part; from then on they are said. */
export async function learnPart(part: TextPart): Promise<void> {
  const texts = await textsOf(LANGUAGE, part);
  if (learned.includes(part)) return;
  learned.push(part);
  learn(texts);
}
