/** What can be done, as things are: by the buttons, lists, settings and keys of the view that is shown, then of the others, then what cannot be done now. */
import { declared } from '../view/commands';
import type { Commands } from '../view/commands';
import { afterFrame } from '../engine/breath';
import { lackOf, partOf, reachable, reveal, waysTo } from './reach';
import { say } from '../text/words';

export interface Action {
  name: string;
  /** Where it belongs, and what else it is found by. */
  more: string;
  keys: readonly string[];
  /** Goes where it is first, where that is not shown. */
  run: () => void;
  /** Cannot be done as things are. */
  disabled?: boolean;
}

/** An action with how many places have to be shown on the way to it. */
interface Offer extends Action {
  away: number;
}

/** All actions. What a button and its keys do is one of them. */
export function actions(): Action[] {
  const buttons = [...document.querySelectorAll('button')].filter(isNamed);
  const offers = [...ofButtons(buttons), ...ofCommands(buttons), ...ofLists(), ...ofSettings()];
  const rank = ({ away, disabled = false }: Offer) => (disabled ? MOST_AWAY : 0) + away;
  const known = new Set<string>();
  return offers
    .sort((a, b) => rank(a) - rank(b))
    .filter(({ name, more }) => {
      const own = `${name}\n${more}`;
      const isFirst = !known.has(own);
      if (name === '') return false;
      known.add(own);
      return isFirst;
    });
}

/** More places than lie one in another. */
const MOST_AWAY = 9;

/** What an element offers, with the way to it. `texts`: what else it is found by. `off`: why it cannot be done, where that is known; false: it can. */
function offer(element: Element, texts: readonly string[], made: Pick<Action, 'name' | 'keys' | 'run'>, off: false | string): Offer {
  const ways = waysTo(element);
  const disabled = off !== false;
  const more = [disabled ? off : '', ...ways.map(({ title }) => title), ...texts];
  return { ...made, disabled, away: ways.length, more: [...new Set(more)].filter((text) => text !== '').join(' · ') };
}

/** Whether a button is one that the search names: not one of a dialog, nor of a row, nor one that sets a setting back or explains it. */
const isNamed = (button: HTMLButtonElement) =>
  button.closest('dialog, table, .control-head, .history, .facts') === null &&
  !button.matches(UNNAMED) &&
  // The tools of a picture are there even while they are hidden: they wait for something to work on.
  (reachable(button) || button.closest('[role="toolbar"]') !== null);

function ofButtons(buttons: readonly HTMLButtonElement[]): Offer[] {
  // What tables do to their rows, before there are any.
  const isEmpty = (button: HTMLButtonElement) => button.closest('[role="tabpanel"]') !== null && lackOf(button) !== '';
  const isOff = (button: HTMLButtonElement) => button.disabled || !reachable(button) || isEmpty(button);
  // Of two that do the same, one that can be pressed stands for both.
  const inOrder = buttons
    .map((button) => ({ button, off: Number(isOff(button)), away: waysTo(button).length }))
    .sort((a, b) => a.off - b.off || a.away - b.away);
  return once(inOrder.map(({ button }) => button)).map((button) => {
    const texts = [groupOf(twinOf(button) ?? button), legendOf(button), tabOf(button), kindOf(button), button.title].filter((text) => !saysName(button, text));
    const run = () => {
      reveal(button);
      button.click();
    };
    return offer(button, texts, { name: nameOf(button), keys: keysOfButton(button), run }, isOff(button) && lackOf(button));
  });
}

/** What keys do. */
function ofCommands(buttons: readonly HTMLButtonElement[]): Offer[] {
  return declared()
    .filter(({ host, list }) => list.length > 0 && reachable(host))
    .flatMap((of) => {
      // Of keys that work anywhere those of buttons that are shown.
      const part = partOf(of.host);
      const around = buttons.filter((button) => (part === null ? waysTo(button).length === 0 : partOf(button) === part));
      const taken = new Set(around.flatMap(keysOfButton));
      return of.list.filter(({ keys }) => !keys.some((key) => taken.has(key))).map((command) => ofCommand(of, command));
    });
}

function ofCommand({ where, host, lacks: otherwise = '' }: Commands, command: Commands['list'][number]): Offer {
  const { keys, does, can, run, lacks } = command;
  const possible = () => can?.() !== false;
  const lack = lackOf(host) || (lacks?.() ?? '');
  const go = () => {
    if (host.checkVisibility()) return run(false);
    reveal(host);
    if (host instanceof HTMLElement) host.focus();
    // Once it has its size.
    afterFrame(() => {
      if (possible()) run(false);
    })();
  };
  return offer(host, [where], { name: sentenceOf(does), keys, run: go }, (!possible() || lack !== '') && (lack || otherwise));
}

function ofSettings(): Offer[] {
  return [...document.querySelectorAll<HTMLLabelElement>('.control label')].filter(reachable).map((label) => {
    const run = () => {
      reveal(label);
      label.control?.focus();
    };
    return offer(label, [say('setting'), legendOf(label)], { name: label.textContent, keys: [], run }, false);
  });
}

/** What the lists over pictures and beside exports offer, and the sliders there, which are gone to. */
function ofLists(): Offer[] {
  const controls = [...document.querySelectorAll<HTMLSelectElement | HTMLInputElement>('select, input[type="range"]')].filter(
    (control) => control.closest('dialog, table, .control') === null && reachable(control),
  );
  return controls.flatMap((control) => {
    const about = control.ariaLabel ?? control.labels?.[0]?.querySelector('span')?.textContent ?? '';
    const goTo = () => {
      reveal(control);
      control.focus();
    };
    const made = (name: string, run: () => void) => offer(control, [groupOf(control)], { name, keys: [], run }, control.disabled && lackOf(control));
    if (!(control instanceof HTMLSelectElement)) return [made(about, goTo)];
    const others = [...control.options].filter((option) => !option.selected && !option.disabled);
    return others.map((option) =>
      made(say('action-about', { about, action: option.text }), () => {
        control.value = option.value;
        control.dispatchEvent(new Event('change', { bubbles: true }));
        goTo();
      }),
    );
  });
}

/** What the fold or the group of settings is called that an element is in. */
const legendOf = (made: Element) => made.closest('fieldset, details')?.querySelector('legend, summary')?.firstChild?.textContent ?? '';

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

/** Of buttons of one name and the same keys in a part of the page, as those beside the pictures and in their panel, the first. */
function once(buttons: readonly HTMLButtonElement[]): HTMLButtonElement[] {
  const known = new Set<string>();
  return buttons.filter((button) => {
    const keys = keysOfButton(button);
    const name = [partOf(button)?.title ?? '', nameOf(button), ...keys].join('\n');
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
