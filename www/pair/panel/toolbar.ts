/** The bar above the images: layers, linking, zoom. */
import type { Display, LineLayer, PointLayer } from '../state/state';
import type { Store } from '../state/store';
import type { Navigator } from '../view/navigate';
import { SOME_LINES } from '../view/marks';
import { button, h } from '../../shared/panel/dom';
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
  const [points, pointSelect] = choice(
    'Points',
    'layer-points',
    [
      ['all', 'all'],
      ['matched', 'matched'],
      ['none', 'none'],
    ],
    (value) => set({ points: value as PointLayer }),
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
  host.append(
    points,
    lines,
    vectors,
    h('span', { class: 'divider' }),
    linked,
    magnifier,
    h('span', { class: 'divider' }),
    ...zoomButtons('', 'Whole images', () => navigator),
    labelled('1:1', 'zoom-actual', 'One image pixel to one screen pixel (1)', () => navigator.actualSize()),
    h('span', { class: 'divider' }),
    labelled('‹', 'previous-point', 'Previous point (P)', () => navigator.step(-1)),
    labelled('›', 'next-point', 'Next point (N)', () => navigator.step(1)),
  );
  store.watch(['display'], ([display]) => {
    pointSelect.value = display.points;
    lineSelect.value = display.lines;
    vectorSelect.value = String(display.vectors);
    linked.setAttribute('aria-pressed', String(display.linked));
    magnifier.setAttribute('aria-pressed', String(display.magnifier));
  });
}
