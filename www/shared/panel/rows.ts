/**
 * The rows of a long table: only those in sight exist, between two fillers as high as the others would be. A row that stays in sight is the same
 * element as long as it does, so that a press that is under way ends on what it began on, whatever is drawn meanwhile.
 */
import type { Column } from '../state/rows';
import { arrange, h } from './dom';
import { isHidden } from './sight';
import { unitText } from '../text/units';

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
  private readonly above = filler();
  private readonly below = filler();
  /** The rows that exist, by their keys. */
  private lines: ReadonlyMap<number, HTMLElement> = new Map();
  private count = 0;
  /** From the first row that exists to the one behind the last. */
  private drawn: readonly [number, number] = [0, 0];
  private frame = 0;
  /** How high all of it is and what of that heads and feet take, as the browser laid them out last: to ask for it makes the browser lay out the page. Null: not yet. */
  private heights: { all: number; fixed: number } | null = null;
  private top = 0;

  /** `key` tells the row at a place from all others; `row` builds it, or brings its former element up to date. */
  constructor(
    testid: string,
    words: { table: string; region: string },
    private readonly key: (place: number) => number,
    private readonly row: (place: number, former: HTMLElement | undefined) => HTMLElement,
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
    new ResizeObserver(() => {
      this.laidOut();
      this.draw();
    }).observe(this.scroller);
    const fixed = new ResizeObserver(() => this.laidOut());
    for (const part of [this.head, this.foot]) fixed.observe(part);
  }

  private laidOut(): { all: number; fixed: number } {
    this.top = this.scroller.scrollTop;
    const heights = { all: this.scroller.clientHeight, fixed: this.head.offsetHeight + this.foot.offsetHeight };
    // Out of sight nothing has a height: it is asked for again.
    this.heights = heights.all === 0 ? null : heights;
    return heights;
  }

  /** The height in which rows are seen. */
  private get room(): number {
    const { all, fixed } = this.heights ?? this.laidOut();
    return all - fixed;
  }

  /** Shows so many rows, or the same ones anew. */
  show(count: number): void {
    this.count = count;
    this.draw();
  }

  /** Brings a row into sight; a place below 0 is none. `near`: no farther than needed. */
  reveal(place: number, near = false): void {
    // It may tell the top, too.
    const { room } = this;
    const top = place * ROW;
    if (place >= 0 && top < this.top) this.scrollTo(near ? top : Math.max(0, top - room / 2));
    else if (place >= 0 && top + ROW > this.top + room) this.scrollTo(near ? top + ROW - room : Math.max(0, top - room / 2));
    this.draw();
  }

  private scrollTo(top: number): void {
    this.scroller.scrollTop = top;
    // No farther than there are rows.
    this.top = this.scroller.scrollTop;
  }

  /** How many rows are seen at once. */
  get page(): number {
    return Math.max(1, Math.floor(this.room / ROW) - 1);
  }

  /** Says on the heads of columns how the rows are sorted. */
  markOrder(key: string, descending: boolean): void {
    for (const cell of this.head.querySelectorAll<HTMLElement>('tr:first-child > th')) {
      cell.setAttribute('aria-sort', cell.dataset.key === key ? (descending ? 'descending' : 'ascending') : 'none');
    }
  }

  /** Draws before the next frame, where rows come into sight that do not exist yet. */
  private scrolled(): void {
    this.top = this.scroller.scrollTop;
    const [first, last] = this.inSight(0);
    if (first >= this.drawn[0] && last <= this.drawn[1]) return;
    if (this.frame === 0) this.frame = requestAnimationFrame(() => this.draw());
  }

  private inSight(margin: number): [number, number] {
    const { all, fixed } = this.heights ?? this.laidOut();
    // Where rows were left out, the browser has yet to scroll back to those that remain.
    const top = Math.min(this.top, Math.max(0, this.count * ROW + Math.min(0, fixed - all)));
    return [Math.max(0, Math.floor(top / ROW) - margin), Math.min(this.count, Math.ceil((top + all) / ROW) + margin)];
  }

  private draw(): void {
    cancelAnimationFrame(this.frame);
    this.frame = 0;
    // Its height would make the browser lay out the whole page; it is drawn when it comes into sight.
    if (isHidden(this.scroller)) return;
    const [first, last] = this.inSight(MARGIN);
    this.drawn = [first, last];
    // The row that has the keyboard says so where it is drawn.
    this.table.removeAttribute('aria-activedescendant');
    const lines = new Map<number, HTMLElement>();
    for (let place = first; place < last; place++) {
      const key = this.key(place);
      lines.set(key, this.row(place, this.lines.get(key)));
    }
    this.lines = lines;
    stretch(this.above, first);
    stretch(this.below, this.count - last);
    arrange(this.body, this.above, ...lines.values(), this.below);
  }
}

/** The head of a column that rows are sorted by. */
export function sortHead({ key, label, unit, help, words }: Column, press: () => void): HTMLElement {
  const button = h(
    'button',
    { type: 'button', class: 'sort', testid: `sort-${key}`, title: help },
    label,
    unit === '' ? null : h('span', { class: 'unit' }, ` ${unitText(unit)}`),
  );
  button.addEventListener('click', press);
  return h('th', { scope: 'col', key, class: words === true ? 'of-words' : '' }, button);
}

function filler(): HTMLElement {
  return h('tr', { class: 'filler', aria: { hidden: 'true' } }, h('td', { colspan: COLUMNS }));
}

/** Makes a filler as high as so many rows. */
function stretch(filler: HTMLElement, rows: number): void {
  const cell = filler.firstElementChild as HTMLElement;
  const height = `${String(Math.max(0, rows) * ROW)}px`;
  if (cell.style.height !== height) cell.style.height = height;
}
