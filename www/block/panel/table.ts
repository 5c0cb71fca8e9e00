/** A table of any length, sorted by any of its columns. */
import { fill, h } from '../../shared/panel/dom';
import { count } from '../../shared/text/format';
import { RowsInSight, sortHead } from '../../shared/panel/rows';

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

export class Table {
  private readonly caption = h('p', { class: 'note' });
  private readonly help = h('p', { class: 'help', hidden: true });
  private readonly table: RowsInSight;
  private rows: Rows = { count: 0, columns: [] };
  private order: readonly number[] = [];
  private sorted = { key: '', descending: false };
  private marked = -1;

  /** `choose` is called with the row that is pressed. */
  constructor(host: HTMLElement, testid: string, private readonly words: string, private readonly choose: ((row: number) => void) | null) {
    this.table = new RowsInSight(testid, { table: words, region: `Table: ${words}` }, (place) => this.row(this.order[place] ?? 0));
    host.append(this.caption, this.help, this.table.scroller);
  }

  show(rows: Rows): void {
    this.rows = rows;
    fill(this.caption, `${this.words}: ${count(rows.count)}`);
    fill(this.table.head, h('tr', {}, ...rows.columns.map((column) => this.headCell(column))));
    this.sort();
  }

  mark(row: number): void {
    this.marked = row;
    this.table.reveal(this.order.indexOf(row));
  }

  private headCell(column: Column): HTMLElement {
    const { key, label, help } = column;
    return sortHead(column, () => {
      // A second press turns the order round.
      this.sorted = { key, descending: this.sorted.key === key && !this.sorted.descending };
      fill(this.help, h('b', {}, label), `: ${help}`);
      this.help.hidden = false;
      this.sort();
    });
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
    this.table.markOrder(key, descending);
    this.table.show(indices.length);
  }

  private row(row: number): HTMLElement {
    const { choose } = this;
    const chosen = row === this.marked;
    const line = h('tr', { class: chosen ? 'best' : '', testid: chosen ? 'row-chosen' : 'row' }, ...this.rows.columns.map(({ value, text }, i) => {
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
