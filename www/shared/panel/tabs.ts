/** Tabs: one panel of a list is shown; arrow keys move between them. */
import { h } from './dom';
import { LANGUAGE, LANGUAGES } from '../text/language';

/** Where they stand: in a drawer beside the stage, or in the dock under it. */
type Place = 'settings' | 'details' | 'dock';

type Tab = readonly [id: string, text: string];

/** A column of tabs with a panel each, in its place. Panel and tab are named after the tab's id. */
export function tabbed<T extends readonly Tab[]>(
  place: Place,
  label: string,
  tabs: readonly [...T],
): { element: HTMLElement; panels: { [K in keyof T]: HTMLElement } } {
  const buttons = tabs.map(([id, text]) =>
    h('button', { type: 'button', role: 'tab', id: `tab-${id}`, testid: `tab-${id}`, aria: { controls: `panel-${id}` } }, text),
  );
  const panels = tabs.map(([id]) => h('div', { class: 'panel', role: 'tabpanel', id: `panel-${id}`, tabindex: 0, aria: { labelledby: `tab-${id}` } }));
  const choose = (chosen: number) => {
    buttons.forEach((tab, i) => {
      tab.setAttribute('aria-selected', String(i === chosen));
      tab.tabIndex = i === chosen ? 0 : -1;
    });
    panels.forEach((panel, i) => {
      panel.hidden = i !== chosen;
    });
  };
  buttons.forEach((tab, i) => {
    tab.addEventListener('click', () => choose(i));
    tab.addEventListener('keydown', (event) => {
      // The next one stands to the left where the page runs so.
      const forward = LANGUAGES[LANGUAGE].direction === 'rtl' ? -1 : 1;
      const step = { ArrowRight: forward, ArrowLeft: -forward }[event.key];
      if (step === undefined) return;
      event.preventDefault();
      const next = (i + step + tabs.length) % tabs.length;
      // Who draws what is in sight is told as of a press.
      buttons[next]?.click();
      buttons[next]?.focus();
    });
  });
  choose(0);
  const element = h(
    'section',
    { class: place === 'dock' ? 'dock' : `side of-${place}`, aria: { label } },
    h('h2', { class: 'visually-hidden' }, label),
    h('div', { class: 'tabs', role: 'tablist', aria: { label } }, ...buttons),
    ...panels,
  );
  // One panel a tab.
  return { element, panels: panels as unknown as { [K in keyof T]: HTMLElement } };
}

/** Shows the panel of a tab. */
export function showTab(id: string): void {
  document.getElementById(id)?.click();
}
