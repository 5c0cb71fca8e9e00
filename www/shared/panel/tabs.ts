/** Tabs: one panel of a list is shown; arrow keys move between them. */
import { h } from './dom';

type Tab = readonly [id: string, text: string];

/** A column of tabs with a panel each. Panel and tab are named after the tab's id. */
export function tabbed<T extends readonly Tab[]>(label: string, tabs: readonly [...T]): { element: HTMLElement; panels: { [K in keyof T]: HTMLElement } } {
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
      const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
      if (step === undefined) return;
      event.preventDefault();
      const next = (i + step + tabs.length) % tabs.length;
      choose(next);
      buttons[next]?.focus();
    });
  });
  choose(0);
  const element = h('section', { class: 'side', aria: { label } }, h('div', { class: 'tabs', role: 'tablist', aria: { label } }, ...buttons), ...panels);
  // One panel a tab.
  return { element, panels: panels as unknown as { [K in keyof T]: HTMLElement } };
}

/** Shows the panel of a tab. */
export function showTab(id: string): void {
  document.getElementById(id)?.click();
}
