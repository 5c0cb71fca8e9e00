/** The rows of a long table: only those in sight exist, between two fillers as high as the others would be. */
import { fill, h } from './dom';

/** Height of a row in CSS px, as in the style sheet. */
const ROW = 24;
/** Rows beyond the ones in sight, so that a scroll shows no gap. */
const MARGIN = 12;
/** More columns than any table has. */
const COLUMNS = 20;

export class RowsInSight {
  readonly head = h('thead', {});
  readonly scroller: HTMLElement;
  private readonly body = h('tbody', {});
  private count = 0;

  /** `row` builds the row at a place; a button in it that has a `data-key` keeps the keyboard while it is in sight. */
  constructor(
    testid: string,
    words: { table: string; region: string },
    private readonly row: (place: number) => HTMLElement,
  ) {
    const table = h('table', { testid, class: 'statistics', aria: { label: words.table } }, this.head, this.body);
    this.scroller = h('div', { class: 'rows', tabindex: 0, role: 'region', aria: { label: words.region } }, table);
    this.scroller.addEventListener('scroll', () => this.draw());
    new ResizeObserver(() => this.draw()).observe(this.scroller);
  }

  /** Shows so many rows, or the same ones anew. */
  show(count: number): void {
    this.count = count;
    this.draw();
  }

  /** Brings a row into sight; a place below 0 is none. */
  reveal(place: number): void {
    const { scrollTop, clientHeight } = this.scroller;
    const top = place * ROW;
    if (place >= 0 && (top < scrollTop || top > scrollTop + clientHeight - 3 * ROW)) this.scroller.scrollTop = Math.max(0, top - clientHeight / 2);
    this.draw();
  }

  /** Says on the heads of columns how the rows are sorted. */
  markOrder(key: string, descending: boolean): void {
    for (const cell of this.head.querySelectorAll('th')) {
      cell.setAttribute('aria-sort', cell.dataset.key === key ? (descending ? 'descending' : 'ascending') : 'none');
    }
  }

  private draw(): void {
    // Its height would make the browser lay out the whole page; it is drawn when it comes into sight.
    if (this.scroller.closest('[hidden]') !== null) return;
    const { scrollTop, clientHeight } = this.scroller;
    const first = Math.max(0, Math.floor(scrollTop / ROW) - MARGIN);
    const last = Math.min(this.count, Math.ceil((scrollTop + clientHeight) / ROW) + MARGIN);
    const seen = Array.from({ length: Math.max(0, last - first) }, (_, i) => this.row(first + i));
    const focused = this.focused();
    fill(this.body, filler(first), ...seen, filler(this.count - last));
    if (focused !== null) this.focus(focused);
  }

  /** The key of the button that has the keyboard; null where none has. */
  private focused(): string | null {
    const { activeElement } = document;
    return activeElement instanceof HTMLElement && this.body.contains(activeElement) ? (activeElement.dataset.key ?? '') : null;
  }

  /** Gives the keyboard back to a button that was built anew, or to the table where it is out of sight. */
  private focus(key: string): void {
    (this.body.querySelector<HTMLElement>(`button[data-key="${key}"]`) ?? this.scroller).focus({ preventScroll: true });
  }
}

/** The head of a column that rows are sorted by. */
export function sortHead(column: { key: string; label: string; unit: string; help: string }, press: () => void): HTMLElement {
  const { key, label, unit, help } = column;
  const button = h(
    'button',
    { type: 'button', class: 'sort', testid: `sort-${key}`, title: help },
    label,
    unit === '' ? null : h('span', { class: 'unit' }, ` ${unit}`),
  );
  button.addEventListener('click', press);
  return h('th', { scope: 'col', key }, button);
}

function filler(rows: number): HTMLElement {
  const cell = h('td', { colspan: COLUMNS });
  cell.style.height = `${String(Math.max(0, rows) * ROW)}px`;
  return h('tr', { class: 'filler', aria: { hidden: 'true' } }, cell);
}
