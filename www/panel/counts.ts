/** The counts of each phase, as in the paper's Table 1, and what each rule refused. */
import type { MatchCounts, PointCounts } from '../engine/wasm';
import { isStale } from '../state/keys';
import { score, TOLERANCE_PX, truthOf } from '../state/score';
import { GROSS_ERROR, leftCodes, shownPair } from '../state/select';
import type { State } from '../state/state';
import type { Store } from '../state/store';
import { fill, h, row, section } from './dom';
import { count, fixed, percent, significant } from './format';
import { swatch } from './swatch';
import { styleOf } from '../view/palette';

/** What the paper's Table 1 has for its pair; it does not count what the threshold of roundness leaves. */
const PAPER: Readonly<Record<keyof PointCounts, readonly [number, number] | null>> = {
  candidates: [46695, 43230],
  after_roundness: null,
  after_suppression: [10761, 9681],
};
const PAPER_MATCHES = 1325;

const PHASES: readonly [keyof PointCounts, string][] = [
  ['candidates', 'Operator'],
  ['after_roundness', 'Roundness'],
  ['after_suppression', 'Suppression'],
];

/** The rules that refuse, in the order in which they are applied: code and field. */
const RULES: readonly [number, keyof MatchCounts][] = [
  [1, 'no_descriptor'], [2, 'no_candidate'], [3, 'threshold'], [4, 'ambiguous'], [5, 'many_to_one'], [6, 'parallax'],
];

export function mountCounts(host: HTMLElement, store: Store): void {
  const phases = h('div', {});
  const rules = h('div', {});
  const points = section('Points', 'counts-section', phases);
  const matches = section('Matches', 'matches-section', rules);
  host.append(points, matches);
  store.watch((s) => [s.results, s.settings, s.images, s.display.hidden, s.camera, s.photos, s.offset] as const, () => {
    const { state } = store;
    points.classList.toggle('is-stale', isStale(state, 'pointsLeft') || isStale(state, 'pointsRight'));
    matches.classList.toggle('is-stale', isStale(state, 'match'));
    fill(phases, phaseTable(state));
    fill(rules, ruleTable(state, store), scoreLine(state));
  });
}

function cell(testid: string, text: string): HTMLTableCellElement {
  return h('td', { testid, class: 'number' }, text);
}

function phaseTable(state: State): HTMLElement {
  const left = state.results.pointsLeft?.value;
  const right = state.results.pointsRight?.value;
  const matches = state.results.match?.value.counts.matches;
  const body = PHASES.map(([field, label]) => row(
    label,
    cell(`count-left-${field}`, count(left?.counts[field])),
    cell(`count-right-${field}`, count(right?.counts[field])),
    h('td', { class: 'number paper' }, PAPER[field]?.map(count).join(' / ') ?? '–'),
  ));
  const threshold = (value: number | undefined) => (value === undefined ? '–' : significant(value));
  return h('table', { aria: { label: 'Points after each phase' } },
    h('thead', {}, h('tr', {}, h('th', { scope: 'col' }, 'Phase'), h('th', { scope: 'col' }, 'Left'), h('th', { scope: 'col' }, 'Right'),
      h('th', { scope: 'col', class: 'paper', title: "The paper's Table 1, for its own pair" }, 'Paper, l / r'))),
    h('tbody', {}, ...body,
      row('Matching', cell('count-left-matches', count(matches)), cell('count-right-matches', count(matches)),
        h('td', { class: 'number paper' }, [PAPER_MATCHES, PAPER_MATCHES].map(count).join(' / '))),
      row('Threshold', cell('threshold-left', threshold(left?.threshold)), cell('threshold-right', threshold(right?.threshold)), h('td', { class: 'number paper' }, '40 / 40'))));
}

function ruleTable(state: State, store: Store): HTMLElement {
  const result = state.results.match?.value;
  const total = result?.rules.length ?? 0;
  const share = (n: number | undefined) => (n === undefined || total === 0 ? '–' : percent(n / total));
  const refused = RULES.map(([code, field]) => ruleRow(code, `refused-${field}`, result?.counts[field], share, state, store));
  const shown = shownPair(state);
  const gross = shown.orientation?.rejected.length;
  return h('table', { aria: { label: 'What became of the left points' } },
    h('thead', {}, h('tr', {}, h('th', { scope: 'col' }, 'Left points'), h('th', { scope: 'col' }, 'Number'), h('th', { scope: 'col' }, 'Share'), h('th', { scope: 'col' }, 'Show'))),
    h('tbody', {}, ruleRow(0, 'count-matches', result?.counts.matches, share, state, store),
      ruleRow(GROSS_ERROR, 'count-gross-errors', gross, share, state, store, 'of these, gross errors'),
      h('tr', { class: 'subhead' }, h('th', { scope: 'rowgroup', colspan: 4 }, 'Refused by')), ...refused));
}

function ruleRow(
  code: number, testid: string, value: number | undefined, share: (n: number | undefined) => string, state: State, store: Store, label?: string,
): HTMLTableRowElement {
  const style = styleOf(code);
  const toggle = h('input', { type: 'checkbox', testid: `show-${String(code)}`, aria: { label: `Show: ${style.label}` } });
  toggle.checked = !state.display.hidden.includes(code);
  toggle.addEventListener('change', () => {
    const hidden = toggle.checked ? store.state.display.hidden.filter((c) => c !== code) : [...store.state.display.hidden, code];
    store.dispatch({ type: 'display', display: { hidden } });
    document.querySelector<HTMLInputElement>(`[data-testid="show-${String(code)}"]`)?.focus();
  });
  const name = h('span', { title: style.sentence }, label ?? style.label);
  return row(h('span', { class: 'legend' }, swatch(code), name), cell(testid, count(value)), h('td', { class: 'number' }, share(value)), h('td', { class: 'centre' }, toggle));
}

/** How many matches are right, where the truth is known. */
function scoreLine(state: State): HTMLElement | null {
  const truth = truthOf(state);
  const { match } = shownPair(state);
  if (truth === null || match === null || match.counts.matches === 0) return null;
  const { precision, right, matches } = score(match, truth);
  return h('p', { class: 'note', testid: 'score' },
    `Against the sample's known surface: ${count(right)} of ${count(matches)} matches (${percent(precision)}) lie within ${fixed(TOLERANCE_PX, 1)} px of where the surface is seen.`);
}

/** What became of the points, in one sentence for the status line. */
export function summary(state: State): string {
  const shown = shownPair(state);
  if (shown.match === null) return '';
  const codes = leftCodes(shown.left, shown.match, shown.orientation);
  return `${count(shown.match.counts.matches)} matches of ${count(codes.length)} left points`;
}
