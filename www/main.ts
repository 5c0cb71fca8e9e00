/** The page: makes the parts and wires them together. */
import './shared/style/base.css';
import './shared/style/layout.css';
import './shared/style/panels.css';
import './pair/style/view.css';
import { mountBlock } from './block/mount';
import { Engine } from './pair/engine/engine';
import { loadCatalogue } from './shared/engine/start';
import { mountDrop } from './pair/files/drop';
import { exportEverything, exportMatches, exportPicture } from './pair/files/export';
import { Files } from './pair/files/open';
import { exportReport } from './pair/files/report';
import { mountAnnouncements } from './pair/panel/announce';
import { mountCamera } from './pair/panel/camera';
import { mountControls } from './pair/panel/controls';
import { mountCounts } from './pair/panel/counts';
import { byId } from './shared/panel/dom';
import { mountFiducials } from './pair/panel/fiducials';
import { mountGeometry } from './pair/panel/geometry';
import { mountHistograms } from './pair/panel/histograms';
import { mountOrientation } from './pair/panel/orientation';
import { mountPanes } from './pair/panel/panes';
import { mountPoint } from './pair/panel/point';
import { mountSimulate } from './pair/panel/simulate';
import { mountStatistics } from './pair/panel/statistics';
import { isBusy, mountStatus } from './pair/panel/status';
import { mountTabs, showTab } from './shared/panel/tabs';
import { mountTheme } from './shared/panel/theme';
import { mountToolbar } from './pair/panel/toolbar';
import { checkRules } from './pair/state/codes';
import { readable } from './shared/text/names';
import { shownPair } from './pair/state/select';
import type { Side } from './pair/state/state';
import { Store } from './pair/state/store';
import { truthOf } from './pair/state/truth';
import { Input } from './pair/view/input';
import { Navigator } from './pair/view/navigate';
import { View } from './pair/view/view';

const store = new Store();
const engine = new Engine(store);
const view = new View(byId('view'), store, engine);
const navigator = new Navigator(store, view);
const files = new Files(store, engine);

new Input(view, store, navigator);
mountTheme(byId('theme'));
for (const list of document.querySelectorAll<HTMLElement>('[role="tablist"]')) mountTabs(list);
mountToolbar(byId('toolbar'), store, navigator);
mountPanes(view, store, {
  open: (side) => { pick(side); },
  mask: (side) => { pick(side, 'mask'); },
  unmask: (side) => { store.dispatch({ type: 'mask', side, mask: null }); },
});
mountControls(byId('panel-settings'), store);
mountCamera(byId('panel-camera'), store, () => { pick(null); });
mountFiducials(byId('panel-camera'), store, (side) => { pick(side); });
mountCounts(byId('panel-results'), store);
mountGeometry(byId('panel-results'), store);
mountOrientation(byId('panel-results'), store);
mountHistograms(byId('panel-results'), store);
mountPoint(byId('panel-point'), store, (side, index) => { navigator.select({ side, index }); });
mountStatistics(byId('panel-matches'), store, (side, index) => { navigator.select({ side, index }); });
mountSimulate(byId('panel-simulate'), store, engine, (name, flight) => { void attempt(() => files.takeFlight(name, flight)); });
mountAnnouncements(byId('announce'), store);
mountDrop(view, files);
mountStatus(store, {
  cancel: () => { engine.cancel(); },
  run: () => { store.dispatch({ type: 'resume' }); },
});
mountHeader();
mountBlock(store, engine);
store.watch((s) => [s.selection] as const, ([selection]) => {
  // The table of matches shows the selected one itself, and is gone through by selecting.
  if (selection !== null && byId('panel-matches').hidden) showTab('tab-point');
});
void start();

/** Opens the file dialog for a side, or for any files; or for the mask of a side. */
function pick(side: Side | null, what: 'any' | 'mask' = 'any'): void {
  const input = byId('file-input') as HTMLInputElement;
  input.dataset['what'] = what;
  input.dataset['side'] = side ?? '';
  input.multiple = side === null;
  input.click();
}

function mountHeader(): void {
  const input = byId('file-input') as HTMLInputElement;
  input.addEventListener('change', () => {
    const given = input.dataset['side'];
    const side = given === 'left' || given === 'right' ? given : null;
    const [first] = input.files ?? [];
    if (input.dataset['what'] === 'mask' && side !== null && first !== undefined) void files.takeMask(first, side);
    else void files.take([...(input.files ?? [])], side);
    input.value = '';
    input.dataset['what'] = '';
    input.dataset['side'] = '';
    input.multiple = true;
  });
  const on = (id: string, action: () => void | Promise<void>) => {
    byId(id).addEventListener('click', () => { void attempt(action); });
  };
  on('open', () => { pick(null); });
  for (const id of ['sample', 'sample-first']) on(id, () => files.takeSample());
  on('open-first', () => { pick(null); });
  on('swap', () => { swap(); });
  on('export-csv', () => exportMatches(store.state, engine));
  on('export-json', () => { exportEverything(store.state); });
  on('export-report', () => exportReport(store, engine));
  on('export-png', () => exportPicture(store.state, view));
  store.watch((s) => [s.images, s.results, s.catalogue, s.notice, s.running] as const, ([images, , catalogue]) => {
    const both = images.left !== null && images.right !== null;
    const set = (id: string, disabled: boolean) => { (byId(id) as HTMLButtonElement).disabled = disabled; };
    set('swap', images.left === null && images.right === null);
    set('sample', catalogue === null);
    set('sample-first', catalogue === null);
    set('export-csv', !both || shownPair(store.state).match === null);
    set('export-json', !both || store.state.results.pointsLeft === undefined);
    set('export-report', !both || isBusy(store.state));
    set('export-png', images.left === null && images.right === null);
    leaveWelcome(images.left !== null || images.right !== null);
  });
}

/** What is known of the truth says where left pixels are seen in the right image: it holds in the simulated order alone. */
function swap(): void {
  const known = truthOf(store.state) !== null;
  engine.swap();
  if (known) store.dispatch({ type: 'notice', notice: { kind: 'info', text: 'The simulated pair is compared with its truth in its own order only: swap again for that.' } });
}

/** Hides the welcome; the keyboard goes on to the images where it was in there, or on the button that gave them. */
function leaveWelcome(left: boolean): void {
  const welcome = byId('welcome');
  const { activeElement } = document;
  const focused = welcome.contains(activeElement) || (!welcome.hidden && [byId('open'), byId('sample')].some((press) => press === activeElement));
  welcome.hidden = left;
  if (left && focused) byId('view').focus();
}

/** Runs an action of the user's; what goes wrong is said in the status line. */
async function attempt(action: () => void | Promise<void>): Promise<void> {
  try {
    await action();
  } catch (error) {
    store.dispatch({ type: 'notice', notice: { kind: 'problem', text: `${readable(store.state.catalogue, error instanceof Error ? error.message : String(error))}.` } });
  }
}

async function start(): Promise<void> {
  await attempt(async () => {
    const catalogue = await loadCatalogue();
    checkRules(catalogue.rules);
    byId('version').textContent = `Tiepoint ${catalogue.version}`;
    store.dispatch({ type: 'ready', catalogue });
  });
}
