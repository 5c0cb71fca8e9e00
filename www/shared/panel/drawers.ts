/** What is opened and closed by a button: the settings, the details of the results, the settings that few need, the tables. It stays as it was left. */
import { hasten } from '../engine/breath';
import { button } from './dom';
import { keepChoice, keptChoice } from '../choices';
import { say } from '../text/words';

export type Drawer = 'settings' | 'details' | 'all-settings' | 'table';

const NAME = 'tiepoint-open';

/** Where a screen has room for pictures and tables, a stranger finds both. */
const AT_FIRST = window.innerHeight >= 900 && window.innerWidth >= 1180 ? 'table' : '';

const open = new Set<string>((keptChoice(NAME) ?? AT_FIRST).split(' '));
const watchers: (() => void)[] = [];

/** Here the settings lie over the pictures, as the style sheet has it. */
const OVER = window.matchMedia('(width < 1180px)');
/** Here settings and details leave room for the pictures between them. */
const ROOM = window.matchMedia('(width >= 1500px)');

/** What gives way to a drawer where there is no room for both. */
const BESIDE: Readonly<Partial<Record<Drawer, readonly Drawer[]>>> = { settings: ['details'], details: ['settings'] };

// What was left open on a wider screen would hide what is to be seen.
if (OVER.matches) open.delete('settings');
ROOM.addEventListener('change', () => !ROOM.matches && isOpen('details') && setDrawer('settings', false));

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
  if (wanted && drawer === 'settings') hasten();
  if (wanted) open.add(drawer);
  else open.delete(drawer);
  if (wanted && !ROOM.matches) for (const other of BESIDE[drawer] ?? []) open.delete(other);
  keepChoice(NAME, [...open].filter((name) => name !== '').join(' '));
  for (const callback of watchers) callback();
}

/** Closes the settings where they lie over the pictures, in which something is to be done now. */
export function uncoverPictures(): void {
  if (OVER.matches) setDrawer('settings', false);
}

/**
 * A button that opens a drawer and closes it; the drawer itself gets a button that closes it.
 * `name`: what it is called where `text` alone does not say of what it is; it begins with that.
 */
export function drawerButton(drawer: Drawer, text: string, testid: string, element: HTMLElement, name = ''): HTMLButtonElement {
  const made = button(text, testid, () => {
    setDrawer(drawer, !isOpen(drawer));
    if (isOpen(drawer)) reveal(element);
  });
  if (name !== '') made.ariaLabel = name;
  const close = button('×', `close-${testid}`, () => {
    setDrawer(drawer, false);
    made.focus();
  });
  close.className = 'icon close';
  close.setAttribute('aria-label', say('close-3', { text }));
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
