/** The block's part of the page: makes its parts and wires them together. */
import './style/block.css';
import { button, byId, fill, h } from '../shared/panel/dom';
import { drawerButton, reveal, setDrawer } from '../shared/panel/drawers';
import type { Taker } from '../shared/files/drop';
import type { Keepable } from '../shared/files/keepable';
import { fileButton } from '../shared/panel/picker';
import { showTab, tabbed } from '../shared/panel/tabs';
import { Holder } from '../shared/state/store';
import { BlockEngine } from './engine/engine';
import type { BlockStore } from './engine/engine';
import { mountExports, saveAs } from './panel/exports';
import { BlockFiles } from './files/files';
import { KeptBlocks } from './files/keep';
import { mountFlight } from './panel/flight';
import { mountBack, mountMode } from './panel/mode';
import { mountProgress } from './panel/progress';
import { reduceBlock } from './state/reducer';
import { mountResults } from './panel/results';
import { mountSettings } from './panel/settings';
import { mountStage } from './panel/stage';
import { BLOCK_INITIAL, isBusy } from './state/state';
import type { BlockCatalogue } from './state/state';
import { mountBlockStatus } from './panel/status';
import { mountImages, mountPoints } from './panel/tables';

/** The sample has so few photos that it is done in half a minute. */
const SAMPLE = { strips: 3, exposures: 4 };

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
}

/** `openPair` shows a pair of the block by itself; `openProject` opens a project of whatever kind where it belongs. */
export function mountBlock(
  catalogue: BlockCatalogue,
  openPair: (block: BlockStore, images: [number, number]) => void,
  openProject: (file: File) => Promise<void>,
): Block {
  const store: BlockStore = new Holder(BLOCK_INITIAL, reduceBlock);
  const engine = new BlockEngine(store);
  const files = new BlockFiles(store, engine, openProject);
  const looking = {
    choose: (choice: typeof store.state.choice) => store.dispatch({ type: 'choose', choice }),
    open: (images: [number, number]) => openPair(store, images),
  };
  const actions = h('div', { class: 'actions', role: 'group', aria: { label: 'Images of the block' } });
  const exports = h('div', { class: 'actions', role: 'group', aria: { label: 'Export of the block' } });
  const settings = tabbed('Settings', [
    ['block-settings', 'Settings'],
    ['block-flight', 'Simulate'],
  ]);
  const results = tabbed('Results', [
    ['block-results', 'Results'],
    ['block-images', 'Images'],
    ['block-points', 'Points'],
  ]);
  const stage = h('section', { class: 'stage', aria: { label: 'Block' } });
  const main = h('main', { class: 'block' }, settings.element, stage, results.element);
  const opener = drawerButton('settings', 'Settings', 'block-settings', settings.element);
  const drawers = h('div', { class: 'drawers', role: 'group', aria: { label: 'Settings of the block' } }, opener);

  const heading = document.querySelector('.bar h1');
  if (heading === null) throw new Error('the page has no bar');
  const pairParts = document.querySelectorAll<HTMLElement>('.bar .actions, .bar .drawers, body > main');
  byId('page-actions').before(actions, exports);
  byId('menu').before(drawers);
  document.querySelector('body > main')?.after(main);
  const back = mountBack(store);
  document.querySelector('body > main')?.before(back);
  heading.after(mountMode(store, { pair: [...pairParts], block: [actions, exports, drawers, main] }));
  store.watch(['mode', 'opened'], ([mode, opened]) => {
    back.hidden = mode !== 'pair' || opened === null;
  });

  const pick = mountActions(actions, store, files);
  mountExports(exports, store, engine);
  const status = mountBlockStatus(
    store,
    engine,
    {
      why: () => {
        showTab('tab-block-results');
        setDrawer('details', true);
        reveal(results.element);
      },
      save: () => void saveAs(store, engine, 'project'),
      open: pick,
    },
    drawerButton('details', 'Details', 'block-details', results.element),
  );
  mountSettings(settings.panels[0], store, files, opener);
  mountFlight(settings.panels[1], store, files);
  mountProgress(results.panels[0], store);
  mountResults(results.panels[0], store);
  const sample = () => void files.sample({ ...catalogue.flight, ...SAMPLE });
  mountStage(stage, store, looking, { sample, open: pick });
  stage.prepend(status);
  mountImages(results.panels[1], store, { ...looking, point: () => undefined });
  mountPoints(results.panels[2], store);
  store.watch(['running'], ([running]) => {
    if (running.kind === 'yes') showTab('tab-block-results');
  });
  return {
    store,
    kept: new KeptBlocks(store, engine, catalogue),
    taker: files.taker,
    give: (given, masks) => void files.give(given, masks),
    sample,
    open: (file) => files.open(file),
  };
}

/** The buttons that give images; gives what asks for images. */
function mountActions(host: HTMLElement, store: BlockStore, files: BlockFiles): () => void {
  const take = (given: File[]) => void files.take(given.map((file) => ({ file, path: file.webkitRelativePath })));
  const [images, imagesInput] = fileButton(
    'Images …',
    { testid: 'block-files', label: 'Images, cameras or project of a block', multiple: true, accept: 'image/*,.tif,.tiff,.pgm,.ppm,.pnm,.json,.tiepoint' },
    take,
    'Image files; a cameras file or a saved project too',
  );
  const [folder, folderInput] = fileButton('Folder …', { testid: 'block-folder', label: 'Folder of images', folder: true }, take, 'All images of a folder');
  const buttons = [
    images,
    folder,
    button('Simulated block', 'block-simulate', () => void files.photograph(), 'Photos of a synthetic scene, rendered in this tab'),
    button('Clear', 'block-clear', () => store.dispatch({ type: 'clear' }), 'Removes all images'),
  ];
  images.classList.add('primary');
  fill(host, ...buttons, imagesInput, folderInput);
  store.watch(['running', 'notice', 'files', 'shown', 'catalogue'], ([, , given, shown, catalogue]) => {
    for (const press of buttons) press.disabled = catalogue === null || isBusy(store.state);
    const last = buttons.at(-1);
    if (last !== undefined) last.disabled ||= given.length === 0 && shown === null;
  });
  return () => imagesInput.click();
}
