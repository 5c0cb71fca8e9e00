/** The pair's part of the page: makes its parts and wires them together. */
import type { Catalogue } from '../shared/crate';
import type { FoundFile, Taker } from '../shared/files/drop';
import type { Keepable } from '../shared/files/keepable';
import type { Here } from '../shared/files/leaving';
import { byId, h } from '../shared/panel/dom';
import { drawerButton, reveal, setDrawer, uncoverPictures } from '../shared/panel/drawers';
import { makeNear } from '../shared/panel/near';
import { declareLack } from '../shared/panel/lack';
import { readSetting, withSetting } from '../shared/panel/settings';
import { showTab, tabbed } from '../shared/panel/tabs';
import { sentence } from '../shared/text/format';
import { readable } from '../shared/text/names';
import { Engine } from './engine/engine';
import { breath } from '../shared/engine/breath';
import { fitted } from './engine/fit';
import { KeptPairs } from './files/keep';
import { Files } from './files/open';
import { takerOf } from './files/taker';
import { paintedMask } from './files/painted';
import { exportProject } from './files/project';
import { shownPair } from './state/select';
import { SIDES } from './state/state';
import { mountAnnouncements } from './panel/announce';
import { useCalibration } from './panel/calibration';
import { focusFocalLength, mountCamera } from './panel/camera';
import { mountControls } from './panel/controls';
import { mountCounts } from './panel/counts';
import { mountDraft } from './panel/draft';
import { mountEditKeys, mountEdits, mountEditTools } from './panel/edits';
import { mountFiducials } from './panel/fiducials';
import { mountGeometry } from './panel/geometry';
import { mountHeader, pickerOf } from './panel/header';
import type { Saving } from './panel/header';
import { mountHistory } from './panel/history';
import { mountHistograms } from './panel/histograms';
import { mountMarking } from './panel/marking';
import { mountMasking } from './panel/masking';
import { mountOrientation } from './panel/orientation';
import { mountPanes } from './panel/panes';
import { mountPoint } from './panel/point';
import { mountSimulate } from './panel/simulate';
import { mountStatistics } from './panel/statistics';
import { mountStatus } from './panel/status';
import { mountToolbar } from './panel/toolbar';
import { lackOfMatches } from './state/choice';
import { Editing } from './state/editing';
import { Marking } from './state/marking';
import { Masking } from './state/masking';
import type { Side } from './state/state';
import { Store } from './state/store';
import { mountInput } from './view/input';
import { Navigator } from './view/navigate';
import { View } from './view/view';
import { say } from '../shared/text/words';
import { messageOf } from '../shared/text/messages';

export interface Pair {
  store: Store;
  engine: Engine;
  /** What of it is kept in the browser's storage. */
  kept: Keepable;
  /** Begins to measure fiducial marks in the image of a side, or ends it where they are measured there. */
  measureMarks: (side: Side) => void;
  /** Takes files from now on. */
  begin: () => void;
  taker: Taker;
  /** Opens a pair that was saved. */
  open: (file: File) => Promise<void>;
  /** Saves the pair as a project file. `near`: the `data-testid` of the button, beside which a refusal is said. */
  save: (near: string) => Promise<void>;
}

/** What the page does for the pair outside it. */
export interface Elsewhere {
  /** Opens a project of whatever kind where it belongs. */
  openProject: (file: File) => Promise<void>;
  /** Takes more images than a pair has. */
  toBlock: (files: readonly File[], masks: readonly File[]) => void;
  /** Takes photographs with the orthophoto or the heights that they are to be placed by; false where there are none among the files. */
  toGround: (found: FoundFile[]) => Promise<boolean>;
  /** Photographs a block and runs it. */
  sampleBlock: () => void;
  /** Leaves a pair in the list of projects. */
  putAside: (pair: Keepable) => Promise<boolean>;
  /** Waits for the project that is being left. */
  left: () => Promise<Here>;
}

/** In pieces, between which the page answers what the user does. */
export async function mountPair(catalogue: Catalogue, { openProject, toBlock, toGround, sampleBlock, putAside, left: projectLeft }: Elsewhere): Promise<Pair> {
  const store = new Store();
  const {
    element: left,
    panels: [settings, camera, simulate],
  } = tabbed('settings', say('settings'), [
    ['settings', say('settings')],
    ['camera', say('camera')],
    ['simulate', say('simulate')],
  ]);
  const {
    element: right,
    panels: [results, point, matches],
  } = tabbed('details', say('results'), [
    ['results', say('results')],
    ['point', say('point')],
    ['matches', say('matches-2')],
  ]);
  byId('stage').before(left);
  byId('stage').after(right);
  const settingsButton = drawerButton('settings', say('settings'), 'settings', left);
  byId('menu').before(h('div', { class: 'drawers', aria: { label: say('settings-of-the-pair') }, role: 'group' }, settingsButton));
  byId('answer-actions').append(drawerButton('details', say('details'), 'details', right, say('details-of-the-results')));
  const engine = new Engine(store);
  const view = new View(byId('view'), store, engine);
  const navigator = new Navigator(store, view);
  await breath();
  const kept = new KeptPairs(store, engine, catalogue);
  const files = new Files(store, engine, openProject, { toBlock, toGround, left: projectLeft }, () => putAside(kept));
  /** Runs an action of the user's; what goes wrong is said in the status line. */
  const attempt = async (action: () => void | Promise<void>) => {
    try {
      await action();
    } catch (error) {
      store.dispatch({ type: 'notice', notice: { kind: 'problem', text: `${readable(store.state.catalogue, messageOf(error))}.` } });
    }
  };

  /** What was said of an earlier deed is over once something else is saved. */
  const saving: Saving = async (near, write) => {
    const { notice: before } = store.state;
    try {
      const name = await write();
      // What goes on says itself when it ends.
      const { notice } = store.state;
      if (name === null || notice?.kind === 'busy' || (notice !== before && notice?.beside !== true)) return;
      store.dispatch({ type: 'notice', notice: { kind: 'info', text: say('was-saved', { name }), beside: true } });
    } catch (error) {
      store.dispatch({ type: 'notice', notice: { kind: 'problem', text: sentence(readable(store.state.catalogue, messageOf(error))), near } });
    }
  };

  const editing = new Editing(store, (left, right) => fitted(store.state, engine, left, right));
  const masking = new Masking(store, (state, side, over, areas) => paintedMask(engine, state, side, over, areas));
  const paint = (masked: boolean) => void attempt(() => masking.paint(masked));
  const stepMasks = (by: 1 | -1) => void attempt(() => masking.step(by));
  // Where it was cancelled, no place is foretold.
  const marking = new Marking(
    store,
    (fiducials, model) =>
      engine
        .client('preview')
        .call('orientMarks', { fiducials: [...fiducials], model })
        .catch(() => null),
    (side, at) => navigator.show(side, at),
  );
  mountInput(view, store, navigator, { editing, masking, marking, paint });
  mountToolbar(byId('toolbar'), store, navigator);
  declareLack([byId('toolbar'), byId('view')], () => (SIDES.some((side) => store.state.images[side] === null) ? say('needs-two-photos') : ''));
  mountEditTools(byId('view-more'), byId('toolbar'), store, editing);
  /** A match is measured in the pictures, wherever it was begun. */
  const measured = () => {
    if (store.state.tool !== 'measure') return;
    uncoverPictures();
    navigator.followDraft();
    view.takeKeys();
  };
  mountDraft(byId('toolbar'), store, editing, { follow: () => navigator.followDraft(), begun: measured, ended: () => view.takeKeys() });
  mountMasking(byId('view-more'), byId('toolbar'), store, masking, { paint, step: stepMasks, giveUp: () => void editing.leave() });
  mountMarking(byId('toolbar'), store, marking);
  await breath();
  const pick = pickerOf(files);
  mountPanes(view, store, {
    open: (side) => pick(side),
    mask: (side) => pick(side, 'mask'),
    unmask: (side) => store.dispatch({ type: 'mask', side, mask: null }),
  });
  await breath();
  mountControls(settings, store, settingsButton);
  mountCamera(camera, store, () => pick(null));
  await breath();
  const measureMarks = (side: Side) => {
    marking.toggle(side);
    if (store.state.tool !== 'fiducials') return;
    uncoverPictures();
    byId('view').focus();
  };
  mountFiducials(camera, store, (side) => pick(side), marking, measureMarks);
  await breath();
  mountCounts(results, store);
  mountGeometry(results, store);
  mountOrientation(results, store);
  mountHistograms(results, store);
  await breath();
  mountPoint(point, store, (side, index) => navigator.select({ side, index }));
  declareLack([matches], () => lackOfMatches(store.state));
  mountEdits(matches, store, editing, measured);
  mountHistory(matches, store, {
    matches: (done) => store.dispatch({ type: 'goto', done }),
    masks: (done) => void attempt(() => masking.goTo(done)),
    marks: (done) => marking.step(done - store.state.markSteps.done),
  });
  mountEditKeys(matches, store, editing, measured);
  mountStatistics(matches, store, editing, (side, index) => navigator.select({ side, index }));
  await breath();
  mountSimulate(simulate, store, engine, (name, flight) => void attempt(() => files.takeFlight(name, flight)));
  mountAnnouncements(byId('announce'), store, () => {
    showTab('tab-point');
    setDrawer('details', true);
    reveal(right);
  });
  mountStatus(store, {
    cancel: () => engine.cancel(),
    run: () => store.dispatch({ type: 'resume' }),
    open: (side) => pick(side),
    camera: () => {
      setDrawer('settings', true);
      showTab('tab-camera');
      focusFocalLength(camera);
    },
    calibrated: () => useCalibration(store),
    otherStrategy: () => {
      const { settings: wanted } = store.state;
      if (wanted !== null)
        store.dispatch({ type: 'settings', settings: withSetting(wanted, 'matching.strategy', readSetting(catalogue.defaults, 'matching.strategy')) });
    },
    why: () => {
      showTab('tab-results');
      setDrawer('details', true);
      const oriented = shownPair(store.state).orientation !== null;
      if (!oriented) store.dispatch({ type: 'display', display: { points: 'all', hidden: [] } });
      // Once it is drawn.
      queueMicrotask(() => results.querySelector(`[data-testid="${oriented ? 'orientation' : 'matches'}-section"]`)?.scrollIntoView({ block: 'start' }));
    },
    save: () => void saving('next', () => exportProject(store, engine)),
  });
  mountHeader({ store, engine, view, files, pick, attempt, saving, sampleBlock });
  const near = makeNear('near', () => store.dispatch({ type: 'notice', notice: null }));
  byId('stage').after(near.element);
  store.watch(['notice'], ([notice]) => near.show(notice));
  store.watch(['selection'], ([selection]) => {
    // The table of matches shows the selected one itself, and is gone through by selecting.
    if (selection !== null && matches.hidden) showTab('tab-point');
  });
  return {
    store,
    engine,
    kept,
    measureMarks,
    begin: () => files.begin(),
    taker: takerOf(store, view, files),
    open: (file) => files.takeProject(file),
    save: (near) => saving(near, () => exportProject(store, engine)),
  };
}
