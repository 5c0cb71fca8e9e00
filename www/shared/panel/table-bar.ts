/** The line over a table: how many rows it shows, which of its columns, and the rows copied or saved. */
import { keepChoice, keptChoice } from '../choices';
import type { Column } from '../state/rows';
import { count as counted } from '../text/format';
import { unitText } from '../text/units';
import { say } from '../text/words';
import { button, fill, h } from './dom';

/** What the bar over a table does. */
export interface Doing {
  hide: (hidden: ReadonlySet<string>) => void;
  /** Saves them as a file. */
  csv: () => void;
  /** What is copied. */
  copied: () => string;
  clear: () => void;
}

/** The line over a table: how many rows it shows, its columns, and what is made of them. */
export class TableBar {
  readonly element: HTMLElement;
  private readonly rows = h('span', {});
  private readonly caption: HTMLElement;
  private readonly list = h('div', { class: 'menu' });
  private readonly clear: HTMLButtonElement;
  private readonly hidden: Set<string>;
  private readonly name: string;

  constructor(
    testid: string,
    words: string,
    private readonly doing: Doing,
    tools: readonly HTMLElement[],
  ) {
    this.name = `tiepoint-hidden-${testid}`;
    this.hidden = new Set((keptChoice(this.name) ?? '').split(' ').filter((key) => key !== ''));
    this.caption = h(
      'span',
      { class: 'note', role: 'status', testid: `${testid}-caption`, aria: { live: 'polite', atomic: 'true' } },
      h('span', { class: 'rows-of' }, `${words}: `),
      this.rows,
    );
    this.clear = button(say('show-all'), `${testid}-clear`, doing.clear, say('takes-away-what-is-typed'));
    const csv = button('CSV', `${testid}-csv`, doing.csv, say('saves-the-rows-and-columns'));
    const copy = button(say('copy-2'), `${testid}-copy`, () => void this.copy(copy), say('copies-the-rows-and-columns'));
    const columns = button(say('columns'), `${testid}-columns`, () => this.unfold(columns, this.list.classList.toggle('is-open')));
    columns.setAttribute('aria-expanded', 'false');
    const menu = h('div', { class: 'exports' }, columns, this.list);
    menu.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape') return;
      this.unfold(columns, false);
      columns.focus();
    });
    menu.addEventListener('focusout', (event) => {
      if (!menu.contains(event.relatedTarget as Node | null)) this.unfold(columns, false);
    });
    this.element = h('div', { class: 'table-bar' }, this.caption, ...tools, this.clear, menu, copy, csv);
  }

  /** `filtered`: not all rows are shown; `clears`: what leaves them out can be taken away here. */
  say(shown: number, all: number, filtered: boolean, clears: boolean): void {
    const text = `${filtered ? say('of-8', { shown: counted(shown) }) : ''}${counted(all)}`;
    if (this.rows.textContent !== text) this.rows.textContent = text;
    this.clear.hidden = !clears;
  }

  /** The columns that are hidden. */
  get left(): ReadonlySet<string> {
    return this.hidden;
  }

  /** Lists the columns; gives those that are hidden. */
  offer(columns: readonly Column[]): ReadonlySet<string> {
    fill(
      this.list,
      ...columns.map(({ key, label, unit }) => {
        const box = h('input', { type: 'checkbox', key });
        box.checked = !this.hidden.has(key);
        box.addEventListener('change', () => {
          if (box.checked) this.hidden.delete(key);
          else this.hidden.add(key);
          keepChoice(this.name, [...this.hidden].join(' '));
          this.doing.hide(this.hidden);
        });
        return h('label', { class: 'choice' }, box, unit === '' ? label : `${label} ${unitText(unit)}`);
      }),
    );
    return this.hidden;
  }

  private unfold(columns: HTMLElement, open: boolean): void {
    this.list.classList.toggle('is-open', open);
    columns.setAttribute('aria-expanded', String(open));
  }

  private async copy(press: HTMLElement): Promise<void> {
    const done = await toClipboard(this.doing.copied());
    tellOn(press, done ? say('copied') : say('not-copied'));
  }
}

/** Says on a button for a moment what came of it. */
function tellOn(press: HTMLElement, text: string): void {
  const own = press.dataset.own ?? press.textContent;
  press.dataset.own = own;
  press.textContent = text;
  window.setTimeout(() => fill(press, own), 2000);
}

/** Pages from plain http have no clipboard of their own: there the browser copies what is selected. */
async function toClipboard(text: string): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const field = h('textarea', { class: 'visually-hidden', aria: { hidden: 'true' } });
    field.value = text;
    document.body.append(field);
    field.select();
    const done = document.execCommand('copy');
    field.remove();
    return done;
  }
}
