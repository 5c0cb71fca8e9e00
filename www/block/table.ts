/** A table of any length, sorted by any of its columns. Only the rows in sight exist. */
import { fill, h } from '../panel/dom';
import { count } from '../panel/format';

export interface Column {
  key: string;
  label: string;
  unit: string;
  help: string;
  /** What it is sorted by; NaN comes last either way. */
  value: (row: number) => number | string;
  text: (row: number) => string;
}

export interface Rows {
  count: number;
  columns: readonly Column[];
}

/** Height of a row in CSS px, as in the style sheet. */
const ROW = 24;
/** Rows beyond the ones in sight, so that a scroll shows no gap. */
const MARGIN = 12;

export class Table {
  private readonly caption = h('p', { class: 'note' });
  private readonly help = h('p', { class: 'help', hidden: true });
  private readonly head = h('thead', {});
  private readonly body = h('tbody', {});
  private readonly scroller: HTMLElement;
  private rows: Rows = { count: 0, columns: [] };
  private order: readonly number[] = [];
  private sorted = { key: '', descending: false };
  private marked = -1;

  /** `choose` is called with the row that is pressed. */
  constructor(host: HTMLElement, testid: string, private readonly words: string, private readonly choose: ((row: number) => void) | null) {
    const table = h('table', { testid, class: 'statistics', aria: { label: words } }, this.head, this.body);
    this.scroller = h('div', { class: 'rows', tabindex: 0, role: 'region', aria: { label: words } }, table);
    host.append(this.caption, this.help, this.scroller);
    this.scroller.addEventListener('scroll', () => { this.showRows(); });
    new ResizeObserver(() => { this.showRows(); }).observe(this.scroller);
  }

  show(rows: Rows): void {
    this.rows = rows;
    fill(this.caption, `${this.words}: ${count(rows.count)}`);
    fill(this.head, h('tr', {}, ...rows.columns.map((column) => this.headCell(column))));
    this.sort();
  }

  mark(row: number): void {
    this.marked = row;
    const at = this.order.indexOf(row);
    const { scrollTop, clientHeight } = this.scroller;
    if (at >= 0 && (at * ROW < scrollTop || at * ROW > scrollTop + clientHeight - 3 * ROW)) this.scroller.scrollTop = Math.max(0, at * ROW - clientHeight / 2);
    this.showRows();
  }

  private headCell({ key, label, unit, help }: Column): HTMLElement {
    const press = h('button', { type: 'button', class: 'sort', testid: `sort-${key}`, title: help }, label, unit === '' ? null : h('span', { class: 'unit' }, ` ${unit}`));
    press.addEventListener('click', () => {
      // A second press turns the order round.
      this.sorted = { key, descending: this.sorted.key === key && !this.sorted.descending };
      fill(this.help, h('b', {}, label), `: ${help}`);
      this.help.hidden = false;
      this.sort();
    });
    return h('th', { scope: 'col', key }, press);
  }

  private sort(): void {
    const { key, descending } = this.sorted;
    const indices = Array.from({ length: this.rows.count }, (_, i) => i);
    const column = this.rows.columns.find((c) => c.key === key);
    if (column !== undefined) {
      const values = indices.map(column.value);
      indices.sort((a, b) => compared(values[a] ?? NaN, values[b] ?? NaN, descending) || a - b);
    }
    this.order = indices;
    for (const cell of this.head.querySelectorAll('th')) {
      const order = cell.dataset['key'] === key ? (descending ? 'descending' : 'ascending') : 'none';
      cell.setAttribute('aria-sort', order);
    }
    this.showRows();
  }

  /** Builds the rows in sight between two fillers as high as the others would be. */
  private showRows(): void {
    const { scrollTop, clientHeight } = this.scroller;
    const first = Math.max(0, Math.floor(scrollTop / ROW) - MARGIN);
    const last = Math.min(this.order.length, Math.ceil((scrollTop + clientHeight) / ROW) + MARGIN);
    const { activeElement } = document;
    const focused = activeElement instanceof HTMLElement && this.body.contains(activeElement) ? activeElement.dataset['key'] : undefined;
    fill(this.body, filler(first), ...this.order.slice(first, last).map((row) => this.row(row)), filler(this.order.length - last));
    if (focused !== undefined) (this.body.querySelector<HTMLElement>(`button[data-key="${focused}"]`) ?? this.scroller).focus({ preventScroll: true });
  }

  private row(row: number): HTMLElement {
    const { choose } = this;
    const line = h('tr', { class: row === this.marked ? 'best' : '', testid: row === this.marked ? 'row-chosen' : 'row' }, ...this.rows.columns.map(({ value, text }, i) => {
      const number = typeof value(row) === 'number';
      const press = i === 0 && choose !== null ? h('button', { type: 'button', class: 'link', key: String(row) }, text(row)) : text(row);
      return h('td', { class: number ? 'number' : '' }, press);
    }));
    if (choose !== null) line.addEventListener('click', () => { choose(row); });
    else line.classList.add('plain');
    return line;
  }
}

function compared(a: number | string, b: number | string, descending: boolean): number {
  const sign = descending ? -1 : 1;
  if (typeof a === 'string' || typeof b === 'string') return sign * String(a).localeCompare(String(b), 'en', { numeric: true });
  if (Number.isNaN(a) || Number.isNaN(b)) return Number(Number.isNaN(a)) - Number(Number.isNaN(b));
  return sign * (a - b);
}

function filler(rows: number): HTMLElement {
  const cell = h('td', { colspan: 20 });
  cell.style.height = `${String(rows * ROW)}px`;
  return h('tr', { class: 'filler', aria: { hidden: 'true' } }, cell);
}
