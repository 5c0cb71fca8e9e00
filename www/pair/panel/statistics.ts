/** The table of matches: each with its statistics, sorted by any of them, linked both ways to the images. */
import { button, fill, h } from '../../shared/panel/dom';
import { afterFrame } from '../../shared/engine/breath';
import { whenInSight } from '../../shared/panel/sight';
import { Table } from '../../shared/panel/table';
import type { Column } from '../../shared/state/rows';
import { count } from '../../shared/text/format';
import type { MatchResult } from '../../shared/crate';
import { chosenLefts } from '../state/choice';
import { BY_HAND, GROSS_ERROR, MANUAL } from '../state/codes';
import type { Editing } from '../state/editing';
import { interiorInUse } from '../state/interior';
import { isStale } from '../state/keys';
import { pixelMm } from '../state/residuals';
import { shownPair } from '../state/select';
import { leftIndexOf } from '../state/selected';
import type { Side, State } from '../state/state';
import { isKept, statisticsOf } from '../state/statistics';
import type { Filter, Statistics } from '../state/statistics';
import type { Store } from '../state/store';
import { say } from '../../shared/text/words';

const FILTERS: readonly (readonly [Filter, string])[] = [
  ['all', say('all-matches')],
  ['used', say('used')],
  ['rejected', say('gross-errors')],
  ['by-hand', say('by-hand')],
  ['wrong', say('wrong-by-the-truth')],
];
/** What became of a match, in a word. */
const STATES: Readonly<Record<number, string>> = { [GROSS_ERROR]: say('gross-error'), [BY_HAND]: say('rejected-by-hand-2'), [MANUAL]: say('by-hand') };
const RIGHTNESS = [say('wrong'), say('at-an-edge'), say('correct')];

export function mountStatistics(host: HTMLElement, store: Store, editing: Editing, select: (side: Side, index: number) => void): void {
  const filter = h('select', { testid: 'statistics-filter', aria: { label: say('matches-to-show') } });
  const caption = h('p', { class: 'note', testid: 'statistics-caption' });
  // More columns than the panel is wide are found by scrolling, which a scrollbar that hides does not tell.
  const sideways = h('p', { class: 'note', hidden: true, testid: 'statistics-sideways' }, say('scroll-sideways-for-more-columns'));
  const all = button(say('choose-all'), 'choose-listed', () => chooseListed(), say('choose-the-matches-that-the'));
  host.append(h('div', { class: 'statistics-head' }, filter, caption, all), sideways);
  const table = new Table(host, {
    testid: 'statistics',
    words: { table: say('matches-with-their-statistics'), region: say('table-of-matches') },
    choose: (match) => {
      const left = statistics?.lefts[match];
      editing.chooseNone();
      if (left !== undefined) select('left', left);
    },
    chooseMore: (rows) => editing.chooseLefts(leftsOf(rows)),
    isChosen: (match) => chosen.has(statistics?.lefts[match] ?? -1),
  });
  new ResizeObserver(() => {
    sideways.hidden = table.scroller.scrollWidth <= table.scroller.clientWidth;
  }).observe(table.head);

  let chosen: ReadonlySet<number> = new Set();
  let statistics: Statistics | null = null;
  /** The matches that they are of, without edits. */
  let found: MatchResult | null = null;
  let columns: readonly Column[] = [];
  const leftsOf = (rows: Iterable<number>) => [...rows].flatMap((row) => statistics?.lefts[row] ?? []);
  const chooseListed = () => {
    editing.chooseNone();
    editing.chooseLefts(leftsOf(table.listed));
  };
  const show = () => {
    const shown = table.show(statistics?.count ?? 0, columns, (match) => statistics !== null && isKept(statistics, filter.value as Filter, match));
    all.disabled = shown === 0;
    fill(caption, statistics === null ? say('no-matches-yet') : say('of-matches', { shown, count: statistics.count }));
  };
  filter.addEventListener('change', show);
  const follow = () => {
    const { state } = store;
    table.scroller.classList.toggle('is-stale', isStale(state, 'match') || (shownPair(state).orientation !== null && isStale(state, 'orientation')));
    const now = statistics !== null && isAwaited(state, found) ? statistics : statisticsOfState(state);
    const lefts = chosenLefts(state);
    const isOther = lefts.length !== chosen.size || !lefts.every((left) => chosen.has(left));
    if (isOther) chosen = new Set(lefts);
    if (now !== statistics || filter.options.length === 0) {
      statistics = now;
      found = shownPair(state).edited?.found ?? null;
      columns = now === null ? [] : columnsOf(now);
      const { value } = filter;
      const offered = FILTERS.filter(([kind]) => kind !== 'wrong' || now?.rightness != null);
      if (filter.options.length !== offered.length) fill(filter, ...offered.map(([kind, text]) => new Option(text, kind, false, kind === value)));
      show();
    } else if (isOther) table.redraw();
    table.mark(selectedMatch(state, statistics));
  };
  const seen = whenInSight(host, follow);
  store.watch(['selection', 'chosen'], seen);
  // The figures of the orientation come first: rows take as long as they do, and change with several of these.
  store.watch(['results', 'running', 'history', 'images', 'settings', 'camera', 'photos', 'offset', 'fiducialModel', 'failures'], afterFrame(seen));
}

function columnsOf({ columns, codes, rightness }: Statistics): Column[] {
  const word = (key: string, label: string, help: string, text: (match: number) => string): Column => ({
    key,
    label,
    unit: '',
    help,
    value: text,
    text,
    words: true,
  });
  return [
    {
      key: '',
      label: say('match-2'),
      unit: '',
      help: say('number-of-the-match-in'),
      value: (match) => match,
      text: (match) => count(match + 1),
    },
    ...columns,
    word('state', say('state-2'), say('whether-the-adjustment-used-the'), (match) => STATES[codes[match] ?? 0] ?? say('used')),
    ...(rightness === null ? [] : [word('truth', say('truth'), say('whether-the-match-is-right'), (match) => RIGHTNESS[rightness[match] ?? 0] ?? '')]),
  ];
}

function statisticsOfState(state: State): Statistics | null {
  const { left, match, orientation, edited } = shownPair(state);
  if (match === null || edited?.found.counts.matches === 0) return null;
  const interior = interiorInUse(state)?.left;
  return statisticsOf(left, match, orientation, state.results.score?.value ?? null, interior === undefined ? null : pixelMm(interior));
}

/** Whether the figures of edited matches are under way: their rows come with these, which rows without them would keep waiting. */
function isAwaited(state: State, found: MatchResult | null): boolean {
  const { edited } = shownPair(state);
  const { orientation, score } = state.running;
  return (orientation !== undefined || score !== undefined) && edited !== null && edited.found === found;
}

/** The match of the selected point; -1 where it has none. */
function selectedMatch(state: State, statistics: Statistics | null): number {
  const { match } = shownPair(state);
  if (match === null || statistics === null || state.selection === null) return -1;
  return statistics.lefts.indexOf(leftIndexOf(state, match.best, match.rules));
}
