/** The bar above the images: layers, linking, zoom. */
import type { Display, LineLayer, PointLayer } from '../state/state';
import { shownPair } from '../state/select';
import type { Store } from '../state/store';
import type { Navigator } from '../view/navigate';
import { SOME_LINES } from '../view/marks';
import { choice, toggle, vectorChoice } from '../../shared/panel/choice';
import { byId, fill, h } from '../../shared/panel/dom';
import { makeLight } from '../../shared/panel/light';
import { mountMenu } from '../../shared/panel/menu';
import { count } from '../../shared/text/format';
import { labelled, zoomButtons } from '../../shared/panel/zoom';
import { say } from '../../shared/text/words';

export function mountToolbar(host: HTMLElement, store: Store, navigator: Navigator): void {
  const set = (display: Partial<Display>) => store.dispatch({ type: 'display', display });
  const shows = (points: PointLayer) => set({ points, hidden: [] });
  const points = toggle(say('points'), 'layer-points', say('show-the-matched-points'), (on) => shows(on ? 'matched' : 'none'));
  const unmatched = toggle(say('unmatched'), 'layer-unmatched', say('show-rejected-points-too-marked'), (on) => shows(on ? 'all' : 'matched'));
  const [lines, lineSelect] = choice(
    say('lines'),
    'layer-lines',
    [
      ['none', say('no-lines')],
      ['some', `≤ ${String(SOME_LINES)}`],
      ['all', say('all-lines')],
    ],
    (value) => set({ lines: value as LineLayer }),
  );
  const [vectors, vectorSelect] = vectorChoice('layer-vectors', (vectors) => set({ vectors }));
  const linked = toggle(say('linked'), 'linked', say('pan-and-zoom-both-images'), (on) => set({ linked: on }));
  const magnifier = toggle(say('magnifier'), 'magnifier', say('enlarge-what-is-under-the-pointer'), (on) => set({ magnifier: on }));
  const unfoldLight = labelled('◐', 'view-light', say('brightness-and-contrast'), () => undefined);
  const unfold = h('button', { type: 'button', class: 'menu-button', testid: 'view-menu' }, say('view'));
  const light = makeLight('view-', byId('view'), set, [
    [unfoldLight, say('brightness-and-contrast')],
    [unfold, say('view-2')],
  ]);
  const sliders = h('div', { class: 'menu', id: 'view-light' }, ...light.elements);
  mountMenu(unfoldLight, sliders);
  const more = h(
    'div',
    { class: 'more', id: 'view-more' },
    lines,
    vectors,
    h('span', { class: 'divider' }),
    linked,
    magnifier,
    labelled('1:1', 'zoom-actual', say('n-1-1-one-image-pixel'), () => navigator.actualSize()),
    h('div', { class: 'light' }, unfoldLight, sliders),
    h('span', { class: 'divider' }),
    labelled('‹', 'previous-point', say('previous-point-p'), () => navigator.step(-1)),
    labelled('›', 'next-point', say('next-point-n'), () => navigator.step(1)),
  );
  mountMenu(unfold, more);
  host.append(points, unmatched, h('span', { class: 'divider' }), ...zoomButtons('', say('whole-images'), () => navigator), unfold, more);
  store.watch(['results'], () => {
    const { left, match } = shownPair(store.state);
    const others = match === null || left === null ? 0 : left.length / 3 - match.counts.matches;
    fill(unmatched, say('unmatched'), others === 0 ? null : h('span', { class: 'number-of' }, ` (${count(others)})`));
  });
  store.watch(['display'], ([display]) => {
    points.setAttribute('aria-pressed', String(display.points !== 'none'));
    unmatched.setAttribute('aria-pressed', String(display.points === 'all'));
    lineSelect.value = display.lines;
    vectorSelect.value = String(display.vectors);
    linked.setAttribute('aria-pressed', String(display.linked));
    magnifier.setAttribute('aria-pressed', String(display.magnifier));
    light.show(display);
  });
}
