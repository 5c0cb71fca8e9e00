/** The tables of a block, under its views: what is chosen in one is chosen in all, and a choice elsewhere is brought into sight. */
import { toggle } from '../../shared/panel/choice';
import { h } from '../../shared/panel/dom';
import { isOpen, watchDrawers } from '../../shared/panel/drawers';
import { declareLack } from '../../shared/panel/lack';
import { sidewaysNote, watchSideways } from '../../shared/panel/sideways';
import { isHidden, whenInSight } from '../../shared/panel/sight';
import { tabbed } from '../../shared/panel/tabs';
import { Table } from '../../shared/panel/table';
import { keepChoice, keptChoice } from '../../shared/choices';
import type { BlockStore } from '../engine/engine';
import type { Facts } from '../engine/facts';
import { choiceOfRow, keptBy, NO_ROWS, observationRows, observationsOf, rowsOf, rowsOfChoice } from '../state/columns';
import type { Rows, Tabled } from '../state/columns';
import { among, observationsIn, withMoreObservations } from '../state/observations';
import { blockOnOrthophoto } from '../state/showing';
import { isSame, pairsOf, pointsOf, withMore, withMoreImages, withMorePairs } from '../state/selection';
import type { Choice, Selection, Subject } from '../state/selection';
import type { Listed } from '../state/state';
import type { Looking } from '../view/looking';
import type { DockTable } from './placing-tables';
import { say } from '../../shared/text/words';
import { lackOfBlock } from '../state/lacks';

const TABLES: readonly (readonly [Subject, string])[] = [
  ['images', say('images-2')],
  ['pairs', say('pairs')],
  ['points', say('points')],
  ['observations', say('observations')],
  ['surveyed', say('control-and-check-points')],
];

const HEIGHT = 'tiepoint-dock';
const TAB = 'tiepoint-table';
/** A step of the splitter by keys, and how low and high the tables may be, CSS px. */
const STEP = 24;
const LEAST = 170;
/** So much of the stage is left to the picture. */
const ABOVE = 240;

/** Makes the tables; they are opened by the button of the drawer `table`. `others`: tables of a view that shows no block. */
export function makeDock(store: BlockStore, looking: Looking, facts: Facts, others: readonly DockTable[]): HTMLElement {
  const sources = TABLES.map(([subject, title]) => (subject === 'observations' ? observationSource(facts, () => draw()) : sourceOf(subject, title)));
  const { element, panels } = tabbed('dock', say('tables'), [
    ...sources.map(({ subject, title }) => [`block-${subject}`, title] as const),
    ...others.map(({ id, title }) => [id, title] as const),
  ]);
  element.prepend(splitter(element));
  declareLack(panels.slice(0, sources.length), () => lackOfBlock(store.state));
  const tables = sources.map((source, i) => oneTable(panels[i] ?? element, store, looking, facts, source));
  const further = others.map((other, i) => other.make(panels[sources.length + i] ?? element));
  const draw = () => {
    for (const table of [...tables, ...further]) table.draw();
  };
  /** Another table comes up, since the one that was chosen is not of this view. */
  let isFallback = false;
  element.addEventListener('click', (event) => {
    const tab = (event.target as Element).closest('[role="tab"]');
    if (tab === null) return;
    if (!isFallback) keepChoice(TAB, tab.id);
    draw();
  });
  // Observations have come.
  facts.watch(() => {
    for (const table of tables) table.refresh();
  });
  watchDrawers(() => {
    // The button of the drawer, which hides the tables, is told after them.
    if (isOpen('table')) queueMicrotask(draw);
  });
  const tabs = [...element.querySelectorAll<HTMLElement>('[role="tab"]')];
  store.watch(
    (s) => [s.shown, s.onStage, blockOnOrthophoto(s) !== null] as const,
    ([shown, onStage, isBlockOn]) => {
      const own = others.map(({ view }) => view);
      // Over the orthophoto the block is looked at as in its other views, where it lies there.
      const isOwn = own.includes(onStage) && !isBlockOn;
      tabs.forEach((tab, i) => {
        const view = own[i - sources.length];
        tab.hidden =
          view === undefined
            ? isOwn || (sources[i]?.subject === 'surveyed' && (shown?.view.surveyed.length ?? 0) + (shown?.given.length ?? 0) === 0)
            : !isOwn || view !== onStage;
      });
      // The tables of another view are not what is looked at; the one that was chosen last comes again with its own.
      const selected = tabs.find((tab) => tab.getAttribute('aria-selected') === 'true');
      const seen = tabs.filter((tab) => !tab.hidden);
      const wanted = seen.find(({ id }) => id === keptChoice(TAB)) ?? (selected?.hidden === true ? seen[0] : selected);
      if (wanted === selected) return;
      isFallback = true;
      wanted?.click();
      isFallback = false;
    },
  );
  return element;
}

/** What a table shows, and what its rows are about. */
interface Source {
  subject: Subject;
  title: string;
  rows: (shown: Listed) => Rows;
  /** Tells the rows that are shown beside what the filter says. */
  keeps: (shown: Listed, selection: Selection) => ((row: number) => boolean) | undefined;
  choice: (shown: Listed, row: number) => Choice | null;
  /** The rows that a choice is about. */
  chosen: (shown: Listed, choice: Choice | null) => { has: (row: number) => boolean; first: number };
  /** What stands over the table. */
  tools?: readonly HTMLElement[];
}

function sourceOf(subject: Tabled, title: string): Source {
  return {
    subject,
    title,
    rows: (shown) => rowsOf(subject, shown),
    keeps: ({ view }, selection) => (subject === 'pairs' ? keptBy(subject, view, selection) : undefined),
    choice: (shown, row) => choiceOfRow(subject, shown, row),
    chosen: (shown, choice) => {
      const rows = rowsOfChoice(subject, shown, choice);
      // Asked of the rows in sight alone: of many thousands a set takes longer.
      return { has: (row) => rows.includes(row), first: rows[0] ?? -1 };
    },
  };
}

/** Observations are asked of the block's worker when their table is looked at. */
function observationSource(facts: Facts, redraw: () => void): Source {
  let only = false;
  const press = toggle(say('of-what-is-chosen'), 'block-observations-only', say('shows-the-observations-of-the'), (on) => {
    only = on;
    press.setAttribute('aria-pressed', String(on));
    redraw();
  });
  return {
    subject: 'observations',
    title: say('observations'),
    rows: ({ view }) => {
      const of = facts.observations();
      return of === null ? NO_ROWS : observationRows(view, of);
    },
    keeps: (_, { chosen }) => {
      const of = facts.observations();
      return of === null || !only ? undefined : observationsOf(of, chosen);
    },
    choice: (_, row) => {
      const of = facts.observations();
      const [point, image] = [of?.points[row], of?.images[row]];
      return point === undefined || image === undefined ? null : { kind: 'observation', point, image };
    },
    chosen: (_, choice) => {
      const of = facts.observations();
      // All observations of an image would be too many to stand out.
      if (of === null || choice === null || pointsOf(choice).length === 0) return { has: () => false, first: -1 };
      const ofPoints = observationsOf(of, choice);
      const isOne = choice.kind === 'observation' || choice.kind === 'observations' ? among(observationsIn(choice)) : null;
      const has = isOne === null ? ofPoints : (row: number) => isOne(of.points[row] ?? -1, of.images[row] ?? -1);
      return { has, first: of.points.findIndex((_, row) => has(row)) };
    },
    tools: [press],
  };
}

function oneTable(host: HTMLElement, store: BlockStore, looking: Looking, facts: Facts, source: Source): { draw: () => void; refresh: () => void } {
  const { subject, title, tools = [] } = source;
  const ofRow = (row: number): Choice | null => {
    const { shown } = store.state;
    return shown === null || row < 0 ? null : source.choice(shown, row);
  };
  const isInBlock = (row: number) => row < (store.state.shown?.view.images.length ?? 0);
  /** What was chosen here last: that is in sight. */
  let own: Choice | null = null;
  /** What is chosen is still to be brought into sight. */
  let seeks = false;
  let chosen: ReturnType<Source['chosen']> = { has: () => false, first: -1 };
  const choose = (choice: Choice | null) => {
    own = choice;
    looking.choose(choice);
  };
  const sideways = sidewaysNote(`block-${subject}-sideways`);
  const table = new Table(host, {
    testid: `block-${subject}`,
    words: { table: title, region: say('table', { title }) },
    file: `block-${subject}.csv`,
    ...(subject === 'points' ? { order: 'point' } : {}),
    tools: [sideways, ...tools],
    point: (row) => looking.point(ofRow(row)),
    filter: (filter) => store.dispatch({ type: 'filter', subject, filter }),
    choose: (row) => choose(ofRow(row)),
    isChosen: (row) => chosen.has(row),
    ...(subject === 'points' ? { chooseMore: (rows) => choose(withMore(store.state.selection.chosen, rows)) } : {}),
    ...(subject === 'observations'
      ? {
          chooseMore: (rows) => {
            const of = facts.observations();
            const more = { points: Uint32Array.from(rows, (row) => of?.points[row] ?? 0), images: Uint32Array.from(rows, (row) => of?.images[row] ?? 0) };
            if (of !== null) choose(withMoreObservations(store.state.selection.chosen, more));
          },
        }
      : {}),
    ...(subject === 'pairs'
      ? {
          chooseMore: (rows) =>
            choose(
              withMorePairs(
                store.state.selection.chosen,
                rows.flatMap((row) => pairsOf(ofRow(row))),
              ),
            ),
        }
      : {}),
    ...(subject === 'images' ? { chooseMore: (rows) => choose(withMoreImages(store.state.selection.chosen, rows.filter(isInBlock))) } : {}),
  });
  watchSideways(sideways, table);
  let shownRows = NO_ROWS;
  const draw = whenInSight(host, () => {
    const { shown, selection } = store.state;
    shownRows = shown === null ? NO_ROWS : source.rows(shown);
    table.show(shownRows.count, shownRows.columns, shown === null ? undefined : source.keeps(shown, selection), selection.filters[subject]);
    mark();
  });
  const mark = () => {
    const { shown, selection } = store.state;
    if (shown !== null) chosen = source.chosen(shown, selection.chosen);
    if (seeks && shown !== null) table.reveal(chosen.first);
    else table.redraw();
    seeks = false;
  };
  store.watch(
    (s) => [s.shown, s.selection.filters[subject], subject === 'pairs' ? s.selection.filters.images : null] as const,
    () => draw(),
  );
  store.watch(
    (s) => [s.selection.chosen] as const,
    ([now]) => {
      seeks = now !== null && !isSame(now, own);
      own = null;
      if (subject === 'observations' || isHidden(host)) draw();
      else mark();
    },
  );
  /** Draws it where its rows are others; rows out of sight are not asked for. */
  const refresh = () => {
    const { shown } = store.state;
    if (isHidden(host) || (shown !== null && source.rows(shown) !== shownRows)) draw();
  };
  return { draw, refresh };
}

/** The line between picture and tables, which is dragged, or moved by arrow keys. */
function splitter(dock: HTMLElement): HTMLElement {
  const line = h('div', {
    class: 'splitter',
    role: 'separator',
    tabindex: 0,
    testid: 'block-splitter',
    aria: { orientation: 'horizontal', label: say('height-of-the-tables') },
  });
  const kept = Number(keptChoice(HEIGHT));
  const highest = () => Math.max(LEAST, (dock.parentElement?.clientHeight ?? Infinity) - ABOVE);
  const tell = () => {
    for (const [name, value] of [
      ['min', LEAST],
      ['max', highest()],
      ['now', dock.clientHeight],
    ] as const)
      line.setAttribute(`aria-value${name}`, String(Math.round(value)));
  };
  const set = (wanted: number) => {
    const height = Math.round(Math.min(highest(), Math.max(LEAST, wanted)));
    dock.style.height = `${String(height)}px`;
    tell();
    keepChoice(HEIGHT, String(height));
  };
  if (kept > 0) dock.style.height = `${String(kept)}px`;
  // Also where the window or the drawers change it.
  new ResizeObserver(tell).observe(dock);
  line.addEventListener('pointerdown', (event) => {
    const [from, height] = [event.clientY, dock.clientHeight];
    line.setPointerCapture(event.pointerId);
    const move = (moved: PointerEvent) => set(height + from - moved.clientY);
    line.addEventListener('pointermove', move);
    line.addEventListener('lostpointercapture', () => line.removeEventListener('pointermove', move), { once: true });
  });
  line.addEventListener('keydown', (event) => {
    const by = { ArrowUp: STEP, ArrowDown: -STEP }[event.key];
    if (by === undefined) return;
    event.preventDefault();
    set(dock.clientHeight + by);
  });
  return line;
}
