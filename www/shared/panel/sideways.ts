/** More columns than a table is wide are found by scrolling, which a scrollbar that hides does not tell. */
import { say } from '../text/words';
import { h } from './dom';
import type { Table } from './table';

/** The note that tells it, for a place beside the table. */
export function sidewaysNote(testid: string): HTMLElement {
  return h('p', { class: 'note sideways', hidden: true, testid }, say('scroll-sideways-for-more-columns'));
}

/** Shows the note as long as there are columns out of sight. */
export function watchSideways(note: HTMLElement, { scroller, head }: Table): void {
  const sized = new ResizeObserver(() => {
    note.hidden = scroller.scrollWidth <= scroller.clientWidth;
  });
  for (const element of [head, scroller]) sized.observe(element);
}
