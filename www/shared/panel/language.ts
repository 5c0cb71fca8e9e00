/** The document in the language of the page, and the button that changes it. */
import type { Keeper } from '../files/keeper';
import { keepLanguage, LANGUAGE, LANGUAGES } from '../text/language';
import type { Language } from '../text/language';
import { say } from '../text/words';
import { fill, h } from './dom';

/** Attributes of the document that hold texts, by those that name them. */
const ATTRIBUTES = ['title', 'aria-label', 'aria-roledescription', 'content'];

/** What the document holds before the program is there is English. */
export function sayDocument(): void {
  // What style sheets write.
  document.documentElement.style.setProperty('--earlier-settings', JSON.stringify(say('earlier-settings-2')));
  if (LANGUAGE === 'en') return;
  for (const element of document.querySelectorAll<HTMLElement>('[data-say]')) fill(element, ...withKeys(say(element.dataset.say ?? '')));
  for (const attribute of ATTRIBUTES) {
    const name = `data-say-${attribute.replace('aria-', '')}`;
    for (const element of document.querySelectorAll(`[${name}]`)) element.setAttribute(attribute, say(element.getAttribute(name) ?? ''));
  }
  showDocument();
}

/** Shows what `turn.ts` keeps out of sight: in the language of the page, or in English where its texts do not come. */
export function showDocument(): void {
  delete document.documentElement.dataset.unsaid;
}

/** A text in which [K] is a key. */
function withKeys(text: string): (string | HTMLElement)[] {
  return text.split(/\[([^\]]+)\]/u).map((part, i) => (i % 2 === 0 ? part : h('kbd', {}, part)));
}

/** The button names the other language, in its own words. The page is loaded again in it, with what was kept; `keeper` is null while there is nothing to keep. */
export function mountLanguage(press: HTMLElement, keeper: () => Keeper | null): void {
  const other: Language = LANGUAGE === 'en' ? 'ar' : 'en';
  // Its title is of the language of the page.
  const name = h('span', {}, LANGUAGES[other].name);
  name.lang = other;
  fill(press, name);
  press.addEventListener('click', () => void change(other, keeper()));
}

async function change(to: Language, keeper: Keeper | null): Promise<void> {
  await keeper?.flush();
  if (keeper?.isLost === true && !window.confirm(say('the-last-changes-on-the'))) return;
  keepLanguage(to);
  location.reload();
}
