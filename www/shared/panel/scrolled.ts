/** Texts that have too little room. */

/** What is scrolled is so by keys, too. */
export function byKeys(text: Element): void {
  if (text.scrollHeight > text.clientHeight) text.setAttribute('tabindex', '0');
  else text.removeAttribute('tabindex');
}
