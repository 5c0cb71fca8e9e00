/** The pair's part of the page: makes its parts and wires them together. */
import './style/pair.css';
import type { Catalogue } from '../shared/crate';
import type { Taker } from '../shared/files/drop';
import type { Keepable } from '../shared/files/keepable';
import { byId } from '../shared/panel/dom';
import { showTab, tabbed } from '../shared/panel/tabs';
import { readable } from '../shared/text/names';
import { Engine } from './engine/engine';
import { fitted } from './engine/fit';
import { KeptPairs } from './files/keep';
import { Files, takerOf } from './files/open';
import { mountAnnouncements } from './panel/announce';
import { mountCamera } from './panel/camera';
import { mountControls } from './panel/controls';
import { mountCounts } from './panel/counts';
import { mountDraft } from './panel/draft';
import { mountEditKeys, mountEdits, mountEditTools } from './panel/edits';
import { mountFiducials } from './panel/fiducials';
import { mountGeometry } from './panel/geometry';
import { mountHeader, pickerOf } from './panel/header';
import { mountHistograms } from './panel/histograms';
import { mountOrientation } from './panel/orientation';
import { mountPanes } from './panel/panes';
import { mountPoint } from './panel/point';
import { mountSimulate } from './panel/simulate';
import { mountStatistics } from './panel/statistics';
import { mountStatus } from './panel/status';
import { mountToolbar } from './panel/toolbar';
import { Editing } from './state/editing';
import { Store } from './state/store';
import { mountInput } from './view/input';
import { Navigator } from './view/navigate';
import { View } from './view/view';
import { messageOf } from '../shared/text/format';

export interface Pair {
  store: Store;
  engine: Engine;
  /** What of it is kept in the browser's storage. */
  kept: Keepable;
  /** Takes files from now on. */
  begin: () => void;
  taker: Taker;
  /** Opens a pair that was saved. */
  open: (file: File) => Promise<void>;
}

/** `openProject` opens a project of whatever kind where it belongs; `toBlock` takes more images than a pair has; `putAside` leaves a pair in the list of projects. */
export function mountPair(
  catalogue: Catalogue,
  openProject: (file: File) => Promise<void>,
  toBlock: (files: readonly File[], masks: readonly File[]) => void,
  putAside: (pair: Keepable) => Promise<boolean>,
): Pair {
  const store = new Store();
  const {
    element: left,
    panels: [settings, camera, simulate],
  } = tabbed('Settings', [
    ['settings', 'Settings'],
    ['camera', 'Camera'],
    ['simulate', 'Simulate'],
  ]);
  const {
    element: right,
    panels: [results, point, matches],
  } = tabbed('Results', [
    ['results', 'Results'],
    ['point', 'Point'],
    ['matches', 'Matches'],
  ]);
  byId('stage').before(left);
  byId('stage').after(right);
  const engine = new Engine(store);
  const view = new View(byId('view'), store, engine);
  const navigator = new Navigator(store, view);
  const kept = new KeptPairs(store, engine, catalogue);
  const files = new Files(store, engine, openProject, toBlock, () => putAside(kept));
  /** Runs an action of the user's; what goes wrong is said in the status line. */
  const attempt = async (action: () => void | Promise<void>) => {
    try {
      await action();
    } catch (error) {
      store.dispatch({ type: 'notice', notice: { kind: 'problem', text: `${readable(store.state.catalogue, messageOf(error))}.` } });
    }
  };

  const editing = new Editing(store, (left, right) => fitted(store.state, engine, left, right));
  mountInput(view, store, navigator, editing);
  mountToolbar(byId('toolbar'), store, navigator);
  mountEditTools(byId('toolbar'), store, editing);
  mountDraft(byId('toolbar'), store, editing, () => navigator.followDraft());
  const pick = pickerOf(files);
  mountPanes(view, store, {
    open: (side) => pick(side),
    mask: (side) => pick(side, 'mask'),
    unmask: (side) => store.dispatch({ type: 'mask', side, mask: null }),
  });
  mountControls(settings, store);
  mountCamera(camera, store, () => pick(null));
  mountFiducials(camera, store, (side) => pick(side));
  mountCounts(results, store);
  mountGeometry(results, store);
  mountOrientation(results, store);
  mountHistograms(results, store);
  mountPoint(point, store, (side, index) => navigator.select({ side, index }));
  mountEdits(matches, store, editing, () => navigator.followDraft());
  mountEditKeys(matches, store, editing);
  mountStatistics(matches, store, editing, (side, index) => navigator.select({ side, index }));
  mountSimulate(simulate, store, engine, (name, flight) => void attempt(() => files.takeFlight(name, flight)));
  mountAnnouncements(byId('announce'), store);
  mountStatus(store, {
    cancel: () => engine.cancel(),
    run: () => store.dispatch({ type: 'resume' }),
  });
  mountHeader({ store, engine, view, files, pick, attempt });
  store.watch(['selection'], ([selection]) => {
    // The table of matches shows the selected one itself, and is gone through by selecting.
    if (selection !== null && matches.hidden) showTab('tab-point');
  });
  return {
    store,
    engine,
    kept,
    begin: () => files.begin(),
    taker: takerOf(view, files),
    open: (file) => files.takeProject(file),
  };
}
