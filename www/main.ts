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
import { loadCatalogue } from './shared/engine/start';
import { mountDrop } from './shared/files/drop';
import { byId } from './shared/panel/dom';
import { mountTheme } from './shared/panel/theme';

const pair = mountPair();
const block = mountBlock((store, images) => { void openPair(store, pair.store, pair.engine, images); });
mountDrop([block.taker, pair.taker]);
mountTheme(byId('theme'));
void pair.attempt(async () => {
  const catalogue = await loadCatalogue();
  checkRules(catalogue.rules);
  byId('version').textContent = `Tiepoint ${catalogue.version}`;
  pair.store.dispatch({ type: 'ready', catalogue });
  block.store.dispatch({ type: 'ready', catalogue: blockCatalogue(catalogue) });
});
