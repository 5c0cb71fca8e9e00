/** The counts of each phase, as in the paper's Table 1, and what each rule refused. */
import { resolved } from '../../shared/crate';
import type { MatchResult, Paper, PointCounts } from '../../shared/crate';
import { comparesMoments, isCurrent, isStale } from '../state/keys';
import { hasPaperCamera } from '../state/paper';
import { BY_HAND, GROSS_ERROR, MANUAL, MATCHED, REFUSALS, codeOf } from '../state/codes';
import { countsByHand, editedPair } from '../state/edited';
import { isCodeShown, withCode } from '../state/display';
import { textOfCode } from '../state/labels';
import { leftCodes, shownPair } from '../state/select';
import type { State } from '../state/state';
import type { Store } from '../state/store';
import { fill, h, markStale, row, section } from '../../shared/panel/dom';
import { count, percent, significant } from '../../shared/text/format';
import { page } from '../../shared/text/words';
import { swatch } from './swatch';

/** Places in the paper's Table 1; it does not count what the threshold of roundness leaves. */
const PAPER: Readonly<Record<keyof PointCounts, 0 | 1 | null>> = { candidates: 0, after_roundness: null, after_suppression: 1 };
const PAPER_MATCHES = 2;

const PHASES: readonly [keyof PointCounts, string][] = [
  ['candidates', 'Operator'],
  ['after_roundness', 'Roundness'],
  ['after_suppression', 'Suppression'],
];

/** The settings by which the paper counted, whose Table 1 says nothing of others. */
function countsAsPaper({ settings }: State): boolean {
  return (
    settings !== null && comparesMoments(settings) && resolved(settings).points.operator === resolved({ matching: { strategy: 'moments' } }).points.operator
  );
}

/** Rules that only some strategies have. */
const RARE: ReadonlySet<string> = new Set(['border', 'left_right', 'not_converged', 'imprecise', 'frame']);

export function mountCounts(host: HTMLElement, store: Store): void {
  const phases = h('div', {});
  const rules = h('div', {});
  const points = section('Points', 'counts-section', phases);
  const matches = section('Matches', 'matches-section', rules);
  host.append(points, matches);
  store.watch(
    (s) => [s.results, s.history, s.settings, s.images, s.display, s.camera, s.photos, s.offset, s.fiducialModel, s.failures] as const,
    () => {
      const { state } = store;
      points.classList.toggle('is-stale', pointsAreStale(state));
      matches.classList.toggle('is-stale', isStale(state, 'match'));
      fill(phases, phaseTable(state));
      fill(rules, ruleTable(state, store), scoreLines(state));
    },
  );
}

function pointsAreStale(state: State): boolean {
  return isStale(state, 'pointsLeft') || isStale(state, 'pointsRight');
}

function cell(testid: string, text: string): HTMLTableCellElement {
  return h('td', { testid, class: 'number' }, text);
}

function phaseTable(state: State): HTMLElement {
  const left = state.results.pointsLeft?.value;
  const right = state.results.pointsRight?.value;
  const matches = matchOf(state)?.counts.matches;
  const printed = hasPaperCamera(state) && countsAsPaper(state) ? state.catalogue?.paper : undefined;
  const paper = (text: (of: Paper) => string) => (printed === undefined ? [] : [h('td', { class: 'number paper' }, text(printed))]);
  const counted = (place: 0 | 1 | 2 | null) => paper(({ points }) => (place === null ? '–' : points[place].map(count).join(' / ')));
  const body = PHASES.map(([field, label]) =>
    row(label, cell(`count-left-${field}`, count(left?.counts[field])), cell(`count-right-${field}`, count(right?.counts[field])), ...counted(PAPER[field])),
  );
  const threshold = (value: number | undefined) => (value === undefined ? '–' : significant(value));
  return h(
    'table',
    { aria: { label: 'Points after each phase' } },
    h(
      'thead',
      {},
      h(
        'tr',
        {},
        h('th', { scope: 'col' }, 'Phase'),
        h('th', { scope: 'col' }, 'Left'),
        h('th', { scope: 'col' }, 'Right'),
        printed !== undefined ? h('th', { scope: 'col', class: 'paper', title: "The paper's Table 1, for its own pair" }, 'Paper, l / r') : null,
      ),
    ),
    h(
      'tbody',
      {},
      ...body,
      markStale(
        row('Matching', cell('count-left-matches', count(matches)), cell('count-right-matches', count(matches)), ...counted(PAPER_MATCHES)),
        isStale(state, 'match') && !pointsAreStale(state),
      ),
      row(
        'Threshold',
        cell('threshold-left', threshold(left?.threshold)),
        cell('threshold-right', threshold(right?.threshold)),
        ...paper((of) => [of.threshold, of.threshold].map(count).join(' / ')),
      ),
    ),
  );
}

/** The matches with what was done to them by hand. */
function matchOf(state: State): MatchResult | undefined {
  return editedPair(state)?.match ?? state.results.match?.value;
}

function ruleTable(state: State, store: Store): HTMLElement {
  const result = matchOf(state);
  const total = result?.rules.length ?? 0;
  const share = (n: number | undefined) => (n === undefined || total === 0 ? '–' : percent(n / total));
  // A rule that the strategy does not have refuses nothing; its row would only lengthen the table.
  const applied = REFUSALS.filter((rule) => !RARE.has(rule) || (result?.counts[rule] ?? 0) > 0);
  const refused = applied.map((rule) => ruleRow(codeOf(rule), `refused-${rule}`, result?.counts[rule], share, state, store));
  const shown = shownPair(state);
  const gross = shown.orientation?.rejected.length;
  return h(
    'table',
    { aria: { label: 'What became of the left points' } },
    h(
      'thead',
      {},
      h(
        'tr',
        {},
        h('th', { scope: 'col' }, 'Left points'),
        h('th', { scope: 'col' }, 'Number'),
        h('th', { scope: 'col' }, 'Share'),
        h('th', { scope: 'col' }, 'Show'),
      ),
    ),
    h(
      'tbody',
      {},
      ruleRow(MATCHED, 'count-matches', result?.counts.matches, share, state, store),
      markStale(
        ruleRow(GROSS_ERROR, 'count-gross-errors', gross, share, state, store, 'of these, gross errors'),
        gross !== undefined && isStale(state, 'orientation') && !isStale(state, 'match'),
      ),
      ...byHand(result).map(([code, testid, value, label]) => ruleRow(code, testid, value, share, state, store, label)),
      h('tr', { class: 'subhead' }, h('th', { scope: 'rowgroup', colspan: 4 }, 'Rejected by')),
      ...refused,
    ),
  );
}

/** What was done by hand, where anything was. */
function byHand(result: MatchResult | undefined): [code: number, testid: string, value: number, label?: string][] {
  if (result === undefined) return [];
  const { rejected, manual } = countsByHand(result);
  const rows: ReturnType<typeof byHand> = [
    [MANUAL, 'count-manual', manual, 'of these, measured by hand'],
    [BY_HAND, 'count-rejected-by-hand', rejected],
  ];
  return rows.filter(([, , value]) => value > 0);
}

function ruleRow(
  code: number,
  testid: string,
  value: number | undefined,
  share: (n: number | undefined) => string,
  state: State,
  store: Store,
  label?: string,
): HTMLTableRowElement {
  const own = textOfCode(code, 'label');
  const toggle = h('input', { type: 'checkbox', testid: `show-${String(code)}`, aria: { label: `Show: ${own}` } });
  toggle.checked = isCodeShown(state.display, code);
  toggle.addEventListener('change', () => {
    store.dispatch({ type: 'display', display: withCode(store.state.display, code, toggle.checked) });
    document.querySelector<HTMLInputElement>(`[data-testid="show-${String(code)}"]`)?.focus();
  });
  const name = h('span', { title: textOfCode(code) }, label ?? own);
  return row(
    h('span', { class: 'legend' }, swatch(code), name),
    cell(testid, count(value)),
    h('td', { class: 'number' }, share(value)),
    h('td', { class: 'centre' }, toggle),
  );
}

/** How many matches are right, where the truth is known. */
function scoreLines(state: State): HTMLElement | null {
  const score = state.results.score?.value;
  const { match } = shownPair(state);
  if (score === undefined || match === null || !isCurrent(state, 'score') || score.matches === 0) return null;
  const line = (name: string, testid: string, value: number, of: string, title: string) =>
    h('tr', { title }, h('th', { scope: 'row' }, name), cell(testid, count(value)), h('td', { class: 'number' }, of));
  const share = (value: number) => percent(value / score.matches);
  return h(
    'table',
    { testid: 'score', aria: { label: 'Matches against the truth' } },
    h('thead', {}, h('tr', {}, h('th', { scope: 'col' }, 'Against the truth'), h('th', { scope: 'col' }, 'Number'), h('th', { scope: 'col' }, 'Share'))),
    h(
      'tbody',
      {},
      line(
        'Right',
        'score-right',
        score.right,
        share(score.right),
        'Within 1.5 px of where the surface at the left pixel, or at one of its 8 neighbours, is seen: points lie on edges, where the surface may jump between two pixels.',
      ),
      line('Strictly right', 'score-strict', score.strict, share(score.strict), 'Within 1.5 px of where the surface at the left pixel itself is seen.'),
      line('Missed', 'score-missed', score.missed, '', 'Left points that are visible in the right image and have no right match.'),
    ),
  );
}

/** What became of the points, in one sentence for the status line. */
export function summary(state: State): string {
  const shown = shownPair(state);
  if (shown.match === null) return '';
  const codes = leftCodes(shown.left, shown.match, shown.orientation);
  return page('matched', { matches: shown.match.counts.matches, points: codes.length });
}
