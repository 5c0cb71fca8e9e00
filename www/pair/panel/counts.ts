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
import { swatch } from '../../shared/panel/swatch';
import { styleOf } from '../view/palette';
import { whenInSight } from '../../shared/panel/sight';
import { say } from '../../shared/text/words';

/** Places in the paper's Table 1; it does not count what the threshold of roundness leaves. */
const PAPER: Readonly<Record<keyof PointCounts, 0 | 1 | null>> = { candidates: 0, after_roundness: null, after_suppression: 1 };
const PAPER_MATCHES = 2;

const PHASES: readonly [keyof PointCounts, string][] = [
  ['candidates', say('operator')],
  ['after_roundness', say('roundness')],
  ['after_suppression', say('suppression')],
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
  const points = section(say('points'), 'counts-section', phases);
  const matches = section(say('matches-2'), 'matches-section', rules);
  host.append(points, matches);
  store.watch(
    (s) => [s.results, s.history, s.settings, s.images, s.display, s.camera, s.photos, s.offset, s.fiducialModel, s.failures] as const,
    whenInSight(host, () => {
      const { state } = store;
      points.classList.toggle('is-stale', pointsAreStale(state));
      matches.classList.toggle('is-stale', isStale(state, 'match'));
      fill(phases, phaseTable(state));
      fill(rules, ruleTable(state, store), scoreLines(state));
    }),
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
    { aria: { label: say('points-after-each-phase') } },
    h(
      'thead',
      {},
      h(
        'tr',
        {},
        h('th', { scope: 'col' }, say('phase')),
        h('th', { scope: 'col' }, say('left')),
        h('th', { scope: 'col' }, say('right')),
        printed !== undefined ? h('th', { scope: 'col', class: 'paper', title: say('the-papers-table-1-for') }, say('paper-l-r')) : null,
      ),
    ),
    h(
      'tbody',
      {},
      ...body,
      markStale(
        row(say('matching'), cell('count-left-matches', count(matches)), cell('count-right-matches', count(matches)), ...counted(PAPER_MATCHES)),
        isStale(state, 'match') && !pointsAreStale(state),
      ),
      row(
        say('threshold'),
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
  const shareOf = (all: number | undefined) => (n: number | undefined) => (n === undefined || all === undefined || all === 0 ? '–' : percent(n / all));
  const share = shareOf(total);
  const ofThese = shareOf(result?.counts.matches);
  // A rule that the strategy does not have refuses nothing; its row would only lengthen the table.
  const applied = REFUSALS.filter((rule) => !RARE.has(rule) || (result?.counts[rule] ?? 0) > 0);
  const refused = applied.map((rule) => ruleRow(codeOf(rule), `refused-${rule}`, result?.counts[rule], share, state, store));
  const shown = shownPair(state);
  const gross = shown.orientation?.rejected.length;
  return h(
    'table',
    { aria: { label: say('what-became-of-the-left') } },
    h(
      'thead',
      {},
      h(
        'tr',
        {},
        h('th', { scope: 'col' }, say('left-points')),
        h('th', { scope: 'col' }, say('number')),
        h('th', { scope: 'col' }, say('share')),
        h('th', { scope: 'col' }, say('show')),
      ),
    ),
    h(
      'tbody',
      {},
      ruleRow(MATCHED, 'count-matches', result?.counts.matches, share, state, store),
      markStale(
        ruleRow(GROSS_ERROR, 'count-gross-errors', gross, ofThese, state, store, say('of-these-gross-errors')),
        gross !== undefined && isStale(state, 'orientation') && !isStale(state, 'match'),
      ),
      ...byHand(result).map(([code, testid, value, label]) => ruleRow(code, testid, value, code === MANUAL ? ofThese : share, state, store, label)),
      h('tr', { class: 'subhead' }, h('th', { scope: 'rowgroup', colspan: 4 }, say('rejected-by'))),
      ...refused,
    ),
  );
}

/** What was done by hand, where anything was. */
function byHand(result: MatchResult | undefined): [code: number, testid: string, value: number, label?: string][] {
  if (result === undefined) return [];
  const { rejected, manual } = countsByHand(result);
  const rows: ReturnType<typeof byHand> = [
    [MANUAL, 'count-manual', manual, say('of-these-measured-by-hand')],
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
  const toggle = h('input', { type: 'checkbox', testid: `show-${String(code)}`, aria: { label: say('show-2', { own }) } });
  toggle.checked = isCodeShown(state.display, code);
  toggle.addEventListener('change', () => {
    store.dispatch({ type: 'display', display: withCode(store.state.display, code, toggle.checked) });
    document.querySelector<HTMLInputElement>(`[data-testid="show-${String(code)}"]`)?.focus();
  });
  const name = h('span', { title: textOfCode(code) }, label ?? own);
  return row(
    h('span', { class: 'legend' }, swatch(styleOf(code)), name),
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
    { testid: 'score', aria: { label: say('matches-against-the-truth') } },
    h(
      'thead',
      {},
      h('tr', {}, h('th', { scope: 'col' }, say('against-the-truth')), h('th', { scope: 'col' }, say('number')), h('th', { scope: 'col' }, say('share'))),
    ),
    h(
      'tbody',
      {},
      line(say('right-matches'), 'score-right', score.right, share(score.right), say('within-1-5-px-of')),
      line(say('strictly-right'), 'score-strict', score.strict, share(score.strict), say('within-1-5-px-of-where')),
      line(say('missed'), 'score-missed', score.missed, '', say('left-points-that-are-visible')),
    ),
  );
}

/** What became of the points, in one sentence for the status line. */
export function summary(state: State): string {
  const shown = shownPair(state);
  if (shown.match === null) return '';
  const codes = leftCodes(shown.left, shown.match, shown.orientation);
  return say('matched', { matches: shown.match.counts.matches, points: codes.length });
}
