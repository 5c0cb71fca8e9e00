/** What lies in a view that is not shown, in a closed drawer, behind a tab or in a fold, and the way to it. */
import { setDrawer } from './drawers';
import { ownLack } from './lack';
import { showTab } from './tabs';

/** A part or view of the page, which is shown in place of others. */
export interface Place {
  title: string;
  show: () => void;
  /** Whether an element that is hidden can be shown so now; always where it is left out. */
  can?: () => boolean;
}

const places = new WeakMap<Element, Place>();

/** These elements are hidden as long as another place is shown. */
export function declarePlace(elements: readonly Element[], place: Place): void {
  for (const element of elements) places.set(element, place);
}

/** An element and what it lies in, the innermost first. */
function around(element: Element): Element[] {
  const all: Element[] = [];
  for (let now: Element | null = element; now !== null; now = now.parentElement) all.push(now);
  return all;
}

const placeOf = (hidden: Element) => {
  const place = places.get(hidden);
  return place?.can?.() === false ? undefined : place;
};

const isHiddenItself = (element: Element) => element.hasAttribute('hidden');

const isPanel = (element: Element) => element.getAttribute('role') === 'tabpanel';

const tabOfPanel = (panel: Element) => document.getElementById(panel.getAttribute('aria-labelledby') ?? '');

/** Whether an element is there for the user, in sight or a few presses away: not where the page itself hides it. */
export function reachable(element: Element): boolean {
  return around(element)
    .filter(isHiddenItself)
    .every((hidden) => placeOf(hidden) !== undefined || (isPanel(hidden) && tabOfPanel(hidden)?.hidden === false));
}

/** The places that have to be shown before an element is seen, the outermost first. */
export function waysTo(element: Element): Place[] {
  const hidden = around(element).filter(isHiddenItself).reverse();
  return hidden.flatMap((one) => placeOf(one) ?? []);
}

/** The part of the page that an element is of; null where it is of none. */
export function partOf(element: Element): Place | null {
  return (
    around(element)
      .reverse()
      .flatMap((one) => places.get(one) ?? [])[0] ?? null
  );
}

/** What is lacking for what an element does, what all around lacks first; empty where nothing is known to be. */
export function lackOf(element: Element): string {
  return (
    around(element)
      .reverse()
      .map((one) => ownLack(one))
      .find((text) => text !== '') ?? ''
  );
}

/** Opens what an element lies in, from the outermost to the innermost. */
export function reveal(element: Element): void {
  for (const one of around(element).reverse()) {
    if (isHiddenItself(one)) placeOf(one)?.show();
    if (one.classList.contains('side')) setDrawer(one.classList.contains('of-settings') ? 'settings' : 'details', true);
    if (one.classList.contains('dock')) setDrawer('table', true);
    if (isPanel(one) && isHiddenItself(one)) showTab(one.getAttribute('aria-labelledby') ?? '');
    if (one.matches('[id].more, [id].menu') && !element.checkVisibility()) unfold(one.id);
    if (one instanceof HTMLDetailsElement) one.open = true;
  }
}

/** Presses the button of a menu that is folded. */
function unfold(menu: string): void {
  const press = document.querySelector<HTMLElement>(`[aria-controls="${menu}"][aria-expanded="false"]`);
  if (press?.checkVisibility() === true) press.click();
}
