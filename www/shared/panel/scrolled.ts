/** Texts and tables that have too little room. */

/** What is scrolled is so by keys, too. */
export function byKeys(text: Element): void {
  if (text.scrollHeight > text.clientHeight || text.scrollWidth > text.clientWidth) text.setAttribute('tabindex', '0');
  else text.removeAttribute('tabindex');
}

/** The same for what has its room only once it is shown.  @returns what was given */
export function scrolledByKeys(table: HTMLElement): HTMLElement {
  new ResizeObserver(() => byKeys(table)).observe(table);
  return table;
}
