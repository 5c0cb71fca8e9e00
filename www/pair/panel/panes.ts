/** What lies over the canvas: the name of each image with its buttons, and the invitation where there is none. */
import type { Side, State } from '../state/state';
import { SIDES } from '../state/state';
import type { Store } from '../state/store';
import { panesOf } from '../view/geometry';
import type { View } from '../view/view';
import { button, fill, h } from '../../shared/panel/dom';
import { asFigure } from '../../shared/text/direction';
import { say } from '../../shared/text/words';

export interface PaneActions {
  open: (side: Side) => void;
  /** Asks for a mask of a side. */
  mask: (side: Side) => void;
  unmask: (side: Side) => void;
}

export function mountPanes(view: View, store: Store, actions: PaneActions): void {
  const labels = { left: label('left', actions), right: label('right', actions) };
  view.host.append(labels.left.element, labels.right.element);
  const place = () => {
    const panes = panesOf(store.state, view.host.clientWidth, view.host.clientHeight);
    for (const side of SIDES) {
      const { style } = labels[side].element;
      const { left, top, width, height } = panes[side];
      Object.assign(style, { width: `${String(width)}px`, height: `${String(height)}px` });
      style.setProperty('--left', `${String(left)}px`);
      style.setProperty('--top', `${String(top)}px`);
    }
  };
  // At once: frames that are placed later would move.
  place();
  new ResizeObserver(place).observe(view.host);
  store.watch(
    (s) => [s.images, s.masks, s.results.openLeft, s.results.openRight, s.activeSide] as const,
    () => {
      place();
      for (const side of SIDES) {
        labels[side].element.classList.toggle('is-active', store.state.activeSide === side);
        labels[side].element.classList.toggle('is-empty', store.state.images[side] === null);
        labels[side].show(store.state);
      }
    },
  );
}

function label(side: Side, actions: PaneActions): { element: HTMLElement; show: (state: State) => void } {
  const name = h('span', { class: 'pane-name', testid: `name-${side}` });
  const replace = button(say('replace'), `replace-${side}`, () => actions.open(side));
  replace.setAttribute('aria-label', say('replace-the-image', { side }));
  const empty = button(say('open-the-image-2', { side }), `open-${side}`, () => actions.open(side));
  empty.className = 'invitation';
  const mask = button(say('mask'), `mask-${side}`, () => actions.mask(side), say('an-image-of-the-same'));
  const unmask = button(say('mask-2'), `unmask-${side}`, () => actions.unmask(side));
  unmask.setAttribute('aria-label', say('remove-the-mask-of-the', { side }));
  const of = say('image-4', { name: side === 'left' ? say('left') : say('right') });
  const head = h('div', { class: 'pane-head twin', role: 'group', aria: { label: of } }, name, replace, mask, unmask);
  const element = h('div', { class: 'pane-frame', testid: `pane-${side}` }, head, empty);
  const show = (state: State) => {
    const image = state.images[side];
    const opened = state.results[side === 'left' ? 'openLeft' : 'openRight'];
    const given = state.masks[side];
    head.hidden = image === null;
    mask.hidden = given !== null;
    unmask.hidden = given === null;
    unmask.title = given === null ? '' : say('remove-3', { name: given.name });
    empty.hidden = image !== null;
    const size = opened === undefined || image === null ? '' : say('px-8', { width: opened.value.info.width, height: opened.value.info.height });
    // Beside the buttons a long one is cut off, and the size left out where it has no place.
    name.title = image === null ? '' : `${asFigure(image.name)}${size}`;
    fill(name, h('span', {}, image?.name ?? ''), h('span', {}, size));
  };
  return { element, show };
}
