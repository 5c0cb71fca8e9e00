/** The page: starts its two parts and joins them. */
import './shared/style/base.css';
import './shared/style/layout.css';
import './shared/style/panels.css';
import './shared/style/view.css';
import { blockCatalogue } from './block/engine/catalogue';
import { mountBlock } from './block/mount';
import { openPair } from './block/pair';
import { mountPair } from './pair/mount';
import { checkRules } from './pair/state/codes';
import { project_kind } from './shared/crate';
import { loadCatalogue } from './shared/engine/start';
import { mountDrop } from './shared/files/drop';
import { byId } from './shared/panel/dom';
import { mountTheme } from './shared/panel/theme';
import { messageOf } from './shared/text/format';

/** So much of a project file says what it holds. */
const START_BYTES = 1024;

/** The module holds words and options of the page: its parts are made once it is there. */
async function start(): Promise<void> {
  const catalogue = await loadCatalogue();
  checkRules(catalogue.rules);
  byId('version').textContent = `Tiepoint ${catalogue.version}`;
  const pair = mountPair(openProject);
  const block = mountBlock((store, images) => void openPair(store, pair.store, pair.engine, images), openProject);
  /** What a file holds decides which part shows it; what is no project is refused by the part that it was given to. */
  async function openProject(file: File): Promise<void> {
    const mode = project_kind(new Uint8Array(await file.slice(0, START_BYTES).arrayBuffer())) ?? block.store.state.mode;
    block.store.dispatch({ type: 'mode', mode });
    await (mode === 'pair' ? pair : block).open(file);
  }
  mountDrop([block.taker, pair.taker]);
  pair.store.dispatch({ type: 'ready', catalogue });
  block.store.dispatch({ type: 'ready', catalogue: blockCatalogue(catalogue) });
}

mountTheme(byId('theme'));
start().catch((error: unknown) => {
  const status = byId('status');
  status.dataset.kind = 'problem';
  status.textContent = messageOf(error);
});
