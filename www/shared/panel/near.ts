/** What is said beside the button that was pressed: over the page, until it is closed or something else is said. The answer stays what it is. */
import type { Notice } from '../state/notice';
import { say } from '../text/words';
import { button, h } from './dom';

/** Between it and the button, and the edges of the page, CSS px. */
const GAP = 6;

export interface Near {
  /** Lies over whatever is beside it. */
  element: HTMLElement;
  show: (notice: Notice | null) => void;
}

/** `close`: the user has read it. */
export function makeNear(testid: string, close: () => void): Near {
  const text = h('p', {});
  const shut = button('×', `${testid}-close`, () => {
    const { near } = element.dataset;
    close();
    if (near !== undefined) pressed(near)?.focus();
  });
  shut.className = 'icon';
  shut.setAttribute('aria-label', say('close-2'));
  const element = h('div', { class: 'near', testid, hidden: true, role: 'alert' }, text, shut);
  const place = () => {
    if (!element.hidden) lay(element, pressed(element.dataset.near ?? ''));
  };
  window.addEventListener('resize', place);
  window.addEventListener('scroll', place, { capture: true, passive: true });
  document.addEventListener('keydown', ({ key, defaultPrevented }) => {
    // What the picture gave up for it was all that it was to end.
    if (key === 'Escape' && !element.hidden && !defaultPrevented) close();
  });
  return {
    element,
    show: (notice) => {
      element.hidden = notice?.near === undefined;
      if (notice?.near === undefined) {
        text.textContent = '';
        return;
      }
      element.dataset.near = notice.near;
      element.dataset.kind = notice.kind;
      if (text.textContent !== notice.text) text.textContent = notice.text;
      place();
    },
  };
}

/** The button, or that of the menu which it is folded into. */
function pressed(testid: string): HTMLElement | null {
  const own = document.querySelector<HTMLElement>(`[data-testid="${testid}"]`);
  return own?.checkVisibility({ visibilityProperty: true }) === true ? own : document.getElementById('menu');
}

/** Under the button where there is room, else over it; within the page. */
function lay(element: HTMLElement, at: HTMLElement | null): void {
  const box = at?.getBoundingClientRect() ?? new DOMRect();
  const { width, height } = element.getBoundingClientRect();
  const { clientWidth, clientHeight } = document.documentElement;
  const wanted = getComputedStyle(element).direction === 'rtl' ? box.right - width : box.left;
  const below = box.bottom + GAP;
  const top = below + height > clientHeight && box.top - GAP - height >= 0 ? box.top - GAP - height : below;
  element.style.left = `${String(Math.max(GAP, Math.min(wanted, clientWidth - GAP - width)))}px`;
  element.style.top = `${String(top)}px`;
}
