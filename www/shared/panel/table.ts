/** A table of any length, sorted by any of its columns. */
import { ordered } from '../state/rows';
import type { Column, Order } from '../state/rows';
import { fill, h } from './dom';
import { RowsInSight, sortHead } from './rows';

export interface TableOptions {
  testid: string;
  /** What the table and the region that scrolls hold. */
  words: { table: string; region: string };
  /** Called with the row that is pressed; without it rows cannot be pressed. */
  choose?: (row: number) => void;
  /** Called with rows that are chosen together: those up to the one pressed with Shift, or the one pressed with Ctrl or Cmd. */
  chooseMore?: (rows: readonly number[]) => void;
  /** Whether a row is one of those chosen together. */
  isChosen?: (row: number) => boolean;
  /** What the button of a row is called, where its text says too little. */
  chooseLabel?: (row: number) => string;
}

const ALL = () => true;

export class Table {
  private readonly help: HTMLElement;
  private readonly table: RowsInSight;
  private columns: readonly Column[] = [];
  private count = 0;
  private keep: (row: number) => boolean = ALL;
  private shown: readonly number[] = [];
  private order: Order = { key: '', descending: false };
  private marked = -1;
  /** The row that was pressed last. */
  private anchor = -1;

  constructor(
    host: HTMLElement,
    private readonly options: TableOptions,
  ) {
    this.help = h('p', { class: 'help', hidden: true, testid: `${options.testid}-help` });
    this.table = new RowsInSight(options.testid, options.words, (place) => this.row(this.shown[place] ?? 0));
    host.append(this.help, this.table.scroller);
  }

  get scroller(): HTMLElement {
    return this.table.scroller;
  }

  get head(): HTMLElement {
    return this.table.head;
  }

  /** Shows rows of other columns; `keep` leaves some of them out. Returns how many are shown. */
  show(count: number, columns: readonly Column[], keep: (row: number) => boolean = ALL): number {
    if (columns !== this.columns) fill(this.table.head, columns.length === 0 ? null : h('tr', {}, ...columns.map((column) => this.headCell(column))));
    Object.assign(this, { count, columns, keep });
    return this.sort();
  }

  /** Marks a row and brings it into sight; none where it is negative. */
  mark(row: number): void {
    this.marked = row;
    this.table.reveal(this.shown.indexOf(row));
  }

  private headCell(column: Column): HTMLElement {
    const { key, label, help } = column;
    return sortHead(column, () => {
      // A second press turns the order round.
      this.order = { key, descending: this.order.key === key && !this.order.descending };
      fill(this.help, h('b', {}, label), `: ${help}`);
      this.help.hidden = false;
      this.sort();
    });
  }

  private press(row: number, event: MouseEvent, choose: (row: number) => void): void {
    const { chooseMore } = this.options;
    const [from, to] = [this.shown.indexOf(this.anchor), this.shown.indexOf(row)];
    if (chooseMore !== undefined && event.shiftKey && from >= 0) chooseMore(this.shown.slice(Math.min(from, to), Math.max(from, to) + 1));
    else if (chooseMore !== undefined && (event.ctrlKey || event.metaKey)) chooseMore([row]);
    else choose(row);
    if (!event.shiftKey || from < 0) this.anchor = row;
  }

  /** Draws the rows anew, as others are chosen. */
  redraw(): void {
    this.table.show(this.shown.length);
  }

  /** The rows that are shown, in their order. */
  get listed(): readonly number[] {
    return this.shown;
  }

  private sort(): number {
    this.shown = ordered(this.count, this.columns, this.order, this.keep);
    this.table.markOrder(this.order.key, this.order.descending);
    this.table.show(this.shown.length);
    return this.shown.length;
  }

  private row(row: number): HTMLElement {
    const { testid, choose, chooseLabel } = this.options;
    const chosen = row === this.marked;
    const together = this.options.isChosen?.(row) === true;
    const line = h(
      'tr',
      { class: `${chosen ? 'best' : ''} ${together ? 'chosen' : ''}`.trim(), testid: chosen ? `${testid}-selected` : `${testid}-row` },
      ...this.columns.map(({ value, text }, i) => {
        const number = typeof value(row) === 'number';
        if (i > 0 || choose === undefined) return h('td', { class: number ? 'number' : '' }, text(row));
        const press = h(
          'button',
          { type: 'button', class: 'link', key: String(row), ...(chooseLabel === undefined ? {} : { aria: { label: chooseLabel(row) } }) },
          text(row),
        );
        return h('td', {}, press);
      }),
    );
    if (choose !== undefined) line.addEventListener('click', (event) => this.press(row, event, choose));
    else line.classList.add('plain');
    return line;
  }
}
