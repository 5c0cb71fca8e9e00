/** The selected point: the rule that decided, its window, what was compared, its candidates, its statistics. */
import type { MatchResult } from '../../shared/crate';
import { interiorInUse } from '../state/interior';
import { comparesGradients, comparesGreyValues, isCurrent } from '../state/keys';
import { pixelMm } from '../state/residuals';
import { matchOfLeft, shownPair } from '../state/select';
import { leftIndexOf } from '../state/selected';
import type { ShownPair } from '../state/select';
import type { Inspection, PointWindow, State } from '../state/state';
import type { Store } from '../state/store';
import { statisticsOf } from '../state/statistics';
import { fill, h, row } from '../../shared/panel/dom';
import { facts } from '../../shared/panel/facts';
import type { Fact } from '../../shared/panel/facts';
import { featurePictures } from './feature';
import { count, fixed, significant } from '../../shared/text/format';
import { swatch } from './swatch';
import { verdictOf } from './verdict';
import { windowPicture } from './window';

const MOST_ROWS = 50;

export function mountPoint(host: HTMLElement, store: Store, select: (side: 'left' | 'right', index: number) => void): void {
  const body = h('div', { testid: 'point-panel' });
  host.append(body);
  store.watch(['selection', 'results', 'history', 'images', 'settings', 'failures'], () => {
    const { state } = store;
    body.classList.toggle('is-stale', state.selection !== null && state.results.match !== undefined && !isCurrent(state, 'match'));
    const focused = body.contains(document.activeElement);
    fill(body, ...content(state, select));
    // A candidate that was chosen is no longer there; the keyboard stays in the panel.
    if (focused) host.focus({ preventScroll: true });
  });
}

function content(state: State, select: (side: 'left' | 'right', index: number) => void): HTMLElement[] {
  const { selection } = state;
  const shown = shownPair(state);
  const points = selection === null ? null : shown[selection.side];
  if (selection === null || points === null || 3 * selection.index >= points.length) {
    return [
      h(
        'p',
        { class: 'note' },
        'Click a point in an image, or press N with the image in focus, to see what was compared, its candidates and the rule that decided.',
      ),
    ];
  }
  const at = points.subarray(3 * selection.index, 3 * selection.index + 3);
  const parts: HTMLElement[] = [
    h('h3', {}, `${selection.side === 'left' ? 'Left' : 'Right'} point ${count(selection.index + 1)}`),
    h('p', { class: 'facts-line', testid: 'point-position' }, `x ${fixed(at[0], 1)} px, y ${fixed(at[1], 1)} px, interest value ${significant(at[2] ?? 0)}`),
  ];
  if (shown.match === null) return [...parts, h('p', { class: 'note' }, 'Not matched yet.')];
  parts.push(verdict(state, shown, shown.match));
  const inspection = state.results.inspection?.value;
  if (inspection === undefined || !isCurrent(state, 'inspection'))
    return [...parts, h('p', { class: 'note' }, problemOr(state, 'Loading the window and the candidates …'))];
  // Grey values are compared as they are: moments of their windows would say nothing about the verdict.
  const byGrey = state.settings !== null && comparesGreyValues(state.settings);
  const byGradients = state.settings !== null && comparesGradients(state.settings);
  const compared = byGradients ? featurePictures(inspection) : [windows(inspection, !byGrey), ...(byGrey ? [] : moments(inspection))];
  return [
    ...parts,
    ...compared,
    ...lineNote(inspection, shown.match),
    ...matchStatistics(state, shown, shown.match),
    ...candidateTable(state, shown.match, inspection, select),
  ];
}

/** What is drawn of the geometry in the other image. */
function lineNote({ line }: Inspection, { geometry }: MatchResult): HTMLElement[] {
  if (line === null || geometry === null) return [];
  const text =
    'fundamental' in geometry.model
      ? `The dashed line in the ${line.side} image is the epipolar line of this point: its match lies on it, whatever the height.`
      : `The cross in the ${line.side} image is where the geometry has this point.`;
  return [
    h(
      'p',
      { class: 'note', testid: 'point-line' },
      line.positions.length === 0 ? `By the geometry of the two views this point lies outside the ${line.side} image.` : text,
    ),
  ];
}

function problemOr(state: State, text: string): string {
  return state.failures.inspection?.message ?? text;
}

function verdict(state: State, shown: ShownPair, match: MatchResult): HTMLElement {
  const { code, text } = verdictOf(state, shown, match);
  return h('p', { class: 'verdict', testid: 'point-verdict' }, swatch(code), h('span', {}, text));
}

function windows({ left, right }: Inspection, axes: boolean): HTMLElement {
  const one = (name: string, window: PointWindow | null) => {
    const report = window?.report ?? null;
    const picture =
      window === null || report === null ? h('p', { class: 'note' }, window?.problem ?? 'No point.') : windowPicture(report, window.col, window.row, axes);
    return h('figure', {}, picture, h('figcaption', {}, name, report === null || !axes ? '' : ` · axis ${fixed(report.axis_angle_deg, 1)}°`));
  };
  return h('div', { class: 'windows', testid: 'point-windows' }, one('Left window', left), one('Right window', right));
}

const MOMENTS = [
  ['mu20', 'µ′₂₀'],
  ['mu11', 'µ′₁₁'],
  ['mu02', 'µ′₀₂'],
  ['mu30', 'µ′₃₀'],
  ['mu21', 'µ′₂₁'],
  ['mu12', 'µ′₁₂'],
  ['mu03', 'µ′₀₃'],
] as const;

function moments({ left, right }: Inspection): HTMLElement[] {
  if ((left?.report ?? right?.report ?? null) === null) return [];
  const value = (number: number | undefined) => h('td', { class: 'number' }, number === undefined ? '–' : significant(number));
  const head = (text: string) =>
    h('thead', {}, h('tr', {}, h('th', { scope: 'col' }, text), h('th', { scope: 'col' }, 'Left'), h('th', { scope: 'col' }, 'Right')));
  return [
    h(
      'div',
      { class: 'moments' },
      h(
        'table',
        { testid: 'point-moments', aria: { label: 'Normalised central moments' } },
        head('Moment'),
        h('tbody', {}, ...MOMENTS.map(([field, name]) => row(name, value(left?.report?.normalized[field]), value(right?.report?.normalized[field])))),
      ),
      h(
        'table',
        { testid: 'point-invariants', aria: { label: 'Invariants' } },
        head('Invariant'),
        h('tbody', {}, ...MOMENTS.map((_, i) => row(`I${'₀₁₂₃₄₅₆'.charAt(i)}`, value(left?.report?.invariants[i]), value(right?.report?.invariants[i])))),
      ),
    ),
  ];
}

/** The figures of the point's match, each with what it is. */
function matchStatistics(state: State, shown: ShownPair, match: MatchResult): HTMLElement[] {
  const index = matchOfLeft(match)[leftIndexOf(state, match.best, match.rules)] ?? -1;
  if (index < 0) return [];
  const interior = interiorInUse(state)?.left;
  const { columns } = statisticsOf(shown.left, match, shown.orientation, state.results.score?.value ?? null, interior === undefined ? null : pixelMm(interior));
  const right = match.matches.subarray(5 * index + 2, 5 * index + 4);
  const list: Fact[] = [
    {
      name: 'Right position',
      testid: 'match-right',
      value: `${fixed(right[0], 2)}, ${fixed(right[1], 2)} px`,
      help: 'Where the match lies in the right image.',
    },
    ...columns
      .filter(({ key }) => key !== 'x' && key !== 'y')
      .map(({ key, label, unit, digits, help, value }) => ({
        name: label,
        testid: `match-${key}`,
        value: `${fixed(value(index), digits)}${unit === '' ? '' : ` ${unit}`}`,
        help,
      })),
  ];
  return [h('h4', {}, `Match ${count(index + 1)}`), facts(list)];
}

function candidateTable(state: State, match: MatchResult, { candidates }: Inspection, select: (side: 'left' | 'right', index: number) => void): HTMLElement[] {
  const points = state.results.pointsRight?.value.points;
  const total = candidates.length / 2;
  const leftIndex = leftIndexOf(state, match.best, match.rules);
  if (points === undefined || leftIndex < 0 || total === 0) return [];
  const rows = Array.from({ length: Math.min(total, MOST_ROWS) }, (_, i) => {
    const index = candidates[2 * i] ?? 0;
    const go = h('button', { type: 'button', class: 'link', aria: { label: `Select right point ${String(index + 1)}` } }, count(index + 1));
    go.addEventListener('click', () => select('right', index));
    const cells = [points[3 * index], points[3 * index + 1]].map((v) => h('td', { class: 'number' }, fixed(v, 1)));
    const [least = NaN, own = NaN] = [candidates[1], candidates[2 * i + 1]];
    return h(
      'tr',
      { class: index === match.best[leftIndex] ? 'best' : '' },
      h('td', {}, String(i + 1)),
      h('td', {}, go),
      ...cells,
      h('td', { class: 'number' }, fixed(own, 4)),
      h('td', { class: 'number' }, i === 0 ? '' : fixed(least / own, 3)),
    );
  });
  const measure = state.settings !== null && comparesGradients(state.settings) ? 'Distance' : 'Measure';
  const heads = ['', 'Right point', 'x px', 'y px', measure].map((text) => h('th', { scope: 'col' }, text));
  heads.push(h('th', { scope: 'col', title: 'The smallest measure divided by its own: that of the second decides whether the best is ambiguous.' }, 'Ratio'));
  const caption = `${count(total)} ${total === 1 ? 'candidate' : 'candidates'} of left point ${count(leftIndex + 1)}${total > MOST_ROWS ? `, the best ${String(MOST_ROWS)}` : ''}`;
  return [
    h('h4', {}, caption),
    h(
      'div',
      { class: 'scroll candidates' },
      h('table', { testid: 'point-candidates', aria: { label: caption } }, h('thead', {}, h('tr', {}, ...heads)), h('tbody', {}, ...rows)),
    ),
  ];
}
