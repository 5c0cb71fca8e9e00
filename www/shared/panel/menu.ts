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
  const show = (unfolded: boolean) => {
    panel.classList.toggle('is-open', unfolded);
    press.setAttribute('aria-expanded', String(unfolded));
  };
  const isUnfolded = () => panel.classList.contains('is-open');
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
  document.addEventListener('keydown', ({ key }) => {
    if (key !== 'Escape' || !isUnfolded()) return;
    const held = panel.contains(document.activeElement);
    show(false);
    if (held) press.focus();
  });
  show(false);
}
