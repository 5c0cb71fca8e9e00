/** The table of matches: each with its statistics, sorted and filtered by any of them, linked both ways to the images. */
import { button, fill, h } from '../../shared/panel/dom';
import { afterFrame } from '../../shared/engine/breath';
import { sidewaysNote, watchSideways } from '../../shared/panel/sideways';
import { whenInSight } from '../../shared/panel/sight';
import { Table } from '../../shared/panel/table';
import type { MatchResult } from '../../shared/crate';
import { chosenLefts } from '../state/choice';
import type { Editing } from '../state/editing';
import { isStale } from '../state/keys';
import { columnsOf, isOf, kindOf } from '../state/listed';
import { shownPair } from '../state/select';
import { leftIndexOf } from '../state/selected';
import { ALL_MATCHES } from '../state/state';
import type { MatchFilter, MatchKind, Side, State } from '../state/state';
import { statisticsOfState } from '../state/statistics';
import type { Statistics } from '../state/statistics';
import type { Store } from '../state/store';
import { say } from '../../shared/text/words';

const KINDS: readonly (readonly [MatchKind, string])[] = [
  ['all', say('all-matches')],
  ['used', say('used')],
  ['rejected', say('gross-errors')],
  ['by-hand', say('by-hand')],
  ['wrong', say('wrong-by-the-truth')],
];

export function mountStatistics(host: HTMLElement, store: Store, editing: Editing, select: (side: Side, index: number) => void): void {
  const kinds = h('select', { testid: 'statistics-filter', aria: { label: say('matches-to-show') } });
  const all = button(say('choose-all'), 'choose-listed', () => chooseListed(), say('choose-the-matches-that-the'));
  const filterBy = (filter: Partial<MatchFilter>) => store.dispatch({ type: 'filter', filter: { ...store.state.filter, ...filter } });
  kinds.addEventListener('change', () => filterBy({ kind: kinds.value as MatchKind }));
  const table = new Table(host, {
    testid: 'statistics',
    words: { table: say('matches-2'), region: say('table-of-matches') },
    file: 'pair-matches.csv',
    tools: [kinds, all],
    filter: (conditions) => filterBy({ conditions }),
    showAll: () => filterBy(ALL_MATCHES),
    choose: (match) => {
      const left = statistics?.lefts[match];
      editing.chooseNone();
      if (left !== undefined) select('left', left);
    },
    chooseMore: (rows) => editing.chooseLefts(leftsOf(rows)),
    isChosen: (match) => chosen.has(statistics?.lefts[match] ?? -1),
  });
  const sideways = sidewaysNote('statistics-sideways');
  table.scroller.before(sideways);
  watchSideways(sideways, table);

  let chosen: ReadonlySet<number> = new Set();
  let statistics: Statistics | null = null;
  /** The matches that they are of, without edits. */
  let found: MatchResult | null = null;
  /** What the rows are filtered by. */
  let filter: MatchFilter | null = null;
  const leftsOf = (rows: Iterable<number>) => [...rows].flatMap((row) => statistics?.lefts[row] ?? []);
  const chooseListed = () => {
    editing.chooseNone();
    editing.chooseLefts(leftsOf(table.listed));
  };
  const show = (now: Statistics | null, wanted: MatchFilter) => {
    [statistics, filter] = [now, wanted];
    const offered = KINDS.filter(([kind]) => kind !== 'wrong' || now?.rightness != null);
    if (kinds.options.length !== offered.length) fill(kinds, ...offered.map(([kind, text]) => new Option(text, kind)));
    const kind = kindOf(now, wanted);
    kinds.value = kind;
    const keeps = (match: number) => now !== null && isOf(now, kind, match);
    const shown = table.show(now?.count ?? 0, now === null ? [] : columnsOf(now), keeps, wanted.conditions);
    all.disabled = shown === 0;
  };
  const follow = () => {
    const { state } = store;
    table.scroller.classList.toggle('is-stale', isStale(state, 'match') || (shownPair(state).orientation !== null && isStale(state, 'orientation')));
    const now = statistics !== null && isAwaited(state, found) ? statistics : statisticsOfState(state);
    const lefts = chosenLefts(state);
    const isOther = lefts.length !== chosen.size || !lefts.every((left) => chosen.has(left));
    if (isOther) chosen = new Set(lefts);
    if (now !== statistics || state.filter !== filter) {
      if (now !== statistics) found = shownPair(state).edited?.found ?? null;
      show(now, state.filter);
    } else if (isOther) table.redraw();
    table.mark(selectedMatch(state, statistics));
  };
  const seen = whenInSight(host, follow);
  store.watch(['selection', 'chosen', 'filter'], seen);
  // The figures of the orientation come first: rows take as long as they do, and change with several of these.
  store.watch(['results', 'running', 'history', 'images', 'settings', 'camera', 'photos', 'offset', 'fiducialModel', 'failures'], afterFrame(seen));
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
