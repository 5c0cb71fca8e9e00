/** The page: starts its two parts and joins them. */
import './shared/style/base.css';
import './shared/style/layout.css';
import './shared/style/answer.css';
import './shared/style/panels.css';
import './shared/style/view.css';
import { blockCatalogue } from './block/engine/catalogue';
import { mountBlock } from './block/mount';
import { openPair } from './block/pair';
import { isMode } from './block/state/state';
import { mountPair } from './pair/mount';
import { checkRules } from './pair/state/codes';
import { project_kind } from './shared/crate';
import { loadCatalogue } from './shared/engine/start';
import { Database } from './shared/files/database';
import { mountDrop } from './shared/files/drop';
import { Keeper } from './shared/files/keeper';
import { byId } from './shared/panel/dom';
import { mountMenu } from './shared/panel/menu';
import { mountProjects } from './shared/panel/projects';
import { mountTheme } from './shared/panel/theme';
import { messageOf } from './shared/text/format';

/** So much of a project file says what it holds. */
const START_BYTES = 1024;

/** The module holds words and options of the page: its parts are made once it is there, and show what the browser has kept. */
async function start(opening: Promise<Database>, serveDrop: ReturnType<typeof mountDrop>): Promise<void> {
  const catalogue = await loadCatalogue();
  checkRules(catalogue.rules);
  byId('version').textContent = `Tiepoint ${catalogue.version}`;
  const pair = mountPair(catalogue, { openProject, toBlock, sampleBlock, putAside: (kept) => keeper.putAside(kept) });
  const ofBlocks = blockCatalogue(catalogue);
  const block = mountBlock(ofBlocks, (store, images) => void openPair(store, pair.store, pair.engine, images), openProject);
  /** What a file holds decides which part shows it; what is no project is refused by the part that it was given to. */
  async function openProject(file: File): Promise<void> {
    const mode = project_kind(new Uint8Array(await file.slice(0, START_BYTES).arrayBuffer())) ?? block.store.state.mode;
    block.store.dispatch({ type: 'mode', mode });
    await (mode === 'pair' ? pair : block).open(file);
  }
  /** More images than two are a block. */
  function toBlock(files: readonly File[], masks: readonly File[]): void {
    block.store.dispatch({ type: 'mode', mode: 'block' });
    block.give(files, masks);
  }
  function sampleBlock(): void {
    block.store.dispatch({ type: 'mode', mode: 'block' });
    block.sample();
  }
  const mode = {
    now: () => block.store.state.mode,
    show: (kept: string) => {
      if (isMode(kept)) block.store.dispatch({ type: 'mode', mode: kept });
    },
  };
  const keeper = new Keeper([block.kept, pair.kept], mode);
  mountProjects(keeper);
  await keeper.start(opening, () => {
    pair.store.dispatch({ type: 'ready', catalogue });
    block.store.dispatch({ type: 'ready', catalogue: ofBlocks });
  });
  pair.begin();
  serveDrop([block.taker, pair.taker]);
}

mountTheme(byId('theme'));
mountMenu(byId('menu'), byId('bar-menu'));
const opening = Database.open();
// `start` waits for it, once the program is there.
opening.catch(() => undefined);
start(opening, mountDrop()).catch((error: unknown) => {
  byId('answer').dataset.kind = 'problem';
  byId('status').textContent = messageOf(error);
});
