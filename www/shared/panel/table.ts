/** A table of any length: sorted by any of its columns, searched, chosen from by mouse and keys, and saved as it is shown. */
import { saveCsv } from '../files/csv';
import { remember } from '../state/remember';
import { conditionOf, conditionText, keeping, keptOf, ordered, tabbedOf, totalOf } from '../state/rows';
import type { Column, Filter, Order, Part, Total } from '../state/rows';
import { count as counted, fixed } from '../text/format';
import { fill, h } from './dom';
import { RowsInSight, sortHead } from './rows';
import { TableBar } from './table-bar';
import { say } from '../text/words';
import { unitText } from '../text/units';

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
  /** Called with the row that the pointer is over; -1 where it has left. */
  point?: (row: number) => void;
  /** Called when other conditions are typed; without it nothing can be typed over the columns. */
  filter?: (filter: Filter) => void;
  /** Shows all rows, where more leaves some out than what is typed over the columns. */
  showAll?: () => void;
  /** What the file is called that the rows are saved as; with it the table has a bar that counts, saves and chooses columns. */
  file?: string;
  /** Further things in the bar. */
  tools?: readonly HTMLElement[];
  /** The column by which rows are sorted at first, where there is such a one. */
  order?: string;
}

const ALL = () => true;
const NONE: ReadonlySet<string> = new Set();

/** Whether columns have the same heads, whatever their rows hold. */
function sameHeads(a: readonly Column[], b: readonly Column[]): boolean {
  const head = ({ key, label, unit, help, words }: Column) => [key, label, unit, help, words].join('\n');
  return a.length === b.length && a.every((column, i) => head(column) === head(b[i] ?? column));
}

/** So many rows say how wide a column is. */
const MEASURED = 200;

const TOTALS: Readonly<Record<Total, string>> = { sum: 'Σ', mean: say('mean'), rms: 'RMS' };

export class Table {
  private readonly help: HTMLElement;
  /** What is typed over a column and cannot be read. */
  private readonly problem: HTMLElement;
  private readonly table: RowsInSight;
  private readonly bar: TableBar | null;
  private all: readonly Column[] = [];
  /** Those that the user has not hidden. */
  private columns: readonly Column[] = [];
  private count = 0;
  private keep: (row: number) => boolean = ALL;
  private conditions: Filter = {};
  private shown: Uint32Array = new Uint32Array();
  private order: Order;
  /** All rows as they are sorted: other conditions leave their order. */
  private readonly inOrder = remember(ordered);
  private marked = -1;
  /** The row that was pressed last. */
  private anchor = -1;
  /** The row that keys start from. */
  private active = -1;

  constructor(
    host: HTMLElement,
    private readonly options: TableOptions,
  ) {
    this.order = { key: options.order ?? '', descending: false };
    const { testid, words, file } = options;
    this.help = h('p', { class: 'help', hidden: true, testid: `${testid}-help` });
    this.problem = h('p', {
      class: 'field-problem',
      id: `${testid}-filter-problem`,
      testid: `${testid}-filter-problem`,
      role: 'status',
      aria: { live: 'polite' },
    });
    this.table = new RowsInSight(
      testid,
      words,
      (place) => this.shown[place] ?? -1,
      (place, former) => this.row(this.shown[place] ?? 0, place, former),
    );
    this.bar =
      file === undefined
        ? null
        : new TableBar(
            testid,
            words.table,
            {
              hide: (hidden) => this.hide(hidden),
              csv: () => saveCsv(this.columns, this.shown, file),
              copied: () => tabbedOf(this.columns, this.shown),
              clear: () => {
                if (options.showAll === undefined) options.filter?.({});
                else options.showAll();
              },
            },
            options.tools ?? [],
          );
    host.append(...(this.bar === null ? [] : [this.bar.element]), this.help, this.problem, this.table.scroller);
    this.table.table.addEventListener('keydown', (event) => this.key(event));
    if (options.choose !== undefined && (options.chooseMore !== undefined || options.isChosen !== undefined))
      this.table.table.setAttribute('aria-multiselectable', 'true');
    this.table.scroller.addEventListener('pointerleave', () => options.point?.(-1));
  }

  get scroller(): HTMLElement {
    return this.table.scroller;
  }

  get head(): HTMLElement {
    return this.table.head;
  }

  /** Shows rows of other columns; `keep` and the conditions leave some of them out. Returns how many are shown. */
  show(count: number, columns: readonly Column[], keep: (row: number) => boolean = ALL, conditions: Filter = {}): number {
    const before = this.all;
    Object.assign(this, { count, all: columns, keep, conditions });
    if (columns !== before) {
      const hidden = sameHeads(before, columns) ? (this.bar?.left ?? NONE) : (this.bar?.offer(columns) ?? NONE);
      this.columns = columns.filter(({ key }) => !hidden.has(key));
      if (!sameHeads(before, columns)) this.showHeads();
    }
    this.showConditions();
    return this.sort();
  }

  /** Marks a row and brings it into sight, where it is not the marked one; none where it is negative. */
  mark(row: number): void {
    if (row === this.marked) return;
    this.marked = row;
    this.reveal(row);
  }

  /** Brings a row into sight, and draws all anew. */
  reveal(row: number): void {
    this.table.reveal(row < 0 ? -1 : this.shown.indexOf(row));
  }

  /** Draws the rows anew, as others are chosen. */
  redraw(): void {
    this.table.show(this.shown.length);
  }

  /** The rows that are shown, in their order. */
  get listed(): Uint32Array {
    return this.shown;
  }

  private hide(hidden: ReadonlySet<string>): void {
    this.columns = this.all.filter(({ key }) => !hidden.has(key));
    this.showHeads();
    this.showConditions();
    this.sort();
  }

  private showHeads(): void {
    const { columns } = this;
    const heads = columns.map((column) => this.headCell(column));
    const filters = this.options.filter === undefined || columns.length === 0 ? null : h('tr', {}, ...columns.map((column) => this.filterCell(column)));
    fill(this.table.head, columns.length === 0 ? null : h('tr', {}, ...heads), filters);
    this.table.table.setAttribute('aria-colcount', String(columns.length));
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

  private filterCell({ key, label, unit, words }: Column): HTMLElement {
    const hint = words === true ? say('contains') : '2..5  >2  ≤0.5';
    const input = h('input', {
      type: 'text',
      class: 'filter',
      key,
      testid: `${this.options.testid}-filter-${key}`,
      title: `${label}: ${words === true ? say('rows-that-contain-this-text') : say('rows-within-these-limits-as')}`,
      aria: { label: say('filter', { label, what: unit === '' ? '' : say('in-2', { unit: unitText(unit) }) }) },
    });
    input.placeholder = hint;
    input.size = 1;
    input.addEventListener('input', () => {
      const condition = conditionOf(input.value, words === true);
      input.setAttribute('aria-invalid', String(condition === undefined));
      this.showProblem();
      if (condition === undefined) return;
      const { [key]: _, ...others } = this.conditions;
      this.options.filter?.(condition === null ? others : { ...others, [key]: condition });
    });
    return h('td', {}, input);
  }

  /** Writes the conditions into their fields; one that is being typed stays as it is. */
  private showConditions(): void {
    for (const input of this.table.head.querySelectorAll<HTMLInputElement>('input.filter')) {
      const key = input.dataset.key ?? '';
      const column = this.columns.find((candidate) => candidate.key === key);
      const typed = conditionOf(input.value, column?.words === true);
      const stands = typed !== undefined && JSON.stringify(typed) === JSON.stringify(this.conditions[key] ?? null);
      if (stands || input === document.activeElement) continue;
      input.value = conditionText(this.conditions[key]);
      input.removeAttribute('aria-invalid');
    }
    this.showProblem();
  }

  /** Says what can be typed where what is typed cannot be read: the rows stay as they are. */
  private showProblem(): void {
    const fields = [...this.table.head.querySelectorAll<HTMLInputElement>('input.filter')];
    const wrong = fields.find((field) => field.getAttribute('aria-invalid') === 'true');
    for (const field of fields) {
      if (field === wrong) field.setAttribute('aria-describedby', this.problem.id);
      else field.removeAttribute('aria-describedby');
    }
    const text = wrong === undefined ? '' : say('is-no-number-or-range', { typed: wrong.value.trim() });
    if (this.problem.textContent !== text) this.problem.textContent = text;
  }

  private press(row: number, { shiftKey, ctrlKey, metaKey }: Pick<MouseEvent, 'shiftKey' | 'ctrlKey' | 'metaKey'>): void {
    const { choose, chooseMore } = this.options;
    this.active = row;
    const [from, to] = [this.shown.indexOf(this.anchor), this.shown.indexOf(row)];
    if (chooseMore !== undefined && shiftKey && from >= 0) chooseMore([...this.shown.subarray(Math.min(from, to), Math.max(from, to) + 1)]);
    else if (chooseMore !== undefined && (ctrlKey || metaKey)) chooseMore([row]);
    else choose?.(row);
    if (!shiftKey || from < 0) this.anchor = row;
    this.redraw();
  }

  /** Arrows go from row to row, Enter chooses; with Shift the rows between are chosen together. */
  private key(event: KeyboardEvent): void {
    if (event.target !== this.table.table || event.altKey || this.shown.length === 0) return;
    const last = this.shown.length - 1;
    const at = this.shown.indexOf(this.active);
    const places: Readonly<Record<string, number>> = {
      ArrowDown: at + 1,
      ArrowUp: at - 1,
      PageDown: at + this.table.page,
      PageUp: at - this.table.page,
      Home: 0,
      End: last,
    };
    const place = places[event.key];
    if (place !== undefined) {
      if (this.anchor < 0) this.anchor = this.active;
      this.active = this.shown[Math.min(last, Math.max(0, place))] ?? -1;
      if (event.shiftKey && this.options.chooseMore !== undefined) this.press(this.active, { shiftKey: true, ctrlKey: false, metaKey: false });
      else this.options.point?.(this.active);
      this.table.reveal(this.shown.indexOf(this.active), true);
    } else if ((event.key === 'Enter' || event.key === ' ') && at >= 0) this.press(this.active, event);
    else if (event.key === 'a' && (event.ctrlKey || event.metaKey) && this.options.chooseMore !== undefined) this.options.chooseMore([...this.shown]);
    else return;
    event.preventDefault();
  }

  private sort(): number {
    const { columns, order, keep } = this;
    const meets = keeping(this.all, this.conditions);
    const rows = this.inOrder(this.count, columns, order);
    const keeps = meets === null || keep === ALL ? (meets ?? keep) : (row: number) => keep(row) && meets(row);
    this.shown = keeps === ALL ? rows : keptOf(rows, keeps);
    this.table.markOrder(order.key, order.descending);
    this.measure();
    this.showFoot(meets !== null);
    const heads = this.table.head.childElementCount;
    this.table.table.setAttribute('aria-rowcount', String(this.shown.length + heads));
    this.table.show(this.shown.length);
    return this.shown.length;
  }

  /** Columns as wide as their longest texts of some rows, so that they do not move while rows come into sight. */
  private measure(): void {
    const step = Math.max(1, Math.floor(this.shown.length / MEASURED));
    const longest = this.columns.map(({ text }) => {
      let most = 0;
      for (let place = this.shown.length - 1; place >= 0; place -= step) most = Math.max(most, text(this.shown[place] ?? 0).length);
      return most;
    });
    fill(
      this.table.columns,
      ...longest.map((length) => {
        const column = h('col', {});
        column.style.minWidth = column.style.width = `calc(${String(Math.min(length, 48))}ch + 8px)`;
        return column;
      }),
    );
  }

  private showFoot(filtered: boolean): void {
    if (this.bar === null) return;
    const fewer = this.shown.length < this.count;
    this.bar.say(this.shown.length, this.count, filtered || fewer, filtered || (fewer && this.options.showAll !== undefined));
    const parts = this.columns.flatMap((column) => (column.parts ?? []).map((part) => ({ column, part, rows: this.shown.filter(part.has) })));
    const lines = parts.length === 0 ? [this.totals(this.shown)] : parts.filter(({ rows }) => rows.length > 0).map((of) => this.totals(of.rows, of));
    fill(this.table.foot, ...lines.filter((cells) => cells.some((cell) => cell.textContent !== '')).map((cells) => h('tr', {}, ...cells)));
  }

  /** A line of the foot: what these rows have together. */
  private totals(rows: Uint32Array, named: { column: Column; part: Part } | null = null): HTMLElement[] {
    return this.columns.map((column) => {
      const { total, value, text } = column;
      if (column === named?.column) return h('td', {}, named.part.label);
      if (total === undefined || rows.length === 0) return h('td', {});
      const number = totalOf(column, rows);
      // Columns of one part say nothing of the others.
      if (named !== null && Number.isNaN(number)) return h('td', {});
      // With as many decimals as the figures have, a mean of whole numbers with one.
      const digits = Math.max(
        total === 'sum' ? 0 : 1,
        ...[...rows.subarray(0, 20)].filter((row) => !Number.isNaN(value(row))).map((row) => decimals(text(row))),
      );
      return h(
        'td',
        { class: 'number' },
        h('span', { class: 'unit' }, `${TOTALS[total]} `),
        digits === 0 ? counted(Number.isNaN(number) ? null : Math.round(number)) : fixed(number, digits),
      );
    });
  }

  private row(row: number, place: number, former = this.line(row)): HTMLElement {
    const { testid, choose, isChosen } = this.options;
    const chosen = row === this.marked;
    const together = isChosen?.(row) === true;
    const active = row === this.active;
    if (former.childElementCount !== this.columns.length) fill(former, ...this.columns.map(() => h('td', {})));
    this.columns.forEach(({ value, text }, column) => {
      const cell = former.children[column] as HTMLElement;
      const shown = text(row);
      if (cell.textContent !== shown) cell.textContent = shown;
      cell.classList.toggle('number', typeof value(row) === 'number');
    });
    former.classList.toggle('best', chosen);
    former.classList.toggle('chosen', together);
    former.classList.toggle('active', active);
    former.dataset.testid = chosen ? `${testid}-selected` : `${testid}-row`;
    former.setAttribute('aria-rowindex', String(place + 1 + this.table.head.childElementCount));
    if (choose !== undefined) former.setAttribute('aria-selected', String(chosen || together));
    if (active) this.table.table.setAttribute('aria-activedescendant', former.id);
    return former;
  }

  /** The line of a row, as yet without its cells. */
  private line(row: number): HTMLElement {
    const { testid, choose, point } = this.options;
    const line = h('tr', { id: `${testid}-row-${String(row)}`, class: choose === undefined ? 'plain' : '' });
    if (choose !== undefined) line.addEventListener('click', (event) => this.press(row, event));
    if (point !== undefined) line.addEventListener('pointerenter', () => point(row));
    return line;
  }
}

/** How many digits stand behind the point. */
function decimals(text: string): number {
  return text.split('.')[1]?.length ?? 0;
}
