/** The switch between the pair and the block. */
import type { Mode, Modes } from '../state/mode';
import { say } from '../text/words';
import { button, h } from './dom';
import { declarePlace } from './reach';

const MODES: readonly (readonly [Mode, string])[] = [
  ['pair', say('pair')],
  ['block', say('block')],
];

/** `show`: shows a part of the page, which may have to be loaded. */
export function modeSwitch(modes: Modes, show: (mode: Mode) => void): HTMLElement {
  const skip = document.querySelector<HTMLAnchorElement>('.skip');
  skip?.addEventListener('click', (event) => {
    // A page of its own in the browser's history would be one to which nothing goes back.
    event.preventDefault();
    document.getElementById(skip.hash.slice(1))?.focus();
  });
  const buttons = MODES.map(([mode, text]) => ({ mode, press: button(text, `mode-${mode}`, () => show(mode)) }));
  modes.watch(['mode'], ([mode]) => {
    for (const { mode: own, press } of buttons) press.setAttribute('aria-pressed', String(own === mode));
    skip?.setAttribute('href', mode === 'pair' ? '#view' : '#block-view');
    document.body.dataset.mode = mode;
  });
  return h('div', { class: 'mode', role: 'group', aria: { label: say('what-is-matched') } }, ...buttons.map(({ press }) => press));
}

/** Shows elements in one mode alone. */
export function showIn(modes: Modes, mode: Mode, elements: readonly HTMLElement[]): void {
  declarePlace(elements, { title: say(mode), show: () => modes.dispatch(mode) });
  modes.watch(['mode'], ([now]) => {
    for (const element of elements) element.hidden = now !== mode;
  });
}
