/** The table of matches: each with its statistics, sorted by any of them, linked both ways to the images. */
import { interiorInUse } from '../state/interior';
import { isStale } from '../state/keys';
import { matchOfLeft, shownPair } from '../state/select';
import { pixelMm } from '../state/residuals';
import { ordered, statisticsOf } from '../state/statistics';
import type { Column, Filter, Order, Statistics } from '../state/statistics';
import type { Side, State } from '../state/state';
import type { Store } from '../state/store';
import { fill, h } from '../../shared/panel/dom';
import { count, fixed } from '../../shared/text/format';
import { RowsInSight, sortHead } from '../../shared/panel/rows';

const FILTERS: readonly (readonly [Filter, string])[] = [['all', 'all matches'], ['used', 'used'], ['rejected', 'gross errors'], ['wrong', 'wrong by the truth']];
const RIGHTNESS = ['wrong', 'at an edge', 'right'];

export function mountStatistics(host: HTMLElement, store: Store, select: (side: Side, index: number) => void): void {
  new StatisticsTable(host, store, select);
}

class StatisticsTable {
  private readonly filter = h('select', { testid: 'statistics-filter', aria: { label: 'Matches to show' } });
  private readonly caption = h('p', { class: 'note', testid: 'statistics-caption' });
  /** More columns than the panel is wide are found by scrolling, which a scrollbar that hides does not tell. */
  private readonly sideways = h('p', { class: 'note', hidden: true, testid: 'statistics-sideways' }, 'Scroll sideways for more columns →');
  private readonly help = h('p', { class: 'help', hidden: true, testid: 'statistics-help' });
  private readonly table = new RowsInSight('statistics', { table: 'Matches with their statistics', region: 'Table of matches' }, (place) => this.row(place));
  private order: Order = { key: '', descending: false, filter: 'all' };
  private statistics: Statistics | null = null;
  private rows: Uint32Array = new Uint32Array();

  constructor(host: HTMLElement, private readonly store: Store, private readonly select: (side: Side, index: number) => void) {
    const { scroller } = this.table;
    host.append(h('div', { class: 'statistics-head' }, this.filter, this.caption), this.sideways, this.help, scroller);
    this.filter.addEventListener('change', () => { this.sort({ ...this.order, filter: this.filter.value as Filter }); });
    new ResizeObserver(() => { this.sideways.hidden = scroller.scrollWidth <= scroller.clientWidth; }).observe(this.table.head);
    store.watch((s) => [s.results, s.images, s.settings, s.camera, s.photos, s.offset, s.fiducialModel, s.failures] as const, () => { this.update(); });
    store.watch((s) => [s.selection] as const, () => { this.reveal(); });
  }

  private update(): void {
    const { state } = this.store;
    const statistics = statisticsOfState(state);
    this.table.scroller.classList.toggle('is-stale', isStale(state, 'match') || (shownPair(state).orientation !== null && isStale(state, 'orientation')));
    if (statistics === this.statistics && this.table.head.hasChildNodes()) return;
    this.statistics = statistics;
    fill(this.filter, ...FILTERS.filter(([value]) => value !== 'wrong' || statistics?.rightness != null).map(([value, text]) => new Option(text, value)));
    if (this.order.filter === 'wrong' && statistics?.rightness == null) this.order = { ...this.order, filter: 'all' };
    this.filter.value = this.order.filter;
    this.showHead();
    this.sort(this.order);
  }

  private sort(order: Order): void {
    this.order = order;
    this.rows = this.statistics === null ? new Uint32Array() : ordered(this.statistics, order);
    const { statistics } = this;
    fill(this.caption, statistics === null ? 'No matches yet.' : `${count(this.rows.length)} of ${count(statistics.count)} matches`);
    this.table.markOrder(order.key, order.descending);
    this.table.show(this.rows.length);
  }

  private showHead(): void {
    const { statistics } = this;
    if (statistics === null) {
      fill(this.table.head);
      return;
    }
    const plain = (text: string) => h('th', { scope: 'col', class: 'word' }, text);
    fill(this.table.head, h('tr', {}, this.headCell({ key: '', label: 'Match', unit: '', help: 'Number of the match, in the order of its left points.' }),
      ...statistics.columns.map((column) => this.headCell(column)), plain('state'), ...(statistics.rightness === null ? [] : [plain('truth')])));
  }

  private headCell(column: Pick<Column, 'key' | 'label' | 'unit' | 'help'>): HTMLElement {
    const { key, label, help } = column;
    return sortHead(column, () => {
      // The signed figures are looked through for the largest; a second click turns the order round.
      this.sort({ ...this.order, key, descending: this.order.key === key && !this.order.descending });
      fill(this.help, h('b', {}, label), `: ${help}`);
      this.help.hidden = false;
    });
  }

  private row(place: number): HTMLElement {
    const { statistics } = this;
    const match = this.rows[place];
    if (statistics === null || match === undefined) return h('tr', {});
    const selected = match === selectedMatch(this.store.state);
    const go = h('button', { type: 'button', class: 'link', key: String(match), aria: { label: `Select match ${String(match + 1)}` } }, count(match + 1));
    const line = h('tr', { class: selected ? 'best' : '', testid: selected ? 'statistics-selected' : 'statistics-row' }, h('td', {}, go),
      ...statistics.columns.map(({ value, digits }) => h('td', { class: 'number' }, fixed(value(match), digits))),
      h('td', {}, statistics.rejected[match] === 1 ? 'gross error' : 'used'),
      ...(statistics.rightness === null ? [] : [h('td', {}, RIGHTNESS[statistics.rightness[match] ?? 0] ?? '')]));
    line.addEventListener('click', () => {
      const left = shownPair(this.store.state).match?.indices[2 * match];
      if (left !== undefined) this.select('left', left);
    });
    return line;
  }

  /** Brings the selected match into sight. */
  private reveal(): void {
    this.table.reveal(this.rows.indexOf(selectedMatch(this.store.state)));
  }
}

function statisticsOfState(state: State): Statistics | null {
  const { match, orientation } = shownPair(state);
  if (match === null || match.counts.matches === 0) return null;
  const interior = interiorInUse(state)?.left;
  return statisticsOf(match, orientation, state.results.score?.value ?? null, interior === undefined ? null : pixelMm(interior));
}

/** The match of the selected point; -1 where it has none. */
function selectedMatch(state: State): number {
  const { match } = shownPair(state);
  const { selection } = state;
  if (match === null || selection === null) return -1;
  if (selection.side === 'left') return matchOfLeft(match)[selection.index] ?? -1;
  return match.indices.findIndex((index, i) => i % 2 === 1 && index === selection.index) >> 1;
}
