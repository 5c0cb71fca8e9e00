/** What lies in a closed drawer, behind a tab or in a fold, and the way to it. */
import { setDrawer } from './drawers';
import { showTab } from './tabs';

/** Whether an element is there for the user, in sight or one press away: not where the page itself hides it. */
export function reachable(element: Element): boolean {
  const hidden = element.closest('[hidden]:not([role="tabpanel"])');
  if (hidden !== null) return false;
  // The rest of a page that is no part of it now.
  return element.closest('main')?.checkVisibility() !== false;
}

/** Opens what an element lies in. */
export function reveal(element: Element): void {
  const side = element.closest('.side');
  if (side !== null) setDrawer(side.classList.contains('of-settings') ? 'settings' : 'details', true);
  if (element.closest('.dock') !== null) setDrawer('table', true);
  const tab = element.closest('[role="tabpanel"][hidden]')?.getAttribute('aria-labelledby');
  if (tab != null) showTab(tab);
  // A menu that is folded.
  const menu = element.checkVisibility() ? null : element.closest('[id].more, [id].menu');
  if (menu !== null) document.querySelector<HTMLElement>(`[aria-controls="${menu.id}"][aria-expanded="false"]`)?.click();
  for (let fold = element.closest('details'); fold !== null; fold = fold.parentElement?.closest('details') ?? null) fold.open = true;
}
