/** Tables under the orthophoto: images that were placed, and the links of the chosen one. */
import { Table } from '../../shared/panel/table';
import type { Filter } from '../../shared/state/rows';
import { remember } from '../../shared/state/remember';
import type { BlockStore } from '../engine/engine';
import { linkColumns, placedColumns } from '../state/placed-columns';
import { chosenPlaced } from '../state/showing';
import { placedFiles } from '../state/placed';
import type { PlacedFile } from '../state/placed';
import { unitOfOrthophoto } from '../state/orthophoto-unit';
import type { LengthUnit } from '../state/orthophoto-unit';
import type { Looked } from '../state/placing';
import type { ViewName } from '../state/state';
import { verdictText } from './placing-words';
import { whenInSight } from '../../shared/panel/sight';
import { say } from '../../shared/text/words';

/** A table of the dock that is no table of a block. */
export interface DockTable {
  id: string;
  title: string;
  /** The view to which it belongs. */
  view: ViewName;
  make: (host: HTMLElement) => { draw: () => void };
}

export function placingTables(store: BlockStore): DockTable[] {
  return [
    { id: 'block-placed', title: say('placed-images'), view: 'orthophoto', make: (host) => placedTable(host, store) },
    { id: 'block-links', title: say('links-2'), view: 'orthophoto', make: (host) => linksTable(host, store) },
  ];
}

function placedTable(host: HTMLElement, store: BlockStore): { draw: () => void } {
  let rows: readonly PlacedFile[] = [];
  let filter: Filter = {};
  const lookedAt = (row: number): Looked => ({ image: rows[row]?.file.id ?? null, link: null });
  const table = new Table(host, {
    testid: 'block-placed',
    words: { table: say('placed-images'), region: say('table-placed-images') },
    file: 'placed-images.csv',
    choose: (row) => store.dispatch({ type: 'choosePlaced', looked: lookedAt(row) }),
    point: (row) => store.dispatch({ type: 'pointPlaced', looked: lookedAt(row) }),
    isChosen: (row) => rows[row]?.file.id === store.state.placing.chosen.image,
    filter: (wanted) => {
      filter = wanted;
      draw();
    },
  });
  const columns = remember((shown: readonly PlacedFile[], unit: LengthUnit) => placedColumns(shown, (one) => verdictText(one, store.state), unit));
  const draw = whenInSight(host, () => {
    rows = placedFiles(store.state);
    table.show(rows.length, columns(rows, unitOfOrthophoto(store.state.placing.orthophoto)), undefined, filter);
    table.reveal(rows.findIndex(({ file }) => file.id === store.state.placing.chosen.image));
  });
  store.watch(
    (s) => [s.placing.placed, s.files, s.placing.options, s.placing.heights, s.options.cameras, s.placing.chosen.image] as const,
    () => draw(),
  );
  return { draw };
}

function linksTable(host: HTMLElement, store: BlockStore): { draw: () => void } {
  let filter: Filter = {};
  const lookedAt = (row: number): Looked => ({ image: store.state.placing.chosen.image, link: row < 0 ? null : row });
  const table = new Table(host, {
    testid: 'block-links',
    words: { table: say('links-of-the-chosen-image'), region: say('table-links-of-the-chosen') },
    file: 'links.csv',
    choose: (row) => store.dispatch({ type: 'choosePlaced', looked: lookedAt(row) }),
    point: (row) => store.dispatch({ type: 'pointPlaced', looked: lookedAt(row) }),
    isChosen: (row) => row === store.state.placing.chosen.link,
    filter: (wanted) => {
      filter = wanted;
      draw();
    },
  });
  const columns = remember(linkColumns);
  const draw = whenInSight(host, () => {
    const placed = chosenPlaced(store.state);
    const placement = placed?.result?.placement ?? null;
    table.show(
      placement?.links.count ?? 0,
      placed === null || placement === null ? [] : columns(placement, placed.steps, placed.done, unitOfOrthophoto(store.state.placing.orthophoto)),
      undefined,
      filter,
    );
    table.reveal(store.state.placing.chosen.link ?? -1);
  });
  store.watch(
    (s) => [s.placing.placed, s.placing.chosen, s.files] as const,
    () => draw(),
  );
  return { draw };
}
