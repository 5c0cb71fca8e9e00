/** What is closed at first and opened by a button: the settings, the details of the results, the settings that few need. It stays as it was left. */
import { button } from './dom';
import { keepChoice, keptChoice } from '../state/choices';

export type Drawer = 'settings' | 'details' | 'all-settings';

const NAME = 'tiepoint-open';

const open = new Set<string>((keptChoice(NAME) ?? '').split(' '));
const watchers: (() => void)[] = [];

/** Calls back now and whenever a drawer is opened or closed. */
export function watchDrawers(callback: () => void): void {
  watchers.push(callback);
  callback();
}

export function isOpen(drawer: Drawer): boolean {
  return open.has(drawer);
}

export function setDrawer(drawer: Drawer, wanted: boolean): void {
  if (isOpen(drawer) === wanted) return;
  if (wanted) open.add(drawer);
  else open.delete(drawer);
  keepChoice(NAME, [...open].filter((name) => name !== '').join(' '));
  for (const callback of watchers) callback();
}

/** A button that opens a drawer and closes it; the drawer itself gets a button that closes it. */
export function drawerButton(drawer: Drawer, text: string, testid: string, element: HTMLElement): HTMLButtonElement {
  const made = button(text, testid, () => {
    setDrawer(drawer, !isOpen(drawer));
    if (isOpen(drawer)) reveal(element);
  });
  const close = button('×', `close-${testid}`, () => {
    setDrawer(drawer, false);
    made.focus();
  });
  close.className = 'icon close';
  close.setAttribute('aria-label', `Close: ${text}`);
  element.append(close);
  watchDrawers(() => {
    element.classList.toggle('is-closed', !isOpen(drawer));
    made.setAttribute('aria-expanded', String(isOpen(drawer)));
  });
  return made;
}

/** Brings what lies below the picture into sight. */
export function reveal(element: HTMLElement): void {
  const { top } = element.getBoundingClientRect();
  if (top < 0 || top > 0.8 * window.innerHeight) element.scrollIntoView({ block: 'start' });
}
