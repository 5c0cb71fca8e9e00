/** All that can be done: found by a word (Ctrl+K), and the list of all keys (?). */
import { hasten } from '../engine/breath';
import { declare, declared, keyText } from '../view/commands';
import { MOVES } from '../view/gestures';
import { button, fill, h } from './dom';
import { reachable, reveal } from './reach';
import { say } from '../text/words';

interface Action {
  name: string;
  /** Where it belongs, and what else it is found by. */
  more: string;
  keys: readonly string[];
  run: () => void;
  /** Its button cannot be pressed as things are. */
  disabled?: boolean;
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

/** What keys do in views that are seen now, what buttons do, and the settings. What a button and its keys do is one action. What cannot be done as things are comes last. */
function actions(): Action[] {
  const made = [...document.querySelectorAll('button')].filter(
    (button) => button.closest('dialog, table, .control, .history, .facts') === null && !button.matches(UNNAMED) && reachable(button),
  );
  const ofButtons = new Set(made.flatMap(keysOfButton));
  const commands = declared()
    .filter(({ host, list }) => host.checkVisibility() && list.length > 0)
    .flatMap(({ where, list }) =>
      list
        .filter(({ keys, can }) => can?.() !== false && !keys.some((key) => ofButtons.has(key)))
        .map(({ keys, does, run }) => ({ name: sentenceOf(does), more: where, keys, run: () => run(false) })),
    );
  // Of two that do the same, one that can be pressed stands for both.
  const all = once([...made].sort((a, b) => Number(a.disabled) - Number(b.disabled))).map((button) => ({
    name: nameOf(button),
    disabled: button.disabled,
    more: [...new Set([groupOf(twinOf(button) ?? button), tabOf(button), kindOf(button), button.title])]
      .filter((text) => text !== '' && !saysName(button, text))
      .join(' · '),
    keys: keysOfButton(button),
    run: () => {
      reveal(button);
      button.click();
    },
  }));
  const settings = [...document.querySelectorAll<HTMLLabelElement>('.control label')].filter(reachable).map((label) => ({
    name: label.textContent,
    more: [say('setting'), label.closest('fieldset, details')?.querySelector('legend, summary')?.firstChild?.textContent ?? '']
      .filter((text) => text !== '')
      .join(' · '),
    keys: [],
    run: () => {
      reveal(label);
      label.control?.focus();
    },
  }));
  return [...all.filter(({ disabled }) => !disabled), ...commands, ...choices(), ...settings, ...all.filter(({ disabled }) => disabled)];
}

/** What the lists over pictures and beside exports offer, and the sliders there, which are gone to. */
function choices(): Action[] {
  const controls = [...document.querySelectorAll<HTMLSelectElement | HTMLInputElement>('select, input[type="range"]')].filter(
    (control) => control.closest('dialog, table, .control') === null && reachable(control),
  );
  return controls.flatMap((control) => {
    const about = control.ariaLabel ?? control.labels?.[0]?.querySelector('span')?.textContent ?? '';
    const made = { more: groupOf(control), keys: [], disabled: control.disabled };
    const goTo = () => {
      reveal(control);
      control.focus();
    };
    if (!(control instanceof HTMLSelectElement)) return [{ ...made, name: about, run: goTo }];
    const others = [...control.options].filter((option) => !option.selected && !option.disabled);
    return others.map((option) => ({
      ...made,
      name: say('action-about', { about, action: option.text }),
      run: () => {
        control.value = option.value;
        control.dispatchEvent(new Event('change', { bubbles: true }));
        goTo();
      },
    }));
  });
}

/** Buttons that only unfold what is listed itself, or close what is open. */
const UNNAMED = '.close, .menu-button, #export-menu';

/** What a button is called; one that shows a sign alone is called by what it says of itself, one that its twin has too by what it is about. */
function nameOf(made: HTMLButtonElement): string {
  const label = made.getAttribute('aria-label');
  const shown = label ?? made.textContent;
  const own = /\p{L}|\d/u.test(shown) || made.title === '' ? shown : made.title;
  const about = label === null && keysOfButton(made).length === 0 ? twinOf(made)?.getAttribute('aria-label') : null;
  return about == null ? own : say('action-about', { about, action: own });
}

/** The group of a button that another group repeats, as that of the left image and that of the right one. */
const twinOf = (made: Element) => made.closest('.twin');

/** Whether a text says no more than what a button is called, and its key. */
const saysName = (button: HTMLButtonElement, text: string) => [nameOf(button), `${nameOf(button)} (${keysOfButton(button)[0] ?? ''})`].includes(text);

/** The keys that do what a button does, as commands name them; `showSteps` gives them to it. */
const keysOfButton = (button: Element) => button.getAttribute('aria-keyshortcuts')?.replaceAll('Control', 'Ctrl').split(' ') ?? [];

/** Of buttons of one name and the same keys, as those beside the pictures and in their panel, the first. */
function once(buttons: readonly HTMLButtonElement[]): HTMLButtonElement[] {
  const known = new Set<string>();
  return buttons.filter((button) => {
    const keys = keysOfButton(button);
    const name = [nameOf(button), ...keys].join('\n');
    const isFirst = !known.has(name);
    if (keys.length > 0) known.add(name);
    return isFirst;
  });
}

/** The tab that a button lies behind: each table has the same buttons. */
function tabOf(made: Element): string {
  const tab = made.closest('[role="tabpanel"]')?.getAttribute('aria-labelledby');
  return tab == null ? '' : (document.getElementById(tab)?.textContent ?? '');
}

/** A tab may be called as the drawer that it is in, which another button opens. */
const kindOf = (made: Element) => (made.getAttribute('role') === 'tab' ? say('tab') : '');

const sentenceOf = (does: string) => does.charAt(0).toUpperCase() + does.slice(1);

const groupOf = (made: Element) => made.parentElement?.closest('[aria-label]')?.getAttribute('aria-label') ?? '';

/** The search for actions: what is typed narrows a list, arrows go through it, Enter runs one. */
class Search {
  readonly dialog = h('dialog', { class: 'dialog search', testid: 'search', aria: { label: say('find-an-action') } });
  private readonly input = h('input', { type: 'text', id: 'search-text', testid: 'search-text', role: 'combobox' });
  private readonly list = h('ul', { id: 'search-list', class: 'found', testid: 'search-list', role: 'listbox', aria: { label: say('actions') } });
  private readonly said = h('p', { class: 'note', role: 'status', testid: 'search-said' });
  private all: readonly Action[] = [];
  private found: readonly Action[] = [];
  private active = 0;

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
    // Settings that are still to be made are found too.
    hasten();
    this.all = actions();
    this.input.value = '';
    this.dialog.showModal();
    this.narrow();
    this.input.focus();
  }

  private narrow(): void {
    const words = this.input.value.toLowerCase().split(/\s+/u);
    const text = ({ name, more }: Action) => `${name} ${more}`.toLowerCase();
    // What is named by the words comes before what is explained by them.
    const rank = ({ name, disabled }: Action) => (words.every((word) => name.toLowerCase().includes(word)) ? 0 : 1) + (disabled === true ? 2 : 0);
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
