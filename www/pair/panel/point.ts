/** The selected point: the rule that decided, its window, what was compared, its candidates, its statistics. */
import type { MatchResult } from '../../shared/crate';
import { comparesGradients, comparesGreyValues, isCurrent } from '../state/keys';
import { isPredicted } from '../state/predicted';
import { matchOfLeft, shownPair } from '../state/select';
import { leftIndexOf } from '../state/selected';
import type { ShownPair } from '../state/select';
import type { Inspection, PointWindow, State } from '../state/state';
import type { Store } from '../state/store';
import { statisticsOfState } from '../state/statistics';
import { fill, h, row } from '../../shared/panel/dom';
import { facts } from '../../shared/panel/facts';
import type { Fact } from '../../shared/panel/facts';
import { featurePictures } from './feature';
import { count, fixed, significant } from '../../shared/text/format';
import { swatch } from '../../shared/panel/swatch';
import { styleOf } from '../view/palette';
import { verdictOf } from './verdict';
import { windowPicture } from './window';
import { whenInSight } from '../../shared/panel/sight';
import { say } from '../../shared/text/words';
import { unitText, withUnit } from '../../shared/text/units';

const MOST_ROWS = 50;

export function mountPoint(host: HTMLElement, store: Store, select: (side: 'left' | 'right', index: number) => void): void {
  const body = h('div', { testid: 'point-panel' });
  host.append(body);
  store.watch(
    ['selection', 'results', 'history', 'images', 'settings', 'failures'],
    whenInSight(host, () => {
      const { state } = store;
      body.classList.toggle('is-stale', state.selection !== null && state.results.match !== undefined && !isCurrent(state, 'match'));
      const focused = body.contains(document.activeElement);
      fill(body, ...content(state, select));
      // A candidate that was chosen is no longer there; the keyboard stays in the panel.
      if (focused) host.focus({ preventScroll: true });
    }),
  );
}

function content(state: State, select: (side: 'left' | 'right', index: number) => void): HTMLElement[] {
  const { selection } = state;
  const shown = shownPair(state);
  const points = selection === null ? null : shown[selection.side];
  if (selection === null || points === null || 3 * selection.index >= points.length) {
    return [h('p', { class: 'note' }, say('click-a-point-in-an'))];
  }
  const at = points.subarray(3 * selection.index, 3 * selection.index + 3);
  const parts: HTMLElement[] = [
    h('h3', {}, say('point-3', { what: selection.side === 'left' ? say('left') : say('right'), index: selection.index + 1 })),
    h('p', { class: 'facts-line', testid: 'point-position' }, say('x-px-y-px-interest', { at: at[0], at_2: at[1], significant: significant(at[2] ?? 0) })),
  ];
  if (shown.match === null) return [...parts, h('p', { class: 'note' }, say('not-matched-yet'))];
  parts.push(verdict(state, shown, shown.match));
  const inspection = state.results.inspection?.value;
  if (inspection === undefined || !isCurrent(state, 'inspection'))
    return [...parts, h('p', { class: 'note' }, problemOr(state, say('loading-the-window-and-the')))];
  // Grey values are compared as they are: moments of their windows would say nothing about the verdict.
  const byGrey = state.settings !== null && comparesGreyValues(state.settings);
  const byGradients = state.settings !== null && comparesGradients(state.settings);
  const compared = byGradients ? featurePictures(inspection) : [windows(inspection, !byGrey), ...(byGrey ? [] : moments(inspection))];
  return [
    ...parts,
    ...compared,
    ...lineNote(inspection, shown.match),
    ...matchStatistics(state, shown.match),
    ...candidateTable(state, shown.match, inspection, select),
  ];
}

/** What is drawn of the geometry in the other image. */
function lineNote({ line }: Inspection, { geometry }: MatchResult): HTMLElement[] {
  if (line === null || geometry === null) return [];
  const text = 'fundamental' in geometry.model ? say('the-dashed-line-in-the', { side: line.side }) : say('the-cross-in-the-image', { side: line.side });
  return [h('p', { class: 'note', testid: 'point-line' }, line.positions.length === 0 ? say('by-the-geometry-of-the', { side: line.side }) : text)];
}

function problemOr(state: State, text: string): string {
  return state.failures.inspection?.message ?? text;
}

function verdict(state: State, shown: ShownPair, match: MatchResult): HTMLElement {
  const { code, text } = verdictOf(state, shown, match);
  return h('p', { class: 'verdict', testid: 'point-verdict' }, swatch(styleOf(code)), h('span', {}, text));
}

function windows({ left, right }: Inspection, axes: boolean): HTMLElement {
  const one = (name: string, window: PointWindow | null) => {
    const report = window?.report ?? null;
    const picture =
      window === null || report === null ? h('p', { class: 'note' }, window?.problem ?? say('no-point')) : windowPicture(report, window.col, window.row, axes);
    return h('figure', {}, picture, h('figcaption', {}, name, report === null || !axes ? '' : say('axis', { axis_angle_deg: report.axis_angle_deg })));
  };
  return h('div', { class: 'windows', testid: 'point-windows' }, one(say('left-window'), left), one(say('right-window'), right));
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
    h('thead', {}, h('tr', {}, h('th', { scope: 'col' }, text), h('th', { scope: 'col' }, say('left')), h('th', { scope: 'col' }, say('right'))));
  return [
    h(
      'div',
      { class: 'moments' },
      h(
        'table',
        { testid: 'point-moments', aria: { label: say('normalised-central-moments') } },
        head(say('moment')),
        h('tbody', {}, ...MOMENTS.map(([field, name]) => row(name, value(left?.report?.normalized[field]), value(right?.report?.normalized[field])))),
      ),
      h(
        'table',
        { testid: 'point-invariants', aria: { label: say('invariants') } },
        head(say('invariant')),
        h('tbody', {}, ...MOMENTS.map((_, i) => row(`I${'₀₁₂₃₄₅₆'.charAt(i)}`, value(left?.report?.invariants[i]), value(right?.report?.invariants[i])))),
      ),
    ),
  ];
}

/** The figures of the point's match, each with what it is. */
function matchStatistics(state: State, match: MatchResult): HTMLElement[] {
  const index = matchOfLeft(match)[leftIndexOf(state, match.best, match.rules)] ?? -1;
  if (index < 0) return [];
  const columns = statisticsOfState(state)?.columns ?? [];
  const right = match.matches.subarray(5 * index + 2, 5 * index + 4);
  const list: Fact[] = [
    {
      name: say('right-position'),
      testid: 'match-right',
      value: say('px-9', { right: right[0], right_2: right[1] }),
      help: say('where-the-match-lies-in'),
    },
    ...columns
      .filter(({ key }) => key !== 'x' && key !== 'y')
      .map(({ key, label, unit, help, text }) => ({
        name: label,
        testid: `match-${key}`,
        value: withUnit(text(index), unit),
        help,
      })),
  ];
  return [h('h4', {}, say('match', { index: index + 1 })), facts(list)];
}

function candidateTable(state: State, match: MatchResult, { candidates }: Inspection, select: (side: 'left' | 'right', index: number) => void): HTMLElement[] {
  const points = state.results.pointsRight?.value.points;
  const total = candidates.length / 2;
  const leftIndex = leftIndexOf(state, match.best, match.rules);
  if (points === undefined || leftIndex < 0 || total === 0) return [];
  const rows = Array.from({ length: Math.min(total, MOST_ROWS) }, (_, i) => {
    const index = candidates[2 * i] ?? 0;
    const go = h('button', { type: 'button', class: 'link', aria: { label: say('select-right-point', { index: index + 1 }) } }, count(index + 1));
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
  const measure = state.settings !== null && comparesGradients(state.settings) ? say('distance-2') : say('measure');
  const heads = [say('rank'), say('right-point'), `x ${unitText('px')}`, `y ${unitText('px')}`, measure].map((text) => h('th', { scope: 'col' }, text));
  heads.push(h('th', { scope: 'col', title: say('the-smallest-measure-divided-by') }, say('ratio-2')));
  const caption = say('of-left-point', { total, left_index: leftIndex + 1, what: total > MOST_ROWS ? say('the-best', { most_rows: MOST_ROWS }) : '' });
  return [
    h('h4', {}, caption),
    ...(isPredicted(match, leftIndex) ? [h('p', { class: 'note', testid: 'point-predicted' }, say('the-match-is-none-of-these'))] : []),
    h(
      'div',
      { class: 'scroll candidates' },
      h('table', { testid: 'point-candidates', aria: { label: caption } }, h('thead', {}, h('tr', {}, ...heads)), h('tbody', {}, ...rows)),
    ),
  ];
}
