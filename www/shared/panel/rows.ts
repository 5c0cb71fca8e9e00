/** The rows of a long table: only those in sight exist, between two fillers as high as the others would be. */
import type { Column } from '../state/rows';
import { fill, h } from './dom';

/** Height of a row in CSS px, as in the style sheet. */
const ROW = 24;
/** Rows beyond the ones in sight, so that a scroll shows no gap. */
const MARGIN = 12;
/** More columns than any table has. */
const COLUMNS = 30;

export class RowsInSight {
  readonly columns = h('colgroup', {});
  readonly head = h('thead', {});
  readonly foot = h('tfoot', {});
  readonly scroller: HTMLElement;
  /** The grid, which has the keyboard for all its rows. */
  readonly table: HTMLElement;
  private readonly body = h('tbody', {});
  private count = 0;
  /** The rows that exist, from the first to the one behind the last. */
  private drawn: readonly [number, number] = [0, 0];
  private frame = 0;

  /** `row` builds the row at a place. */
  constructor(
    testid: string,
    words: { table: string; region: string },
    private readonly row: (place: number) => HTMLElement,
  ) {
    this.table = h(
      'table',
      { testid, class: 'statistics', role: 'grid', tabindex: 0, aria: { label: words.table } },
      this.columns,
      this.head,
      this.body,
      this.foot,
    );
    this.scroller = h('div', { class: 'rows', role: 'region', aria: { label: words.region } }, this.table);
    this.scroller.addEventListener('scroll', () => this.scrolled());
    new ResizeObserver(() => this.draw()).observe(this.scroller);
  }

  /** Shows so many rows, or the same ones anew. */
  show(count: number): void {
    this.count = count;
    this.draw();
  }

  /** Brings a row into sight; a place below 0 is none. `near`: no farther than needed. */
  reveal(place: number, near = false): void {
    const { scrollTop, clientHeight } = this.scroller;
    const room = clientHeight - this.head.offsetHeight - this.foot.offsetHeight;
    const top = place * ROW;
    if (place >= 0 && top < scrollTop) this.scroller.scrollTop = near ? top : Math.max(0, top - room / 2);
    else if (place >= 0 && top + ROW > scrollTop + room) this.scroller.scrollTop = near ? top + ROW - room : Math.max(0, top - room / 2);
    this.draw();
  }

  /** How many rows are seen at once. */
  get page(): number {
    return Math.max(1, Math.floor((this.scroller.clientHeight - this.head.offsetHeight - this.foot.offsetHeight) / ROW) - 1);
  }

  /** Says on the heads of columns how the rows are sorted. */
  markOrder(key: string, descending: boolean): void {
    for (const cell of this.head.querySelectorAll<HTMLElement>('tr:first-child > th')) {
      cell.setAttribute('aria-sort', cell.dataset.key === key ? (descending ? 'descending' : 'ascending') : 'none');
    }
  }

  /** Draws before the next frame, where rows come into sight that do not exist yet. */
  private scrolled(): void {
    const [first, last] = this.inSight(0);
    if (first >= this.drawn[0] && last <= this.drawn[1]) return;
    if (this.frame === 0) this.frame = requestAnimationFrame(() => this.draw());
  }

  private inSight(margin: number): [number, number] {
    const { scrollTop, clientHeight } = this.scroller;
    return [Math.max(0, Math.floor(scrollTop / ROW) - margin), Math.min(this.count, Math.ceil((scrollTop + clientHeight) / ROW) + margin)];
  }

  private draw(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    // Its height would make the browser lay out the whole page; it is drawn when it comes into sight.
    if (this.scroller.closest('[hidden], .is-closed') !== null) return;
    const [first, last] = this.inSight(MARGIN);
    this.drawn = [first, last];
    // The row that has the keyboard says so where it is drawn.
    this.table.removeAttribute('aria-activedescendant');
    const seen = Array.from({ length: Math.max(0, last - first) }, (_, i) => this.row(first + i));
    fill(this.body, filler(first), ...seen, filler(this.count - last));
  }
}

/** The head of a column that rows are sorted by. */
export function sortHead({ key, label, unit, help, words }: Column, press: () => void): HTMLElement {
  const button = h(
    'button',
    { type: 'button', class: 'sort', testid: `sort-${key}`, title: help },
    label,
    unit === '' ? null : h('span', { class: 'unit' }, ` ${unit}`),
  );
  button.addEventListener('click', press);
  return h('th', { scope: 'col', key, class: words === true ? 'of-words' : '' }, button);
}

function filler(rows: number): HTMLElement {
  const cell = h('td', { colspan: COLUMNS });
  cell.style.height = `${String(Math.max(0, rows) * ROW)}px`;
  return h('tr', { class: 'filler', aria: { hidden: 'true' } }, cell);
}
