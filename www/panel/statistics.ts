/** The table of matches: each with its statistics, sorted by any of them, linked both ways to the images. Only the rows in sight exist. */
import { interiorInUse } from '../state/interior';
import { isStale } from '../state/keys';
import { matchOfLeft, shownPair } from '../state/select';
import { pixelMm } from '../state/residuals';
import { ordered, statisticsOf } from '../state/statistics';
import type { Column, Filter, Order, Statistics } from '../state/statistics';
import type { Side, State } from '../state/state';
import type { Store } from '../state/store';
import { fill, h } from './dom';
import { count, fixed } from './format';

/** Height of a row in CSS px, as in the style sheet. */
const ROW = 24;
/** Rows beyond the ones in sight, so that a scroll shows no gap. */
const MARGIN = 12;

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
  private readonly head = h('thead', {});
  private readonly body = h('tbody', {});
  private readonly scroller: HTMLElement;
  private readonly table = h('table', { testid: 'statistics', class: 'statistics', aria: { label: 'Matches with their statistics' } }, this.head, this.body);
  private order: Order = { key: '', descending: false, filter: 'all' };
  private statistics: Statistics | null = null;
  private rows: Uint32Array = new Uint32Array();

  constructor(host: HTMLElement, private readonly store: Store, private readonly select: (side: Side, index: number) => void) {
    this.scroller = h('div', { class: 'rows', tabindex: 0, role: 'region', aria: { label: 'Table of matches' } }, this.table);
    host.append(h('div', { class: 'statistics-head' }, this.filter, this.caption), this.sideways, this.help, this.scroller);
    this.filter.addEventListener('change', () => { this.sort({ ...this.order, filter: this.filter.value as Filter }); });
    this.scroller.addEventListener('scroll', () => { this.showRows(); });
    new ResizeObserver(() => { this.showRows(); }).observe(this.scroller);
    new ResizeObserver(() => { this.sideways.hidden = this.scroller.scrollWidth <= this.scroller.clientWidth; }).observe(this.table);
    store.watch((s) => [s.results, s.images, s.settings, s.camera, s.photos, s.offset, s.fiducialModel, s.failures] as const, () => { this.update(); });
    store.watch((s) => [s.selection] as const, () => { this.reveal(); });
  }

  private update(): void {
    const { state } = this.store;
    const statistics = statisticsOfState(state);
    this.scroller.classList.toggle('is-stale', isStale(state, 'match') || (shownPair(state).orientation !== null && isStale(state, 'orientation')));
    if (statistics === this.statistics && this.head.hasChildNodes()) return;
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
    for (const cell of this.head.querySelectorAll('th')) {
      const sorted = cell.dataset['key'] === order.key;
      cell.setAttribute('aria-sort', sorted ? (order.descending ? 'descending' : 'ascending') : 'none');
    }
    this.showRows();
  }

  private showHead(): void {
    const { statistics } = this;
    if (statistics === null) {
      fill(this.head);
      return;
    }
    const plain = (text: string) => h('th', { scope: 'col', class: 'word' }, text);
    fill(this.head, h('tr', {}, this.headCell({ key: '', label: 'Match', unit: '', help: 'Number of the match, in the order of its left points.' }),
      ...statistics.columns.map((column) => this.headCell(column)), plain('state'), ...(statistics.rightness === null ? [] : [plain('truth')])));
  }

  private headCell({ key, label, unit, help }: Pick<Column, 'key' | 'label' | 'unit' | 'help'>): HTMLElement {
    const press = h('button', { type: 'button', class: 'sort', testid: `sort-${key}`, title: help }, label, unit === '' ? null : h('span', { class: 'unit' }, ` ${unit}`));
    press.addEventListener('click', () => {
      // The signed figures are looked through for the largest; a second click turns the order round.
      this.sort({ ...this.order, key, descending: this.order.key === key && !this.order.descending });
      fill(this.help, h('b', {}, label), `: ${help}`);
      this.help.hidden = false;
    });
    return h('th', { scope: 'col', key }, press);
  }

  /** Builds the rows in sight between two fillers as high as the others would be. */
  private showRows(): void {
    const { statistics, rows } = this;
    if (statistics === null) {
      fill(this.body);
      return;
    }
    const first = Math.max(0, Math.floor(this.scroller.scrollTop / ROW) - MARGIN);
    const last = Math.min(rows.length, Math.ceil((this.scroller.scrollTop + this.scroller.clientHeight) / ROW) + MARGIN);
    const selected = selectedMatch(this.store.state);
    const seen = Array.from(rows.subarray(first, last), (match) => this.row(statistics, match, match === selected));
    const focused = this.focusedMatch();
    fill(this.body, filler(first), ...seen, filler(rows.length - last));
    if (focused !== null) this.focusMatch(focused);
  }

  /** The match whose button has the keyboard; null where none has. */
  private focusedMatch(): string | null {
    const { activeElement } = document;
    return activeElement instanceof HTMLElement && this.body.contains(activeElement) ? (activeElement.dataset['key'] ?? '') : null;
  }

  /** Gives the keyboard back to a match that was built anew, or to the table where the match is out of sight. */
  private focusMatch(match: string): void {
    (this.body.querySelector<HTMLElement>(`button[data-key="${match}"]`) ?? this.scroller).focus({ preventScroll: true });
  }

  private row(statistics: Statistics, match: number, selected: boolean): HTMLElement {
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
    const place = this.rows.indexOf(selectedMatch(this.store.state));
    if (place >= 0) {
      const top = place * ROW;
      const { scrollTop, clientHeight } = this.scroller;
      if (top < scrollTop || top > scrollTop + clientHeight - 3 * ROW) this.scroller.scrollTop = Math.max(0, top - clientHeight / 2);
    }
    this.showRows();
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

function filler(rows: number): HTMLElement {
  const cell = h('td', { colspan: 20 });
  cell.style.height = `${String(rows * ROW)}px`;
  return h('tr', { class: 'filler', aria: { hidden: 'true' } }, cell);
}
