/** The block's part of the page: makes its parts and wires them together. */
import { showIn } from '../shared/panel/mode';
import type { Modes } from '../shared/state/mode';
import { button, byId, fill, h } from '../shared/panel/dom';
import { drawerButton, reveal, setDrawer } from '../shared/panel/drawers';
import type { Taker } from '../shared/files/drop';
import type { Keepable } from '../shared/files/keepable';
import type { Here } from '../shared/files/leaving';
import { fileButton } from '../shared/panel/picker';
import { makeNear } from '../shared/panel/near';
import { declareLack } from '../shared/panel/lack';
import { reveal as revealField } from '../shared/panel/reach';
import { showTab, tabbed } from '../shared/panel/tabs';
import { Holder } from '../shared/state/store';
import { breath } from '../shared/engine/breath';
import { Facts } from './engine/facts';
import { BlockPlacing } from './engine/block-placing';
import { BlockEngine } from './engine/engine';
import { PlacingEngine } from './engine/placing';
import type { BlockStore } from './engine/engine';
import { EditFollower } from './engine/follow';
import { mountEditBar } from './panel/edit-bar';
import type { Measures } from './panel/edit-bar';
import { mountBlockEditKeys } from './panel/edit-keys';
import { mountEditPanel } from './panel/edit-panel';
import { mountExports, saveAs } from './panel/exports';
import { BlockFiles } from './files/files';
import { GroundFiles } from './files/ground';
import { KeptBlocks } from './files/keep';
import { BlockRuns } from './files/runs';
import { mountAddress } from './panel/address';
import { makeDock } from './panel/dock';
import { mountFlight } from './panel/flight';
import { mountBack } from './panel/back';
import type { PairBeside } from './panel/back';
import { mountProgress } from './panel/progress';
import { reduceBlock } from './state/reducer';
import { imagesView } from './panel/images-view';
import { MATRIX_VIEW } from './panel/matrix-view';
import { mapView } from './panel/map-view';
import { makeMosaic } from './panel/mosaic';
import { orthophotoView } from './panel/orthophoto-view';
import { savePlaced } from './panel/placing-exports';
import { mountPlacingSettings } from './panel/placing-settings';
import { placingTables } from './panel/placing-tables';
import { plotsView } from './panel/plots-view';
import { mountResults, showReasons } from './panel/results';
import { mountScansLine } from './panel/scans-line';
import type { ScansBeside } from './panel/scans-line';
import { mountSettings } from './panel/settings';
import { mountStage } from './panel/stage';
import type { Choice } from './state/selection';
import { givenPositions } from './state/given-positions';
import { nextScans } from './state/scan-marks';
import { BLOCK_INITIAL, isBusy } from './state/state';
import type { BlockCatalogue } from './state/state';
import { mountBlockStatus } from './panel/status';
import { say } from '../shared/text/words';
import { lackOfBlock, lackOfImages } from './state/lacks';

/** The sample has so few photos that it is done in half a minute. */
const SAMPLE = { strips: 3, exposures: 4 };
/** The sample of images on an orthophoto; the side of its pixels in m is near that of the photos. */
const PLACED_SAMPLE = { strips: 2, exposures: 2, pixel_mm: 0.045 };
const PLACED_GSD_M = 0.5;

export interface Block {
  store: BlockStore;
  taker: Taker;
  /** What of it is kept in the browser's storage. */
  kept: Keepable;
  /** Takes images that were given elsewhere, with their masks. */
  give: (files: readonly File[], masks: readonly File[]) => void;
  /** Photographs a block and runs it. */
  sample: () => void;
  /** Opens a block that was saved. */
  open: (file: File) => Promise<void>;
  /** Saves the block as a project file. `near`: the `data-testid` of the button, beside which a refusal is said. */
  save: (near: string) => Promise<void>;
}

/** What of the page is no part of the block. */
interface Elsewhere {
  modes: Modes;
  /** Shows a pair of the block by itself. */
  openPair: (block: BlockStore, images: [number, number]) => Promise<void>;
  /** What the block has to know of the pair. */
  pair: Omit<PairBeside, 'open'>;
  /** The same where scans are in it, whose marks are measured there. */
  scans: (block: BlockStore) => ScansBeside;
  /** Opens a project of whatever kind where it belongs. */
  openProject: (file: File) => Promise<void>;
  /** Leaves a part of the page in the list of projects; false where it cannot be. */
  putAside: (part: Keepable) => Promise<boolean>;
  /** Waits for the project that is being left. */
  left: () => Promise<Here>;
  /** Waits for it with what is done with the project that is shown now. */
  stays: () => Promise<Here>;
}

/** In pieces, between which the page answers what the user does. */
export async function mountBlock(
  catalogue: BlockCatalogue,
  { modes, openPair, pair, scans: scansOf, openProject, putAside, left, stays }: Elsewhere,
): Promise<Block> {
  const store: BlockStore = new Holder(BLOCK_INITIAL, reduceBlock);
  const engine = new BlockEngine(store);
  const placing = new PlacingEngine(store);
  const onGround = new BlockPlacing(store, engine, placing);
  const facts = new Facts(store, engine);
  const runs = new BlockRuns(store, engine, placing, onGround, new GroundFiles(store, placing));
  const leave = () => {
    placing.cancel();
    onGround.cancel();
    engine.leave();
  };
  const kept = new KeptBlocks(store, engine, catalogue, leave, () => void files.actions.run());
  const files = new BlockFiles(store, engine, placing, runs, openProject, () => putAside(kept), left, stays);
  const looking = {
    choose: (choice: Choice | null) => store.dispatch({ type: 'choose', choice }),
    point: (choice: Choice | null) => store.dispatch({ type: 'point', choice }),
    open: (images: [number, number]) => void openPair(store, images),
  };
  const beside: PairBeside = { ...pair, open: (images) => openPair(store, images) };
  const scans = scansOf(store);
  const toMarks = () => {
    files.film.areScans();
    const { film } = store.state.placing;
    void scans.open(nextScans(film, store.state.files));
  };
  const actions = h('div', { class: 'actions', role: 'group', aria: { label: say('images-of-the-block') } });
  const exports = h('div', { class: 'actions', role: 'group', aria: { label: say('export-of-the-block') } });
  declareLack([actions], () => lackOfImages(store.state));
  declareLack([exports], () => lackOfBlock(store.state));
  const settings = tabbed('settings', say('settings'), [
    ['block-settings', say('settings')],
    ['block-orthophoto', say('orthophoto')],
    ['block-flight', say('simulate')],
  ]);
  const results = tabbed('details', say('results'), [
    ['block-results', say('results')],
    ['block-edits', say('edits')],
  ]);
  const stage = h('section', { class: 'stage', aria: { label: say('views-of-the-block') } });
  const main = h('main', { class: 'block' }, settings.element, stage, results.element);
  const opener = drawerButton('settings', say('settings'), 'block-settings', settings.element);
  const drawers = h('div', { class: 'drawers', role: 'group', aria: { label: say('settings-of-the-block') } }, opener);

  byId('page-actions').before(actions, exports);
  byId('menu').before(drawers);
  document.querySelector('body > main')?.after(main);
  document.querySelector('body > main')?.before(mountBack(store, facts, modes, beside, (masks) => files.beside.takePairMasks(masks)));
  document.querySelector('body > main')?.before(
    mountScansLine(store, modes, scans, {
      take: (tables) => files.film.takeMeasured(tables),
      back: () => {
        setDrawer('settings', true);
        showTab('tab-block-orthophoto');
      },
    }),
  );
  showIn(modes, 'block', [actions, exports, drawers, main]);

  const pick = mountActions(actions, store, files);
  mountExports(exports, store, engine, facts, placing);
  const status = mountBlockStatus(
    store,
    {
      run: () => void files.actions.run(),
      why: () => {
        showTab('tab-block-results');
        setDrawer('details', true);
        reveal(results.element);
        showReasons(results.panels[0]);
      },
      save: () => void saveAs(store, engine, 'project', 'block-next'),
      open: pick,
      place: () => void files.actions.place(),
      decide: (purpose) => void files.actions.decide(purpose),
      cancel: () => {
        placing.cancel();
        onGround.cancel();
        engine.cancel();
      },
      openHeights: () => pickers.heights(),
      savePlaced: () => void savePlaced(store, placing, 'placed', 'block-next'),
      whyPlaced: () => {
        setDrawer('table', true);
        showTab('tab-block-placed');
      },
      openSetting: (key) => {
        const field = settings.element.querySelector<HTMLElement>(`[data-key="${key}"]`);
        if (field === null) return;
        revealField(field);
        field.focus();
      },
    },
    drawerButton('details', say('details'), 'block-details', results.element, say('details-of-the-results')),
  );
  await breath();
  mountSettings(settings.panels[0], store, files, opener);
  await breath();
  const pickers = mountPlacingSettings(settings.panels[1], store, files, toMarks);
  mountFlight(settings.panels[2], store, files);
  mountProgress(results.panels[0], store);
  mountResults(results.panels[0], store, () => void files.actions.takeOff());
  await breath();
  const placedSample = () => void files.simulated.sampleOnOrthophoto({ ...catalogue.flight, ...PLACED_SAMPLE }, PLACED_GSD_M);
  const sample = () => void files.simulated.sample({ ...catalogue.flight, ...SAMPLE });
  let measures: Measures | null = null;
  const images = imagesView(engine, placing, facts, pick, (made) => {
    measures = made;
  });
  const views = [
    mapView(facts, placing, () => void makeMosaic(store, engine, placing, 'map-mosaic')),
    images,
    MATRIX_VIEW,
    plotsView(facts),
    orthophotoView(engine, facts, placing, {
      open: pickers.orthophoto,
      sample: placedSample,
      measure: () => {
        store.dispatch({ type: 'stage', view: 'images' });
        measures?.toggle(false);
      },
    }),
  ];
  const editLine = mountStage(stage, store, looking, facts, views, makeDock(store, looking, facts, placingTables(store)), { sample, placedSample, open: pick });
  stage.prepend(status);
  editLine.prepend(mountEditBar(store, facts, () => measures));
  mountEditPanel(results.panels[1], store);
  mountBlockEditKeys(store, facts, [stage, results.element]);
  const near = makeNear('block-near', () => store.dispatch({ type: 'notice', notice: null }));
  main.append(near.element);
  store.watch(['notice'], ([notice]) => near.show(notice));
  store.watch(
    (s) => [s.files, s.placing.orthophoto?.raster ?? null, s.placing.options, givenPositions(s)] as const,
    () => void placing.lookElsewhere(),
  );
  new EditFollower(store, engine);
  mountAddress(store, modes, beside);
  store.watch(['running'], ([running]) => {
    if (running.kind === 'yes') showTab('tab-block-results');
  });
  return {
    store,
    kept,
    taker: {
      isActive: () => modes.state.mode === 'block',
      markAt: () => 'block',
      take: (found) => void files.take(found),
    },
    give: (given, masks) => void files.give(given, masks),
    sample,
    open: (file) => files.open(file),
    save: (near) => saveAs(store, engine, 'project', near),
  };
}

/** The buttons that give images; gives what asks for images. */
function mountActions(host: HTMLElement, store: BlockStore, files: BlockFiles): () => void {
  const take = (given: File[]) => void files.take(given.map((file) => ({ file, path: file.webkitRelativePath })));
  const [images, imagesInput] = fileButton(
    say('images'),
    { testid: 'block-files', label: say('images-cameras-or-project-of'), multiple: true, accept: 'image/*,.tif,.tiff,.pgm,.ppm,.pnm,.json,.tiepoint' },
    take,
    say('image-files-a-cameras-file'),
  );
  const [folder, folderInput] = fileButton(
    say('folder'),
    { testid: 'block-folder', label: say('folder-of-images'), folder: true },
    take,
    say('all-images-of-a-folder'),
  );
  const buttons = [
    images,
    folder,
    button(say('simulated-block'), 'block-simulate', () => void files.simulated.photograph(), say('photos-of-a-synthetic-scene')),
    button(say('clear'), 'block-clear', () => void files.actions.clear(), say('removes-all-images-an-edited')),
  ];
  fill(host, ...buttons, imagesInput, folderInput);
  store.watch(['running', 'notice', 'files', 'shown', 'catalogue', 'placing'], ([, , given, shown, catalogue, placing]) => {
    for (const press of buttons) press.disabled = catalogue === null || isBusy(store.state);
    const last = buttons.at(-1);
    if (last !== undefined) last.disabled ||= given.length === 0 && shown === null && placing.orthophoto === null;
  });
  return () => imagesInput.click();
}
