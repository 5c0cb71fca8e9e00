/** The bar above the images: layers, linking, zoom. */
import type { Display, LineLayer, PointLayer } from '../state/state';
import { shownPair } from '../state/select';
import type { Store } from '../state/store';
import type { Navigator } from '../view/navigate';
import { SOME_LINES } from '../view/marks';
import { button, fill, h } from '../../shared/panel/dom';
import { mountMenu } from '../../shared/panel/menu';
import { count } from '../../shared/text/format';
import { labelled, zoomButtons } from '../../shared/panel/zoom';

const VECTOR_FACTORS = [0, 10, 20, 50, 100, 200, 500, 1000];

function choice(
  label: string,
  testid: string,
  options: readonly (readonly [string, string])[],
  onChange: (value: string) => void,
): [HTMLElement, HTMLSelectElement] {
  const select = h('select', { testid });
  for (const [value, text] of options) select.append(new Option(text, value));
  select.addEventListener('change', () => onChange(select.value));
  return [h('label', { class: 'choice' }, h('span', {}, label), select), select];
}

function toggle(label: string, testid: string, title: string, onChange: (on: boolean) => void): HTMLButtonElement {
  const made = button(label, testid, () => onChange(made.getAttribute('aria-pressed') !== 'true'), title);
  made.setAttribute('aria-pressed', 'false');
  return made;
}

export function mountToolbar(host: HTMLElement, store: Store, navigator: Navigator): void {
  const set = (display: Partial<Display>) => store.dispatch({ type: 'display', display });
  const shows = (points: PointLayer) => set({ points, hidden: [] });
  const points = toggle('Points', 'layer-points', 'Show the matched points', (on) => shows(on ? 'matched' : 'none'));
  const unmatched = toggle('Unmatched', 'layer-unmatched', 'Show rejected points too, marked by the rule that rejected them: press one to see why', (on) =>
    shows(on ? 'all' : 'matched'),
  );
  const [lines, lineSelect] = choice(
    'Lines',
    'layer-lines',
    [
      ['none', 'none'],
      ['some', `≤ ${String(SOME_LINES)}`],
      ['all', 'all'],
    ],
    (value) => set({ lines: value as LineLayer }),
  );
  const [vectors, vectorSelect] = choice(
    'Residuals',
    'layer-vectors',
    VECTOR_FACTORS.map((f) => [String(f), f === 0 ? 'none' : `× ${String(f)}`] as const),
    (value) => set({ vectors: Number(value) }),
  );
  const linked = toggle('Linked', 'linked', 'Pan and zoom both images together (L)', (on) => set({ linked: on }));
  const magnifier = toggle('Magnifier', 'magnifier', 'Enlarge what is under the pointer (M)', (on) => set({ magnifier: on }));
  const more = h(
    'div',
    { class: 'more', id: 'view-more' },
    lines,
    vectors,
    h('span', { class: 'divider' }),
    linked,
    magnifier,
    labelled('1:1', 'zoom-actual', 'One image pixel to one screen pixel (1)', () => navigator.actualSize()),
    h('span', { class: 'divider' }),
    labelled('‹', 'previous-point', 'Previous point (P)', () => navigator.step(-1)),
    labelled('›', 'next-point', 'Next point (N)', () => navigator.step(1)),
  );
  const unfold = h('button', { type: 'button', class: 'menu-button', testid: 'view-menu' }, 'View ▾');
  mountMenu(unfold, more);
  host.append(points, unmatched, h('span', { class: 'divider' }), ...zoomButtons('', 'Whole images', () => navigator), unfold, more);
  store.watch(['results'], () => {
    const { left, match } = shownPair(store.state);
    const others = match === null || left === null ? 0 : left.length / 3 - match.counts.matches;
    fill(unmatched, 'Unmatched', others === 0 ? null : h('span', { class: 'number-of' }, ` (${count(others)})`));
  });
  store.watch(['display'], ([display]) => {
    points.setAttribute('aria-pressed', String(display.points !== 'none'));
    unmatched.setAttribute('aria-pressed', String(display.points === 'all'));
    lineSelect.value = display.lines;
    vectorSelect.value = String(display.vectors);
    linked.setAttribute('aria-pressed', String(display.linked));
    magnifier.setAttribute('aria-pressed', String(display.magnifier));
  });
}
