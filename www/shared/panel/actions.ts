/** All that can be done: found by a word (Ctrl+K), and the list of all keys (?). */
import { hasten } from '../engine/breath';
import { declare, declared, keyText } from '../view/commands';
import { MOVES } from '../view/gestures';
import { button, fill, h } from './dom';
import { actions } from './offers';
import type { Action } from './offers';
import { folded } from '../text/folded';
import { say } from '../text/words';

/** What makes views and parts that are made late, each once. */
const late = new Set<() => unknown>();

/** `make`: makes what is found only once it is there. What it gives may take a while. */
export function beforeSearch(make: () => unknown): void {
  late.add(make);
}

/** Makes what is made late; `made` is called where that took a while. Gives how much is still on its way. What fails is tried again by the next search. */
function makeLate(made: () => void): number {
  // Settings that are still to be made are found too.
  hasten();
  let waits = 0;
  for (const make of [...late]) {
    late.delete(make);
    const making = make();
    if (!(making instanceof Promise)) continue;
    waits += 1;
    making.then(made, () => {
      late.add(make);
      made();
    });
  }
  return waits;
}

/** `press` opens the search. */
export function mountActions(press: HTMLElement): void {
  const keys = new KeyList();
  const search = new Search(() => keys.open());
  document.body.append(keys.dialog, search.dialog);
  press.addEventListener('click', () => search.open());
  const everywhere = declare({
    where: say('anywhere'),
    host: document.body,
    list: [
      { keys: ['Ctrl+K'], does: say('finds-any-action'), run: () => search.open() },
      { keys: ['?'], does: say('lists-all-keys'), run: () => keys.open() },
    ],
  });
  document.addEventListener('keydown', (event) => {
    const typing = event.target instanceof Element && event.target.closest('input, textarea, select, dialog') !== null;
    const held = event.ctrlKey || event.metaKey;
    if (event.altKey || (typing && !held) || document.querySelector('dialog[open]') !== null) return;
    if (everywhere(held ? `Ctrl+${event.key.toUpperCase()}` : event.key, event.shiftKey)) event.preventDefault();
  });
}

/** The search for actions: what is typed narrows a list, arrows go through it, Enter runs one. */
class Search {
  readonly dialog = h('dialog', { class: 'dialog search', testid: 'search', aria: { label: say('find-an-action') } });
  private readonly input = h('input', { type: 'text', id: 'search-text', testid: 'search-text', role: 'combobox' });
  private readonly list = h('ul', { id: 'search-list', class: 'found', testid: 'search-list', role: 'listbox', aria: { label: say('actions') } });
  private readonly said = h('p', { class: 'note', role: 'status', testid: 'search-said' });
  private all: readonly Action[] = [];
  private found: readonly Action[] = [];
  private active = 0;
  /** Parts of the page that are on their way. */
  private waits = 0;

  constructor(keys: () => void) {
    const close = button(say('close-2'), 'search-close', () => this.dialog.close());
    const list = button(say('all-keys'), 'search-keys', () => {
      this.dialog.close();
      keys();
    });
    this.input.autocomplete = 'off';
    for (const [name, value] of [
      ['controls', this.list.id],
      ['expanded', 'true'],
      ['autocomplete', 'list'],
    ] as const)
      this.input.setAttribute(`aria-${name}`, value);
    this.dialog.append(
      h('label', { for: this.input.id }, say('what-do-you-want-to')),
      this.input,
      this.list,
      h('div', { class: 'dialog-head' }, this.said, h('div', { class: 'buttons' }, list, close)),
    );
    this.input.addEventListener('input', () => this.narrow());
    this.input.addEventListener('keydown', (event) => {
      const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
      if (event.key === 'Enter') this.run(this.active);
      else if (by !== undefined) this.mark(this.active + by);
      else return;
      event.preventDefault();
    });
  }

  open(): void {
    this.gather();
    this.input.value = '';
    this.dialog.showModal();
    this.narrow();
    this.input.focus();
  }

  private gather(): void {
    this.waits += makeLate(() => {
      this.waits -= 1;
      this.arrived();
    });
    this.list.setAttribute('aria-busy', String(this.waits > 0));
    this.all = actions();
  }

  /** More is there to be found: what is gone through stays the same. */
  private arrived(): void {
    if (!this.dialog.open) return;
    const now = this.found[this.active];
    this.gather();
    this.narrow();
    const again = this.found.findIndex(({ name, more }) => name === now?.name && more === now.more);
    if (again > 0) this.mark(again);
  }

  private narrow(): void {
    const words = folded(this.input.value).split(/\s+/u);
    const text = ({ name, more }: Action) => folded(`${name} ${more}`);
    // What is named by the words comes before what is explained by them.
    const rank = ({ name, disabled }: Action) => (words.every((word) => folded(name).includes(word)) ? 0 : 1) + (disabled === true ? 2 : 0);
    this.found = this.all.filter((action) => words.every((word) => text(action).includes(word))).sort((a, b) => rank(a) - rank(b));
    const rows = this.found.map(({ name, more, keys, disabled = false }, place) => {
      const row = h(
        'li',
        { role: 'option', id: `search-${String(place)}`, aria: disabled ? { disabled: 'true' } : {} },
        h('span', {}, name),
        h('small', {}, [disabled ? say('not-possible-now') : '', more].filter((text) => text !== '').join(' · ')),
        keys.length === 0 ? null : keysOf(keys),
      );
      row.addEventListener('click', () => this.run(place));
      return row;
    });
    fill(this.list, ...rows);
    const { length } = this.found;
    this.said.textContent = length === 0 ? say('no-action-has-these-words') : say('so-many-actions', { actions: length });
    this.mark(0);
  }

  private mark(wanted: number): void {
    const rows = [...this.list.children];
    this.active = rows.length === 0 ? 0 : (wanted + rows.length) % rows.length;
    for (const [place, option] of rows.entries()) option.setAttribute('aria-selected', String(place === this.active));
    const row = rows[this.active];
    if (row === undefined) this.input.removeAttribute('aria-activedescendant');
    else this.input.setAttribute('aria-activedescendant', row.id);
    row?.scrollIntoView({ block: 'nearest' });
  }

  private run(place: number): void {
    const action = this.found[place];
    if (action === undefined || action.disabled === true) return;
    this.dialog.close();
    action.run();
  }
}

interface Listed {
  where: string;
  seen: boolean;
  list: readonly { keys: readonly string[]; does: string }[];
}

/** Keys that do the same are one row, and so is all that the same keys do one after the other. */
function rowsOf(list: Listed['list']): { keys: readonly string[]; does: string[] }[] {
  const rows = new Map<string, { keys: readonly string[]; does: string[] }>();
  for (const does of new Set(list.map((one) => one.does))) {
    const keys = [...new Set(list.filter((one) => one.does === does).flatMap((one) => one.keys))];
    const row = rows.get(keys.join(' '));
    if (row === undefined) rows.set(keys.join(' '), { keys, does: [does] });
    else row.does.push(does);
  }
  return [...rows.values()];
}

/** Keys, each in a box of its own; arrows stand side by side. */
function keysOf(keys: readonly string[]): HTMLElement {
  const between = keys.every((key) => /^Arrow/u.test(key)) ? ' ' : say('or');
  return h('span', { class: 'keys-of' }, ...keys.flatMap((key, i) => [...(i === 0 ? [] : [between]), h('kbd', {}, keyText(key))]));
}

/** All keys, those of what is seen now first. */
class KeyList {
  readonly dialog = h('dialog', { class: 'dialog', testid: 'keys-dialog', aria: { labelledby: 'keys-heading' } });

  open(): void {
    makeLate(() => undefined);
    const own: Listed[] = declared().map(({ where, host, list }) => ({ where, seen: host.checkVisibility(), list }));
    const all = [...own.filter(({ seen }) => seen), { where: say('every-picture'), seen: true, list: MOVES }, ...own.filter(({ seen }) => !seen)];
    const names = [...new Set(all.map(({ where }) => where))];
    const tables = names.map((name) => {
      const list = all.filter(({ where }) => where === name).flatMap((of) => [...of.list]);
      const rows = rowsOf(list).map(({ keys, does }) => h('div', {}, h('dt', {}, keysOf(keys)), h('dd', {}, does.join('; '))));
      return h('section', {}, h('h3', {}, name), h('dl', { class: 'key-list' }, ...rows));
    });
    const close = button(say('close-2'), 'keys-close', () => this.dialog.close());
    fill(this.dialog, h('div', { class: 'dialog-head' }, h('h2', { id: 'keys-heading' }, say('keys')), close), h('div', { class: 'key-lists' }, ...tables));
    this.dialog.showModal();
  }
}
