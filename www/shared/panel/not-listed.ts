/** Beside buttons that edit what is chosen: how many more are chosen that a filter leaves out, which stay as they are. */
import { say } from '../text/words';
import { h } from './dom';

/** `of`: the buttons that it is said of. */
export class NotListed {
  readonly element: HTMLElement;

  constructor(testid: string, of: readonly HTMLElement[]) {
    this.element = h('span', { class: 'note', id: testid, testid, hidden: true });
    for (const made of of) made.setAttribute('aria-describedby', testid);
  }

  show(others: number): void {
    this.element.hidden = others === 0;
    const text = others === 0 ? '' : say('chosen-not-listed', { others });
    if (this.element.textContent !== text) this.element.textContent = text;
  }
}
