/** A menu: a button, and what it unfolds. A press elsewhere, a choice or Escape folds it again. On wide screens a style may show it unfolded. */
import { h } from './dom';
import { say } from '../text/words';

/** Tools of a view: side by side where there is room, a menu on a phone. */
export function unfolded(testid: string, ...tools: HTMLElement[]): HTMLElement {
  const more = h('div', { class: 'more', id: `${testid}-tools` }, ...tools);
  const press = h('button', { type: 'button', class: 'menu-button', testid }, say('view'));
  mountMenu(press, more);
  return h('div', { class: 'view-tools' }, press, more);
}

export function mountMenu(press: HTMLElement, panel: HTMLElement): void {
  const isUnfolded = () => panel.classList.contains('is-open');
  let covered: readonly HTMLElement[] = [];
  /** What the panel covers cannot be pressed, nor come to by keys, as long as it does. */
  const cover = () => {
    for (const control of covered) control.inert = false;
    covered = isUnfolded() ? controlsUnder(panel) : [];
    for (const control of covered) control.inert = true;
  };
  const show = (unfolded: boolean) => {
    panel.classList.toggle('is-open', unfolded);
    press.setAttribute('aria-expanded', String(unfolded));
    cover();
  };
  press.setAttribute('aria-controls', panel.id);
  press.addEventListener('click', () => show(!isUnfolded()));
  document.addEventListener('pointerdown', ({ target }) => {
    if (isUnfolded() && target instanceof Node && !panel.contains(target) && !press.contains(target)) show(false);
  });
  panel.addEventListener('click', ({ target }) => {
    if (!isUnfolded() || !(target instanceof Element) || target.closest('button:not([aria-expanded])') === null) return;
    // What is folded cannot hold the keyboard; a choice that took it elsewhere keeps it there.
    const held = panel.contains(document.activeElement);
    show(false);
    if (held) press.focus();
  });
  // Before anything under it: one press ends one thing.
  document.addEventListener(
    'keydown',
    (event) => {
      if (event.key !== 'Escape' || !isUnfolded()) return;
      event.stopImmediatePropagation();
      const held = panel.contains(document.activeElement);
      show(false);
      if (held) press.focus();
    },
    { capture: true },
  );
  show(false);
  // Where the window is resized, and where what holds the panel is hidden, it covers others, or none.
  const resized = new ResizeObserver(cover);
  for (const element of [panel, document.documentElement]) resized.observe(element);
}

/** The controls of the page that lie under a panel, wholly or in part. */
function controlsUnder(panel: HTMLElement): HTMLElement[] {
  const over = panel.getBoundingClientRect();
  return [...document.querySelectorAll<HTMLElement>('button, select, input, a')].filter((control) => {
    if (control.inert || panel.contains(control)) return false;
    const { left, right, top, bottom } = control.getBoundingClientRect();
    return left < over.right && right > over.left && top < over.bottom && bottom > over.top;
  });
}
